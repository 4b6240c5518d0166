//! Laws of growth.

use nacreous_nacre::{Growth, NacreError, Season};
use proptest::prelude::*;

fn paper() -> Growth {
    Growth {
        days: 245,
        season: Season { peak_day: 108.0, width_days: 45.0 },
        thickness_winter_nm: 400.0,
        thickness_summer_nm: 700.0,
        layers_winter: 1.0,
        layers_summer: 3.0,
        thickness_noise_nm: 20.0,
        layers_noise: 0.5,
    }
}

#[test]
fn without_noise_the_bell_curve_is_met_exactly() {
    let quiet = Growth { thickness_noise_nm: 0.0, layers_noise: 0.0, ..paper() };
    for deposit in quiet.grow(1).unwrap().deposits() {
        let z = (f64::from(deposit.day) - 108.0) / 45.0;
        let bell_nm = 400.0 + 300.0 * (-0.5 * z * z).exp();
        assert!((deposit.thickness_nm - bell_nm).abs() < 1e-9, "day {}", deposit.day);
    }
}

#[test]
fn layers_a_day_stay_in_the_papers_range() {
    let diary = paper().grow(3).unwrap();
    for day in 0..245 {
        let layers = diary.deposits().iter().filter(|d| d.day == day).count();
        assert!((1..=3).contains(&layers), "{layers} layers on day {day}");
    }
}

#[test]
fn winter_is_thin_and_summer_thick() {
    let diary = paper().grow(3).unwrap();
    let outermost = diary.deposits().last().unwrap().thickness_nm;
    let thickest = diary.deposits().iter().map(|d| d.thickness_nm).fold(0.0, f64::max);
    assert!(outermost < 500.0, "the paper: thin layers, below 500 nm, before a December harvest");
    assert!((680.0..=720.0).contains(&thickest));
}

#[test]
fn noise_has_the_spread_of_a_uniform_distribution() {
    let level = Growth { thickness_summer_nm: 400.0, days: 1000, ..paper() };
    let diary = level.grow(11).unwrap();
    let n = diary.deposits().len() as f64;
    let squares = diary.deposits().iter().map(|d| (d.thickness_nm - 400.0).powi(2));
    let sd = (squares.sum::<f64>() / n).sqrt();
    // Half width 20 gives 20 / sqrt(3); the standard error of the sd of n uniform values is 0.45 / sqrt(n) of it.
    let expected = 20.0 / 3_f64.sqrt();
    assert!((sd / expected - 1.0).abs() < 5.0 * 0.45 / n.sqrt(), "{sd}");
}

#[test]
fn the_same_seed_gives_the_same_bytes_on_every_platform() {
    // Written down once on x86-64 Linux, where an independent ChaCha8 in Python agrees
    // (tests/nacre/test_nacre.py); every other platform must print the same.
    let diary = paper().grow(7).unwrap();
    let bits: Vec<u64> = diary.deposits()[..3].iter().map(|d| d.thickness_nm.to_bits()).collect();
    assert_eq!(
        bits,
        [4_646_016_781_294_301_408, 4_645_917_132_054_105_456, 4_645_958_835_449_991_424]
    );
}

#[test]
fn a_billion_layers_are_refused() {
    let greedy = Growth { layers_winter: 100.0, layers_summer: 100.0, days: 7305, ..paper() };
    assert_eq!(greedy.grow(1).unwrap_err(), NacreError::LayerCount(730_500));
}

#[test]
fn no_growth_is_no_pearl() {
    let idle = Growth { layers_winter: 0.0, layers_summer: 0.0, layers_noise: 0.0, ..paper() };
    assert_eq!(idle.grow(1).unwrap_err(), NacreError::LayerCount(0));
}

proptest! {
    #[test]
    fn every_layer_is_positive_whatever_the_parameters(
        days in 1_u32..400, peak in -400.0..400.0, width in 1.0..200.0, winter in 1.0..900.0,
        summer in 1.0..900.0, share in 0.0..0.999, seed: u64,
    ) {
        let growth = Growth {
            days,
            season: Season { peak_day: peak, width_days: width },
            thickness_winter_nm: winter,
            thickness_summer_nm: summer,
            thickness_noise_nm: share * f64::min(winter, summer),
            ..paper()
        };
        let diary = growth.grow(seed).unwrap();
        prop_assert!(diary.deposits().iter().all(|d| d.thickness_nm > 0.0));
        prop_assert!(diary.deposits().is_sorted_by_key(|d| d.day));
    }

    #[test]
    fn bad_parameters_are_named(bad in prop_oneof![Just(f64::NAN), Just(f64::INFINITY), Just(-1.0)]) {
        let error = Growth { thickness_winter_nm: bad, ..paper() }.grow(1).unwrap_err();
        prop_assert!(error.to_string().starts_with("thickness_winter_nm is "), "{error}");
    }
}
