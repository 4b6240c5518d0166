//! Means over columns in single precision against exact columns in double.

use std::f64::consts::FRAC_PI_2;
use std::sync::atomic::AtomicBool;

use nacreous_nacre::{Index, LayerStack, Medium};
use nacreous_optics::{Ensemble, Polarisation, Precision, TransferModel};
use proptest::prelude::*;

fn index(n: f64) -> Index {
    Index::new("medium", n, 0.0).unwrap()
}

fn stack(thickness_nm: &[f64], protein_nm: f64, [n_o, n_e, n_p]: [f64; 3]) -> LayerStack {
    let aragonite = Medium::uniaxial(index(n_o), index(n_e));
    let air = index(1.0);
    LayerStack::new(thickness_nm.to_vec(), protein_nm, aragonite, index(n_p), air, index(1.53))
        .unwrap()
}

fn mean(precision: Precision, stacks: &[LayerStack], angles: &[f64], nm: &[f64]) -> Ensemble {
    added(Ensemble::empty(angles.len() * nm.len()), precision, stacks, angles, nm)
}

fn added(
    to: Ensemble,
    precision: Precision,
    stacks: &[LayerStack],
    angles: &[f64],
    nm: &[f64],
) -> Ensemble {
    let model = TransferModel {
        polarisation: Polarisation::Unpolarised,
        precision,
        ..TransferModel::default()
    };
    to.with(model, stacks, angles, nm, &AtomicBool::new(false)).unwrap().unwrap()
}

/// The largest difference between single and double precision, of means of R and of T.
fn error(stacks: &[LayerStack], angles: &[f64], nm: &[f64]) -> f64 {
    let [double, single] =
        [Precision::Double, Precision::Single].map(|precision| mean(precision, stacks, angles, nm));
    let apart = |a: &[f64], b: &[f64]| {
        assert!(b.iter().all(|b| b.is_finite()));
        a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    };
    apart(double.reflectance(), single.reflectance())
        .max(apart(double.transmittance(), single.transmittance()))
}

/// 103 tablets of a pearl's spread.
fn column(seed: u64) -> Vec<f64> {
    (0..103_u64).map(|i| 300.0 + ((i * 7919 + seed * 104_729) % 2003) as f64 * 0.113).collect()
}

#[test]
fn a_pearls_columns_are_right_to_1e_5() {
    let stacks: Vec<LayerStack> =
        (0..16).map(|seed| stack(&column(seed), 20.0, [1.683, 1.53, 1.56])).collect();
    let angles: Vec<f64> = (0..=24).map(|step| f64::from(step) / 24.0 * FRAC_PI_2).collect();
    let nm: Vec<f64> = (380..=780).map(f64::from).collect();
    let found = error(&stacks, &angles, &nm);
    assert!(found < 1e-5, "{found}");
}

#[test]
fn no_column_depends_on_its_neighbours() {
    let [first, second] = [3, 4].map(|seed| stack(&column(seed), 20.0, [1.683, 1.53, 1.43]));
    let (angles, nm) = ([0.0, 0.7, FRAC_PI_2], [400.0, 500.5, 777.0]);
    let together = mean(Precision::Single, &[first.clone(), second.clone()], &angles, &nm);
    let one = mean(Precision::Single, &[first], &angles, &nm);
    assert_eq!(together, added(one, Precision::Single, &[second], &angles, &nm));
}

#[test]
fn media_of_extreme_contrast_stay_right() {
    for indices in [[10.0, 10.0, 1.001], [1.001, 1.002, 100.0], [1.53, 1.683, 1.53], [1.6; 3]] {
        let stacks = [stack(&column(1), 130.0, indices), stack(&column(2), 0.0, indices)];
        let found = error(&stacks, &[0.0, 0.5, 1.5, FRAC_PI_2], &[400.0, 521.0, 640.0]);
        assert!(found < 1e-4, "{indices:?}: {found}");
    }
}

#[test]
fn any_wavelength_and_thickness_will_do() {
    let stacks = [stack(&[1e-3, 400.0, 1e6, 350.0], 20.0, [1.683, 1.53, 1.43])];
    for nm in [1.0, 40.0, 1e4, 1e6] {
        // Single precision knows a thickness of 1 mm to 1e-9 nm.
        let found = error(&stacks, &[0.0, 1.0], &[nm]);
        assert!(found < 1e-5, "{nm}: {found}");
    }
}

proptest! {
    #[test]
    fn single_precision_errs_by_what_it_says(
        d in prop::collection::vec(300.0..600.0, 1..400), n_p in 1.4..1.6, n_e in 1.5..1.7, angle in 0.0..1.57,
    ) {
        let stacks = [stack(&d, 20.0, [1.683, n_e, n_p])];
        let nm: Vec<f64> = (380..=780).step_by(4).map(f64::from).collect();
        let found = error(&stacks, &[angle], &nm);
        prop_assert!(found < 2e-4, "{}", found);
    }
}
