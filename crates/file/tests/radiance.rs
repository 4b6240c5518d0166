//! Radiance files: what the lines above the pixels mean, and how pixels are coded.

use nacreous_file::panorama::decode_panorama;

fn file(lines: &str, size: &str, pixels: &[u8]) -> Vec<u8> {
    [format!("#?RADIANCE\n{lines}\n{size}\n").as_bytes(), pixels].concat()
}

/// Three rows of two pixels, red told apart: 1 to 6 times 2^-8.
fn numbered() -> Vec<u8> {
    (1..=6).flat_map(|red| [red, 0, 0, 128]).collect()
}

fn reds(bytes: &[u8]) -> Vec<f32> {
    let picture = decode_panorama(bytes).unwrap();
    picture.rgb.chunks(3).map(|pixel| pixel[0] * 256.0).collect()
}

fn message(lines: &str) -> String {
    decode_panorama(&file(lines, "-Y 3 +X 2", &numbered())).unwrap_err().to_string()
}

#[test]
fn all_eight_orders_of_pixels_give_the_upright_picture() {
    for (size, expected) in [
        ("-Y 3 +X 2", [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]),
        ("-Y 3 -X 2", [2.0, 1.0, 4.0, 3.0, 6.0, 5.0]),
        ("+Y 3 +X 2", [5.0, 6.0, 3.0, 4.0, 1.0, 2.0]),
        ("+Y 3 -X 2", [6.0, 5.0, 4.0, 3.0, 2.0, 1.0]),
        ("+X 3 -Y 2", [1.0, 3.0, 5.0, 2.0, 4.0, 6.0]),
        ("-X 3 -Y 2", [5.0, 3.0, 1.0, 6.0, 4.0, 2.0]),
        ("+X 3 +Y 2", [2.0, 4.0, 6.0, 1.0, 3.0, 5.0]),
        ("-X 3 +Y 2", [6.0, 4.0, 2.0, 5.0, 3.0, 1.0]),
    ] {
        assert_eq!(reds(&file("", size, &numbered())), expected, "{size}");
    }
}

#[test]
fn exposures_and_colour_corrections_are_divided_out_wherever_they_stand() {
    let lines =
        "EXPOSURE=2\nFORMAT=32-bit_rle_rgbe\n\tEXPOSURE=7\nEXPOSURE= 4.0\nCOLORCORR=.5 1 1\n";
    let once = reds(&file("", "-Y 3 +X 2", &numbered()));
    let found = reds(&file(lines, "-Y 3 +X 2", &numbered()));
    assert_eq!(found, once.iter().map(|red| red / 4.0).collect::<Vec<_>>());
    for wrong in ["EXPOSURE=0\n", "EXPOSURE=-1\n", "EXPOSURE=1 2\n", "EXPOSURE=dark\n"] {
        assert!(message(wrong).contains("allowed: a number above 0"), "{wrong}");
    }
    assert!(message("COLORCORR=1 1\n").contains("allowed: 3 numbers above 0"));
    assert!(message(&"EXPOSURE=1e30\n".repeat(20)).contains("product"));
}

#[test]
fn light_that_an_exposure_makes_infinite_is_told_by_that_exposure() {
    for lines in ["EXPOSURE=1e-45\n", "EXPOSURE=1e-30\nEXPOSURE=1e-30\n", "COLORCORR=1e-45 1 1\n"] {
        let message = message(lines);
        assert!(
            message.contains("EXPOSURE or COLORCORR lines whose product is 1.0e-"),
            "{message}"
        );
    }
    assert!(reds(&file("EXPOSURE=1e-30\n", "-Y 3 +X 2", &numbered()))[0] > 1e29);
}

