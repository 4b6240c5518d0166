//! Light that comes from inside the nacre, and what it makes together with the surface.

use std::sync::atomic::AtomicBool;

use nacreous_nacre::{Index, LayerStack, Medium};
use nacreous_optics::{Ensemble, Origin, Polarisation, Precision, TransferModel};

const ANGLES_RAD: [f64; 4] = [0.0, 0.5, 1.1, 1.5];
const NM: [f64; 3] = [420.0, 550.0, 680.0];

fn real(n: f64) -> Medium {
    Index::new("medium", n, 0.0).unwrap().into()
}

fn crystal() -> Medium {
    let index = |n| Index::new("aragonite", n, 0.0).unwrap();
    Medium::uniaxial(index(1.683), index(1.53))
}

fn nacre(aragonite: Medium, outermost_nm: f64) -> LayerStack {
    let mut nm: Vec<f64> = (0..40).map(|layer| 340.0 + f64::from(layer * 7 % 13)).collect();
    nm[0] = outermost_nm;
    LayerStack::new(nm, 20.0, aragonite.clone(), real(1.43), real(1.0), aragonite).unwrap()
}

/// The boundary alone: aragonite on aragonite.
fn boundary(aragonite: Medium) -> LayerStack {
    LayerStack::new(vec![300.0], 0.0, aragonite.clone(), real(1.43), real(1.0), aragonite).unwrap()
}

fn mirrored(stack: &LayerStack, origin: Origin, polarisation: Polarisation) -> Vec<f64> {
    let model = TransferModel { polarisation, origin, ..TransferModel::default() };
    let found = model.energies(stack, &ANGLES_RAD, &NM, &AtomicBool::new(false));
    found.unwrap().unwrap().reflectance().to_vec()
}

#[test]
fn light_from_inside_is_that_of_a_stack_in_aragonite_at_snells_angle() {
    let inside: Vec<f64> = ANGLES_RAD.iter().map(|a| (a.sin() / 1.6).asin()).collect();
    let stack = nacre(real(1.6), 400.0);
    let immersed = LayerStack::new(
        stack.thickness_nm().to_vec(),
        20.0,
        real(1.6),
        real(1.43),
        real(1.6),
        real(1.6),
    );
    for polarisation in [Polarisation::S, Polarisation::P, Polarisation::Unpolarised] {
        let model = TransferModel { polarisation, ..TransferModel::default() };
        let never = AtomicBool::new(false);
        let law = model.energies(immersed.as_ref().unwrap(), &inside, &NM, &never);
        let law = law.unwrap().unwrap();
        let found = mirrored(&stack, Origin::Aragonite, polarisation);
        for (a, b) in found.iter().zip(law.reflectance()) {
            assert!((a - b).abs() < 1e-12, "{a} {b}");
        }
    }
}

/// Airy's sum over all phases between two mirrors: their energies added up.
#[test]
fn surface_and_film_without_a_phase_between_them_add_up_by_energy() {
    const STEPS: usize = 256;
    for polarisation in [Polarisation::S, Polarisation::P] {
        let surface = mirrored(&boundary(crystal()), Origin::Ambient, polarisation);
        let film = mirrored(&nacre(crystal(), 400.0), Origin::Aragonite, polarisation);
        for (row, angle) in ANGLES_RAD.iter().enumerate() {
            for (column, nm) in NM.iter().enumerate() {
                let sin = angle.sin();
                let along = match polarisation {
                    Polarisation::P => 1.683 * (1.0 - (sin / 1.53).powi(2)).sqrt(),
                    _ => (1.683_f64.powi(2) - sin * sin).sqrt(),
                };
                // The outermost layer through one whole fringe.
                let whole = (0..STEPS).map(|step| {
                    let more_nm = step as f64 / STEPS as f64 * nm / (2.0 * along);
                    let model = TransferModel { polarisation, ..TransferModel::default() };
                    let stack = nacre(crystal(), 300.0 + more_nm);
                    let found = model.energies(&stack, &[*angle], &[*nm], &AtomicBool::new(false));
                    found.unwrap().unwrap().reflectance()[0]
                });
                let mean = whole.sum::<f64>() / STEPS as f64;
                let place = row * NM.len() + column;
                let (r_s, r_i) = (surface[place], film[place]);
                let law = r_s + (1.0 - r_s).powi(2) * r_i / (1.0 - r_s * r_i);
                assert!((mean - law).abs() < 1e-9, "{polarisation:?} {angle} {nm}: {mean} {law}");
            }
        }
    }
}

#[test]
fn the_outermost_layer_does_not_matter_to_light_from_inside_and_nothing_is_lost() {
    let model = TransferModel { origin: Origin::Aragonite, ..TransferModel::default() };
    let never = AtomicBool::new(false);
    let shares = |nm| {
        let found = model.energies(&nacre(crystal(), nm), &ANGLES_RAD, &NM, &never);
        found.unwrap().unwrap()
    };
    let (thin, thick) = (shares(200.0), shares(517.0));
    for (place, (a, b)) in thin.reflectance().iter().zip(thick.reflectance()).enumerate() {
        assert!((a - b).abs() < 1e-12, "{a} {b}");
        assert!((a + thin.transmittance()[place] - 1.0).abs() < 1e-12);
    }
    for (precision, bound) in [(Precision::Double, 1e-12), (Precision::Single, 2e-4)] {
        let model = TransferModel { precision, ..model };
        let empty = Ensemble::empty(ANGLES_RAD.len() * NM.len());
        let columns = [nacre(crystal(), 200.0), nacre(crystal(), 517.0)];
        let mean = empty.with(model, &columns, &ANGLES_RAD, &NM, &never).unwrap().unwrap();
        let found = mean.reflectance().iter().zip(thin.reflectance());
        assert!(found.into_iter().all(|(a, b)| (a - b).abs() < bound), "{precision:?}");
    }
}
