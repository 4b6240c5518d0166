//! Laws of light inside the pearl: nothing is gained or lost, a body without spread is matt, one with
//! much of it shines alike on all sides.

use std::{
    f64::consts::PI,
    sync::{Arc, atomic::AtomicBool},
};

use glam::DVec3;
use nacreous_colour::{Illuminant, Observer};
use nacreous_image::{
    Arounds, BANDS, Ball, Bands, Body, Camera, Film, Grain, Lamp, Light, Lit, Local, Microfacets,
    Model, Panorama, Pearl, Place, Projection, Response, Sight, Skin, Sky, Source, Spread, Surface,
    Surroundings, Transport, Waviness,
};
use nacreous_nacre::{Index, LayerStack, Medium};

const SIDE: usize = 4;

/// Disordered uniaxial nacre: thicknesses that a plain rule throws about.
fn film(waviness: Waviness) -> Film {
    let named = |name| Medium::named(name).unwrap();
    let air = Index::new("air", 1.0, 0.0).unwrap();
    let column = |column: usize| {
        let noise = |i: usize| ((i * 37 + column * 101 + i * i * 7) % 41) as f64 - 20.0;
        let layers = (0..60).map(|i| 340.0 + noise(i)).collect();
        LayerStack::new(layers, 20.0, named("aragonite"), named("chitin"), air, named("aragonite"))
            .unwrap()
    };
    let columns: Vec<LayerStack> = (0..16).map(column).collect();
    Film::new(&columns, waviness.parts(), &AtomicBool::new(false)).unwrap().unwrap()
}

fn level(microfacets: Microfacets) -> Surface {
    waving(microfacets, 0.0)
}

fn waving(microfacets: Microfacets, slope_rad: f64) -> Surface {
    let waviness = Waviness::new(slope_rad);
    Surface::new(&film(waviness), microfacets, waviness)
}

struct Scene {
    surroundings: Lit,
    light: Light,
    lamps: Vec<Bands>,
}

/// A sky of two colours, alike if they are, and a white lamp if a direction is given.
fn scene(horizon: [f64; 3], zenith: [f64; 3], lamp: Option<(DVec3, f64)>) -> Scene {
    let source = Source { spectrum: Illuminant::D65.spectrum(), intensity: 1.0 };
    let sources: Vec<Source> = lamp.iter().map(|_| source.clone()).collect();
    let white = Some(Illuminant::D65.spectrum());
    let light = Light::new(&sources, 1.0, white, Observer::Cie1931).unwrap();
    let lamps = lamp.map(|(direction, radius_rad)| {
        Lamp::new(Place::Direction(direction), radius_rad, light.brightness(&source).unwrap())
    });
    let sky = Sky::Gradient { horizon, zenith };
    let surroundings = under(sky, lamps.into_iter().collect());
    let lamps = sources.iter().map(|source| light.bands(source).unwrap()).collect();
    Scene { surroundings, light, lamps }
}

/// A pearl of 8 mm under a sky and lamps.
fn under(sky: Sky, lamps: Vec<Lamp>) -> Lit {
    Surroundings::new(None, None, sky, lamps, vec![Ball::alone(4.0)]).settled(false)
}

impl Scene {
    fn pearl(&self, surface: &Surface, body: &Body) -> Pearl {
        let (palette, around) = (self.light.palette(), &self.surroundings);
        let response = Arc::new(Response::new(
            (std::slice::from_ref(surface), 1.0),
            body,
            &palette,
            &self.lamps,
        ));
        let transport = Transport::new(&response, around, 0, SIDE);
        let grain = Grain { hue_rad: 0.0, chroma: 0.0, value: 0.0, relief_rad: 0.0 };
        Pearl {
            model: Arc::new(Model::Transport(Box::new(transport))),
            skin: Skin { texture: None, grain, coat: None },
        }
    }

    /// Light from inside and light mirrored, mean over a pixel's samples, where lines of sight along -z
    /// meet the pearl `x`, `y` radii from its middle.
    fn seen(&self, pearl: &Pearl, x: f64, y: f64) -> ([f64; 3], [f64; 3]) {
        self.seen_with(pearl, (x, y), SIDE)
    }

