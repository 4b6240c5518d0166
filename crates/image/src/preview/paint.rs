//! The pixels of a preview, from all that is kept and a film's tables to codes.
//!
//! In single precision: light inside and in the lobes between the knots, dyed by the film, with grain, before what lies behind.
//! Left out: glare.

use nacreous_colour::{Gamut, RgbSpace};

use crate::{
    parallel,
    pearl::{films::Films, response::Response, skin::Grain, subsurface::Subsurface},
    preview::{
        canvas::{Canvas, Glint, Spot},
        codes::Codes,
        dyes::{Dye, Dyes},
        glimpses::Glimpses,
        grained::Grained,
        veil::{Knot, Veil},
    },
};

/// A pearl as a film, its grain and its light make it.
pub struct Painted {
    dyes: Films<Dyes>,
    veil: Veil,
    grain: Option<Grain>,
}

impl Painted {
    /// `grain` is the weights of a pearl that has a texture.
    pub fn new(
        response: &Response,
        glimpses: &Glimpses,
        inside: &Subsurface,
        grain: Option<Grain>,
    ) -> Self {
        let veil = Veil::new(glimpses, inside);
        Self { dyes: Dyes::of(response), veil, grain }
    }
}

/// How light becomes codes.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Development {
    /// Factor on all light.
    pub exposure: f64,
    /// Of the screen.
    pub space: RgbSpace,
    /// What becomes of colours that it cannot show.
    pub gamut: Gamut,
}

/// The codes of a preview, RGBA, row by row: `pearls[i]` is ball `i` of the canvas.
pub fn paint(canvas: &Canvas, pearls: &[Painted], development: &Development) -> Vec<u8> {
    let brush = Brush {
        pearls,
        grained: Grained::new(),
        codes: Codes::new(development.space, development.gamut),
        exposure: development.exposure as f32,
    };
    let size_px = canvas.size_px;
    let mut codes = vec![0; 4 * size_px * size_px];
    parallel::map_chunks(&mut codes, 4 * size_px, |row, codes| {
        let spots = &canvas.spots[row * size_px..][..size_px];
        let mut glints = canvas.glints[row].as_slice();
        for (column, (spot, code)) in spots.iter().zip(codes.chunks_exact_mut(4)).enumerate() {
            let count = glints.iter().take_while(|glint| glint.column as usize == column).count();
            let (here, later) = glints.split_at(count);
            glints = later;
            code.copy_from_slice(&brush.codes.of(brush.light(spot, here)));
        }
    });
    codes
}

/// What makes light of what a pixel shows.
struct Brush<'a> {
    pearls: &'a [Painted],
    grained: Grained,
    codes: Codes,
    exposure: f32,
}

impl Brush<'_> {
    /// The light of a pixel, exposed.
    #[inline]
    fn light(&self, spot: &Spot, glints: &[Glint]) -> [f32; 3] {
        let mut light = spot.behind.map(|channel| channel * self.exposure);
        if spot.coverage > 0.0 {
            let pearl = &self.pearls[spot.ball as usize];
            let [mirror, mut diffuse, interference] =
                pearl.parts(spot, glints).map(|part| part.map(|channel| channel * self.exposure));
            let mut mirror = mirror;
            if let Some(grain) = &pearl.grain {
                [mirror, diffuse] = self.grained.laid(grain, spot.grain, mirror, diffuse);
            }
            for i in 0..3 {
                light[i] += spot.coverage * (mirror[i] + diffuse[i] + interference[i]);
            }
        }
        light
    }
}

impl Painted {
    /// What is mirrored, what comes from inside through a film without colour, and what the film changes of it.
    #[inline]
    fn parts(&self, spot: &Spot, glints: &[Glint]) -> [[f32; 3]; 3] {
        let knot = self.veil.at(spot.normal);
        let (row, dyes) = (spot.row as usize, self.dyes.nearest(f64::from(spot.thickness)));
        let mut mirror = [0.0; 3];
        for (number, [whole, leaning]) in dyes.lobes.iter().enumerate() {
            let first = 3 + 6 * number;
            add(&mut mirror, dyed(&whole[row], &knot, first));
            add(&mut mirror, dyed(&leaning[row], &knot, first + 3));
        }
        for glint in glints {
            let lamp = &dyes.lamps[glint.lobe as usize][glint.lamp as usize];
            let colour = lamp[glint.row as usize];
            add(&mut mirror, colour.map(|channel| channel * glint.strength));
        }
        let knot = if spot.outward == spot.normal { knot } else { self.veil.at(spot.outward) };
        let whole = dyed(&dyes.leaving[row], &knot, 0);
        let plain = [knot[0], knot[1], knot[2]];
        let nacre = 1.0 - spot.chalk;
        let diffuse = plain.map(|part| part * spot.inside * (nacre + spot.chalk * dyes.chalk));
        let between = [0, 1, 2].map(|i| (whole[i] - plain[i]) * spot.inside * nacre);
        [mirror.map(|part| part * nacre), diffuse, between]
    }
}

#[inline]
fn dyed(dye: &Dye, knot: &Knot, first: usize) -> [f32; 3] {
    let [a, b, c] = [knot[first], knot[first + 1], knot[first + 2]];
    dye.map(|row| row[0] * a + row[1] * b + row[2] * c)
}

#[inline]
fn add(sum: &mut [f32; 3], part: [f32; 3]) {
    for (sum, part) in sum.iter_mut().zip(part) {
        *sum += part;
    }
}
