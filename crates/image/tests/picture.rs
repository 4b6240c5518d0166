//! Laws of the whole picture.

use std::{f64::consts::PI, sync::Arc};

use glam::DVec3;
use nacreous_colour::{Illuminant, Observer, RgbSpace, SAMPLES, delta_e_2000, lab_from_xyz};
use nacreous_image::{
    Ball, CHANNELS, Camera, Grain, IlluminantPearl, Irradiance, Lamp, Light, Lit, Model, PARTS,
    Pearl, Place, Progress, Projection, Reflections, Rings, Sampler, Skin, Sky, Source,
    Surroundings, Table, TorranceSparrow, direction,
};
use nacreous_nacre::{Growth, Index, LayerStack, Season};
use nacreous_optics::IlluminantModel;

const SIZE: usize = 96;
const RADIUS_MM: f64 = 4.0;
const FIELD_MM: f64 = 9.0;
const MODEL: IlluminantModel =
    IlluminantModel { coherence_nm: 5000.0, threshold: 0.05, diffuse_loss: 0.03 };
const TABLE: Option<Table> =
    Some(Table::Checker { colour: [0.8; 3], second_colour: [0.1; 3], check_mm: 2.0 });

fn rendered(
    pearl: Pearl,
    surroundings: &Arc<Lit>,
    camera: &Camera,
    samples_side: usize,
    progress: &Progress,
) -> Option<Vec<f32>> {
    let (pearls, around) = (vec![pearl], Arc::clone(surroundings));
    let models: Vec<Arc<Model>> = pearls.iter().map(|pearl| Arc::clone(&pearl.model)).collect();
    let reflections = Arc::new(Reflections::new(&models, &around, camera, SIZE));
    Sampler::new(pearls, around, *camera, (SIZE, samples_side), reflections).rows(0..SIZE, progress)
}

fn december() -> LayerStack {
    let growth = Growth {
        days: 245,
        season: Season { peak_day: 108.0, width_days: 45.0 },
        thickness_winter_nm: 400.0,
        thickness_summer_nm: 700.0,
        layers_winter: 1.0,
        layers_summer: 3.0,
        thickness_noise_nm: 20.0,
        layers_noise: 0.5,
    };
    let layers = growth.grow(7).unwrap();
    let thickness_nm = layers.deposits().iter().rev().map(|d| d.thickness_nm).collect();
    let index = |n| Index::new("medium", n, 0.0).unwrap();
    LayerStack::new(thickness_nm, 20.0, index(1.53), index(1.43), index(1.0), index(1.53)).unwrap()
}

fn source(intensity: f64) -> Source {
    Source { spectrum: Illuminant::E.spectrum(), intensity }
}

fn light(lamps: &[Source], sky: f64) -> Light {
    Light::new(lamps, sky, None, Observer::Cie1931).unwrap()
}

/// A pearl with a lamp of brightness 1 at each place.
struct Set {
    surroundings: Arc<Lit>,
    rings: Arc<Rings>,
    facets: TorranceSparrow,
}

impl Set {
    fn new(places: &[Place], table: Option<Table>, sky: f64, facets: TorranceSparrow) -> Self {
        let light = light(&vec![source(1.0); places.len()], sky);
        let lamps = places.iter().map(|&place| {
            let brightness = light.brightness(&source(1.0)).unwrap();
            Lamp::new(place, 0.05, brightness).resolved_for(&facets.microfacets.into())
        });
        let rings = Rings::new(&december(), &MODEL, &light, &Progress::default()).unwrap().unwrap();
        let even = Sky::Gradient { horizon: [sky; 3], zenith: [sky; 3] };
        let surroundings =
            Surroundings::new(table, None, even, lamps.collect(), vec![Ball::alone(RADIUS_MM)]);
        let surroundings = Arc::new(surroundings.settled(false));
        Self { surroundings, rings: Arc::new(rings), facets }
    }

    fn pearl(&self) -> Pearl {
        Self::with(self.model())
    }

