//! Where light is caught between layers: lines of a spectrum so narrow that samples may miss them.
//!
//! Light that runs round inside a layer comes back as g times itself, g = the product of what the layers
//! above and below send back, seen from there. Where g passes 1 it adds up: at a wavenumber at which the
//! phase of g passes 0, over half a width of (1 - |g|) / (slope of that phase) (Airy's sum; M. Born and
//! E. Wolf, Principles of Optics, 7.6). Mirrors of a few layers change slowly with wavenumber, so a line is
//! found between samples far wider apart than itself.

use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::LayerStack;
use num_complex::Complex64;

use crate::{
    OpticsError, Polarisation,
    lanes::LANES,
    media::Table,
    parallel, phase,
    transfer::{Origin, table},
    wave::Plane,
    waves::Waves,
};

/// A narrow line of a spectrum.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Resonance {
    /// Which of the asked angles, times two, plus one for light that swings in the plane.
    pub series: usize,
    /// 1 / wavelength in nm, near the top.
    pub wavenumber: f64,
    /// Half its width at half the top, in wavenumber.
    pub half_width: f64,
    /// Its top, as a share of the incoming energy **(ours)**: 4 u d / (u + d)^2, u and d being what
    /// each round trip loses upward and downward.
    pub height: f64,
}

/// Below this |g| a line is as wide as half a fringe, and no sample misses it.
const LEAST_RETURN: f64 = 0.5;

/// The narrowest line between each two neighbours of `wavelength_nm` where there is one, falling and at
/// most a quarter of a fringe of the whole stack apart; for each angle and polarisation by itself.
///
/// `None` once `stop` is set.
///
/// # Errors
/// As [`crate::TransferModel::energies`].
///
/// ```
/// use nacreous_nacre::{Index, LayerStack};
/// use nacreous_optics::{Polarisation, resonances};
/// let n = |n| Index::new("medium", n, 0.0).unwrap();
/// let flake = LayerStack::new(vec![5000.0], 0.0, n(1.68), n(1.43), n(1.0), n(1.0))?;
/// let nm: Vec<f64> = (0..200).map(|i| 1.0 / (1.8e-3 + 1e-6 * i as f64)).collect();
/// let half_width = |angle| {
///     let found = resonances(&flake, Polarisation::S, &[angle], &nm, &Default::default());
///     found.map(|lines| lines.unwrap().first().map(|line| line.half_width))
/// };
/// assert_eq!(half_width(0.0)?, None); // a plate of glass
/// assert!(half_width(1.56)?.unwrap() < 1e-6); // near grazing a mirror on either side
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn resonances(
    stack: &LayerStack,
    polarisation: Polarisation,
    angle_rad: &[f64],
    wavelength_nm: &[f64],
    stop: &AtomicBool,
) -> Result<Option<Vec<Resonance>>, OpticsError> {
    let media = table(stack, Origin::Ambient, angle_rad, wavelength_nm)?;
    let planes: &[(usize, Plane)] = match polarisation {
        Polarisation::S => &[(0, Plane::S)],
        Polarisation::P => &[(1, Plane::P)],
        Polarisation::Unpolarised => &[(0, Plane::S), (1, Plane::P)],
    };
    let series = |(i, angle): (usize, &f64)| {
        let cos_angle = angle.cos();
        planes.iter().map(move |&(k, plane)| Series { index: 2 * i + k, plane, cos_angle })
    };
    let series: Vec<Series> = angle_rad.iter().enumerate().flat_map(series).collect();
    let search = Search { stack, media: &media, wavelength_nm, stop };
    let found = search.all(&series);
    Ok((!stop.load(Ordering::Relaxed)).then_some(found))
}

/// Light of one angle and polarisation.
struct Series {
    index: usize,
    plane: Plane,
    cos_angle: f64,
}

struct Search<'a> {
    stack: &'a LayerStack,
    media: &'a Table,
    wavelength_nm: &'a [f64],
    stop: &'a AtomicBool,
}

impl Search<'_> {
    fn all(&self, series: &[Series]) -> Vec<Resonance> {
        if let [series] = series {
            return self.one(series);
        }
        let (first, second) = series.split_at(series.len() / 2);
        let (mut before, mut after) = (Vec::new(), Vec::new());
        if !second.is_empty() {
            parallel::join(|| before = self.all(first), || after = self.all(second));
        }
        before.append(&mut after);
        before
    }

    fn one(&self, series: &Series) -> Vec<Resonance> {
        let mut found = Vec::new();
        let mut last: Option<(f64, Vec<Returns>)> = None;
        for (block, nm) in self.wavelength_nm.chunks(LANES).enumerate() {
            if self.stop.load(Ordering::Relaxed) {
                break;
            }
            let [waves] = self.media.at([series.plane], series.cos_angle, block).waves;
            for (lane, nm) in nm.iter().enumerate() {
                let half_turns_per_nm = self.media.half_turns_per_nm[block][lane];
                let returns = returns(self.stack, &Layers::of(&waves, lane, half_turns_per_nm));
                let here = 1.0 / nm;
                if let Some((there, before)) = &last {
                    found.extend(narrowest(series.index, (*there, here), before, &returns));
                }
                last = Some((here, returns));
            }
        }
        found
    }
}

