//! Laws of the illuminant model.

use nacreous_nacre::{Index, LayerStack, Medium};
use nacreous_optics::{IlluminantModel, OpticsError};
use num_complex::Complex64;
use proptest::prelude::*;
use std::f64::consts::FRAC_PI_2;

const PAPER: IlluminantModel =
    IlluminantModel { coherence_nm: 5000.0, threshold: 0.05, diffuse_loss: 0.02 };

fn stack(thickness_nm: Vec<f64>) -> LayerStack {
    let index = |n| Index::new("medium", n, 0.0).unwrap();
    LayerStack::new(thickness_nm, 20.0, index(1.53), index(1.43), index(1.0), index(1.53)).unwrap()
}

fn wavelengths_nm() -> Vec<f64> {
    (380..=780).map(f64::from).collect()
}

/// (cos theta_1, T1, |a|^2 of s, |a|^2 of p), written again from the paper's formulas.
fn by_hand(theta_0: f64, wavelength_nm: f64) -> (f64, f64, f64, f64) {
    let (c0, n1, n2) = (theta_0.cos(), 1.53, 1.43);
    let c1 = (1.0 - (theta_0.sin() / n1).powi(2)).sqrt();
    let c2 = (1.0 - (theta_0.sin() / n2).powi(2)).sqrt();
    let r1_p = (n1 * c0 - c1) / (n1 * c0 + c1);
    let r1_s = (n1 * c1 - c0) / (n1 * c1 + c0);
    let r2_p = (n1 * c2 - n2 * c1) / (n1 * c2 + n2 * c1);
    let r2_s = (n1 * c1 - n2 * c2) / (n1 * c1 + n2 * c2);
    let delta = 4.0 * std::f64::consts::PI * n2 * 20.0 * c2 / wavelength_nm;
    let face_pair = (1.0 - delta.cos()).powi(2) + delta.sin().powi(2);
    let t1 = 1.0 - 0.5 * (r1_p * r1_p + r1_s * r1_s);
    (c1, t1, r2_s * r2_s * face_pair, r2_p * r2_p * face_pair)
}

/// Section 3.2.4 as its flow chart says it: loops in loops, no telescoping.
fn as_the_flow_chart_says(
    model: IlluminantModel,
    thickness_nm: &[f64],
    theta_0: f64,
    wavelength_nm: f64,
) -> f64 {
    let (c1, t1, a2_s, a2_p) = by_hand(theta_0, wavelength_nm);
    let mut both = 0.0;
    for a2 in [a2_s, a2_p] {
        let mut light = 1.0;
        for l in 0..thickness_nm.len() {
            let (mut re, mut im, mut depth_nm) = (0.0, 0.0, 0.0);
            for k in l..thickness_nm.len() {
                if k > l {
                    depth_nm += thickness_nm[k];
                    if 2.0 * 1.53 * c1 * depth_nm >= model.coherence_nm {
                        break;
                    }
                }
                let xi = 4.0 * std::f64::consts::PI * depth_nm * 1.53 * c1 / wavelength_nm;
                re += xi.cos();
                im += xi.sin();
            }
            both += light * a2 * (re * re + im * im);
            light *= (1.0 - a2 - model.diffuse_loss).powi(2);
            if light < model.threshold {
                break;
            }
        }
    }
    0.5 * t1 * both
}

#[test]
fn one_window_of_equal_layers_is_a_finite_grating() {
    let layers = 9;
    let coherent = IlluminantModel { coherence_nm: 1e9, threshold: 1.0, diffuse_loss: 0.0 };
    let thickness_nm = vec![431.0; layers];
    for theta_0 in [0.0, 0.4, 1.1] {
        let spectrum =
            coherent.spectra(&stack(thickness_nm.clone()), &[theta_0], &wavelengths_nm()).unwrap();
        for (wavelength_nm, got) in wavelengths_nm().into_iter().zip(spectrum) {
            let (c1, t1, a2_s, a2_p) = by_hand(theta_0, wavelength_nm);
            let half = 2.0 * std::f64::consts::PI * 1.53 * c1 * 431.0 / wavelength_nm;
            let grating = ((layers as f64 * half).sin() / half.sin()).powi(2);
            let closed = 0.5 * t1 * (a2_s + a2_p) * grating;
            assert!((got - closed).abs() < 1e-12 * (1.0 + closed / a2_s), "{wavelength_nm}");
        }
    }
}

#[test]
fn without_coherence_there_are_no_fringes() {
    let incoherent = IlluminantModel { coherence_nm: 0.0, threshold: 0.0, ..PAPER };
    let spectrum = incoherent.spectra(&stack(vec![431.0; 60]), &[0.3], &wavelengths_nm()).unwrap();
    // What is left is the slow rise of one protein layer towards blue: monotone, so without a fringe.
    assert!(spectrum.windows(2).all(|pair| pair[1] < pair[0]));
    let coherent = IlluminantModel { threshold: 0.0, ..PAPER };
    let fringes = coherent.spectra(&stack(vec![431.0; 60]), &[0.3], &wavelengths_nm()).unwrap();
    assert!(fringes.windows(2).filter(|pair| pair[1] > pair[0]).count() > 50);
}

#[test]
fn no_light_leaves_along_the_surface() {
    let grazing = PAPER.spectra(&stack(vec![431.0; 60]), &[FRAC_PI_2], &wavelengths_nm()).unwrap();
    assert!(grazing.iter().all(|&intensity| (0.0..1e-9).contains(&intensity)));
}