    /// The same with more samples along a pixel's side.
    fn seen_with(&self, pearl: &Pearl, (x, y): (f64, f64), side: usize) -> ([f64; 3], [f64; 3]) {
        let camera = Camera::new(Projection::Orthographic, 0.0, 0.0, 8.0);
        let ray = camera.ray(x, y);
        let hit = self.surroundings.balls[0].hit(&ray).unwrap();
        let (mut inside, mut mirror) = ([0.0; 3], [0.0; 3]);
        let spread = Spread::of_square(0.01 / self.surroundings.balls[0].radius_mm, hit.cos_view);
        for part in 0..side {
            let view = -ray.along;
            let (ball, pixel_mm, part, around) = (0, 0.01, (part, side), Arounds::default());
            let (outward, local) = (hit.normal, Local::EVEN);
            let sight = Sight {
                ball,
                hit,
                outward,
                local,
                grain: None,
                view,
                pixel_mm,
                spread,
                part,
                around,
            };
            let parts = pearl.shade(&self.surroundings, &sight);
            for i in 0..3 {
                inside[i] += (parts.interference[i] + parts.diffuse[i]) / side as f64;
                mirror[i] += parts.mirror[i] / side as f64;
            }
        }
        (inside, mirror)
    }
}

const PLACES: [(f64, f64); 6] =
    [(0.0, 0.0), (0.4, -0.3), (-0.7, 0.1), (0.1, 0.85), (-0.65, -0.68), (0.0, -0.97)];

fn white(spread: f64) -> Body {
    Body { reflectance: [1.0; BANDS], spread }
}

#[test]
fn a_lossless_pearl_in_even_light_cannot_be_seen() {
    let furnace = scene([1.0; 3], [1.0; 3], None);
    for (microfacets, slope_rad) in [
        (Microfacets::grooves(0.012), 0.0),
        (Microfacets::grooves(0.25), 0.0),
        (Microfacets::ggx(0.1), 0.0),
        (Microfacets::ggx(0.4), 0.0),
        (Microfacets::grooves(0.012), 0.02),
        (Microfacets::grooves(0.05), 0.3),
        (Microfacets::ggx(0.1), 0.12),
    ] {
        let surface = waving(microfacets, slope_rad);
        for spread in [0.0, 0.3, 1000.0] {
            let pearl = furnace.pearl(&surface, &white(spread));
            for (x, y) in PLACES {
                let (inside, mirror) = furnace.seen(&pearl, x, y);
                for i in 0..3 {
                    let light = inside[i] + mirror[i];
                    assert!(
                        (light - 1.0).abs() < 0.005,
                        "{microfacets:?} {spread} {x} {y}: {light}"
                    );
                }
            }
        }
    }
}

#[test]
fn what_is_missing_in_even_light_is_what_the_body_absorbs() {
    // Light of each direction enters, and is absorbed with the chance that the body keeps it before the
    // surface lets it out: counted round by round, it is the absorptance of a beam that comes the way
    // that the eye looks.
    let furnace = scene([1.0; 3], [1.0; 3], None);
    let reflectance: Bands = std::array::from_fn(|band| 0.95 - 0.015 * band as f64);
    let surface = level(Microfacets::grooves(0.05));
    let n2 = 0.5 * (1.683_f64.powi(2) + 1.530_f64.powi(2));
    let out = surface.entering_from_all_sides().map(|share| share / n2);
    let absorbed: Bands = std::array::from_fn(|band| {
        let (mut inside, mut kept) = (1.0, 0.0);
        for _ in 0..3000 {
            kept += inside * (1.0 - reflectance[band]);
            inside *= reflectance[band] * (1.0 - out[band]);
        }
        kept
    });
    let palette = furnace.light.palette();
    let pearl = furnace.pearl(&surface, &Body { reflectance, spread: 0.2 });
    for (x, y) in PLACES {
        let cosine = (1.0 - x * x - y * y).sqrt();
        let absorptance: Bands =
            std::array::from_fn(|band| surface.entering(cosine)[band] * absorbed[band]);
        let light = palette.bands([1.0; 3]);
        let lost = palette.rgb(&std::array::from_fn(|band| light[band] * absorptance[band]));
        let (inside, mirror) = furnace.seen(&pearl, x, y);
        for i in 0..3 {
            let missing = 1.0 - inside[i] - mirror[i];
            assert!(lost[i] > 0.02 && (missing - lost[i]).abs() < 0.006, "{missing} {}", lost[i]);
        }
    }
}

