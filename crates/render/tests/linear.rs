//! A picture is linear in light: what lights gain, exposure takes back, grain included.

#[allow(dead_code)] // each file of tests takes what it needs
mod common;

use nacreous_colour::{Gamut, RgbSpace};
use nacreous_image::{Progress, develop, eight_bit};
use nacreous_render::{Job, Resources, light_of, spec::Recipe};
use serde_json::{Value, json};

const NAMES: [&str; 3] =
    ["paper-paper", "akoya-rg-north-window-white", "tahitian-north-window-black"];

fn scale(value: &mut Value, place: &str, factor: f64) {
    if let Some(light) = value.pointer_mut(place) {
        *light = json!(light.as_f64().expect("a number") * factor);
    }
}

/// Codes of a grainy pearl whose lights are all `brighter` times as strong, at 1 / `brighter` of the exposure.
fn codes(name: &str, brighter: f64) -> Vec<u16> {
    let mut value = common::value(name);
    *value.pointer_mut("/pearls/0/grain").expect("a key") = json!(1.0);
    for light in 0..4 {
        scale(&mut value, &format!("/scene/lamps/{light}/intensity"), brighter);
        scale(&mut value, &format!("/scene/windows/{light}/luminance"), brighter);
    }
    scale(&mut value, "/scene/sky/intensity", brighter);
    scale(&mut value, "/scene/camera/exposure", 1.0 / brighter);
    let recipe = Recipe::from_json(&value.to_string()).expect("a recipe");
    let mut job = Job::new(recipe, Resources::default()).expect("a job");
    let progress = Progress::default();
    let pixels = job.view(&progress).unwrap().unwrap().picture(&progress).unwrap();
    develop(&light_of(&pixels), RgbSpace::Srgb, Gamut::Clip).codes
}

#[test]
fn twice_the_light_at_half_the_exposure_changes_no_code() {
    for name in NAMES {
        let once = codes(name, 1.0);
        for brighter in [2.0, 0.25] {
            assert!(codes(name, brighter) == once, "{name}, {brighter}");
        }
    }
}

#[test]
fn any_light_at_its_inverse_exposure_moves_codes_by_rounding_alone() {
    for name in NAMES {
        let once = codes(name, 1.0);
        for brighter in [3.0, 0.1] {
            let other = codes(name, brighter);
            let moved = once.iter().zip(&other).map(|(a, b)| a.abs_diff(*b)).max();
            assert!(moved <= Some(1), "{name}, {brighter}: {moved:?} of 65535");
            assert!(eight_bit(&once) == eight_bit(&other), "{name}, {brighter}");
        }
    }
}
