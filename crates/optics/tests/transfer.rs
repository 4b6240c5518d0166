//! Exact optics against a peer's numbers, closed forms and conservation laws.

use std::f64::consts::FRAC_PI_2;
use std::sync::atomic::AtomicBool;

use nacreous_nacre::{Index, LayerStack, Medium};
use nacreous_optics::{Energies, Polarisation, Precision, TransferModel, fresnel};
use num_complex::Complex64;
use proptest::prelude::*;

fn medium(n: Complex64) -> Medium {
    Index::new("medium", n.re, n.im).unwrap().into()
}

fn real(n: f64) -> Medium {
    medium(Complex64::from(n))
}

fn energies(
    stack: &LayerStack,
    angle_rad: &[f64],
    wavelength_nm: &[f64],
    polarisation: Polarisation,
) -> Energies {
    let model = TransferModel { polarisation, ..TransferModel::default() };
    model.energies(stack, angle_rad, wavelength_nm, &AtomicBool::new(false)).unwrap().unwrap()
}

/// R, T, A at one angle and wavelength.
fn one(stack: &LayerStack, angle_rad: f64, wavelength_nm: f64, plane: Polarisation) -> [f64; 3] {
    let e = energies(stack, &[angle_rad], &[wavelength_nm], plane);
    [e.reflectance()[0], e.transmittance()[0], e.absorptance()[0]]
}

fn complex(text: &str) -> Complex64 {
    let (re, im) = text.trim_end_matches('j').rsplit_once('+').unwrap();
    Complex64::new(re.parse().unwrap(), im.parse().unwrap())
}

#[test]
fn all_the_peers_stacks_agree_to_1e_12() {
    let table = include_str!("../../../tests/golden/tmm_reference.csv");
    let mut seen = 0;
    for row in table.lines().skip(1) {
        let cells: Vec<&str> = row.split(',').collect();
        let number = |i: usize| cells[i].parse::<f64>().unwrap();
        let media: Vec<Complex64> = cells[6].split(';').map(complex).collect();
        let d_nm: Vec<f64> = cells[7].split(';').map(|d| d.parse().unwrap()).collect();
        let (first, last) = (media[0], media[media.len() - 1]);
        let stack = if media.len() == 2 {
            // A boundary only: an aragonite layer on aragonite.
            LayerStack::new(vec![300.0], 0.0, medium(last), real(1.43), medium(first), medium(last))
        } else {
            let aragonite_nm = d_nm[1..d_nm.len() - 1].iter().copied().step_by(2).collect();
            let (aragonite, protein) = (medium(media[1]), medium(media[2]));
            LayerStack::new(aragonite_nm, d_nm[2], aragonite, protein, medium(first), medium(last))
        };
        let plane = cells[1].parse().unwrap();
        let [r, t, _] = one(&stack.unwrap(), number(3).to_radians(), number(2), plane);
        assert!((r - number(4)).abs() < 1e-12 && (t - number(5)).abs() < 1e-12, "{row}\n{r} {t}");
        seen += 1;
    }
    assert_eq!(seen, 144);
}

/// Born and Wolf 1.6.5: N pairs of quarter waves, high index outside, on a substrate.
#[test]
fn a_quarter_wave_stack_has_its_closed_form() {
    let (n_0, n_h, n_l, n_s) = (1.0, 1.683, 1.43, 1.53);
    for pairs in [1_u8, 5, 40] {
        let quarter_nm = |n: f64| 550.0 / (4.0 * n);
        let layers = vec![quarter_nm(n_h); usize::from(pairs)];
        let stack =
            LayerStack::new(layers, quarter_nm(n_l), real(n_h), real(n_l), real(n_0), real(n_s));
        let y = (n_h / n_l).powi(2 * i32::from(pairs)) * n_s;
        let exact = ((n_0 - y) / (n_0 + y)).powi(2);
        for plane in [Polarisation::S, Polarisation::P, Polarisation::Unpolarised] {
            let [r, t, a] = one(stack.as_ref().unwrap(), 0.0, 550.0, plane);
            assert!((r - exact).abs() < 1e-12, "{pairs}: {r} {exact}");
            assert!((r + t - 1.0).abs() < 1e-13 && a == 0.0);
        }
    }
}

