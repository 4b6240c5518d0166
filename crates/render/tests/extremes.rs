//! At both ends of every key's range nothing panics, and no picture holds a number that is none.

#[allow(dead_code)] // each file of tests takes what it needs
mod common;

use nacreous_image::Progress;
use nacreous_render::{Job, Resources, spec::Recipe};
use serde_json::{Value, json};

/// (place in a recipe, both ends) of every number that `ranges.csv` declares.
fn ends() -> Vec<(String, [f64; 2])> {
    let row = |line: &str| {
        let cells: Vec<&str> = line.splitn(7, ',').collect();
        let number = |cell: &str| cell.parse::<f64>().ok();
        let low = number(cells[2]).or(number(cells[3]).map(|above| above + 1e-3))?;
        let high = number(cells[4]).or(number(cells[5]).map(|below| below - 1e-3))?;
        let place = cells[0].replacen("pearl.", "/pearls/0/", 1).replacen("scene.", "/scene/", 1);
        let place = place.replace("[]", "/0").replace('[', "/").replace(']', "").replace('.', "/");
        (cells[1] == "number").then_some((place, [low, high]))
    };
    include_str!("../src/spec/ranges.csv").lines().skip(1).filter_map(row).collect()
}

/// A golden recipe, small and with a lamp, a window and walls in it.
fn small(name: &str) -> Value {
    let mut recipe = common::value(name);
    (recipe["size"], recipe["samples"]) = (json!(3), json!(1));
    recipe["scene"]["lamps"] = json!([{
        "azimuth_deg": 20.0, "elevation_deg": 40.0, "position_mm": null, "angular_radius_deg": 3.0,
        "spectrum": "D65", "intensity": 1.0,
    }]);
    recipe["scene"]["windows"] = json!([{
        "azimuth_deg": -40.0, "elevation_deg": 30.0, "distance_mm": 900.0, "position_mm": null,
        "facing": null, "below_mm": null, "width_mm": 300.0, "height_mm": 300.0, "spectrum": "D65",
        "luminance": 2.0,
    }]);
    recipe["scene"]["walls"] =
        json!({"half_width_mm": 150.0, "height_mm": 200.0, "colour": "#b9b4ab"});
    if let Some(film) = recipe["pearls"][0].get_mut("film") {
        (film["columns"], film["outer_um"]) = (json!(2), json!(2.0));
    }
    recipe
}

#[test]
fn the_ends_of_every_range_give_a_picture_or_a_refusal() {
    let (mut tried, mut pictures) = (0, 0);
    for (name, part) in [("akoya-rg-north-window-white", "/"), ("paper-paper", "/pearls")] {
        let whole = small(name);
        let progress = Progress::default();
        // One job for all: what a key leaves as it was is not made again.
        let first = Recipe::from_json(&whole.to_string()).expect("a recipe");
        let mut job = Job::new(first, Resources::default()).expect("a job");
        for (place, ends) in ends().into_iter().filter(|(place, _)| place.starts_with(part)) {
            for end in ends {
                let mut recipe = whole.clone();
                let Some(number) = recipe.pointer_mut(&place) else { continue };
                *number = if end.fract() == 0.0 && end.abs() < 1e15 {
                    json!(end as i64)
                } else {
                    json!(end)
                };
                tried += 1;
                let Ok(recipe) = Recipe::from_json(&recipe.to_string()) else { continue };
                let changed = job.change(recipe, Resources::default());
                let Ok(Some(view)) = changed.and_then(|()| job.view(&progress)) else { continue };
                let pixels = view.picture(&progress).expect("nobody stops it");
                assert!(pixels.iter().all(|light| light.is_finite()), "{place} = {end}");
                pictures += 1;
            }
        }
    }
    assert!(tried > 100 && 10 * pictures > 8 * tried, "{pictures} pictures of {tried}");
}
