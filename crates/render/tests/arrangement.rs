//! Which pearl lies where, and what is refused.

#[allow(dead_code)] // each file of tests takes what it needs
mod common;

use glam::DVec3;
use nacreous_render::{Arrangement, spec::Recipe};
use serde_json::{Value, json};

/// Pearls of these diameters in rows of a scene.
fn rows(diameters_mm: &[f64], rows: &Value, changes: &[(&str, Value)]) -> Recipe {
    let pearl = common::value("akoya-rg-north-window-white")["pearls"][0].clone();
    let pearls: Vec<Value> = diameters_mm
        .iter()
        .map(|diameter_mm| {
            let mut pearl = pearl.clone();
            pearl["diameter_mm"] = json!(diameter_mm);
            pearl
        })
        .collect();
    let named = rows.as_array().expect("rows").iter();
    let rows: Vec<Value> =
        named.map(|row| json!({"pearls": row, "form": "line", "label": null})).collect();
    let mut all = vec![("/pearls", json!(pearls)), ("/scene/rows", json!(rows))];
    all.extend_from_slice(changes);
    common::recipe("akoya-rg-north-window-white", &all)
}

fn refusal(recipe: &Recipe) -> String {
    Arrangement::new(recipe).expect_err("a refusal").to_string()
}

#[test]
fn all_pearls_lie_on_one_table_around_the_middle_the_first_row_behind() {
    let apart = [("/scene/pitch_mm", json!(11.0)), ("/scene/row_gap_mm", json!(10.0))];
    let recipe = rows(&[9.0, 6.0], &json!([["*0", "*1"], ["*1"]]), &apart);
    let made = Arrangement::new(&recipe).unwrap();
    let centres: Vec<DVec3> = made.places().iter().map(|place| place.centre_mm).collect();
    let expected = [[-5.5, 0.0, -5.0], [5.5, -1.5, -5.0], [0.0, -1.5, 5.0]].map(DVec3::from);
    assert_eq!(centres, expected);
    for place in made.places() {
        assert!((place.centre_mm.y - place.radius_mm + 4.5).abs() < 1e-12);
    }
}

#[test]
fn left_out_distances_leave_room_between_the_largest() {
    let recipe = rows(&[9.0], &json!([["*0", "*0", "*0"], ["*0", "*0"]]), &[]);
    let made = Arrangement::new(&recipe).unwrap();
    let mut nearest_mm = f64::INFINITY;
    for (i, a) in made.places().iter().enumerate() {
        for b in &made.places()[..i] {
            nearest_mm = nearest_mm.min(a.centre_mm.distance(b.centre_mm));
        }
    }
    assert!(9.0 < nearest_mm && nearest_mm < 1.2 * 9.0, "{nearest_mm}");
}

#[test]
fn a_view_left_open_shows_every_pearl() {
    for projection in ["orthographic", "perspective"] {
        let changes = [
            ("/scene/camera/projection", json!(projection)),
            ("/scene/camera/distance_mm", json!(150.0)),
            ("/scene/camera/field_mm", Value::Null),
        ];
        let recipe = rows(&[9.0, 6.0], &json!([["*0", "*1", "*0"], ["*1"]]), &changes);
        let made = Arrangement::new(&recipe).unwrap();
        let camera = made.camera();
        for ball in made.balls() {
            let (toward, far_mm) = camera.toward_eye(ball.centre);
            let eye = ball.centre + toward * far_mm.min(1e6);
            for outward in [camera.right(), -camera.right(), camera.up(), -camera.up()] {
                // The outline as a line of sight just beside the ball meets the view.
                let ahead =
                    (eye - ball.centre - outward * 1.02 * ball.radius_mm).dot(camera.back());
                let scale = if far_mm.is_finite() { 150.0 / ahead } else { 1.0 };
                let aside_mm = (ball.centre + outward * 1.02 * ball.radius_mm).dot(outward) * scale;
                assert!(aside_mm < 0.5 * made.field_mm(), "{projection}: {aside_mm}");
            }
        }
    }
}

#[test]
fn what_would_touch_is_refused_in_one_line() {
    let nine = json!([["*0", "*0", "*0", "*0", "*0", "*0", "*0", "*0", "*0"]]);
    let near = [
        ("/scene/camera/projection", json!("perspective")),
        ("/scene/camera/distance_mm", json!(50.0)),
    ];
    let walls = json!({"half_width_mm": 30.0, "height_mm": 200.0, "colour": "#b9b4ab"});
    let window = json!({
        "azimuth_deg": null, "elevation_deg": null, "distance_mm": null,
        "position_mm": [21.0, 0.0, 0.0], "facing": [0.0, 0.0, 1.0], "below_mm": null,
        "width_mm": 300.0, "height_mm": 300.0, "spectrum": "D65", "luminance": 1.0,
    });
    for (recipe, message) in [
        (rows(&[9.0, 6.0], &json!([]), &[]), "has a place for one pearl, not 2"),
        (rows(&[9.0], &json!([["*0", "*3"]]), &[]), "a row has \"*3\"; allowed: \"*0\" to \"*0\""),
        (
            rows(&[9.0], &nine, &[("/scene/pitch_mm", json!(8.9))]),
            "pitch_mm is 8.9; allowed: at least 9 mm",
        ),
        (rows(&[9.0], &nine, &near), "camera.distance_mm is 50.0; allowed: at least 52.92 mm"),
        (
            rows(&[9.0], &nine, &[("/scene/walls", walls)]),
            "walls.half_width_mm is 30.0; allowed: at least 44.1 mm",
        ),
        (
            rows(&[9.0], &nine, &[("/scene/windows", json!([window]))]),
            "windows.0 passes 0 mm from a pearl's centre",
        ),
    ] {
        let found = refusal(&recipe);
        assert!(found.contains(message) && !found.contains('\n'), "{found}");
    }
}