#[test]
fn thousands_of_absorbing_layers_are_finite() {
    let thickness_nm: Vec<f64> = (0..5000).map(|i| 300.0 + f64::from(i % 97)).collect();
    let angles = [0.0, 0.7, 1.4, FRAC_PI_2];
    let wavelengths = [1.0, 380.0, 550.0, 1e6];
    let indices = [0.001, 0.05, 1.0, 1.5, 100.0];
    for n in indices {
        for k in [0.0, 1e-9, 0.01, 3.0, 100.0] {
            for protein in
                [Complex64::new(1.43, 0.0), Complex64::new(0.05, 4.0), Complex64::new(100.0, 100.0)]
            {
                let aragonite = medium(Complex64::new(n, k));
                let s = LayerStack::new(
                    thickness_nm.clone(),
                    20.0,
                    aragonite,
                    medium(protein),
                    real(1.5),
                    medium(Complex64::new(0.2, 3.4)),
                )
                .unwrap();
                for (precision, margin) in [(Precision::Double, 1e-9), (Precision::Single, 1e-4)] {
                    let model = TransferModel {
                        polarisation: Polarisation::Unpolarised,
                        precision,
                        ..TransferModel::default()
                    };
                    let e = model
                        .energies(&s, &angles, &wavelengths, &AtomicBool::new(false))
                        .unwrap()
                        .unwrap();
                    for share in e.into_flat() {
                        assert!((0.0..=1.0 + margin).contains(&share), "{n} {k} {protein} {share}");
                    }
                }
            }
        }
    }
}

#[test]
fn a_stopped_computation_has_no_answer() {
    let stack = LayerStack::new(vec![400.0], 20.0, real(1.53), real(1.43), real(1.0), real(1.53));
    let stopped = TransferModel::default().energies(
        &stack.unwrap(),
        &[0.0],
        &[500.0],
        &AtomicBool::new(true),
    );
    assert_eq!(stopped, Ok(None));
}

fn any_index() -> impl Strategy<Value = Complex64> {
    prop_oneof![
        (0.9..3.0).prop_map(Complex64::from),
        (0.9..3.0, 0.0..0.05).prop_map(|(n, k)| Complex64::new(n, k)),
        (0.04..3.0, 0.5..6.0).prop_map(|(n, k)| Complex64::new(n, k)),
    ]
}

fn any_medium() -> impl Strategy<Value = Medium> {
    prop_oneof![
        any_index().prop_map(medium),
        (any_index(), any_index()).prop_map(|(o, e)| {
            let index = |n: Complex64| Index::new("medium", n.re, n.im).unwrap();
            Medium::uniaxial(index(o), index(e))
        }),
    ]
}

/// Optically denser than any ambient of these tests: light runs through it at every angle.
fn dense_medium() -> impl Strategy<Value = Medium> {
    let index = || {
        (1.35..3.0, prop_oneof![Just(0.0), 0.0..0.05])
            .prop_map(|(n, k)| Index::new("medium", n, k).unwrap())
    };
    prop_oneof![
        index().prop_map(Medium::from),
        (index(), index()).prop_map(|(o, e)| Medium::uniaxial(o, e)),
    ]
}

fn any_plane() -> impl Strategy<Value = Polarisation> {
    prop_oneof![Just(Polarisation::S), Just(Polarisation::P), Just(Polarisation::Unpolarised)]
}

fn layers() -> impl Strategy<Value = Vec<f64>> {
    prop::collection::vec(5.0..900.0, 1..40)
}

