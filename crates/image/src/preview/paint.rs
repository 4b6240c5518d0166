//! The pixels of a preview, from all that is kept and a film's tables to codes.
//!
//! In single precision: light inside and in the lobes between the knots, dyed by the film, with grain, before what lies behind.
//! Left out: glare.

use nacreous_colour::{Gamut, RgbSpace};

use crate::{
    parallel,
    pearl::skin::Grain,
    preview::{
        backdrop::Backdrop,
        canvas::{Canvas, Glint, Spot},
        codes::Codes,
        dyes::{Dye, Dyed, Dyes},
        grained::{Grained, Grains},
        lanes::{LANES, Lanes},
        veil::{Knot, Veil},
    },
};

/// A pearl as a film, its grain and its light make it.
pub struct Painted<'a> {
    /// The film's colours.
    pub dyes: &'a Dyes,
    /// The light.
    pub veil: &'a Veil,
    /// The weights of its grain, if it shows any.
    pub grain: Option<Grain>,
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
pub fn paint(
    (canvas, backdrop): (&Canvas, &Backdrop),
    pearls: &[Painted<'_>],
    development: &Development,
) -> Vec<u8> {
    let brush = Brush {
        pearls,
        grained: Grained::new(),
        codes: Codes::new(development.space, development.gamut),
        exposure: development.exposure as f32,
    };
    let size_px = canvas.size_px;
    let mut codes = vec![0; 4 * size_px * size_px];
    parallel::map_chunks(&mut codes, 4 * size_px, |row, codes| {
        let spots = canvas.spots[row * size_px..][..size_px].chunks(LANES);
        let behind = backdrop.0[row * size_px..][..size_px].chunks(LANES);
        let mut glints = canvas.glints[row].iter().peekable();
        let mut run = Run::default();
        for (number, ((codes, spots), behind)) in
            codes.chunks_mut(4 * LANES).zip(spots).zip(behind).enumerate()
        {
            brush.gather(spots, behind, &mut run);
            while let Some(glint) =
                glints.next_if(|glint| usize::from(glint.column) < LANES * (number + 1))
            {
                brush.add_glint(glint, spots, &mut run);
            }
            brush.finish(&mut run);
            for (lane, code) in codes.chunks_exact_mut(4).enumerate() {
                code.copy_from_slice(&brush.codes.code([0, 1, 2].map(|i| run.light[i][lane])));
            }
        }
    });
    codes
}

/// A run of pixels, channel by channel.
#[derive(Default)]
struct Run {
    mirror: [Lanes; 3],
    diffuse: [Lanes; 3],
    interference: [Lanes; 3],
    /// From behind, then all.
    light: [Lanes; 3],
    coverage: Lanes,
    grain: Grains,
    has_pearl: bool,
}

/// What makes light of what pixels show.
struct Brush<'a> {
    pearls: &'a [Painted<'a>],
    grained: Grained,
    codes: Codes,
    exposure: f32,
}

impl Brush<'_> {
    /// What each pixel of a run shows, lamps apart, exposed.
    fn gather(&self, spots: &[Spot], behind: &[[f32; 3]], run: &mut Run) {
        run.has_pearl = false;
        for (lane, (spot, behind)) in spots.iter().zip(behind).enumerate() {
            run.coverage[lane] = spot.coverage;
            for i in 0..3 {
                run.light[i][lane] = behind[i] * (1.0 - spot.coverage) * self.exposure;
            }
            if spot.coverage <= 0.0 {
                continue;
            }
            run.has_pearl = true;
            let pearl = &self.pearls[spot.ball as usize];
            let parts = pearl.parts(spot);
            let lanes = [&mut run.mirror, &mut run.diffuse, &mut run.interference];
            for (lanes, part) in lanes.into_iter().zip(parts) {
                for i in 0..3 {
                    lanes[i][lane] = part[i] * self.exposure;
                }
            }
            run.grain.set(lane, pearl.grain.as_ref(), spot.grain);
        }
    }

    /// Adds the image of a lamp in one of a run's pixels.
    fn add_glint(&self, glint: &Glint, spots: &[Spot], run: &mut Run) {
        let lane = usize::from(glint.column) % LANES;
        let spot = &spots[lane];
        let (one, two, share) = self.pearls[spot.ball as usize].dyes.both(spot.thickness);
        let colour = |dyed: &Dyed| {
            dyed.lamps[usize::from(glint.lobe)][usize::from(glint.lamp)][usize::from(glint.row)]
        };
        let (one, two) = (colour(one), colour(two));
        let factor = glint.strength * (1.0 - spot.chalk) * self.exposure;
        for (i, lanes) in run.mirror.iter_mut().enumerate() {
            lanes[lane] += (one[i] + (two[i] - one[i]) * share) * factor;
        }
    }

    /// The light of all pixels of a run, as the screen shows it.
    fn finish(&self, run: &mut Run) {
        if run.has_pearl {
            self.grained.lay(&run.grain, &mut run.mirror, &mut run.diffuse);
            for i in 0..3 {
                for lane in 0..LANES {
                    let light = run.mirror[i][lane] + run.diffuse[i][lane];
                    run.light[i][lane] += run.coverage[lane] * (light + run.interference[i][lane]);
                }
            }
        }
        self.codes.bring_in(&mut run.light);
    }
}

impl Painted<'_> {
    /// What is mirrored, what comes from inside through a film without colour, and what the film changes of it.
    #[inline]
    fn parts(&self, spot: &Spot) -> [[f32; 3]; 3] {
        let outer = self.veil.at(spot.normal);
        let inner = spot.outward.map_or(outer, |outward| self.veil.at(outward));
        let (one, two, share) = self.dyes.both(spot.thickness);
        let row = usize::from(spot.row);
        let [mut mirror, mut whole] = one.seen(row, &outer, &inner);
        if share > 0.0 {
            let [more, all] = two.seen(row, &outer, &inner);
            for i in 0..4 {
                mirror[i] += (more[i] - mirror[i]) * share;
                whole[i] += (all[i] - whole[i]) * share;
            }
        }
        for rest in outer[6..].chunks_exact(3).step_by(2) {
            for i in 0..3 {
                mirror[i] += rest[i];
            }
        }
        let (plain, nacre) = ([inner[0], inner[1], inner[2]], 1.0 - spot.chalk);
        let diffuse = plain.map(|part| part * spot.inside * (nacre + spot.chalk * one.chalk));
        let between = [0, 1, 2].map(|i| (whole[i] - plain[i]) * spot.inside * nacre);
        [[0, 1, 2].map(|i| mirror[i] * nacre), diffuse, between]
    }
}

impl Dyed {
    /// What lobes mirror of their mean light, and what leaves of light inside.
    #[inline]
    fn seen(&self, row: usize, outer: &Knot, inner: &Knot) -> [[f32; 4]; 2] {
        let (mut mirror, mut whole) = ([0.0; 4], [0.0; 4]);
        for (number, mirrored) in self.lobes.iter().enumerate() {
            add_dyed(&mut mirror, &mirrored[row], outer, 3 + 6 * number);
        }
        add_dyed(&mut whole, &self.leaving[row], inner, 0);
        [mirror, whole]
    }
}

#[inline]
fn add_dyed(sum: &mut [f32; 4], dye: &Dye, knot: &Knot, first: usize) {
    for (column, amount) in dye.iter().zip(&knot[first..first + 3]) {
        for i in 0..4 {
            sum[i] += column[i] * amount;
        }
    }
}
