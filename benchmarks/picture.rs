//! What a knob costs until its new picture, on one thread, beside which `picture.mjs` prints the browser's:
//!
//!     ./just bench-wasm
//!
//! `akoya-rg` under `north-window-white`, 512 x 512, one sample a pixel. Processor time where Linux tells it.

use std::{hint::black_box, time::Instant};

use nacreous_colour::{Gamut, RgbSpace};
use nacreous_image::{Progress, develop};
use nacreous_render::{Job, Resources, light_of, spec::Recipe};
use serde_json::{Value, json};

const RUNS: usize = 5;
const RECIPE: &str = include_str!("../tests/golden/recipes/akoya-rg-north-window-white.json");
const KNOBS: &str = include_str!("knobs.json");

fn main() {
    let mut value: Value = serde_json::from_str(RECIPE).expect("JSON");
    (value["size"], value["samples"]) = (json!(512), json!(1));
    let recipe = |value: &Value| Recipe::from_json(&value.to_string()).expect("a recipe");
    let progress = Progress::default();
    let view = |job: &mut Job| job.view(&progress).expect("a view").expect("never stopped");
    let new = || Job::new(recipe(&value), Resources::default()).expect("a job");
    print("first", || drop(view(&mut new())));
    let mut job = new();
    let seen = view(&mut job);
    print("rows", || drop(seen.rows(0..512, &progress)));
    let pixels = seen.picture(&progress).expect("never stopped");
    print("codes", || drop(black_box(develop(&light_of(&pixels), RgbSpace::Srgb, Gamut::Soft))));
    let knobs: Vec<(String, String, [Value; 2])> = serde_json::from_str(KNOBS).expect("JSON");
    for (name, path, values) in knobs {
        let mut turn = 0;
        print(&name, || {
            *value.pointer_mut(&path).expect("a key") = values[turn % 2].clone();
            turn += 1;
            job.change(recipe(&value), Resources::default()).expect("a change");
            drop(view(&mut job));
        });
    }
}

/// Prints the least ms of some runs.
fn print(name: &str, mut work: impl FnMut()) {
    let begun = Instant::now();
    let one = |_| {
        let begin = processor_ms(begun);
        work();
        processor_ms(begun) - begin
    };
    println!("{name},{:.2}", (0..RUNS).map(one).fold(f64::INFINITY, f64::min));
}

/// Processor time of this thread, or the time since `begun`.
fn processor_ms(begun: Instant) -> f64 {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let ns = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    ns.map_or_else(|| begun.elapsed().as_secs_f64() * 1e3, |ns| ns * 1e-6)
}
