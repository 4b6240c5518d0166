//! A job that is kept and asked again gives what a new one would, and works out only what changed.

#[allow(dead_code)] // each file of tests takes what it needs
mod common;

use std::sync::atomic::Ordering;

use nacreous_image::{CHANNELS, Progress};
use nacreous_render::{Job, Resources, Shared, spec::Recipe};
use serde_json::{Value, json};

fn picture(job: &mut Job) -> Vec<f32> {
    let progress = Progress::default();
    job.view(&progress).unwrap().unwrap().picture(&progress).unwrap()
}

fn new(recipe: Recipe) -> Job {
    Job::new(recipe, Resources::default()).unwrap()
}

const NAME: &str = "akoya-rg-north-window-white";

/// Every knob of the viewer, one after the other.
fn changes() -> Vec<(&'static str, Value)> {
    vec![
        ("/pearls/0/depth", json!(0.3)),
        ("/pearls/0/shininess", json!(0.4)),
        ("/pearls/0/grain", json!(0.9)),
        ("/pearls/0/body/pigment", json!("gold")),
        ("/pearls/0/nacre/harvest", json!("2024-11-20")),
        ("/pearls/0/diameter_mm", json!(7.0)),
        ("/scene/camera/azimuth_deg", json!(30.0)),
        ("/scene/camera/exposure", json!(0.5)),
        ("/scene/camera/glare", json!(0.2)),
        ("/scene/windows/0/azimuth_deg", json!(20.0)),
        ("/scene/table/kind", json!("plain")),
        ("/scene/sky/intensity", json!(0.9)),
        ("/size", json!(16)),
        ("/samples", json!(4)),
    ]
}

#[test]
fn a_job_that_was_changed_gives_the_bytes_of_a_new_one() {
    let mut job = new(common::recipe(NAME, &[]));
    picture(&mut job);
    let mut so_far: Vec<(&str, Value)> = Vec::new();
    for change in changes() {
        so_far.push(change.clone());
        let recipe = common::recipe(NAME, &so_far);
        job.change(recipe.clone(), Resources::default()).unwrap();
        assert!(picture(&mut job) == picture(&mut new(recipe)), "{change:?}");
    }
}

#[test]
fn rows_asked_for_by_range_are_those_of_the_whole_picture() {
    let (mut job, progress) = (new(common::recipe(NAME, &[])), Progress::default());
    let view = job.view(&progress).unwrap().unwrap();
    let whole = view.rows(0..24, &progress).unwrap();
    let parts = [0..5, 5..6, 6..24, 24..99].map(|rows| view.rows(rows, &progress).unwrap());
    assert!(parts.concat() == whole);
    assert_eq!(whole.len(), 24 * 24 * CHANNELS);
}

#[test]
fn a_job_in_pieces_gives_the_bytes_of_one_at_once() {
    let (mut job, progress) = (new(common::recipe(NAME, &[])), Progress::default());
    let mut pieces = 0;
    let view = loop {
        pieces += 1;
        if let Some(view) = job.step(&progress).unwrap() {
            break view;
        }
    };
    assert!(pieces > 3, "{pieces}");
    assert!(view.picture(&progress).unwrap() == picture(&mut new(common::recipe(NAME, &[]))));
    assert!(job.step(&progress).unwrap().is_some());
}

#[test]
fn a_refused_change_leaves_the_job_as_it_was() {
    let mut job = new(common::recipe(NAME, &[]));
    let before = picture(&mut job);
    let refused = job.change(common::recipe(NAME, &[("/size", json!(0))]), Resources::default());
    assert!(refused.is_err());
    assert!(picture(&mut job) == before);
}

#[test]
fn a_job_that_was_stopped_can_go_on() {
    let mut job = new(common::recipe(NAME, &[]));
    let stopped = Progress::default();
    stopped.stop_flag().store(true, Ordering::Relaxed);
    assert!(job.view(&stopped).unwrap().is_none());
    assert!(picture(&mut job) == picture(&mut new(common::recipe(NAME, &[]))));
}

/// What all jobs work on: the first that any of them lacks.
fn lacked(jobs: &mut [Job]) -> Option<Shared> {
    jobs.iter_mut().filter_map(|job| job.lacks().unwrap()).min()
}

#[test]
fn work_shared_out_gives_the_same_to_the_bit() {
    // Large enough for a cache of what the pearl mirrors.
    let changes = [("/size", json!(256)), ("/pearls/0/film/columns", json!(9))];
    let recipe = || common::recipe(NAME, &changes);
    let progress = Progress::default();
    let rows = |job: &mut Job| job.view(&progress).unwrap().unwrap().rows(120..122, &progress);
    let whole = rows(&mut new(recipe()));
    // One knows all of it already, another the film of another pearl, as after knobs that were turned back.
    let mut jobs = [(); 3].map(|()| new(recipe()));
    rows(&mut jobs[0]);
    rows(&mut jobs[2]);
    let other = [("/size", json!(24)), ("/pearls/0/film/columns", json!(8))];
    jobs[2].change(common::recipe(NAME, &other), Resources::default()).unwrap();
    picture(&mut jobs[2]);
    jobs[2].change(recipe(), Resources::default()).unwrap();
    let mut done = Vec::new();
    while let Some(shared) = lacked(&mut jobs) {
        let parts: Vec<Vec<f64>> = (0..3).map(|i| jobs[i].part(shared, (i, 3)).unwrap()).collect();
        let parts: Vec<&[f64]> = parts.iter().map(Vec::as_slice).collect();
        for job in &mut jobs {
            assert!(job.join(shared, &[parts[0], parts[1]]).is_err());
            assert!(job.join(shared, &[parts[0], parts[1], &parts[2][1..]]).is_err());
            assert!(job.join(shared, &[]).is_err());
            job.join(shared, &parts).unwrap();
        }
        done.push(shared);
    }
    assert_eq!(done, [Shared::Films, Shared::Reflections]);
    for job in &mut jobs {
        assert!(rows(job) == whole);
    }
}