#[test]
fn media_the_model_does_not_know_are_refused_by_name() {
    let index = |n, k| Index::new("medium", n, k).unwrap();
    let with = |aragonite, protein, ambient| {
        let s = LayerStack::new(vec![400.0], 20.0, aragonite, protein, ambient, index(1.5, 0.0));
        PAPER.spectra(&s.unwrap(), &[0.0], &[500.0]).unwrap_err()
    };
    let (clear, dark) = (index(1.5, 0.0), index(1.5, 0.1));
    assert_eq!(with(dark, clear, clear), OpticsError::Absorbing { medium: "aragonite", k: 0.1 });
    assert_eq!(
        with(clear, index(1.2, 0.0), index(1.33, 0.0)),
        OpticsError::TotalReflection { medium: "protein", n: 1.2, ambient: 1.33 }
    );
}

#[test]
fn bad_numbers_are_refused_by_name() {
    let one = stack(vec![400.0]);
    let ask = |model: IlluminantModel, angle, wavelength| {
        model.spectra(&one, &[angle], &[wavelength]).unwrap_err().to_string()
    };
    let nan = f64::NAN;
    assert!(
        ask(IlluminantModel { coherence_nm: nan, ..PAPER }, 0.0, 500.0).contains("coherence_nm")
    );
    assert!(ask(IlluminantModel { threshold: -0.1, ..PAPER }, 0.0, 500.0).contains("threshold"));
    assert!(
        ask(IlluminantModel { diffuse_loss: 2.0, ..PAPER }, 0.0, 500.0).contains("diffuse_loss")
    );
    assert!(ask(PAPER, 1.6, 500.0).contains("angle_rad is 1.6"));
    assert!(ask(PAPER, 0.0, 0.0).contains("wavelength_nm is 0"));
}

/// Stacks of every way through the model: one index for all wavelengths, or one of its own for each; windows
/// as wide as the stack, and narrower at some angles than at others.
fn stacks() -> [LayerStack; 4] {
    let index = |n| Index::new("medium", n, 0.0).unwrap();
    let glass = [390.0, 550.0, 720.0].map(|nm| Complex64::from(1.5 + 5000.0 / (nm * nm)));
    let glass = Medium::table("aragonite", vec![390.0, 550.0, 720.0], &glass, &glass).unwrap();
    let uneven = (0..70).map(|i| 250.0 + f64::from(i * 37 % 101) * 3.0).collect();
    let (protein, water) = (index(1.43), index(1.33));
    [
        stack(vec![400.0; 10]),
        stack(uneven),
        LayerStack::new(vec![410.0; 60], 30.0, glass, protein, water, protein).unwrap(),
        // No denser than around, where light along the surface goes on.
        LayerStack::new(vec![300.0; 3], 20.0, water, protein, water, protein).unwrap(),
    ]
}

#[test]
fn few_wavelengths_beside_many_angles_give_each_point_the_bits_it_has_alone() {
    for stack in stacks() {
        for (angles, wavelengths) in [(2, 1), (33, 1), (200, 1), (31, 3), (7, 16), (7, 17)] {
            let at = |i: usize, of: usize| i as f64 / (of - 1).max(1) as f64;
            let angle_rad: Vec<f64> = (0..angles).map(|i| FRAC_PI_2 * at(i, angles)).collect();
            let nm: Vec<f64> =
                (0..wavelengths).map(|i| 400.0 + 300.0 * at(i, wavelengths)).collect();
            let table = PAPER.spectra(&stack, &angle_rad, &nm).unwrap();
            let alone = angle_rad.iter().flat_map(|&angle| {
                let stack = &stack;
                nm.iter().map(move |&nm| PAPER.spectra(stack, &[angle], &[nm]).unwrap()[0])
            });
            assert!(table.iter().copied().map(f64::to_bits).eq(alone.map(f64::to_bits)));
        }
    }
}

#[test]
fn a_table_of_few_wavelengths_is_its_parts_wherever_it_is_cut() {
    for stack in stacks() {
        let angle_rad: Vec<f64> = (0..90).map(|i| f64::from(i) / 58.0).collect();
        let nm = [450.0, 550.0, 650.0];
        let whole = PAPER.spectra(&stack, &angle_rad, &nm).unwrap();
        for cut in [1, 11, 45, 89] {
            let (first, second) = angle_rad.split_at(cut);
            let parts = [first, second].map(|part| PAPER.spectra(&stack, part, &nm).unwrap());
            assert_eq!(parts.concat(), whole);
        }
    }
}

proptest! {
    #[test]
    fn running_sums_equal_the_papers_flow_chart(
        thickness_nm in prop::collection::vec(200.0..900.0, 1..120),
        theta_0 in 0.0..1.55, wavelength_nm in 380.0..780.0,
        coherence_nm in 0.0..20_000.0, diffuse_loss in 0.0..0.2,
    ) {
        let model = IlluminantModel { coherence_nm, diffuse_loss, ..PAPER };
        let got = model.spectra(&stack(thickness_nm.clone()), &[theta_0], &[wavelength_nm]).unwrap()[0];
        let expected = as_the_flow_chart_says(model, &thickness_nm, theta_0, wavelength_nm);
        prop_assert!((got - expected).abs() < 1e-10 * (1.0 + expected), "{got} {expected}");
    }

    #[test]
    fn a_spectrum_does_not_depend_on_its_neighbours(theta_0 in 0.0..1.5, wavelength_nm in 400.0..700.0) {
        let layers = stack((0..80).map(|i| 400.0 + f64::from(i)).collect());
        let alone = PAPER.spectra(&layers, &[theta_0], &[wavelength_nm]).unwrap()[0];
        let many: Vec<f64> = (0..37).map(|i| wavelength_nm + f64::from(i - 20)).collect();
        let table = PAPER.spectra(&layers, &[0.1, theta_0], &many).unwrap();
        prop_assert_eq!(alone.to_bits(), table[37 + 20].to_bits());
    }
}
