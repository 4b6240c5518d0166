//! Laws of one boundary, over real, absorbing, metallic, oblique and totally reflecting cases.

use std::f64::consts::FRAC_PI_2;

use nacreous_nacre::Index;
use nacreous_optics::{Fresnel, fresnel};
use proptest::prelude::*;

fn at(n_i: (f64, f64), n_t: (f64, f64), angle_rad: f64) -> Fresnel {
    let index = |(n, k)| Index::new("medium", n, k).unwrap();
    fresnel(index(n_i), index(n_t), angle_rad).unwrap()
}

const AIR: (f64, f64) = (1.0, 0.0);
const ARAGONITE: (f64, f64) = (1.53, 0.0);

#[test]
fn figure_8_of_the_paper() {
    let normal = at(ARAGONITE, AIR, 0.0);
    assert!((normal.R() - 0.0439).abs() < 5e-5);
    let theta_1 = (1.0_f64 / 1.53).asin();
    assert!((theta_1.to_degrees() - 40.8).abs() < 0.05);
    assert!((at(ARAGONITE, AIR, theta_1).R() - 1.0).abs() < 1e-6);
}

#[test]
fn no_p_light_is_reflected_at_brewsters_angle() {
    let brewster = (1.53_f64).atan();
    assert!(at(AIR, ARAGONITE, brewster).R_p < 1e-30);
}

#[test]
fn total_reflection_is_total_and_turns_the_phase() {
    let beyond = at(ARAGONITE, AIR, 0.9);
    assert!((beyond.R_s - 1.0).abs() < 1e-14 && (beyond.R_p - 1.0).abs() < 1e-14);
    assert!(beyond.T_s.abs() < 1e-14 && beyond.T_p.abs() < 1e-14);
    // Born and Wolf, 1.5.4: tan(delta_s / 2) = sqrt(sin^2 - n^2) / cos with n = n_t / n_i.
    let n = 1.0 / 1.53;
    let tan_half = (0.9_f64.sin().powi(2) - n * n).sqrt() / 0.9_f64.cos();
    assert!((beyond.r_s.arg().abs() - 2.0 * tan_half.atan()).abs() < 1e-14);
}

#[test]
fn a_metal_at_normal_incidence_meets_its_closed_form() {
    let (n, k) = (0.05_f64, 3.3_f64); // about silver in the green
    let closed = ((1.0 - n).powi(2) + k * k) / ((1.0 + n).powi(2) + k * k);
    let silver = at(AIR, (n, k), 0.0);
    assert!((silver.R_s - closed).abs() < 1e-14 && (silver.R_p - closed).abs() < 1e-14);
}

#[test]
fn both_polarisations_have_one_sign_at_normal_incidence() {
    let normal = at(ARAGONITE, AIR, 0.0);
    assert!((normal.r_s - normal.r_p).norm() < 1e-15 && (normal.t_s - normal.t_p).norm() < 1e-15);
}

#[test]
fn equal_media_are_invisible_up_to_grazing() {
    for angle_rad in [0.0, 0.7, 1.57, FRAC_PI_2] {
        let nothing = at((1.53, 0.2), (1.53, 0.2), angle_rad);
        assert!(nothing.r_s.norm() < 1e-12 && nothing.r_p.norm() < 1e-12, "{nothing:?}");
    }
}

#[test]
fn an_angle_that_is_none_is_refused_by_name() {
    for bad in [-0.1, 1.6, f64::NAN] {
        let air = Index::new("air", 1.0, 0.0).unwrap();
        let message = fresnel(air, air, bad).unwrap_err().to_string();
        assert!(
            message.starts_with("angle_rad is ") && message.ends_with("0 to pi/2"),
            "{message}"
        );
    }
}

proptest! {
    #[test]
    fn r_plus_t_is_one_when_lossless(
        n_i in 0.2..4.0, n_t in 0.2..4.0, angle_rad in 0.0..1.57,
    ) {
        let f = at((n_i, 0.0), (n_t, 0.0), angle_rad);
        prop_assert!((f.R_s + f.T_s - 1.0).abs() < 1e-12, "{f:?}");
        prop_assert!((f.R_p + f.T_p - 1.0).abs() < 1e-12, "{f:?}");
    }

    #[test]
    fn energy_into_an_absorber_is_what_is_not_reflected(
        n_i in 0.5..3.0, n in 0.05..4.0, k in 0.0..5.0, angle_rad in 0.0..1.57,
    ) {
        let f = at((n_i, 0.0), (n, k), angle_rad);
        prop_assert!((f.R() + f.T() - 1.0).abs() < 1e-11, "{f:?}");
        prop_assert!((0.0..=1.0 + 1e-12).contains(&f.R()));
    }

    #[test]
    fn fields_are_continuous_across_the_boundary(
        n_i in 0.5..3.0, n in 0.05..4.0, k in 0.0..5.0, angle_rad in 0.0..1.57,
    ) {
        // s: the electric field, 1 + r = t. p: the magnetic field, n_i (1 - r) = n_t t; it turns its sign
        // where the electric field keeps it.
        let f = at((n_i, 0.0), (n, k), angle_rad);
        let n_t = num_complex::Complex64::new(n, k);
        prop_assert!((1.0 + f.r_s - f.t_s).norm() < 1e-12);
        prop_assert!((n_i * (1.0 - f.r_p) - n_t * f.t_p).norm() < 1e-11);
    }

    #[test]
    fn stokes_relations_hold_on_the_way_back(n_i in 1.0..2.0, n_t in 2.0..3.0, angle_rad in 0.0..1.5) {
        let there = at((n_i, 0.0), (n_t, 0.0), angle_rad);
        let refracted_rad = (n_i / n_t * f64::sin(angle_rad)).asin();
        let back = at((n_t, 0.0), (n_i, 0.0), refracted_rad);
        prop_assert!((there.r_p + back.r_p).norm() < 1e-12);
        prop_assert!((there.t_s * back.t_s - (1.0 - there.r_s * there.r_s)).norm() < 1e-12);
        prop_assert!((there.t_p * back.t_p - (1.0 - there.r_p * there.r_p)).norm() < 1e-12);
    }

    #[test]
    fn nothing_outside_the_real_numbers_comes_out(
        n_i in 0.01..10.0, k_i in 0.0..10.0, n in 0.01..10.0, k in 0.0..10.0, angle_rad in 0.0..=FRAC_PI_2,
    ) {
        let f = at((n_i, k_i), (n, k), angle_rad);
        prop_assert!(f.R().is_finite() && f.T().is_finite() && f.t_p.norm().is_finite(), "{f:?}");
    }
}