    fn with(model: IlluminantPearl) -> Pearl {
        let grain = Grain { hue_rad: 0.0, chroma: 0.0, value: 0.0, relief_rad: 0.0 };
        Pearl {
            model: Arc::new(Model::Illuminant(Box::new(model))),
            skin: Skin { texture: None, grain, coat: None },
        }
    }

    fn model(&self) -> IlluminantPearl {
        IlluminantPearl {
            rings: Arc::clone(&self.rings),
            mixing: 0.3,
            body_colour: [0.8, 0.75, 0.7],
            irradiance: Irradiance::new(&self.surroundings, 0),
            facets: self.facets,
            mirror_weight: 1.0,
            falloff_mm: 40.0,
        }
    }

    fn picture(&self) -> Vec<f32> {
        let camera = Camera::new(Projection::Orthographic, 0.3, 0.0, FIELD_MM);
        rendered(self.pearl(), &self.surroundings, &camera, 4, &Progress::default()).unwrap()
    }
}

fn part<'a>(pixels: &'a [f32], name: &str) -> impl Iterator<Item = &'a [f32]> {
    let channels = PARTS.iter().find(|part| part.0 == name).unwrap().1.clone();
    pixels.chunks_exact(CHANNELS).map(move |pixel| &pixel[channels.clone()])
}

#[test]
fn moving_a_lamp_changes_no_bit_of_the_interference() {
    let facets = TorranceSparrow::new(0.05, 1.53, 0.1);
    let at = |place| Set::new(&[place], TABLE, 0.2, facets).picture();
    let left = at(Place::Direction(direction(-0.8, 0.7)));
    let near = at(Place::Position(DVec3::new(30.0, 25.0, -10.0)));
    assert!(part(&left, "interference").eq(part(&near, "interference")));
    assert!(part(&left, "diffuse").ne(part(&near, "diffuse")));
}

#[test]
fn equal_view_angle_means_equal_interference_colour() {
    let pixels = Set::new(&[], TABLE, 0.5, TorranceSparrow::new(0.05, 1.53, 0.1)).picture();
    let rings: Vec<&[f32]> = part(&pixels, "interference").collect();
    for row in 0..SIZE {
        for column in 0..SIZE {
            let pixel = rings[row * SIZE + column];
            let turned = rings[column * SIZE + (SIZE - 1 - row)];
            let mirrored = rings[row * SIZE + (SIZE - 1 - column)];
            for (a, (b, c)) in pixel.iter().zip(turned.iter().zip(mirrored)) {
                assert!((a - b).abs() < 1e-6 && (a - c).abs() < 1e-6, "{row} {column}");
            }
        }
    }
}

#[test]
fn a_balls_highlight_holds_a_quarter_of_the_light_that_meets_its_disc() {
    // A ball with narrow facets scatters evenly: each solid angle gets R^2 / 4 of the irradiance,
    // times the reflectance at half the angle between lamp and eye. Irradiance of brightness 1 is pi.
    for apart_rad in [0.4_f64, 0.9, 1.5] {
        let facets = TorranceSparrow::new(0.02, 1.53, 0.1);
        let toward = direction(apart_rad, 0.3);
        let pixels = Set::new(&[Place::Direction(toward)], None, 0.0, facets).picture();
        let pixel_mm2 = (FIELD_MM / SIZE as f64).powi(2);
        let highlight: f64 =
            part(&pixels, "mirror").map(|mirror| f64::from(mirror[1])).sum::<f64>() * pixel_mm2;
        let half_angle = toward.dot(direction(0.0, 0.3)).acos() / 2.0;
        let expected = PI * RADIUS_MM.powi(2) / 4.0 * facets.reflectance(half_angle.cos());
        assert!((highlight / expected - 1.0).abs() < 0.02, "{apart_rad}: {highlight} {expected}");
    }
}

