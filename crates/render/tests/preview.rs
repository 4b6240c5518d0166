//! First pictures against the pictures that they stand for.

use nacreous_colour::{Gamut, RgbSpace, decode, delta_e_2000, lab_from_xyz};
use nacreous_image::{CHANNELS, Development, Progress, develop, eight_bit};
use nacreous_render::{Asked, Job, Resources, light_of, spec::Recipe};
use serde_json::{Value, json};

const SIZE: usize = 96;

fn recipe(name: &str, changes: &[(&str, Value)]) -> Recipe {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/recipes");
    let text = std::fs::read_to_string(format!("{folder}/{name}.json")).expect("a golden recipe");
    let mut value: Value = serde_json::from_str(&text).expect("JSON");
    (value["size"], value["samples"]) = (json!(SIZE), json!(16));
    for (place, new) in changes {
        *value.pointer_mut(place).expect("a key") = new.clone();
    }
    Recipe::from_json(&value.to_string()).expect("a recipe")
}

fn asked() -> Asked {
    let development = Development { exposure: 1.0, space: RgbSpace::Srgb, gamut: Gamut::Soft };
    Asked { size_px: SIZE, development }
}

fn job(recipe: Recipe) -> Job {
    Job::new(recipe, Resources::default()).expect("a job")
}

fn preview(job: &mut Job) -> Vec<u8> {
    job.preview(&asked(), &Progress::default()).expect("a preview").expect("never stopped")
}

/// CIEDE2000 between the codes of both, pixel by pixel, where the pearl is: the mean, and what 95 of 100 are below.
fn apart(job: &mut Job) -> [f64; 2] {
    let progress = Progress::default();
    let view = job.view(&progress).expect("a view").expect("never stopped");
    let pixels = view.picture(&progress).expect("never stopped");
    let whole = eight_bit(&develop(&light_of(&pixels), RgbSpace::Srgb, Gamut::Soft).codes);
    let lab = |codes: &[u8]| {
        let rgb = [0, 1, 2].map(|i| decode(f64::from(codes[i]) / 255.0));
        lab_from_xyz(RgbSpace::Srgb.xyz_from_rgb(rgb), RgbSpace::Srgb.white_xyz())
    };
    let first = preview(job);
    let both = first.chunks_exact(4).zip(whole.chunks_exact(3)).zip(pixels.chunks_exact(CHANNELS));
    let pearl = both.filter(|(_, pixel)| pixel[15] > 0.99);
    let mut apart: Vec<f64> = pearl.map(|((a, b), _)| delta_e_2000(lab(a), lab(b))).collect();
    apart.sort_by(f64::total_cmp);
    [apart.iter().sum::<f64>() / apart.len() as f64, apart[apart.len() * 95 / 100]]
}

#[test]
fn a_first_picture_looks_like_the_picture() {
    let bump = ("/pearls/0/blemishes/bumps", json!(30));
    let oval = ("/pearls/0/shape/length", json!(1.4));
    let lamp = |power: f64| ("/scene/windows/0/luminance", json!(power));
    for (name, changes, bounds) in [
        ("akoya-rg-north-window-white", vec![], [0.7, 1.6]),
        (
            "akoya-rg-north-window-white",
            vec![("/pearls/0/surface/waviness_rad", json!(0.0))],
            [0.7, 1.6],
        ),
        (
            "akoya-rg-north-window-white",
            vec![("/pearls/0/depth", json!(0.9)), lamp(2.0)],
            [0.8, 1.8],
        ),
        ("tahitian-north-window-black", vec![], [1.2, 2.6]),
        // Approximate by more: edges within pixels, and light inside that knows the form.
        ("akoya-rg-north-window-white", vec![bump], [1.0, 2.5]),
        ("akoya-rg-north-window-white", vec![oval], [1.3, 3.0]),
        ("paper-paper", vec![], [1.5, 5.0]),
    ] {
        let found = apart(&mut job(recipe(name, &changes)));
        assert!(found[0] < bounds[0] && found[1] < bounds[1], "{name} {changes:?}: {found:?}");
    }
}

#[test]
fn what_is_kept_shows_what_is_made_anew() {
    let name = "akoya-rg-north-window-white";
    let mut kept = job(recipe(name, &[]));
    preview(&mut kept);
    for change in [
        ("/pearls/0/nacre/protein_nm", json!(25.0)),
        ("/pearls/0/shininess", json!(0.9)),
        ("/pearls/0/grain", json!(0.9)),
        ("/pearls/0/texture/seed", json!(5)),
        ("/scene/camera/azimuth_deg", json!(30.0)),
        ("/scene/camera/exposure", json!(0.5)),
        ("/scene/windows/0/azimuth_deg", json!(-71.0)),
    ] {
        let changed = recipe(name, std::slice::from_ref(&change));
        kept.change(changed.clone(), Resources::default()).unwrap();
        let (kept, anew) = (preview(&mut kept), preview(&mut job(changed)));
        // Light that the pearl sends out is taken as it was.
        let far = kept.iter().zip(&anew).filter(|(a, b)| a.abs_diff(**b) > 6).count();
        assert!(far * 100 < kept.len(), "{change:?}: {far} of {}", kept.len());
    }
}

#[test]
fn many_pearls_and_any_size_are_shown_and_a_size_beyond_all_is_refused() {
    let mut two = job(recipe("paper-paper", &[]));
    for size_px in [1, 7, 64] {
        let asked = Asked { size_px, ..asked() };
        let codes = two.preview(&asked, &Progress::default()).unwrap().unwrap();
        assert_eq!(codes.len(), 4 * size_px * size_px);
    }
    let asked = Asked { size_px: 100_000, ..asked() };
    assert!(two.preview(&asked, &Progress::default()).is_err());
}