proptest! {
    #[test]
    fn r_plus_t_plus_a_is_one(
        d in prop::collection::vec(5.0..900.0, 1..400), d_p in 0.0..80.0, aragonite in dense_medium(), protein in dense_medium(),
        n_0 in 1.0..1.3, substrate in any_medium(), angle in 0.0..FRAC_PI_2, nm in 300.0..900.0, plane in any_plane(),
    ) {
        let stack = LayerStack::new(d, d_p, aragonite, protein, real(n_0), substrate).unwrap();
        let [r, t, a] = one(&stack, angle, nm, plane);
        prop_assert!((r + t + a - 1.0).abs() < 1e-12, "{} {} {}", r, t, a);
        prop_assert!(r > -1e-13 && t >= 0.0 && a >= 0.0);
    }

    /// Light that tunnels into a layer between two others is stored there, and a field greater inside
    /// than outside takes its rounding with it: resonances lose digits in every method.
    #[test]
    fn r_plus_t_plus_a_is_one_where_light_tunnels(
        d in layers(), d_p in 0.0..80.0, aragonite in any_medium(), protein in any_medium(),
        n_0 in 1.0..1.6, substrate in any_medium(), angle in 0.0..FRAC_PI_2, nm in 300.0..900.0, plane in any_plane(),
    ) {
        let stack = LayerStack::new(d, d_p, aragonite, protein, real(n_0), substrate).unwrap();
        let [r, t, a] = one(&stack, angle, nm, plane);
        prop_assert!((r + t + a - 1.0).abs() < 1e-12, "{} {} {}", r, t, a);
        prop_assert!(r > -1e-13 && t >= 0.0 && a >= 0.0);
    }

    /// Turned over, with the light at the matching angle, a stack transmits the same; a lossless one
    /// reflects the same too.
    #[test]
    fn transmittance_is_reciprocal(
        pairs in 1_usize..60, d_nm in 5.0..900.0, d_p in 1.0..80.0, aragonite in dense_medium(), protein in dense_medium(),
        n_0 in 1.0..1.3, n_s in 1.3..2.0, angle in 0.0..1.5_f64, nm in 300.0..900.0, plane in any_plane(),
    ) {
        let lossless = [&aragonite, &protein].iter().all(|m| {
            let both = m.constant().unwrap();
            both.ordinary.is_lossless() && both.extraordinary.is_lossless()
        });
        let down = LayerStack::new(vec![d_nm; pairs], d_p, aragonite.clone(), protein.clone(), real(n_0), real(n_s)).unwrap();
        let up = LayerStack::new(vec![d_p; pairs], d_nm, protein, aragonite, real(n_s), real(n_0)).unwrap();
        let below = (n_0 * angle.sin() / n_s).asin();
        let (down, up) = (one(&down, angle, nm, plane), one(&up, below, nm, plane));
        prop_assert!((down[1] - up[1]).abs() < 1e-11, "{:?} {:?}", down, up);
        if lossless {
            prop_assert!((down[0] - up[0]).abs() < 1e-11, "{:?} {:?}", down, up);
        }
    }

    /// Between two half-spaces of the protein the order of different layers can be turned too.
    #[test]
    fn a_lossless_stack_reflects_the_same_from_both_sides(
        d in prop::collection::vec(5.0..900.0, 1..400), d_p in 1.0..80.0, n_a in 1.5..2.0, n_p in 1.2..1.5, angle in 0.0..1.5, nm in 300.0..900.0, plane in any_plane(),
    ) {
        let stack = |d: Vec<f64>| LayerStack::new(d, d_p, real(n_a), real(n_p), real(n_p), real(n_p)).unwrap();
        let turned = d.iter().rev().copied().collect();
        let (down, up) = (one(&stack(d), angle, nm, plane), one(&stack(turned), angle, nm, plane));
        prop_assert!((down[0] - up[0]).abs() < 1e-11 && (down[1] - up[1]).abs() < 1e-11, "{:?} {:?}", down, up);
    }

    #[test]
    fn a_vanishing_stack_is_fresnels_boundary(
        aragonite in any_medium(), protein in any_medium(), n_0 in 1.0..1.6, n_s in any_index(), angle in 0.0..1.57, nm in 300.0..900.0,
    ) {
        let stack = LayerStack::new(vec![1e-12], 0.0, aragonite, protein, real(n_0), medium(n_s)).unwrap();
        let index = |n: Complex64| Index::new("medium", n.re, n.im).unwrap();
        let exact = fresnel(index(Complex64::from(n_0)), index(n_s), angle).unwrap();
        for (plane, r, t) in [(Polarisation::S, exact.R_s, exact.T_s), (Polarisation::P, exact.R_p, exact.T_p)] {
            let [found_r, found_t, _] = one(&stack, angle, nm, plane);
            prop_assert!((found_r - r).abs() < 1e-9 && (found_t - t).abs() < 1e-9, "{} {} {} {}", found_r, r, found_t, t);
        }
    }

    /// The other kernel gives the same: an absorption too small to see.
    #[test]
    fn lossless_is_the_limit_of_absorbing(
        d in prop::collection::vec(5.0..900.0, 1..400), n_a in 1.2..2.0, n_p in 1.2..2.0, angle in 0.0..1.57, nm in 300.0..900.0, plane in any_plane(),
    ) {
        let stack = |k: f64| LayerStack::new(d.clone(), 20.0, medium(Complex64::new(n_a, k)), real(n_p), real(1.0), real(1.53)).unwrap();
        let (exact, almost) = (one(&stack(0.0), angle, nm, plane), one(&stack(1e-18), angle, nm, plane));
        for (a, b) in exact.iter().zip(almost) {
            prop_assert!((a - b).abs() < 2e-12, "{} {}", a, b);
        }
    }

    #[test]
    fn single_precision_errs_by_what_it_says(
        d in prop::collection::vec(300.0..600.0, 1..400), n_p in 1.4..1.6, n_e in 1.5..1.7, angle in 0.0..1.57, plane in any_plane(),
    ) {
        let index = |n| Index::new("medium", n, 0.0).unwrap();
        let aragonite = Medium::uniaxial(index(1.683), index(n_e));
        let stack = LayerStack::new(d, 20.0, aragonite, real(n_p), real(1.0), real(1.53)).unwrap();
        let nm: Vec<f64> = (380..=780).map(f64::from).collect();
        let [double, single] = [Precision::Double, Precision::Single].map(|precision| {
            TransferModel { polarisation: plane, precision, ..TransferModel::default() }.energies(&stack, &[angle], &nm, &AtomicBool::new(false)).unwrap().unwrap().reflectance().to_vec()
        });
        let worst = double.iter().zip(&single).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        prop_assert!(worst < 2e-4, "{}", worst);
    }
}
