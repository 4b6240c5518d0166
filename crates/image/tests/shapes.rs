//! Laws of pearls that are not round: a lossless one in even light is invisible, whatever its shape and its coat; rays meet
//! the surface that normals and silhouettes are of.

use std::sync::{Arc, atomic::AtomicBool};

use glam::DVec3;
use nacreous_colour::{Illuminant, Observer};
use nacreous_image::{
    BANDS, Ball, BlemishKind, Blemishes, Body, CHANNELS, Camera, Coat, CoatParameters, Drill, Film,
    FormParameters, Grain, Light, Lit, Microfacets, Model, NucleusBands, Pearl, Pose, Progress,
    Projection, Reflections, Response, Sampler, Skin, Sky, Solid, Surface, Surroundings, Transport,
    Waviness,
};
use nacreous_nacre::{Index, LayerStack, Medium};

const RADIUS_MM: f64 = 4.0;

/// A form of every kind.
fn forms() -> Vec<FormParameters> {
    let round = FormParameters::ROUND;
    vec![
        FormParameters { length: 1.35, out_of_round: 0.04, ..round },
        FormParameters { length: 0.75, flattening: 0.5, ..round },
        FormParameters { length: 1.5, taper: 1.2, ..round },
        FormParameters { lumps: 0.1, lump_rad: 0.9, seed: 3, ..round },
        FormParameters { length: 1.2, circles: 4, circle_depth: 0.06, seed: 5, ..round },
    ]
}

fn pose() -> Pose {
    Pose::new(0.6, 1.2, 0.4)
}

fn lossless(pearl: &Arc<Solid>) -> (Lit, Response) {
    let named = |name| Medium::named(name).unwrap();
    let air = Index::new("air", 1.0, 0.0).unwrap();
    let layers = (0..40).map(|i| 340.0 + f64::from((i * 37 + i * i * 7) % 41) - 20.0).collect();
    let stack =
        LayerStack::new(layers, 20.0, named("aragonite"), named("chitin"), air, named("aragonite"))
            .unwrap();
    let waviness = Waviness::new(0.08);
    let film = Film::new(&[stack], waviness.parts(), &AtomicBool::new(false)).unwrap().unwrap();
    let surface = Surface::new(&film, Microfacets::grooves(0.06), waviness);
    let light = Light::new(&[], 1.0, Some(Illuminant::D65.spectrum()), Observer::Cie1931).unwrap();
    let body = Body { reflectance: [1.0; BANDS], spread: 0.1 };
    let response =
        Response::new((std::slice::from_ref(&surface), 1.0), &body, &light.palette(), &[]);
    let sky = Sky::Gradient { horizon: [1.0; 3], zenith: [1.0; 3] };
    let ball = Ball { hull: Some(pearl.hull()), ..Ball::alone(RADIUS_MM) };
    let around = Surroundings::new(None, None, sky, vec![], vec![ball]);
    (around.with_solids(vec![Some(Arc::clone(pearl))]).settled(false), response)
}

fn coat() -> Coat {
    let counts = vec![(BlemishKind::Pit, 6), (BlemishKind::Bump, 6), (BlemishKind::Wrinkle, 3)];
    Coat::new(CoatParameters {
        radius_mm: RADIUS_MM,
        pose: pose(),
        seed: 1,
        thickness_spread: 0.0,
        patch_mm: 3.0,
        banding: 0.0,
        liveliness: 0.0,
        hammering_rad: 0.03,
        dent_mm: 0.8,
        terrace_mm: 0.1,
        step_mm: 4e-4,
        blemishes: Blemishes { counts, size_mm: 0.4, depth_mm: 0.01, area: None, seed: 2 },
        nucleus: NucleusBands { contrast: 0.0, band_mm: 1.0 },
        drill: Drill::NONE,
    })
}

