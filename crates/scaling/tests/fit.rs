//! Laws of the fitted scale.

use std::sync::atomic::{AtomicBool, AtomicUsize};

use nacreous_scaling::{
    Answers, Bootstrap, Counts, Design, Existence, Fit, Kind, Link, Model, Outcome, Source,
    existence, fit, information, log_likelihood, person_scores,
};
use proptest::prelude::*;

static ANY: AtomicBool = AtomicBool::new(false);

fn fitted(model: &Model, counts: &Counts) -> Fit {
    assert_eq!(existence(model, counts), Existence::Exists);
    fit(model, counts, &ANY).expect("a maximum that exists is found")
}

/// Every ordered pair of n, with answers of every kind.
fn full(n: u32, answers: impl Fn(u32, u32) -> [f64; 3]) -> Counts {
    let pairs = (0..n).flat_map(|i| (0..n).map(move |j| [i, j])).filter(|[i, j]| i != j);
    let pairs: Vec<_> = pairs.collect();
    let answers = pairs.iter().map(|&[i, j]| answers(i, j)).collect();
    Counts::new(n as usize, pairs, answers).expect("counts")
}

fn models() -> impl Strategy<Value = Model> {
    (any::<bool>(), any::<bool>(), any::<bool>(), prop::option::of(0.3..3.0_f64)).prop_map(
        |(probit, ties, order, prior)| Model {
            link: if probit { Link::Probit } else { Link::Logit },
            ties,
            order,
            prior,
            design: None,
        },
    )
}

fn tables() -> impl Strategy<Value = Counts> {
    (2..7_u32, prop::collection::vec(prop::array::uniform3(1..30_u32), 42))
        .prop_map(|(n, table)| full(n, |i, j| table[(i * n + j) as usize % 42].map(f64::from)))
}

proptest! {
    #[test]
    fn nothing_near_the_maximum_is_higher(model in models(), counts in tables()) {
        let best = fitted(&model, &counts);
        let height = |p: &[f64]| {
            let held: f64 = p[..counts.stimuli].iter().map(|v| v * v).sum();
            log_likelihood(&model, &counts, p) - model.prior.map_or(0.0, |s| held / (2.0 * s * s))
        };
        let top = height(&best.parameters);
        for i in 0..best.parameters.len() {
            for step in [-1e-4, 1e-4] {
                let mut near = best.parameters.clone();
                near[i] += step;
                prop_assert!(height(&near) < top);
            }
        }
        prop_assert!(best.values.iter().sum::<f64>().abs() < 1e-12);
    }

    #[test]
    fn observed_information_is_the_bend_of_the_likelihood(model in models(), counts in tables()) {
        let model = Model { prior: None, ..model };
        let p = fitted(&model, &counts).parameters;
        let table = information(&model, &counts, &p, Kind::Observed);
        let (h, n) = (1e-4, p.len());
        let at = |i: usize, x: f64, j: usize, y: f64| {
            let mut q = p.clone();
            q[i] += x;
            q[j] += y;
            log_likelihood(&model, &counts, &q)
        };
        for i in 0..n {
            for j in 0..n {
                let bend = -(at(i, h, j, h) - at(i, h, j, -h) - at(i, -h, j, h) + at(i, -h, j, -h))
                    / (4.0 * h * h);
                let size = (table[i * n + i] * table[j * n + j]).sqrt();
                prop_assert!((table[i * n + j] - bend).abs() < 1e-4 * size + 1e-3);
            }
        }
    }

    #[test]
    fn names_do_not_matter(model in models(), counts in tables()) {
        let n = counts.stimuli as u32;
        let turned: Vec<_> = counts.pairs.iter().map(|p| p.map(|i| n - 1 - i)).collect();
        let mirror = Counts::new(counts.stimuli, turned, counts.answers.clone()).expect("counts");
        let (one, other) = (fitted(&model, &counts), fitted(&model, &mirror));
        for (a, b) in one.values.iter().zip(other.values.iter().rev()) {
            prop_assert!((a - b).abs() < 1e-11);
        }
    }

    #[test]
    fn a_design_of_indicators_changes_nothing(model in models(), counts in tables()) {
        let (n, columns) = (counts.stimuli, counts.stimuli - 1);
        let model = Model { prior: None, ..model };
        let values = (0..n * columns).map(|k| f64::from(k / columns == k % columns)).collect();
        let made = Model { design: Some(Design { values, columns }), ..model.clone() };
        let (free, made) = (fitted(&model, &counts), fit(&made, &counts, &ANY).expect("fit"));
        for (a, b) in free.values.iter().zip(&made.values) {
            prop_assert!((a - b).abs() < 1e-10);
        }
    }

    #[test]
    fn the_scores_of_all_people_add_to_nothing(
        model in models(), outcomes in prop::collection::vec((0..4_u32, 1..4_u32, -1..=1_i8), 60),
    ) {
        let model = Model { prior: None, ..model };
        let mut answers = Answers::default();
        for (k, (left, on, sign)) in outcomes.into_iter().enumerate() {
            answers.pairs.push([left, (left + on) % 4]);
            answers.outcomes.push(Outcome::from(sign));
            answers.people.push(k as u32 % 7);
        }
        let counts = answers.ledger(&Model { order: true, ties: true, ..model.clone() }, 4, 7).counts;
        prop_assume!(existence(&model, &counts) == Existence::Exists);
        prop_assume!(!model.ties || counts.totals()[2] > 0.0);
        let p = fitted(&model, &counts).parameters;
        let scores = person_scores(&model, &answers, 4, 7, &p);
        for i in 0..p.len() {
            let sum: f64 = scores.chunks(p.len()).map(|score| score[i]).sum();
            prop_assert!(sum.abs() < 1e-9);
        }
    }
}

