//! What scatters light in all directions: the two fluxes of Kubelka and Munk.

use libm::{exp, expm1, sqrt};

/// Diffuse reflectance of a layer that scatters and absorbs, on a background (Kubelka and Munk 1931).
///
/// Scattering S and absorption K per mm and the thickness in mm are 0 or more and finite, the
/// background's reflectance is 0 to 1; so is what comes out. Both fluxes are those inside the medium:
/// what its surface sends back is for the caller to add.
///
/// The textbook's hyperbolic cotangent is written with exp(-2 k h), k^2 = K (K + 2 S), in sums of
/// positive terms alone. So nothing cancels, and the limits come by themselves: S h / (1 + S h) over
/// black where K = 0, exp(-2 K h) times the background where S = 0, and for thick layers
/// S / (K + S + k), whatever lies below. Without absorption a white background stays exactly 1.
///
/// ```
/// use nacreous_optics::kubelka_munk;
/// assert_eq!(kubelka_munk(3.0, 0.0, 0.5, 1.0), 1.0);
/// assert!((kubelka_munk(4.0, 0.0, 0.5, 0.0) - 2.0 / 3.0).abs() < 1e-15);
/// ```
pub fn kubelka_munk(
    scattering_per_mm: f64,
    absorption_per_mm: f64,
    thickness_mm: f64,
    background: f64,
) -> f64 {
    let (s, k, h) = (scattering_per_mm, absorption_per_mm, thickness_mm);
    let decay = sqrt(k * (k + 2.0 * s));
    let depth = 2.0 * decay * h;
    let through = exp(-depth);
    // (1 - exp(-2 k h)) / (2 k), which is h where nothing is absorbed.
    let reach = if depth > 0.0 { -expm1(-depth) / (2.0 * decay) } else { h };
    let endless = if s > 0.0 { s / (k + s + decay) } else { 0.0 };
    let sent_back = s * reach * (1.0 - background * endless) + background * through;
    sent_back / ((k + s - background * s) * reach + 0.5 * (1.0 + through))
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// The two fluxes by Runge and Kutta's fourth order, from the background up to the surface.
    fn integrated(s: f64, k: f64, h: f64, background: f64) -> f64 {
        const STEPS: usize = 4000;
        let rise = |[down, up]: [f64; 2]| [(k + s) * down - s * up, s * down - (k + s) * up];
        let step = h / STEPS as f64;
        let mut flux = [1.0, background];
        for _ in 0..STEPS {
            let ahead = |slope: [f64; 2], share: f64| {
                [flux[0] + share * step * slope[0], flux[1] + share * step * slope[1]]
            };
            let first = rise(flux);
            let second = rise(ahead(first, 0.5));
            let third = rise(ahead(second, 0.5));
            let fourth = rise(ahead(third, 1.0));
            for i in 0..2 {
                flux[i] += step / 6.0 * (first[i] + 2.0 * (second[i] + third[i]) + fourth[i]);
            }
        }
        flux[1] / flux[0]
    }

    #[test]
    fn the_two_fluxes_integrated_give_the_same() {
        for s in [0.0, 0.3, 3.0, 20.0] {
            for k in [0.0, 1e-9, 1e-3, 0.2, 4.0] {
                for h in [0.01, 0.3, 1.0] {
                    for background in [0.0, 0.4, 0.9, 1.0] {
                        let exact = kubelka_munk(s, k, h, background);
                        let found = integrated(s, k, h, background);
                        assert!((exact - found).abs() < 1e-10, "{s} {k} {h} {background}");
                    }
                }
            }
        }
    }

    #[test]
    fn its_limits_are_the_known_ones() {
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-14 * b, "{a} {b}");
        let (s, k, h, background) = (3.0, 0.7, 0.4, 0.9);
        let inward: f64 = s * h * (1.0 - background);
        close(kubelka_munk(s, 0.0, h, background), (inward + background) / (inward + 1.0));
        close(kubelka_munk(0.0, k, h, background), (-2.0 * k * h).exp() * background);
        close(kubelka_munk(0.0, 1.0, 200.0, 0.5), 0.5 * (-400.0_f64).exp());
        let a: f64 = 1.0 + k / s;
        for background in [0.0, 0.5, 1.0] {
            close(kubelka_munk(s, k, 1e6, background), a - (a * a - 1.0).sqrt());
        }
        close(kubelka_munk(s, k, 0.0, background), background);
        close(kubelka_munk(0.0, 0.0, h, background), background);
    }

    #[test]
    fn weak_absorption_goes_over_into_none() {
        // Paints: the change by K is proportional to it, down to where it no longer shows.
        let none = kubelka_munk(3.0, 0.0, 0.5, 0.6);
        let slope = (none - kubelka_munk(3.0, 1e-6, 0.5, 0.6)) / 1e-6;
        for k in [1e-7, 1e-9, 1e-11] {
            let loss = none - kubelka_munk(3.0, k, 0.5, 0.6);
            assert!((loss - slope * k).abs() < 1e-5 * slope * k + 4.0 * f64::EPSILON);
        }
        assert!((kubelka_munk(3.0, 1e-300, 0.5, 0.6) - none).abs() < 4.0 * f64::EPSILON);
    }

    #[test]
    fn without_loss_nothing_is_lost() {
        for s in [0.0, 0.1, 3.0, 1000.0] {
            for h in [0.0, 0.01, 0.5, 15.0] {
                assert!(kubelka_munk(s, 0.0, h, 1.0).to_bits() == 1.0_f64.to_bits());
            }
        }
    }

    proptest! {
        #[test]
        fn reflectance_goes_steadily_from_the_background_to_that_of_endless_depth(
            s in 0.0..1000.0_f64, k in 0.0..100.0_f64, background in 0.0..=1.0_f64,
            thin in 1e-4..15.0_f64, more in 1e-4..15.0_f64,
        ) {
            let at = |h| kubelka_munk(s, k, h, background);
            let (first, then, last) = (at(thin), at(thin + more), at(1e9));
            let rounding = 1e-13;
            let (low, high) = (background.min(last) - rounding, background.max(last) + rounding);
            prop_assert!((low..=high).contains(&first));
            prop_assert!((then - first) * (last - background) >= -rounding);
            prop_assert!((0.0..=1.0).contains(&first));
        }

        #[test]
        fn more_absorption_sends_less_back(
            s in 0.0..100.0_f64, k in 0.0..100.0_f64, more in 0.0..10.0_f64,
            background in 0.0..=1.0_f64, h in 0.0..5.0_f64,
        ) {
            let (pale, dark) = (kubelka_munk(s, k, h, background), kubelka_munk(s, k + more, h, background));
            prop_assert!(dark <= pale + 1e-14);
        }
    }
}
