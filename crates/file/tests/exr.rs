//! EXR: every bit comes back, and equal input gives equal bytes.

use nacreous_file::exr::{Channels, Plane, read_exr, read_exr_text, write_exr};

const SIZE: (usize, usize) = (19, 35);

fn plane(name: &str, channels: Channels) -> Plane<'static> {
    let count = SIZE.0 * SIZE.1 * channels.names().len();
    let mut samples: Vec<f32> = (0..count).map(|index| (index as f32 * 0.37).sin() * 2.0).collect();
    samples[..6].copy_from_slice(&[f32::MAX, f32::MIN, 1e-45, -0.0, f32::MIN_POSITIVE, 0.1]);
    Plane { name: name.to_owned(), channels, samples: samples.into() }
}

fn planes() -> Vec<Plane<'static>> {
    let own = [("", Channels::Rgba), ("diffuse", Channels::Rgb), ("texture-V", Channels::Grey)];
    own.map(|(name, channels)| plane(name, channels)).to_vec()
}

fn text() -> Vec<(String, String)> {
    let keys = ["Software", "nacreous:seed", "nacreous:spec", "nacreous:version"];
    keys.map(|key| (key.to_owned(), format!("the {key} of 真珠, {}", "µ".repeat(300)))).to_vec()
}

fn written() -> Vec<u8> {
    let mut file = Vec::new();
    write_exr(&mut file, SIZE.0, SIZE.1, &planes(), &text()).unwrap();
    file
}

#[test]
fn every_bit_of_every_layer_comes_back() {
    let read = read_exr(&written()).unwrap();
    assert_eq!((read.width, read.height), SIZE);
    let bits = |planes: &[Plane<'_>]| -> Vec<_> {
        let of = |plane: &Plane<'_>| -> Vec<u32> {
            plane.samples.iter().map(|sample| sample.to_bits()).collect()
        };
        planes.iter().map(|plane| (plane.name.clone(), plane.channels, of(plane))).collect()
    };
    assert_eq!(bits(&read.planes), bits(&planes()));
    assert_eq!(read.text, text());
}

#[test]
fn equal_input_gives_equal_bytes() {
    let first = written();
    assert!((0..20).all(|_| written() == first));
}

#[test]
fn what_an_exr_cannot_hold_is_refused() {
    let message = |planes: &[Plane<'_>], text: &[(String, String)]| {
        write_exr(&mut Vec::new(), SIZE.0, SIZE.1, planes, text).unwrap_err().to_string()
    };
    let main = plane("", Channels::Rgb);
    let layer = |name: &str| plane(name, Channels::Rgb);
    assert!(message(&[layer("diffuse")], &[]).contains("is missing"));
    assert!(message(&[main.clone(), layer("a.b")], &[]).contains("no layer name"));
    let twice = [main.clone(), layer("mirror"), layer("mirror")];
    assert_eq!(message(&twice, &[]), "layer \"mirror\" is given twice; allowed: each layer once");
    let mut short = layer("mirror");
    short.samples.to_mut().pop();
    assert!(message(&[main.clone(), short], &[]).ends_with("samples; 19 x 35 x 3 are needed"));
    let mut broken = layer("mirror");
    broken.samples.to_mut()[3 * 20 + 1] = f32::NAN;
    assert_eq!(
        message(&[main.clone(), broken], &[]),
        "layer \"mirror\" holds 1 values that are not finite, the first at row 1, column 1, \
         channel 1"
    );
    let reserved = [("channels".to_owned(), "x".to_owned())];
    assert!(message(&[main], &reserved).contains("`channels` is reserved"));
}

#[test]
fn texts_are_read_without_the_pixels() {
    let folder = std::env::temp_dir().join(format!("nacreous-exr-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.exr");
    std::fs::write(&path, written()).unwrap();
    assert_eq!(read_exr_text(&path).unwrap(), text());
    std::fs::write(&path, b"pearl").unwrap();
    assert!(read_exr_text(&path).unwrap_err().to_string().contains("allowed: OpenEXR"));
    std::fs::remove_dir_all(&folder).unwrap();
}