/// The narrowest line that any layer has between two wavenumbers.
fn narrowest(
    series: usize,
    (there, here): (f64, f64),
    before: &[Returns],
    after: &[Returns],
) -> Option<Resonance> {
    let lines = before.iter().zip(after).filter_map(|(one, two)| one.line(two, here - there));
    let (half_width, height) = lines.min_by(|a, b| a.0.total_cmp(&b.0))?;
    Some(Resonance { series, wavenumber: 0.5 * (here + there), half_width, height })
}

/// The media at one wavelength.
struct Layers {
    half_turns_per_nm: f64,
    ambient: Complex64,
    substrate: Complex64,
    aragonite: Side,
    protein: Side,
}

/// Wave and admittance of one kind of layer.
struct Side {
    along: Complex64,
    admittance: Complex64,
}

impl Layers {
    fn of(waves: &Waves, lane: usize, half_turns_per_nm: f64) -> Self {
        let admittance = waves.aragonite.at(lane);
        let protein =
            Side { along: waves.protein_along.at(lane), admittance: admittance * waves.q.at(lane) };
        Self {
            half_turns_per_nm,
            ambient: waves.ambient.at(lane),
            substrate: waves.substrate.at(lane),
            aragonite: Side { along: waves.aragonite_along.at(lane), admittance },
            protein,
        }
    }

    /// What way down a layer and up again leaves of a wave.
    fn round_trip(&self, side: &Side, thickness_nm: f64) -> Complex64 {
        let turns = side.along * (thickness_nm * self.half_turns_per_nm);
        let (cos, sin) = phase::cos_sin_of_turns(turns.re);
        Complex64::new(cos, sin) * libm::exp(-2.0 * std::f64::consts::PI * turns.im)
    }
}

/// What comes back to one layer.
#[derive(Clone, Copy)]
struct Returns {
    /// From above and from below, both seen from the layer's top.
    up: Complex64,
    down: Complex64,
}

impl Returns {
    /// (half width, height) of the line where g passes 1 on the way to the next wavenumber.
    fn line(&self, next: &Self, step: f64) -> Option<(f64, f64)> {
        let (one, two) = (self.up * self.down, next.up * next.down);
        let most = one.norm_sqr().min(two.norm_sqr());
        if most < LEAST_RETURN * LEAST_RETURN {
            return None;
        }
        let lost = 1.0 - 0.5 * (one.norm() + two.norm());
        let (from, turned) = (one.arg(), (two * one.conj()).arg());
        let to = from + turned;
        let passes = from * to <= 0.0 || from.abs().min(to.abs()) < 2.0 * lost;
        if !passes || turned == 0.0 || lost <= 0.0 {
            return None;
        }
        let up = 1.0 - 0.5 * (self.up.norm() + next.up.norm());
        let down = 1.0 - 0.5 * (self.down.norm() + next.down.norm());
        let height = (4.0 * up * down / (up + down).powi(2)).clamp(0.0, 1.0);
        Some((lost * (step / turned).abs(), if height.is_finite() { height } else { 1.0 }))
    }
}

/// For each layer that carries waves, aragonite and protein in turn, surface first.
fn returns(stack: &LayerStack, layers: &Layers) -> Vec<Returns> {
    let (aragonite, protein) = (&layers.aragonite, &layers.protein);
    let ratio = |of: Complex64, beyond: Complex64| (of - beyond) / (of + beyond);
    let behind = |boundary: Complex64, r: Complex64| (boundary + r) / (1.0 + boundary * r);
    let within = ratio(aragonite.admittance, protein.admittance);
    let through_protein = layers.round_trip(protein, stack.protein_nm());
    let thickness_nm = stack.thickness_nm();
    let trips: Vec<Complex64> =
        thickness_nm.iter().map(|&nm| layers.round_trip(aragonite, nm)).collect();

    let nothing = Returns { up: Complex64::ZERO, down: Complex64::ZERO };
    let mut found = vec![nothing; 2 * thickness_nm.len()];
    let mut r = ratio(protein.admittance, layers.substrate);
    for (pair, &trip) in found.chunks_exact_mut(2).zip(&trips).rev() {
        r *= through_protein;
        pair[1].down = r;
        r = behind(within, r) * trip;
        pair[0].down = r;
        r = behind(-within, r);
    }
    let mut r = ratio(aragonite.admittance, layers.ambient);
    for (pair, &trip) in found.chunks_exact_mut(2).zip(&trips) {
        pair[0].up = r;
        r = behind(-within, r * trip);
        pair[1].up = r;
        r = behind(within, r * through_protein);
    }
    // An evanescent wave has no phase to come back with.
    for (i, side) in [aragonite, protein].into_iter().enumerate() {
        if side.along.im > side.along.re {
            found.iter_mut().skip(i).step_by(2).for_each(|returns| *returns = nothing);
        }
    }
    found
}
