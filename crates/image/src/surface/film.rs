//! What the outer layers of nacre mirror, as tables.
//!
//! Exact optics of columns of tablets; surface and layers in phase, or each by itself (docs/transport.md, Two lobes).
//! Left out: absorption in the film, which the body has.

use crate::{
    light::bands::{self, BANDS, Bands},
    surface::waviness::Waviness,
};

/// What the outer layers of nacre mirror, by the cosine of the angle of incidence in air and band: exact
/// optics, the mean over columns of tablets. They absorb nothing, so the rest gets through.
#[derive(Debug, Clone, PartialEq)]
pub struct Film {
    mirrors: Mirrors,
    /// Modes of light in the nacre below, for each of the air's.
    modes: Bands,
    /// Of aragonite, for waves along its layers' normal, over air's.
    index: f64,
}

/// Shares mirrored, by cosine, evenly from 0 (grazing) to 1.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Mirrors {
    Together(Vec<Bands>),
    Apart(Apart),
    Both(Vec<Bands>, Apart),
}

/// The surface and the layers below it each by themselves, without a phase between them.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Apart {
    /// What the surface mirrors.
    pub(crate) surface: Vec<Bands>,
    /// What the layers add to it: twice through the surface, and to and fro below it.
    pub(crate) layers: Vec<Bands>,
}

/// Shares that a film's two mirrors send back, by cosine.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Mirrored {
    /// In the surface's own direction.
    pub(crate) sharp: Vec<Bands>,
    /// As the layers lean, where they do.
    pub(crate) layers: Option<LayersMirrored>,
}

/// What layers mirror below the surface.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LayersMirrored {
    /// What the surface lets through, all bands alike.
    pub(crate) passing: Vec<f64>,
    /// Share of the light sent back that goes through the surface as it came, over both passings.
    pub(crate) through: Vec<Bands>,
}

/// Steps in the cosine. The rings of an ensemble are wider than a tenth.
pub(crate) const STEPS: usize = 128;

impl Film {
    /// A film that mirrors the same at every angle and wavelength, above nacre of index `n`.
    pub fn even(reflectance: f64, n: f64) -> Self {
        let mirrors = Mirrors::Together(vec![[reflectance; BANDS]; STEPS + 1]);
        Self { mirrors, modes: [n * n; BANDS], index: n }
    }

    /// The share mirrored at a cosine by level layers, or apart from their phase to the surface.
    #[cfg(test)]
    pub(crate) fn reflectance(&self, cosine: f64) -> Bands {
        match &self.mirrors {
            Mirrors::Together(mirrored) | Mirrors::Both(mirrored, _) => at(mirrored, cosine),
            Mirrors::Apart(Apart { surface, layers }) => {
                let (surface, layers) = (at(surface, cosine), at(layers, cosine));
                std::array::from_fn(|band| surface[band] + layers[band])
            }
        }
    }

    /// What surface and layers mirror each in its own direction, where layers wave.
    pub(crate) fn mirrored(&self, waviness: Waviness) -> Mirrored {
        match &self.mirrors {
            Mirrors::Together(sharp) => Mirrored { sharp: sharp.clone(), layers: None },
            Mirrors::Apart(apart) => Mirrored {
                sharp: apart.surface.clone(),
                layers: Some(LayersMirrored::new(&apart.surface, &apart.layers)),
            },
            Mirrors::Both(together, Apart { surface, layers }) => {
                let row = |(row, cosine): (usize, f64)| {
                    let path = (self.index * self.index - 1.0 + cosine * cosine).max(0.0).sqrt();
                    parted(&together[row], &surface[row], &layers[row], &waviness.in_phase(path))
                };
                let (sharp, leaning): (_, Vec<Bands>) = cosines().enumerate().map(row).unzip();
                Mirrored { sharp, layers: Some(LayersMirrored::new(surface, &leaning)) }
            }
        }
    }

    /// Of what [`FilmDraft`](crate::FilmDraft) found.
    pub(crate) fn of(mirrors: Mirrors, modes: &Bands, index: f64) -> Self {
        Self { mirrors, modes: *modes, index }
    }

    /// Modes of light in the nacre below, for each of the air's.
    pub(crate) fn modes(&self) -> &Bands {
        &self.modes
    }

    /// Of aragonite over air's, for the direction of light below the surface.
    pub(crate) fn index(&self) -> f64 {
        self.index
    }
}

impl LayersMirrored {
    /// Of what the surface mirrors, and what of the layers' light leaves through it.
    fn new(surface: &[Bands], layers: &[Bands]) -> Self {
        let mean = |bands: &Bands| bands.iter().sum::<f64>() / BANDS as f64;
        let passing: Vec<f64> = surface.iter().map(|bands| 1.0 - mean(bands)).collect();
        let over = |row: usize| {
            let twice = passing[row].powi(2);
            layers[row].map(|share| if twice > 0.0 { share / twice } else { 0.0 })
        };
        // Nothing passes at grazing incidence; the next row stands for the limit there.
        let through = (0..layers.len()).map(|row| over(row.max(1))).collect();
        Self { passing, through }
    }
}

/// What goes the surface's way and the layers', of waves of which a share of the amplitude is `in_phase` with
/// the surface's: its square and its product with the surface's stay, the rest goes as the layers lean.
fn parted(together: &Bands, surface: &Bands, layers: &Bands, in_phase: &Bands) -> (Bands, Bands) {
    let square = |band: usize| in_phase[band] * in_phase[band];
    let sharp = std::array::from_fn(|band| {
        let between = together[band] - surface[band] - layers[band];
        let stays = surface[band] + layers[band] * square(band) + between * in_phase[band];
        stays.clamp(0.0, 1.0)
    });
    (sharp, std::array::from_fn(|band| layers[band] * (1.0 - square(band))))
}

/// Cosines of the tables' rows.
pub(crate) fn cosines() -> impl Iterator<Item = f64> {
    (0..=STEPS).map(|step| step as f64 / STEPS as f64)
}

/// Where a cosine lies in a table: the row before it, and how far on to the next.
pub(crate) fn place(cosine: f64) -> (usize, f64) {
    let x = cosine.clamp(0.0, 1.0) * STEPS as f64;
    let i = (x as usize).min(STEPS - 1);
    (i, x - i as f64)
}

/// A row between the table's rows.
pub(crate) fn at(table: &[Bands], cosine: f64) -> Bands {
    let (i, share) = place(cosine);
    bands::mix(&table[i], &table[i + 1], share)
}