/// Light of a sky and a lamp that enters where the normal is `normal`, in linear RGB after a filter by
/// band: the plain integral over all directions.
fn entering(scene: &Scene, surface: &Surface, normal: DVec3, lamp: Option<DVec3>) -> Bands {
    let palette = scene.light.palette();
    let rows = 200;
    let mut sum = [0.0; BANDS];
    for row in 0..rows {
        let theta = (f64::from(row) + 0.5) * PI / f64::from(rows);
        for column in 0..2 * rows {
            let phi = (f64::from(column) + 0.5) * PI / f64::from(rows);
            let along = DVec3::new(theta.sin() * phi.cos(), theta.cos(), theta.sin() * phi.sin());
            let cosine = along.dot(normal);
            if cosine > 0.0 {
                let light = palette.bands(scene.surroundings.sky.radiance(along, 0.0));
                let share = cosine * theta.sin() * (PI / f64::from(rows)).powi(2) / PI;
                let enters = surface.entering(cosine);
                for band in 0..BANDS {
                    sum[band] += share * enters[band] * light[band];
                }
            }
        }
    }
    if let Some(cosine) = lamp.map(|lamp| lamp.dot(normal)).filter(|cosine| *cosine > 0.0) {
        let enters = surface.entering(cosine);
        for band in 0..BANDS {
            sum[band] += cosine * enters[band] * scene.lamps[0][band];
        }
    }
    sum
}

#[test]
fn without_spread_the_body_is_matt() {
    let lamp = DVec3::new(0.5, 0.7, 0.5).normalize();
    let scene = scene([0.3, 0.2, 0.1], [0.5, 0.7, 1.0], Some((lamp, 0.02)));
    let surface = level(Microfacets::grooves(0.05));
    let reflectance: Bands = std::array::from_fn(|band| 0.5 + 0.01 * band as f64);
    let pearl = scene.pearl(&surface, &Body { reflectance, spread: 0.0 });
    let leaving = surface.leaving(&reflectance);
    for (x, y) in PLACES {
        let cosine = (1.0 - x * x - y * y).sqrt();
        let normal = DVec3::new(x, y, cosine);
        let light = entering(&scene, &surface, normal, Some(lamp));
        let leaves = surface.entering(cosine);
        let direct = scene
            .light
            .palette()
            .rgb(&std::array::from_fn(|band| light[band] * leaving[band] * leaves[band]));
        let (inside, _) = scene.seen(&pearl, x, y);
        for i in 0..3 {
            assert!((inside[i] - direct[i]).abs() < 0.005, "{x} {y}: {inside:?} {direct:?}");
        }
    }
}

#[test]
fn much_spread_is_the_illuminant_limit() {
    // Every point sends light in every direction: it depends on the view angle alone, not on the lamp's
    // place (paper 3.1).
    let lit = |lamp: DVec3| scene([0.2; 3], [0.2; 3], Some((lamp.normalize(), 0.1)));
    let lamps = [DVec3::Y, DVec3::new(-1.0, -0.2, 0.3), DVec3::NEG_Z];
    let surface = level(Microfacets::grooves(0.05));
    let all = surface.entering_from_all_sides();
    for scene in lamps.map(|lamp| Box::new(lit(lamp))) {
        let pearl = scene.pearl(&surface, &white(1000.0));
        for angle in 0..12 {
            let (y, x) = (f64::from(angle) * PI / 6.0).sin_cos();
            let (inside, _) = scene.seen(&pearl, 0.6 * x, 0.6 * y);
            // A ball takes in a quarter of what a lamp's light would be on all its surface, and all of
            // the sky's; a lossless one lets it out again evenly.
            let palette = scene.light.palette();
            let sky = palette.bands([0.2; 3]);
            let mean = surface_mean(&surface, &scene);
            let leaves = surface.entering(0.8);
            let expected = palette.rgb(&std::array::from_fn(|band| {
                leaves[band] * (sky[band] + mean[band] / all[band])
            }));
            for i in 0..3 {
                assert!((inside[i] - expected[i]).abs() < 1e-4, "{inside:?} {expected:?}");
            }
        }
    }
}

