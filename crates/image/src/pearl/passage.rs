//! What becomes of light between entering a pearl and leaving it, by degree and band.
//!
//! Eigenvalues of the surface (Funk and Hecke) times exp(-l (l + 1) spread) **(ours)**, to the degree that counts.
//! Left out: where the light comes from, which is each place's own.

use crate::{
    light::{
        bands::{BANDS, Bands},
        palette::Palette,
    },
    parallel,
    pearl::{body::Body, films::Films},
    rgb,
    surface::{coating::Surface, film::STEPS},
};

/// What becomes of light in a pearl, from outside through the surface, the body and the surface again: all that
/// does not depend on where the light comes from.
#[derive(Debug)]
pub(crate) struct Passage {
    palette: Palette,
    /// What is left of waves of light when they are about to leave, by degree.
    shares: Vec<Bands>,
    /// What the surface lets in, by degree and by cosine.
    entering_moments: Vec<Bands>,
    entering: Vec<Bands>,
    /// Of light spread evenly inside, what leaves.
    leaving_evenly: Bands,
    /// Share of even light that comes back.
    albedo: Bands,
    /// How far light wanders.
    spread: f64,
    /// RGB of what leaves, by band: by the thickness of the layers and the cosine of the view angle, and through a film
    /// without colour.
    leaving: Films<Vec<[[f32; BANDS]; 3]>>,
    leaving_plain: [[f32; BANDS]; 3],
    /// What such a film lets through.
    plain: f64,
}

/// The highest degree of the waves; what a point lamp leaves out at its terminator is 0.3 % of its light.
const TOP: usize = 40;

/// The highest degree of light around a pearl that is not round, which is looked up by normal before it wanders.
pub(crate) const TOP_AROUND: usize = 24;

/// Degrees of which less than this is left, of a point lamp's light at its brightest, are left out: the step
/// between 8-bit codes is hundreds of times as large.
const LEAST_LEFT: f64 = 1e-6;

/// Steps of [`Surface::entering`] in the cosine, of which the nearest is taken.
pub(crate) const COSINES: usize = 8 * STEPS;

/// Cosines of tables that have so many steps.
pub(crate) fn cosines() -> impl Iterator<Item = f64> {
    (0..=COSINES).map(|step| step as f64 / COSINES as f64)
}

/// Their row for a cosine.
pub(crate) fn row(cosine: f64) -> usize {
    (cosine.clamp(0.0, 1.0) * COSINES as f64 + 0.5) as usize
}

impl Passage {
    /// Through `surfaces` whose layers' thickness is `step` apart; the middle one stands for all of the pearl.
    pub(crate) fn new((surfaces, step): (&[Surface], f64), body: &Body, palette: &Palette) -> Self {
        let surface = &surfaces[surfaces.len() / 2];
        let leaving = surface.leaving(&body.reflectance);
        let top = top(body.spread);
        let moments = surface.moments(top.max(TOP_AROUND));
        let share = |(l, enters): (usize, &Bands)| {
            let fading = fading(l, body.spread);
            std::array::from_fn(|band| fading * enters[band] * leaving[band])
        };
        let albedo = |band: usize| {
            let enters = moments[0][band];
            1.0 - enters + enters * enters * leaving[band]
        };
        let whole = surface.entering_from_all_sides();
        let plain = rgb::luminance(palette.rgb(&palette.bands_of_white(&whole)));
        let coloured = |share: Bands| by_channel(palette, |band| share[band]);
        let through = |film: usize| {
            cosines().map(|cosine| coloured(surfaces[film].entering(cosine))).collect()
        };
        Self {
            shares: moments[..=top].iter().enumerate().map(share).collect(),
            albedo: std::array::from_fn(albedo),
            entering_moments: moments,
            entering: cosines().map(|cosine| surface.entering(cosine)).collect(),
            leaving_evenly: leaving,
            spread: body.spread,
            leaving: Films::new(parallel::map(surfaces.len(), through), step),
            leaving_plain: by_channel(palette, |_| plain),
            plain,
            palette: palette.clone(),
        }
    }

    /// How the scene's colours become bands.
    pub(crate) fn palette(&self) -> &Palette {
        &self.palette
    }

    /// The highest degree of which anything is left.
    pub(crate) fn top(&self) -> usize {
        self.shares.len() - 1
    }

    /// What is left of waves of a degree when they are about to leave.
    pub(crate) fn share(&self, l: usize) -> &Bands {
        &self.shares[l]
    }

    /// What wandering inside leaves of waves of a degree.
    pub(crate) fn fading(&self, l: usize) -> f64 {
        fading(l, self.spread)
    }

    /// What the surface lets in of waves, by degree.
    pub(crate) fn entering_moments(&self) -> &[Bands] {
        &self.entering_moments
    }

    /// What the surface lets in, by the [`row`] of the cosine to the normal.
    pub(crate) fn entering(&self) -> &[Bands] {
        &self.entering
    }

    /// Of light spread evenly inside what is about to leave.
    pub(crate) fn leaving_evenly(&self) -> &Bands {
        &self.leaving_evenly
    }

    /// The share of even light that comes back, mirrored or from inside.
    pub(crate) fn albedo(&self) -> &Bands {
        &self.albedo
    }

    /// What leaves, by the thickness of the layers: RGB, channel by channel, for light in each band, by the [`row`] of
    /// the cosine to the normal.
    pub(crate) fn leaving(&self) -> &Films<Vec<[[f32; BANDS]; 3]>> {
        &self.leaving
    }

    /// What a film without colour lets through.
    pub(crate) fn plain(&self) -> f64 {
        self.plain
    }

    /// The same through a film without colour, at any cosine.
    pub(crate) fn leaving_plain(&self) -> &[[f32; BANDS]; 3] {
        &self.leaving_plain
    }
}

/// What wandering inside leaves of waves of a degree.
fn fading(l: usize, spread: f64) -> f64 {
    libm::exp(-((l * (l + 1)) as f64) * spread)
}

/// The highest degree that counts.
fn top(spread: f64) -> usize {
    // A point lamp has 2 l + 1 equal waves of each degree.
    let left = |l: usize| (2 * l + 1) as f64 * fading(l, spread);
    (1..=TOP).find(|&l| left(l) < LEAST_LEFT).map_or(TOP, |l| l - 1)
}

/// RGB of each band's light after a filter, channel by channel.
fn by_channel(palette: &Palette, filter: impl Fn(usize) -> f64) -> [[f32; BANDS]; 3] {
    let unit = palette.band_rgb();
    [0, 1, 2].map(|i| std::array::from_fn(|band| (unit[band][i] * filter(band)) as f32))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_the_degrees_left_out_would_add_is_below_the_bound() {
        assert_eq!((top(0.0), top(1000.0)), (TOP, 0));
        for spread in [0.012, 0.05, 0.1163, 1.0] {
            let after: f64 =
                (top(spread) + 1..200).map(|l| (2 * l + 1) as f64 * fading(l, spread)).sum();
            assert!(after < 2.0 * LEAST_LEFT, "{spread}: {after}");
        }
    }
}
