//! What depends on a film whose layers are thinner here and thicker there: tables by thickness.
//!
//! Straight lines between films whose thickness differs by even steps.
//! Left out: films beyond the first and last, which count as these.

use crate::rgb::{self, Rgb};

/// Something of films, by the thickness of their layers: thinnest first, an odd number in even steps about 1.
#[derive(Debug)]
pub(crate) struct Films<T> {
    all: Vec<T>,
    step: f64,
}

/// A place between two films.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FilmAt {
    film: usize,
    /// How far on to the next, 0 to 1.
    share: f64,
}

impl<T> Films<T> {
    /// Of films whose thickness is `step` apart, as a share of the middle one's.
    pub(crate) fn new(all: Vec<T>, step: f64) -> Self {
        Self { all, step }
    }

    /// Something of each film in both.
    pub(crate) fn with<U, V>(&self, other: &Films<U>, of: impl Fn(&T, &U) -> V) -> Films<V> {
        let both = self.all.iter().zip(&other.all);
        Films { all: both.map(|(a, b)| of(a, b)).collect(), step: self.step }
    }

    /// Those of the films before and behind layers that are so many times as thick as on average, and how far on to the
    /// second they are; the same twice where they are one's.
    pub(crate) fn both(&self, thickness: f64) -> (&T, &T, f64) {
        let FilmAt { film, share } = self.place(thickness);
        (&self.all[film], &self.all[film + usize::from(share > 0.0)], share)
    }

    /// That of layers as thick as on average.
    pub(crate) fn middle(&self) -> &T {
        &self.all[self.all.len() / 2]
    }

    /// Where layers lie that are so many times as thick as on average.
    pub(crate) fn place(&self, thickness: f64) -> FilmAt {
        let last = self.all.len() - 1;
        if last == 0 {
            return FilmAt { film: 0, share: 0.0 };
        }
        let x = ((thickness - 1.0) / self.step + 0.5 * last as f64).clamp(0.0, last as f64);
        let film = (x as usize).min(last - 1);
        FilmAt { film, share: x - film as f64 }
    }

    /// A colour of a film there.
    pub(crate) fn between(&self, place: FilmAt, colour: impl Fn(&T) -> Rgb) -> Rgb {
        let here = colour(&self.all[place.film]);
        if place.share <= 0.0 {
            return here;
        }
        rgb::mix(here, colour(&self.all[place.film + 1]), place.share)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_thickness_lies_between_its_films() {
        let films = Films::new(vec![0.9, 1.0, 1.1], 0.1);
        for (thickness, expected) in
            [(1.0, 1.0), (0.93, 0.93), (1.07, 1.07), (0.5, 0.9), (2.0, 1.1)]
        {
            let found = films.between(films.place(thickness), |film| [*film; 3])[0];
            assert!((found - expected).abs() < 1e-12, "{thickness}: {found}");
        }
        let one = Films::new(vec![[0.25; 3]], 0.1);
        assert!((one.between(one.place(1.3), |film| *film)[1] - 0.25).abs() < 1e-12);
    }
}
