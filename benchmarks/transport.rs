//! What a transport picture costs before its first pixel, part by part, in ms on one thread
//! (`cargo bench -p nacreous-image --bench transport`): the pearl `akoya-rg` with `outer_um = 37` under
//! the scene `north-window-white`, 64 columns of some 103 tablets. The grain's texture is left out.

use std::{
    hint::black_box,
    sync::{Arc, atomic::AtomicBool},
    time::Instant,
};

use glam::DVec3;
use nacreous_colour::{Illuminant, Observer, SAMPLES};
use nacreous_image::{
    Ball, Body, Film, Glow, Light, Lit, Microfacets, Model, Palette, Response, Sky, Source,
    Surface, Surroundings, Table, Transport, Waviness, Window,
};
use nacreous_nacre::{Growth, Index, LayerStack, Medium, Season};

const RUNS: usize = 9;
const COLUMNS: u64 = 64;
const OUTER_NM: f64 = 37e3;
/// What the knobs of `akoya-rg` give.
const FACET_SPREAD_RAD: f64 = 0.034_733;
const WAVINESS_RAD: f64 = 0.05;
const INSIDE_SPREAD: f64 = 0.116_3;

fn main() {
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
    pool.expect("a pool of one thread").install(print_parts);
}

/// The least of some runs of each part, and their sum.
fn print_parts() {
    let mut best: Vec<(&str, f64)> = Vec::new();
    for _ in 0..RUNS {
        let parts = one_run();
        if best.is_empty() {
            best = parts;
        } else {
            for (best, part) in best.iter_mut().zip(parts) {
                best.1 = best.1.min(part.1);
            }
        }
    }
    for (name, ms) in &best {
        println!("{name:12} {ms:7.2} ms");
    }
    println!("{:12} {:7.2} ms", "all", best.iter().map(|part| part.1).sum::<f64>());
}

fn one_run() -> Vec<(&'static str, f64)> {
    let mut parts = Vec::new();
    let (around, palette) = scene();
    let columns = timed(&mut parts, "growth", columns);
    let never = AtomicBool::new(false);
    let waviness = Waviness::new(WAVINESS_RAD);
    let film = timed(&mut parts, "film", || Film::new(&columns, waviness.parts(), &never));
    let film = film.expect("media known in the light").expect("never stopped");
    let microfacets = Microfacets::grooves(FACET_SPREAD_RAD);
    let surface = timed(&mut parts, "surface", || Surface::new(&film, microfacets, waviness));
    let response = timed(&mut parts, "response", || response(&surface, &palette));
    let around = timed(&mut parts, "settle", || around.settled(true));
    let first = timed(&mut parts, "pearl", || pearl(&response, &around));
    let glow: Glow = timed(&mut parts, "glow", || first.glow(&around, 0));
    let around = timed(&mut parts, "settle again", || around.with_glows(vec![glow], true));
    timed(&mut parts, "pearl again", || pearl(&response, &around));
    parts
}

fn timed<T>(
    parts: &mut Vec<(&'static str, f64)>,
    name: &'static str,
    work: impl FnOnce() -> T,
) -> T {
    let begin = Instant::now();
    let done = black_box(work());
    parts.push((name, begin.elapsed().as_secs_f64() * 1e3));
    done
}

/// The outer nacre of `akoya-rg`, grown by seeds 0 to 63.
fn columns() -> Vec<LayerStack> {
    let growth = Growth {
        days: 595,
        season: Season { peak_day: 92.0, width_days: 30.0 },
        thickness_winter_nm: 340.0,
        thickness_summer_nm: 490.0,
        layers_winter: 2.0,
        layers_summer: 3.0,
        thickness_noise_nm: 21.0,
        layers_noise: 0.5,
    };
    let [aragonite, chitin] = ["aragonite", "chitin"].map(|name| Medium::named(name).unwrap());
    let air = Index::new("air", 1.0, 0.0).unwrap();
    let column = |seed| {
        let diary = growth.grow(seed).unwrap();
        let mut depth_nm = 0.0;
        let inward = diary.deposits().iter().rev().map(|deposit| deposit.thickness_nm);
        let outer = inward.take_while(|thickness_nm| {
            depth_nm += thickness_nm + 20.0;
            depth_nm <= OUTER_NM
        });
        let (aragonite, chitin) = (aragonite.clone(), chitin.clone());
        LayerStack::new(outer.collect(), 20.0, aragonite.clone(), chitin, air, aragonite).unwrap()
    };
    (0..COLUMNS).map(column).collect()
}

/// `north-window-white`, not yet settled.
fn scene() -> (Surroundings, Palette) {
    let spectrum = Illuminant::D65.spectrum();
    let sky = Sky::Gradient { horizon: [0.05; 3], zenith: [0.2; 3] };
    let window = |radiance| {
        let middle = DVec3::new(-791.24, 573.58, 212.01);
        let right = DVec3::new(-116.47, 0.0, -434.67);
        Window::new(middle, right, DVec3::new(332.42, 491.49, -89.07), radiance)
    };
    let intensity = 6.0 * window([1.0; 3]).facing_factor(DVec3::ZERO);
    let all = [Source { spectrum: spectrum.clone(), intensity }];
    let light = Light::new(&all, sky.mean_luminance(), None, Observer::Cie1931).unwrap();
    let pane = light.brightness(&Source { spectrum, intensity: 6.0 }).unwrap();
    let table = Table::Cloth {
        colour: [0.905, 0.896, 0.863],
        second_colour: [0.644, 0.631, 0.591],
        weave_mm: 0.4,
    };
    let bare = Surroundings::new(Some(table), None, sky, vec![], vec![Ball::alone(4.0)]);
    (bare.with_windows(vec![window(pane)]), light.palette())
}

fn response(surface: &Surface, palette: &Palette) -> Arc<Response> {
    let body = Body::new(&[0.8; SAMPLES], INSIDE_SPREAD);
    Arc::new(Response::new((std::slice::from_ref(surface), 1.0), &body, palette, &[]))
}

fn pearl(response: &Arc<Response>, around: &Lit) -> Model {
    let transport = Transport::new(response, around, 0, 4);
    Model::Transport(Box::new(transport))
}
