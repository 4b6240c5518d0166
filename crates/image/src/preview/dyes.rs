//! What a film makes of light, in RGB, by the cosine of the view angle: tables for the pixels of a preview.
//!
//! Matrices from light to what is mirrored and what leaves, of `Response`, nearest row. Light inside has the spectrum that the
//! palette gives its colour, as evenly entering light has it, so that films without colour are exact.
//! Left out: what lies between two films whose thickness differs by a step.

use nacreous_colour::{
    Matrix,
    matrix::{inverse, product},
};

use crate::{
    light::bands::BANDS,
    pearl::{
        films::Films,
        lobe_colours::LobeColours,
        passage::{self, Passage},
        response::Response,
    },
};

/// From RGB to RGB, column by column, each filled up to a register.
pub(super) type Dye = [[f32; 4]; 3];

/// Steps of the cosine; neighbours differ by less than a code.
pub(super) const STEPS: usize = 512;

/// The tables of all films of a pearl, by the thickness of their layers.
#[derive(Debug)]
pub struct Dyes(Films<Dyed>);

/// A film's tables.
#[derive(Debug)]
pub(super) struct Dyed {
    /// What is mirrored of the mean light of each lobe.
    pub(super) lobes: Vec<Vec<Dye>>,
    /// What is mirrored of each lamp, by lobe.
    pub(super) lamps: Vec<Vec<Vec<[f32; 3]>>>,
    /// What leaves of light inside that looks so through a film without colour.
    pub(super) leaving: Vec<Dye>,
    /// Factor of chalk on such a film.
    pub(super) chalk: f32,
}

impl Dyes {
    /// Of a response to light.
    pub fn new(response: &Response) -> Self {
        let (passage, lamps) = (response.passage(), response.powers().len());
        let dyed = |lobes: &Vec<_>, leaving: &Vec<_>| Dyed::new(lobes, leaving, &passage, lamps);
        Self(response.films().with(passage.leaving(), dyed))
    }

    /// Those of the films before and behind layers that are so many times as thick as on average, and how far on to the
    /// second they are.
    #[inline]
    pub(super) fn both(&self, thickness: f32) -> (&Dyed, &Dyed, f32) {
        let (one, two, share) = self.0.both(f64::from(thickness));
        (one, two, share as f32)
    }
}

impl Dyed {
    fn new(
        lobes: &[LobeColours],
        leaving: &[[[f32; BANDS]; 3]],
        passage: &Passage,
        lamps: usize,
    ) -> Self {
        let mirrored = |lobe: &LobeColours| {
            cosines().map(|cosine| dye(lobe.mirrored_by_all(cosine))).collect()
        };
        let lamp = |lobe: &LobeColours, lamp: usize| {
            let colour = |cosine: f64| lobe.lamp_mirrored(lamp, cosine).map(|part| part as f32);
            cosines().map(colour).collect()
        };
        let amounts = inverse(&left(passage, passage.leaving_plain()));
        let through =
            |cosine| dye(&product(&left(passage, &leaving[passage::row(cosine)]), &amounts));
        let lamps = |lobe| (0..lamps).map(|number| lamp(lobe, number)).collect();
        Self {
            lobes: lobes.iter().map(mirrored).collect(),
            lamps: lobes.iter().map(lamps).collect(),
            leaving: cosines().map(through).collect(),
            chalk: passage.plain().recip() as f32,
        }
    }
}

fn cosines() -> impl Iterator<Item = f64> {
    (0..=STEPS).map(|step| step as f64 / STEPS as f64)
}

/// A row of the tables for a cosine.
pub(super) fn row(cosine: f64) -> u16 {
    (cosine.clamp(0.0, 1.0) * STEPS as f64 + 0.5) as u16
}

/// What leaves by bands of RGB each, of light inside that has the spectrum that the palette's curves give it, as it enters from all sides.
fn left(passage: &Passage, leaving: &[[f32; BANDS]; 3]) -> Matrix {
    let shares = passage.share(0);
    let mut dye = [[0.0; 3]; 3];
    for band in 0..BANDS {
        let curves = passage.palette().curves_of_white(band);
        for (row, weights) in dye.iter_mut().zip(leaving) {
            for (sum, curve) in row.iter_mut().zip(curves) {
                *sum += f64::from(weights[band]) * shares[band] * curve;
            }
        }
    }
    dye
}

fn dye(matrix: &Matrix) -> Dye {
    let column = |k: usize| [0, 1, 2].map(|i| matrix[i][k] as f32);
    [0, 1, 2].map(column).map(|[red, green, blue]| [red, green, blue, 0.0])
}