/// The mean over the ball of a lamp's light that enters: the integral over the cosine of incidence.
fn surface_mean(surface: &Surface, scene: &Scene) -> Bands {
    let steps = 2000;
    let mut mean = [0.0; BANDS];
    for step in 0..steps {
        let cosine = (f64::from(step) + 0.5) / f64::from(steps);
        let enters = surface.entering(cosine);
        for band in 0..BANDS {
            mean[band] += 0.5 * cosine * enters[band] * scene.lamps[0][band] / f64::from(steps);
        }
    }
    mean
}

/// What all facets mirror of sky and lamp where the normal is `normal`, seen along -z: the plain integral
/// of D G R / (4 cos) over all light.
fn mirrored_by_all(
    scene: &Scene,
    surface: &Surface,
    normal: DVec3,
    lamp: Option<DVec3>,
) -> [f64; 3] {
    let palette = scene.light.palette();
    let mut all = [0.0; 3];
    let rows = 400;
    for row in 0..rows {
        let theta = (f64::from(row) + 0.5) * PI / f64::from(rows);
        let solid = theta.sin() * (PI / f64::from(rows)).powi(2);
        for column in 0..2 * rows {
            let phi = (f64::from(column) + 0.5) * PI / f64::from(rows);
            let along = DVec3::new(theta.sin() * phi.cos(), theta.cos(), theta.sin() * phi.sin());
            let mut light = palette.bands(scene.surroundings.sky.radiance(along, 0.0));
            // The lamp: an even disc whose light on a surface that faces it is pi.
            let disc = 2.0 * (1.0 - 0.1_f64.cos());
            if lamp.is_some_and(|lamp| along.dot(lamp) > 0.1_f64.cos()) {
                light = std::array::from_fn(|b| light[b] + scene.lamps[0][b] / disc);
            }
            for lobe in surface.lobes() {
                let Some(glint) = lobe.facets().mirrored(normal, DVec3::Z, along) else { continue };
                let film = lobe.mirrored(glint.cos_half);
                let bands = std::array::from_fn(|b| film[b] * light[b] * glint.share * solid);
                for (sum, part) in all.iter_mut().zip(palette.rgb(&bands)) {
                    *sum += part;
                }
            }
        }
    }
    all
}

/// Places of the pearl that look at the sky, its horizon and the ground.
const MIRRORING: [(f64, f64); 3] = [(0.0, 0.3), (-0.3, 0.4), (0.5, -0.5)];

fn normal_at((x, y): (f64, f64)) -> DVec3 {
    DVec3::new(x, y, (1.0_f64 - x * x - y * y).sqrt())
}

#[test]
fn few_facets_agree_with_all_of_them() {
    let lamp = DVec3::new(-0.4, 0.6, 0.7).normalize();
    let scene = scene([0.2, 0.3, 0.4], [1.0, 0.9, 0.7], Some((lamp, 0.1)));
    for (microfacets, slope_rad) in [
        (Microfacets::grooves(0.1), 0.0),
        (Microfacets::ggx(0.1), 0.0),
        (Microfacets::grooves(0.25), 0.0),
        (Microfacets::grooves(0.1), 0.05),
        (Microfacets::grooves(0.1), 0.15),
    ] {
        let surface = waving(microfacets, slope_rad);
        let pearl = scene.pearl(&surface, &white(0.0));
        for place in MIRRORING {
            let all = mirrored_by_all(&scene, &surface, normal_at(place), Some(lamp));
            let (_, mirror) = scene.seen(&pearl, place.0, place.1);
            for i in 0..3 {
                let error = (mirror[i] - all[i]).abs();
                assert!(
                    error < 0.004 + 0.02 * all[i],
                    "{microfacets:?} {place:?} {mirror:?} {all:?}"
                );
            }
        }
    }
}

