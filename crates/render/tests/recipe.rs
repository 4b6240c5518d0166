//! What a recipe may say, and what is refused.

#[allow(dead_code)] // each file of tests takes what it needs
mod common;

use nacreous_render::{Job, Needs, Resources, spec::Recipe};
use serde_json::{Value, json};

#[test]
fn an_unknown_key_and_an_unknown_word_are_refused_by_name() {
    for (place, key, value, message) in [
        ("", "sise", json!(1), "unknown field `sise`"),
        ("/pearls/0", "form", json!("oval"), "unknown field `form`"),
        ("/pearls/0/film", "outer_nm", json!(1), "unknown field `outer_nm`"),
        ("/pearls/0/nacre", "protien_nm", json!(1), "unknown field `protien_nm`"),
        ("/pearls/0/surface", "facets", json!("blinn"), "unknown variant `blinn`"),
        ("/scene/table", "kind", json!("glass"), "unknown variant `glass`"),
        ("/scene/sky", "horizon", json!("#12345"), "colour is \"#12345\""),
    ] {
        let mut recipe = common::value("akoya-rg-north-window-white");
        recipe.pointer_mut(place).unwrap()[key] = value;
        let found = Recipe::from_json(&recipe.to_string()).expect_err("a refusal").to_string();
        assert!(found.contains(message), "{found}");
    }
}

#[test]
fn sizes_and_samples_that_cannot_be_are_refused() {
    for (place, value, message) in [
        ("/size", 0, "size is 0; allowed: a whole number from 1 to 8192"),
        ("/size", 8193, "size is 8193; allowed: a whole number from 1 to 8192"),
        ("/samples", 15, "samples is 15; allowed: a square number from 1 to 1024, such as 16"),
    ] {
        let recipe = common::recipe("paper-paper", &[(place, json!(value))]);
        let found = Job::new(recipe, Resources::default()).expect_err("a refusal").to_string();
        assert_eq!(found, message);
    }
}

#[test]
fn a_file_that_was_not_handed_over_is_named() {
    for (place, value) in [
        ("/scene/lamps/0/spectrum", json!("lamp.csv")),
        ("/pearls/0/texture/source", json!("pearl.png")),
    ] {
        let changes = [(place, value.clone()), ("/pearls/0/grain", json!(0.5))];
        let recipe = common::recipe("paper-paper", &changes);
        let mut job = Job::new(recipe, Resources::default()).unwrap();
        let found = job.view(&nacreous_image::Progress::default()).expect_err("a refusal");
        let name: &str = value.as_str().unwrap();
        assert!(found.to_string().starts_with(name), "{found}");
    }
}

#[test]
fn days_that_are_none_are_refused() {
    for (place, value) in
        [("seeding", "02-30"), ("harvest", "2023-1-1"), ("peak", "ä8-01"), ("harvest", "éé-éé")]
    {
        let place = format!("/pearls/0/nacre/{place}");
        let recipe = common::recipe("paper-paper", &[(place.as_str(), json!(value))]);
        let mut job = Job::new(recipe, Resources::default()).unwrap();
        let found = job.view(&nacreous_image::Progress::default()).expect_err("a refusal");
        assert!(found.to_string().contains("allowed: MM-DD or YYYY-MM-DD"), "{found}");
    }
}

#[test]
fn the_files_needed_are_those_of_lights_that_are_on_of_the_sky_and_of_photographs() {
    let lamps = json!([lamp("on.csv", 1.0), lamp("off.csv", 0.0), lamp("D65", 1.0)]);
    let changes = [
        ("/scene/lamps", lamps),
        ("/scene/sky/kind", json!("panorama")),
        ("/scene/sky/path", json!("sky.hdr")),
        ("/pearls/0/texture/source", json!("pearl.png")),
    ];
    let needs = Needs::of(&common::recipe("paper-paper", &changes));
    assert_eq!(needs.spectra, ["on.csv".to_owned()].into());
    assert_eq!(needs.panoramas, ["sky.hdr".to_owned()].into());
    assert_eq!(needs.photographs, [(0, "pearl.png".to_owned())].into());
    assert_eq!(Needs::of(&common::recipe("paper-paper", &[])), Needs::default());
}

fn lamp(spectrum: &str, intensity: f64) -> Value {
    let mut lamp = common::value("paper-paper")["scene"]["lamps"][0].clone();
    (lamp["spectrum"], lamp["intensity"]) = (json!(spectrum), json!(intensity));
    lamp
}

#[test]
fn a_list_in_the_place_of_a_table_is_refused() {
    let mut recipe = common::value("akoya-rg-north-window-white");
    let whole = json!([recipe["pearls"], recipe["scene"], 8, 1]);
    assert!(Recipe::from_json(&whole.to_string()).is_err());
    recipe["pearls"][0]["film"] = json!([37.0, 64, null]);
    let found = Recipe::from_json(&recipe.to_string()).expect_err("a refusal").to_string();
    assert_eq!(found, "pearls.0.film is a list; allowed: no list");
}
