//! A film of nacre on microfacets: what enters, what leaves again.
//!
//! The film's reflectance averaged over sampled facets; Funk and Hecke's theorem; a geometric series over all ways inside.
//! Left out: colours of light that meets two facets, which is taken to enter.

use crate::{
    light::bands::{BANDS, Bands},
    surface::{
        film::{self, Film, STEPS},
        lobe::{FACETS, FEW_FACETS, Lobe, lobes},
        microfacets::Microfacets,
        waviness::Waviness,
    },
};

/// A film of nacre on facets: how much light leaves again after one facet, and how much enters.
///
/// Light that a facet mirrors onto another is taken to enter there: of what is mirrored twice, a few
/// percent of a few percent, the model knows nothing else. Nothing is lost.
#[derive(Debug, Clone)]
pub struct Surface {
    /// Modes of light in the nacre below, for each of the air's.
    modes: Bands,
    /// What mirrors, each in its own direction: the surface, and the layers where they wave against it.
    lobes: Vec<Lobe>,
    /// Share that enters, or leaves from inside, by the cosine to the surface's normal.
    entering: Vec<Bands>,
    entering_from_all_sides: Bands,
}

/// Steps of integrals over the hemisphere.
const FINE_STEPS: usize = 1024;

impl Surface {
    /// Puts the film on the facets, its layers waving against them.
    pub fn new(film: &Film, microfacets: Microfacets, waviness: Waviness) -> Self {
        Self::of_lobes(film, lobes(film, microfacets, waviness, FACETS))
    }

    /// The same by fewer facets: for previews.
    pub fn quick(film: &Film, microfacets: Microfacets, waviness: Waviness) -> Self {
        Self::of_lobes(film, lobes(film, microfacets, waviness, FEW_FACETS))
    }

    fn of_lobes(film: &Film, lobes: Vec<Lobe>) -> Self {
        let mut entering = vec![[1.0; BANDS]; STEPS + 1];
        for lobe in &lobes {
            for (left, albedo) in entering.iter_mut().zip(lobe.albedo_rows()) {
                *left = std::array::from_fn(|band| left[band] - albedo[band]);
            }
        }
        let entering = entering.iter().map(|row| row.map(|share| share.clamp(0.0, 1.0))).collect();
        let entering_from_all_sides = [0.0; BANDS];
        let modes = *film.modes();
        let mut surface = Self { modes, lobes, entering, entering_from_all_sides };
        surface.entering_from_all_sides = surface.moments(0)[0];
        surface
    }

    /// What mirrors, the sharpest first: the surface, and the layers where they wave.
    pub fn lobes(&self) -> &[Lobe] {
        &self.lobes
    }

    /// Share that enters, or leaves from inside, by the cosine to the surface's normal.
    pub fn entering(&self, cosine: f64) -> Bands {
        film::at(&self.entering, cosine)
    }

    /// The part of light from all sides that enters: 2 times the integral of the share times cosine.
    pub fn entering_from_all_sides(&self) -> Bands {
        self.entering_from_all_sides
    }

    /// What the surface makes of waves of light on the sphere of directions, by degree: the eigenvalues of
    /// the entering share times cosine (Funk and Hecke), such that light of radiance 1 from all sides
    /// gives degree 0 the share that enters.
    pub(crate) fn moments(&self, top: usize) -> Vec<Bands> {
        let mut moments = vec![[0.0; BANDS]; top + 1];
        let step = 1.0 / FINE_STEPS as f64;
        for i in 0..FINE_STEPS {
            let cosine = (i as f64 + 0.5) * step;
            let share = self.entering(cosine).map(|share| 2.0 * share * cosine * step);
            for (moment, legendre) in moments.iter_mut().zip(legendre(cosine)) {
                for (sum, part) in moment.iter_mut().zip(&share) {
                    *sum += part * legendre;
                }
            }
        }
        moments
    }

    /// Of light spread inside, what leaves again after `body` (its share sent back, by band) and the
    /// surface from below have thrown it to and fro: for light that entered, radiance just outside over
    /// the share [`Self::entering`] in the direction of leaving.
    ///
    /// Inside, light fills all waves of the nacre alike. What the surface lets out of them is what it lets
    /// in of the air's, of which the nacre has `modes` times as many; the rest is mirrored back, total
    /// reflection included.
    pub fn leaving(&self, body: &Bands) -> Bands {
        let (enters, modes) = (self.entering_from_all_sides(), &self.modes);
        std::array::from_fn(|band| {
            let kept = 1.0 - enters[band] / modes[band];
            body[band] / (modes[band] * (1.0 - body[band] * kept))
        })
    }
}

/// Legendre's polynomials from degree 0 up.
pub(crate) fn legendre(x: f64) -> impl Iterator<Item = f64> {
    let (mut now, mut next, mut degree) = (1.0, x, 0.0);
    std::iter::from_fn(move || {
        let given = now;
        degree += 1.0;
        (now, next) = (next, ((2.0 * degree + 1.0) * x * next - degree * now) / (degree + 1.0));
        Some(given)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn level(film: &Film, microfacets: Microfacets) -> Surface {
        Surface::new(film, microfacets, Waviness::new(0.0))
    }

    fn mean(bands: &Bands) -> f64 {
        bands.iter().sum::<f64>() / BANDS as f64
    }

    #[test]
    fn a_clear_surface_lets_in_like_a_matt_one() {
        let surface = level(&Film::even(0.0, 1.0), Microfacets::grooves(0.05));
        let moments = surface.moments(4);
        // Ramamoorthi and Hanrahan 2001, over pi: 1, 2/3, 1/4, 0, -1/24.
        for (moment, law) in moments.iter().zip([1.0, 2.0 / 3.0, 0.25, 0.0, -1.0 / 24.0]) {
            assert!((mean(moment) - law).abs() < 1e-5, "{} {law}", mean(moment));
        }
        assert!((mean(&surface.leaving(&[1.0; BANDS])) - 1.0).abs() < 1e-5);
    }

    #[test]
    fn what_a_lossless_pearl_takes_in_it_gives_back() {
        for microfacets in [Microfacets::grooves(0.25), Microfacets::ggx(0.3)] {
            let surface = level(&Film::even(0.3, 1.6), microfacets);
            let (enters, leaves) =
                (surface.entering_from_all_sides(), surface.leaving(&[1.0; BANDS]));
            assert!((enters[9] * leaves[9] - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn light_lost_inside_is_the_sum_over_all_its_ways() {
        // An independent count: each round the body keeps 1 - rho, the surface lets out a share e.
        let surface = level(&Film::even(0.2, 1.6), Microfacets::grooves(0.05));
        let (rho, n2) = (0.8, 1.6 * 1.6);
        let out = surface.entering_from_all_sides()[0] / n2;
        let (mut inside, mut left) = (1.0, 0.0);
        for _ in 0..2000 {
            inside *= rho;
            left += inside * out;
            inside *= 1.0 - out;
        }
        // All sides together give `leaving` times the share that leaves.
        let stated = surface.leaving(&[rho; BANDS])[0] * surface.entering_from_all_sides()[0];
        assert!((stated - left).abs() < 1e-9, "{stated} {left}");
    }

    #[test]
    fn legendres_polynomials_are_those_of_the_books() {
        let given: Vec<f64> = legendre(0.5).take(5).collect();
        let books = [1.0, 0.5, -0.125, -0.4375, -0.289_062_5];
        assert!(given.iter().zip(books).all(|(a, b)| (a - b).abs() < 1e-15));
    }
}
