//! What some facets show of the surroundings, added up.
//!
//! A control variate: what all facets mirror of even surroundings is known.
//! Left out: which facets, and where they look.

use nacreous_colour::{Matrix, matrix::apply};

use crate::{
    pearl::reflection_cache::Around,
    rgb::{self, Rgb},
};

/// Some facets' view of the surroundings.
#[derive(Debug, Default)]
pub(crate) struct Gathered {
    weight: f64,
    /// Sum of what the film mirrors, from RGB to RGB.
    film: Matrix,
    /// Sum of the surroundings' light, before the film and after it.
    light: Rgb,
    mirrored: Rgb,
}

impl Gathered {
    /// Adds a facet that counts `weight`, mirrors by `film` and shows `light`.
    #[inline]
    pub(crate) fn add(&mut self, weight: f64, film: &Matrix, light: Rgb) {
        self.weight += weight;
        for (sum, row) in self.film.iter_mut().zip(film) {
            rgb::add(sum, rgb::scaled(*row, weight));
        }
        rgb::add(&mut self.light, rgb::scaled(light, weight));
        rgb::add(&mut self.mirrored, rgb::scaled(apply(film, light), weight));
    }

    /// Few facets give the surroundings' colours; `all` of them how much is mirrored: exactly where the
    /// surroundings are even (a control variate).
    pub(crate) fn around(&self, all: &Matrix) -> Around {
        let of_white = |film: &Matrix| rgb::luminance(apply(film, [1.0; 3]));
        let some = of_white(&self.film);
        if some <= 0.0 {
            return Around::default();
        }
        let share = of_white(all) / some;
        let light = rgb::scaled(self.light, 1.0 / self.weight);
        let even = apply(&self.film, light);
        Around { light, rest: std::array::from_fn(|i| (self.mirrored[i] - even[i]) * share) }
    }
}
