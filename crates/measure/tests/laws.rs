//! What must hold of any picture's measures, whatever it shows.

use nacreous_measure::{Circle, Given, MeasureError, Picture, measure};

const SIDE: usize = 120;

/// A ball with a lamp's image on its upper left, in a colour that changes from middle to rim.
fn ball() -> Vec<f32> {
    let mut light = Vec::with_capacity(3 * SIDE * SIDE);
    for at in 0..SIDE * SIDE {
        let (x, y) = ((at % SIDE) as f64 + 0.5, (at / SIDE) as f64 + 0.5);
        let (right, down) = ((x - 62.3) / 41.0, (y - 58.8) / 41.0);
        let square = right * right + down * down;
        let covered = ((1.0 - square.sqrt()) * 41.0 + 0.5).clamp(0.0, 1.0);
        let lamp = (-40.0 * ((right + 0.3).powi(2) + (down + 0.25).powi(2))).exp();
        for rgb in [0.5 + 0.1 * square, 0.45, 0.5 - 0.1 * square] {
            light.push((0.04 + covered * (rgb + 1.5 * lamp - 0.04)) as f32);
        }
    }
    light
}

fn measured(light: &[f32], given: &Given) -> nacreous_measure::Measures {
    measure(&Picture::new(light, SIDE, SIDE).unwrap(), given).unwrap()
}

fn near(one: f64, other: f64) {
    assert!((one - other).abs() < 1e-3 * other.abs().max(0.1), "{one} {other}");
}

#[test]
fn twice_the_light_with_twice_the_white_measures_the_same() {
    let light = ball();
    let twice: Vec<f32> = light.iter().map(|one| 2.0 * one).collect();
    let one = measured(&light, &Given::default());
    let other = measured(&twice, &Given { white: [2.0; 3], ..Given::default() });
    near(one.size.mean.value, other.size.mean.value);
    near(one.colour.unwrap().chroma.value, other.colour.unwrap().chroma.value);
    let (one, other) = (one.lamp.unwrap(), other.lamp.unwrap());
    near(one.peak, other.peak);
    near(one.half_width_deg.value, other.half_width_deg.value);
}

#[test]
fn a_mirrored_picture_has_mirrored_places_and_the_same_numbers() {
    let light = ball();
    let mirrored: Vec<f32> =
        light.chunks(3 * SIDE).flat_map(|row| row.chunks(3).rev().flatten().copied()).collect();
    let one = measured(&light, &Given::default());
    let other = measured(&mirrored, &Given::default());
    near(one.place.circle.x_px, SIDE as f64 - other.place.circle.x_px);
    near(one.place.circle.y_px, other.place.circle.y_px);
    assert!((one.place.circle.radius_px - 41.0).abs() < 0.1);
    let (one, other) = (one.lamp.unwrap(), other.lamp.unwrap());
    near(one.x_px, SIDE as f64 - other.x_px);
    assert!((one.half_width_deg.value - other.half_width_deg.value).abs() < 0.05);
}

#[test]
fn a_circle_given_roughly_leads_to_the_same_outline_and_scale_to_millimetres() {
    let light = ball();
    let circle = Some(Circle { x_px: 63.5, y_px: 58.0, radius_px: 40.0 });
    let found = measured(&light, &Given::default());
    let given = measured(&light, &Given { circle, mm_per_pixel: Some(0.1), ..Given::default() });
    near(found.place.circle.radius_px, given.place.circle.radius_px);
    near(0.1 * found.size.mean.value, given.size.mean.value);
    assert_eq!((found.size.unit, given.size.unit), ("px", "mm"));
}

#[test]
fn light_that_is_no_number_is_told_with_its_place() {
    let mut light = ball();
    light[3 * (7 * SIDE + 5) + 1] = f32::NAN;
    let error = Picture::new(&light, SIDE, SIDE).unwrap_err();
    assert!(matches!(error, MeasureError::Light { row: 7, column: 5, .. }), "{error}");
    assert!(Picture::new(&light, SIDE, SIDE + 1).is_err());
}

/// A ball of some radius in pixels, its middle off by some, with three spots a share darker, of 0.1 radii.
fn spotted(radius: f64, off: f64, darker: f64) -> nacreous_measure::Measures {
    let side = (2.6 * radius) as usize;
    let middle = side as f64 / 2.0 + off;
    let mut light = Vec::with_capacity(3 * side * side);
    for at in 0..side * side {
        let (right, down) = (
            ((at % side) as f64 + 0.5 - middle) / radius,
            ((at / side) as f64 + 0.5 - middle) / radius,
        );
        let square = right * right + down * down;
        let covered = ((1.0 - square.sqrt()) * radius + 0.5).clamp(0.0, 1.0);
        let spots: f64 = [(0.1, 0.3), (-0.4, 0.0), (0.3, -0.4)]
            .iter()
            .map(|(x, y)| ((0.1 - (right - x).hypot(down - y)) * radius + 0.5).clamp(0.0, 1.0))
            .sum();
        let own = (0.5 + 0.1 * down) * (1.0 - darker * spots);
        light.extend([(0.02 + covered * (own - 0.02)) as f32; 3]);
    }
    measure(&Picture::new(&light, side, side).unwrap(), &Given::default()).unwrap()
}

#[test]
fn the_blemished_area_is_that_of_the_spots_whatever_the_pixels_are() {
    // Of caps whose discs are seen 0.1 radii wide, 0.32, 0.4 and 0.5 radii off the middle.
    let true_area: f64 =
        [0.1_f64, 0.16, 0.25].iter().map(|square| 0.01 / (1.0 - square).sqrt()).sum();
    for (radius, off) in [(60.0, 0.0), (60.0, 0.37), (90.5, 0.2), (140.0, 0.0), (300.0, 0.5)] {
        let found = spotted(radius, off, 0.2).blemishes.unwrap();
        assert_eq!(found.count, 3, "{radius}");
        let seen = found.area.value / 100.0 * 2.0 * found.looked_at;
        assert!((seen / true_area - 1.0).abs() < 0.15, "{radius}, {off}: {seen} for {true_area}");
        let least = spotted(60.0, 0.0, 0.2).blemishes.unwrap().area.value;
        assert!((found.area.value / least - 1.0).abs() < 0.05, "{radius}, {off}");
    }
}

#[test]
fn the_blemished_area_rises_with_what_spots_differ_by_and_does_not_jump() {
    let areas: Vec<f64> = (0..=14)
        .map(|step| spotted(80.0, 0.1, 0.005 * f64::from(step)).blemishes.unwrap().area.value)
        .collect();
    assert!(areas[0] == 0.0 && areas[14] > 2.0, "{areas:?}");
    for pair in areas.windows(2) {
        assert!(pair[1] >= pair[0] - 0.02 && pair[1] - pair[0] < 0.35 * areas[14], "{areas:?}");
    }
}