#[test]
fn a_panorama_in_high_range_is_mirrored_as_by_brute_force() {
    // A sun ten degrees wide, 60 times as bright as the sky, over squares of ground.
    let (width, height) = (256, 128);
    let pixel = |i: usize| {
        let (row, column) = (i / width, i % width);
        let apart = ((row as f32 - 44.0).powi(2) + (column as f32 - 104.0).powi(2)).sqrt();
        let square = if (row / 8 + column / 8) % 2 == 0 { 0.4 } else { 0.1 };
        match row {
            _ if apart < 3.5 => [40.0, 36.0, 30.0],
            0..64 => [0.5, 0.6, 0.8],
            _ => [square, square * 0.8, square * 0.6],
        }
    };
    let panorama = Panorama::new(width, height, (0..width * height).map(pixel).collect());
    let sky = Sky::Panorama { picture: Arc::new(panorama), rotation_rad: 0.3, intensity: 1.0 };
    let scene = Scene { surroundings: under(sky, vec![]), ..scene([0.0; 3], [0.0; 3], None) };
    for microfacets in [Microfacets::grooves(0.1), Microfacets::ggx(0.15)] {
        let surface = level(microfacets);
        let (palette, around) = (scene.light.palette(), &scene.surroundings);
        let response = Arc::new(Response::new(
            (std::slice::from_ref(&surface), 1.0),
            &white(0.0),
            &palette,
            &[],
        ));
        let many = Transport::new(&response, around, 0, 64);
        let grain = Grain { hue_rad: 0.0, chroma: 0.0, value: 0.0, relief_rad: 0.0 };
        let pearl = Pearl {
            model: Arc::new(Model::Transport(Box::new(many))),
            skin: Skin { texture: None, grain, coat: None },
        };
        for place in MIRRORING {
            let all = mirrored_by_all(&scene, &surface, normal_at(place), None);
            let (_, mirror) = scene.seen_with(&pearl, place, 64);
            for i in 0..3 {
                let error = (mirror[i] - all[i]).abs();
                assert!(
                    error < 0.002 + 0.02 * all[i],
                    "{microfacets:?} {place:?} {mirror:?} {all:?}"
                );
            }
        }
    }
}

#[test]
fn layers_that_hardly_wave_mirror_as_those_that_lie_level() {
    let lamp = DVec3::new(-0.4, 0.6, 0.7).normalize();
    let scene = scene([0.2, 0.3, 0.4], [1.0, 0.9, 0.7], Some((lamp, 0.1)));
    let pearl = |slope_rad| scene.pearl(&waving(Microfacets::grooves(0.1), slope_rad), &white(0.3));
    let (level, nearly) = (pearl(0.0), pearl(0.0005));
    for place in MIRRORING {
        let (of_level, of_nearly) =
            (scene.seen(&level, place.0, place.1), scene.seen(&nearly, place.0, place.1));
        for i in 0..3 {
            assert!((of_level.0[i] - of_nearly.0[i]).abs() < 0.004);
            assert!((of_level.1[i] - of_nearly.1[i]).abs() < 0.004 + 0.01 * of_level.1[i]);
        }
    }
}

#[test]
fn the_surfaces_image_has_no_colour_and_the_layers_have() {
    let chroma = |bands: Bands| {
        let mean = bands.iter().sum::<f64>() / BANDS as f64;
        let square = bands.iter().map(|share| (share - mean).powi(2)).sum::<f64>();
        (square / BANDS as f64).sqrt() / mean
    };
    let surface = waving(Microfacets::grooves(0.03), 0.15);
    let [sharp, layers] = surface.lobes() else { panic!("two lobes") };
    assert!(chroma(sharp.mirrored(0.9)) < 0.05 && chroma(layers.mirrored(0.9)) > 0.2);
}