#[test]
fn huge_and_tiny_counts_give_the_same_scale() {
    let answers =
        |i: u32, j: u32| [f64::from(1 + (i * 3 + j) % 5), f64::from(2 + (i + j) % 3), 1.0];
    for link in [Link::Probit, Link::Logit] {
        for (ties, order) in [(false, false), (true, true)] {
            let model = Model { link, ties, order, ..Model::default() };
            let plain = fitted(&model, &full(5, answers));
            for times in [1e-9, 0.3, 1e9] {
                let scaled = fitted(&model, &full(5, |i, j| answers(i, j).map(|c| c * times)));
                for (a, b) in plain.parameters.iter().zip(&scaled.parameters) {
                    assert!((a - b).abs() < 1e-12, "{link:?} x {times}: {a} {b}");
                }
            }
        }
    }
}

#[test]
fn two_stimuli_stand_apart_by_the_inverse_of_the_link() {
    for odds in [1e-9, 0.1, 1.0, 7.0, 1e9] {
        let counts = Counts::new(2, vec![[0, 1]], vec![[odds, 1.0, 0.0]]).expect("counts");
        let model = Model { link: Link::Logit, ..Model::default() };
        let values = fitted(&model, &counts).values;
        assert!((values[0] - values[1] - odds.ln()).abs() < 1e-9);
        let values = fitted(&Model::default(), &counts).values;
        let share = nacreous_scaling::cdf(values[0] - values[1]);
        assert!((share / (odds / (1.0 + odds)) - 1.0).abs() < 1e-9);
    }
}

#[test]
fn a_chain_of_thousands_and_a_star_are_fitted() {
    for star in [false, true] {
        let n = 2000;
        let pairs = (1..n).map(|i| [if star { 0 } else { i - 1 }, i]).collect();
        let counts = Counts::new(n as usize, pairs, vec![[3.0, 1.0, 0.0]; n as usize - 1]);
        let model = Model { link: Link::Logit, ..Model::default() };
        let values = fitted(&model, &counts.expect("counts")).values;
        let before = if star { values[0] } else { values[n as usize - 2] };
        assert!((before - values[n as usize - 1] - 3.0_f64.ln()).abs() < 1e-8);
    }
}

#[test]
fn a_bootstrap_is_the_same_on_any_number_of_threads() {
    let counts = full(4, |i, j| [f64::from(3 + i), f64::from(2 + j), 2.0]);
    let model = Model { ties: true, order: true, ..Model::default() };
    let parameters = fitted(&model, &counts).parameters;
    let source = Source::Answers(counts);
    let job = Bootstrap {
        model: &model,
        source: &source,
        parameters: &parameters,
        samples: 40,
        seed: 7,
        studentised: true,
    };
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| job.run(&ANY, &AtomicUsize::new(0))).expect("samples")
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn samples_without_a_maximum_are_held_and_counted() {
    // One person in five disagrees: whoever draws none of her has no maximum.
    let mut answers = Answers::default();
    for person in 0..5 {
        answers.pairs.push([0, 1]);
        answers.outcomes.push(if person == 0 { Outcome::Right } else { Outcome::Left });
        answers.people.push(person);
    }
    let model = Model::default();
    let ledger = answers.ledger(&model, 2, 5);
    let parameters = fitted(&model, &ledger.counts).parameters;
    let source = Source::People(ledger);
    let job = Bootstrap {
        model: &model,
        source: &source,
        parameters: &parameters,
        samples: 2000,
        seed: 1,
        studentised: true,
    };
    let samples = job.run(&ANY, &AtomicUsize::new(0)).expect("samples");
    let held = samples.iter().filter(|sample| !sample.placed).count() as f64 / 2000.0;
    assert!((held - 0.8_f64.powi(5)).abs() < 0.04, "{held}");
    let farthest = samples.iter().filter(|s| s.placed).map(|s| s.values[0]).fold(0.0, f64::max);
    for sample in samples.iter().filter(|sample| !sample.placed) {
        assert!(sample.values[0].abs() > farthest && sample.values[0].abs() < 5.0);
        assert!(sample.se.iter().all(|se| se.is_finite()));
    }
}
