//! Tables of any values `[angle, wavelength]`, one point at a time, filled on all processors.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::parallel;

/// `of` (cosine, place of the wavelength) at each angle and wavelength, on all processors.
pub(crate) fn table<T: Send>(
    angle_rad: &[f64],
    wavelength_nm: &[f64],
    stop: &AtomicBool,
    of: &(impl Fn(f64, usize) -> T + Sync),
) -> Option<Vec<T>> {
    let mut found = Vec::new();
    rows(angle_rad, wavelength_nm.len(), stop, of, &mut found);
    (!stop.load(Ordering::Relaxed)).then_some(found)
}

fn rows<T: Send>(
    angle_rad: &[f64],
    wavelengths: usize,
    stop: &AtomicBool,
    of: &(impl Fn(f64, usize) -> T + Sync),
    found: &mut Vec<T>,
) {
    match angle_rad {
        [] => {}
        [angle] => {
            let go_on = |_: &usize| !stop.load(Ordering::Relaxed);
            found.extend((0..wavelengths).take_while(go_on).map(|at| of(angle.cos(), at)));
        }
        _ => {
            let (first, second) = angle_rad.split_at(angle_rad.len() / 2);
            let mut after = Vec::new();
            parallel::join(
                || rows(first, wavelengths, stop, of, found),
                || rows(second, wavelengths, stop, of, &mut after),
            );
            found.append(&mut after);
        }
    }
}
