//! Terraces too fine to be seen apart, as the rulings of a grating.
//!
//! A blazed grating: treads send light where they mirror it, and only into directions between which the way differs by whole
//! waves; each order's share is sinc^2 (Born and Wolf, 8.6.1).
//! Left out: spirals, and light that the steps of one lobe send into the other.

use std::f64::consts::PI;

use glam::DVec3;

/// Terraces at a place, as rulings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rulings {
    /// Along the surface, up the growth front.
    pub up: DVec3,
    /// How many there are in a millimetre.
    pub per_mm: f64,
    /// Height of a step.
    pub step_mm: f64,
    /// Share of them that is finer than what is looked at.
    pub unseen: f64,
    /// The part of the mean square of unseen slopes that is theirs.
    pub fine_slope2: f64,
}

/// One direction into which rulings send light.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Order {
    /// How far the normal leans up the growth front that would mirror light into it.
    pub(crate) lean: f64,
    /// Its share of the light.
    pub(crate) share: f64,
}

/// So many orders about the treads' own direction hold 90 % of the light; they are taken for all of it.
const ORDERS: i32 = 4;

impl Rulings {
    /// The orders that hold most of the light of a wavelength, at a cosine of incidence. Their shares add up to 1.
    pub(crate) fn orders(&self, wavelength_mm: f64, cosine: f64) -> [Order; ORDERS as usize] {
        let cosine = cosine.max(LEAST_COSINE);
        // Where the treads mirror to, in orders.
        let blaze = 2.0 * self.step_mm * cosine / wavelength_mm;
        let first = libm::floor(blaze) as i32 - ORDERS / 2 + 1;
        let mut sum = 0.0;
        let mut orders = [Order { lean: 0.0, share: 0.0 }; ORDERS as usize];
        for (number, order) in (first..).zip(&mut orders) {
            let number = f64::from(number);
            order.lean = number * wavelength_mm * self.per_mm / (2.0 * cosine);
            order.share = sinc(number - blaze).powi(2);
            sum += order.share;
        }
        orders.map(|order| Order { share: order.share / sum, ..order })
    }
}

/// At grazing angles steps hide each other.
const LEAST_COSINE: f64 = 0.1;

fn sinc(x: f64) -> f64 {
    if x.abs() < 1e-9 { 1.0 } else { libm::sin(PI * x) / (PI * x) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RULINGS: Rulings =
        Rulings { up: DVec3::X, per_mm: 50.0, step_mm: 4e-4, unseen: 1.0, fine_slope2: 0.0 };

    /// The amplitude that a staircase of 40 treads, in steps of a hundredth of a tread, sends where a normal that leans
    /// `lean` would mirror it, straight from above.
    fn brute(lean: f64, wavelength_mm: f64) -> f64 {
        let (mut re, mut im, count) = (0.0, 0.0, 4000);
        for i in 0..count {
            let x_mm = f64::from(i) / 100.0 / RULINGS.per_mm;
            let height_mm = -RULINGS.step_mm * (x_mm * RULINGS.per_mm).fract();
            let phase = 2.0 * PI / wavelength_mm * 2.0 * (height_mm + lean * x_mm);
            (re, im) = (re + phase.cos(), im + phase.sin());
        }
        (re * re + im * im) / f64::from(count).powi(2)
    }

    #[test]
    fn orders_are_those_of_a_sum_over_the_stairs() {
        for wavelength_mm in [4.64e-4, 5.49e-4, 6.11e-4] {
            let orders = RULINGS.orders(wavelength_mm, 1.0);
            let whole: f64 = orders.iter().map(|order| brute(order.lean, wavelength_mm)).sum();
            assert!(whole > 0.85, "{whole}");
            for order in orders {
                let exact = brute(order.lean, wavelength_mm) / whole;
                assert!((order.share - exact).abs() < 0.01, "{order:?} {exact}");
            }
            // Between two orders there is next to nothing.
            let between = 0.5 * (orders[1].lean + orders[2].lean);
            assert!(brute(between, wavelength_mm) < 1e-3);
        }
    }

    #[test]
    fn steps_of_many_waves_mirror_as_their_treads_do() {
        let high = Rulings { step_mm: 0.02, ..RULINGS };
        let mean: f64 = high.orders(5.5e-4, 1.0).iter().map(|order| order.lean * order.share).sum();
        assert!((mean / (high.step_mm * high.per_mm) - 1.0).abs() < 0.02, "{mean}");
    }
}