#[test]
fn a_mirrored_table_fades_with_distance() {
    // What the mirrored pattern adds is the difference to the same table with its colours swapped.
    let swapped = Some(Table::Checker { colour: [0.1; 3], second_colour: [0.8; 3], check_mm: 2.0 });
    let camera = Camera::new(Projection::Orthographic, 0.1, 0.0, FIELD_MM);
    let mirrored = |table, falloff_mm: f64| -> Vec<f32> {
        let set = Set::new(&[], table, 0.5, TorranceSparrow::new(0.05, 1.53, 0.1));
        let pearl = Set::with(IlluminantPearl { falloff_mm, ..set.model() });
        let pixels = rendered(pearl, &set.surroundings, &camera, 2, &Progress::default());
        part(&pixels.unwrap(), "mirror").map(|mirror| mirror[1]).collect()
    };
    let contrast = |falloff_mm: f64| -> f32 {
        let (one, other) = (mirrored(TABLE, falloff_mm), mirrored(swapped, falloff_mm));
        one.iter().zip(&other).map(|(a, b)| (a - b).abs()).sum()
    };
    let (short, middle, clear) = (contrast(2.0), contrast(10.0), contrast(1e6));
    assert!(short < 0.6 * middle && middle < 0.8 * clear, "{short} {middle} {clear}");
}

#[test]
fn steps_between_rings_are_far_below_what_can_be_seen() {
    let light = light(&[source(1.0)], 0.0);
    let rings = Rings::new(&december(), &MODEL, &light, &Progress::default()).unwrap().unwrap();
    let white = RgbSpace::Srgb.white_xyz();
    let wavelength_nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let lab = |rgb| lab_from_xyz(RgbSpace::Srgb.xyz_from_rgb(rgb), white);
    let exact = |cosine: f64| {
        let spectra = MODEL.spectra(&december(), &[cosine.acos()], &wavelength_nm).unwrap();
        light.rgb_inside(<&[f64; SAMPLES]>::try_from(spectra.as_slice()).unwrap())
    };
    // Rings are normalised; the ratio at one node of their table says by how much.
    let scale = rings.colour(1.0)[1] / exact(1.0)[1];
    for step in 1..60 {
        let cosine = f64::from(step) / 60.0 + 0.5 / 256.0;
        let truth = lab(exact(cosine).map(|channel| channel * scale));
        let difference = delta_e_2000(lab(rings.colour(cosine)), truth);
        assert!(difference < 0.2, "{cosine}: {difference}");
    }
}

#[test]
fn nothing_lit_is_black_and_finite() {
    let pixels = Set::new(&[], TABLE, 0.0, TorranceSparrow::new(0.05, 1.53, 0.1)).picture();
    for name in ["interference", "diffuse", "mirror", "surroundings"] {
        assert!(part(&pixels, name).flatten().all(|&channel| channel == 0.0), "{name}");
    }
    assert!(part(&pixels, "coverage").any(|coverage| coverage[0] > 0.999_999));
}

#[test]
fn the_silhouette_covers_the_area_of_a_disc() {
    let pixels = Set::new(&[], None, 0.5, TorranceSparrow::new(0.05, 1.53, 0.1)).picture();
    let covered: f64 = part(&pixels, "coverage").map(|share| f64::from(share[0])).sum();
    let area_mm2 = covered * (FIELD_MM / SIZE as f64).powi(2);
    assert!((area_mm2 / (PI * RADIUS_MM * RADIUS_MM) - 1.0).abs() < 1e-3, "{area_mm2}");
}

#[test]
fn a_stopped_render_gives_no_picture() {
    let set = Set::new(&[], None, 0.5, TorranceSparrow::new(0.05, 1.53, 0.1));
    let camera = Camera::new(Projection::Orthographic, 0.0, 0.0, FIELD_MM);
    let progress = Progress::default();
    progress.stop();
    assert!(rendered(set.pearl(), &set.surroundings, &camera, 1, &progress).is_none());
}

#[test]
fn without_coherence_the_rings_have_one_hue() {
    let light = light(&[source(1.0)], 0.0);
    let model = IlluminantModel { coherence_nm: 0.0, ..MODEL };
    let rings = Rings::new(&december(), &model, &light, &Progress::default()).unwrap().unwrap();
    let ratio = |cosine: f64| {
        let [red, _, blue] = rings.colour(cosine);
        red / blue
    };
    assert!((ratio(1.0) / ratio(0.4) - 1.0).abs() < 0.02, "{} {}", ratio(1.0), ratio(0.4));
}