#[test]
fn pixels_that_are_not_linear_light_are_refused_by_their_gamma() {
    for lines in ["GAMMA=2.2\n", "GAMMA=\n", "GAMMA=1\nGAMMA=1.8\n"] {
        assert!(message(lines).contains("has the GAMMA"), "{lines}");
    }
    for lines in ["GAMMA=1\n", "GAMMA= 1.0\n", "\tGAMMA=2.2\n"] {
        assert_eq!(
            reds(&file(lines, "-Y 3 +X 2", &numbered())),
            [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
            "{lines}"
        );
    }
}

#[test]
fn stated_primaries_are_converted_and_keep_white() {
    // The values of Rec. 2020 with D65: ITU-R BT.2087 gives the red of Rec. 709.
    let lines = "PRIMARIES=.708 .292 .170 .797 .131 .046 .3127 .3290\n";
    let pixels = [[128, 128, 128, 128], [128, 0, 0, 128]].concat();
    let rgb = decode_panorama(&file(lines, "-Y 1 +X 2", &pixels)).unwrap().rgb;
    assert!(rgb[..3].iter().all(|value| (value - 0.5).abs() < 1e-5), "{rgb:?}");
    // Green and blue would be below zero, which a panorama's light is not.
    for (own, published) in rgb[3..].iter().zip([1.6605, 0.0, 0.0]) {
        assert!((own - 0.5 * published).abs() < 1e-3, "{rgb:?}");
    }
    for wrong in ["PRIMARIES=1 2 3\n", "PRIMARIES=.3 .3 .3 .3 .3 .3 .3 .3\n"] {
        assert!(message(wrong).contains("has the PRIMARIES"), "{wrong}");
    }
}

#[test]
fn any_program_and_either_end_of_line_are_read() {
    for head in ["#?RGBE\n", "#?RADIANCE\r\nFORMAT=32-bit_rle_rgbe\r\n", "#?AUTOPANO\n#note\n"] {
        let end = if head.contains('\r') { "\r\n" } else { "\n" };
        let text = format!("{head}{end}-Y 3 +X 2{end}");
        let found = reds(&[text.as_bytes(), &numbered()].concat());
        assert_eq!(found, [1.0, 2.0, 3.0, 4.0, 5.0, 6.0], "{head:?}");
    }
}

#[test]
fn both_kinds_of_runs_are_the_pixels_one_by_one() {
    let flat = [[9, 8, 7, 130].repeat(10), vec![1, 2, 3, 131, 4, 5, 6, 129]].concat();
    let old = [vec![9, 8, 7, 130, 1, 1, 1, 9], vec![1, 2, 3, 131, 4, 5, 6, 129]].concat();
    let channel = |many: u8, two: [u8; 2]| [128 + 10, many, 2, two[0], two[1]];
    let new = [
        [2, 2, 0, 12].as_slice(),
        &channel(9, [1, 4]),
        &channel(8, [2, 5]),
        &channel(7, [3, 6]),
        &channel(130, [131, 129]),
    ]
    .concat();
    let expected = decode_panorama(&file("", "-Y 1 +X 12", &flat)).unwrap();
    assert_eq!(decode_panorama(&file("", "-Y 1 +X 12", &old)).unwrap(), expected);
    assert_eq!(decode_panorama(&file("", "-Y 1 +X 12", &new)).unwrap(), expected);
    // A second repetition counts 256 times as much.
    let long = [vec![9, 8, 7, 130, 1, 1, 1, 43, 1, 1, 1, 1], vec![]].concat();
    let picture = decode_panorama(&file("", "-Y 1 +X 300", &long)).unwrap();
    assert!(picture.rgb.chunks(3).all(|pixel| pixel == &picture.rgb[..3]));
}

#[test]
fn what_is_not_honoured_is_refused_by_name() {
    assert!(message("FORMAT=32-bit_rle_xyze\n").contains("XYZE"));
    assert!(message("FORMAT=64-bit\n").contains("has the FORMAT \"64-bit\""));
    for size in ["-Y 3", "-Y 3 +Y 2", "3 2", "-Y three +X 2", "-Y -3 +X 2"] {
        let message = decode_panorama(&file("", size, &numbered())).unwrap_err().to_string();
        assert!(message.contains("its size is"), "{message}");
    }
    let message = decode_panorama(&file("", "-Y 4 +X 2", &numbered())).unwrap_err().to_string();
    assert!(message.contains("ends before its pixels"), "{message}");
}