/// The greatest and the mean difference from 1 of the light of a lossless pearl's picture in even light.
fn seen_in_even_light(form: &FormParameters, coat: Option<Coat>) -> (f64, f64) {
    let solid = Arc::new(Solid::new(form, pose(), RADIUS_MM));
    let (lit, response) = lossless(&solid);
    let response = Arc::new(response);
    let side = 3;
    let model = |lit: &Lit| Model::Transport(Box::new(Transport::new(&response, lit, 0, side)));
    let glow = model(&lit).glow(&lit, 0);
    let lit = lit.with_glows(vec![glow], false);
    let grain = Grain { hue_rad: 0.0, chroma: 0.0, value: 0.0, relief_rad: 0.0 };
    let coat = coat.map(Arc::new);
    let pearl = Pearl { model: Arc::new(model(&lit)), skin: Skin { texture: None, grain, coat } };
    let camera = Camera::new(Projection::Perspective { distance_mm: 60.0 }, 0.4, 0.3, 14.0);
    let (lit, size_px, pearls) = (Arc::new(lit), 48, vec![pearl]);
    let reflections = Arc::new(Reflections::new(&models_of(&pearls), &lit, &camera, size_px));
    let sampler = Sampler::new(pearls, lit, camera, (size_px, side), reflections);
    let pixels = sampler.rows(0..size_px, &Progress::default()).unwrap();
    let off = |pixel: &[f32]| {
        let light: f32 = [1, 4, 7, 10].iter().map(|&part| pixel[part]).sum();
        f64::from(light - 1.0).abs()
    };
    let offs: Vec<f64> = pixels.chunks_exact(CHANNELS).map(off).collect();
    let most = offs.iter().copied().fold(0.0, f64::max);
    (most, offs.iter().sum::<f64>() / offs.len() as f64)
}

#[test]
fn a_lossless_pearl_of_any_shape_cannot_be_seen_in_even_light() {
    for form in forms() {
        let (most, mean) = seen_in_even_light(&form, None);
        assert!(most < 1e-3, "{form:?}: {most} {mean}");
        let (most, mean) = seen_in_even_light(&form, Some(coat()));
        assert!(most < 1e-3, "{form:?}, with its coat: {most} {mean}");
    }
}

#[test]
fn rays_meet_the_surface_where_its_normal_leans_towards_them() {
    for form in forms() {
        let solid = Solid::new(&form, pose(), RADIUS_MM);
        let mut met = 0;
        for i in 0..400 {
            let t = f64::from(i);
            let from =
                30.0 * DVec3::new((0.7 * t).sin(), (0.31 * t).cos(), (0.13 * t).sin()).normalize();
            let aim = 3.5 * DVec3::new((1.1 * t).cos(), (1.7 * t).sin(), (2.3 * t).cos());
            let along = (aim - from).normalize();
            let Some(hit) = solid.hit(from, along) else {
                assert!(solid.square(from, along) < 1e-6, "{form:?} {i}");
                continue;
            };
            met += 1;
            let towards = hit.point.normalize();
            let (place, normal) = solid.surface(towards);
            assert!((place - hit.point).length() < 1e-8, "{form:?} {i}");
            assert!(normal.dot(along) < 1e-6 && (normal - hit.normal).length() < 1e-9);
            // Nothing lies before it.
            let far = (hit.point - from).dot(along);
            let outside = (0..300).map(|k| from + along * (far * f64::from(k) / 300.5));
            for point in outside {
                let surface = solid.surface(point.normalize()).0.length();
                assert!(point.length() > surface - 1e-9, "{form:?} {i}");
            }
        }
        assert!(met > 150, "{form:?}: {met}");
    }
}

#[test]
fn normals_are_those_of_differences_between_places() {
    for form in forms() {
        let solid = Solid::new(&form, pose(), RADIUS_MM);
        for i in 0..200 {
            let t = f64::from(i);
            let towards =
                DVec3::new((0.7 * t).sin(), (0.31 * t).cos(), (0.13 * t).sin()).normalize();
            let (u, v) = towards.any_orthonormal_pair();
            let place = |aside: DVec3| solid.surface((towards + aside).normalize()).0;
            let along = |axis: DVec3| place(axis * 1e-5) - place(axis * -1e-5);
            let numeric = along(u).cross(along(v)).normalize();
            assert!((numeric - solid.surface(towards).1).length() < 1e-6, "{form:?} {i}");
        }
    }
}

fn models_of(pearls: &[Pearl]) -> Vec<Arc<Model>> {
    pearls.iter().map(|pearl| Arc::clone(&pearl.model)).collect()
}
