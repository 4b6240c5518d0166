//! The media of a stack, as light of a block of wavelengths meets them.

use multiversion::multiversion;
use nacreous_nacre::{LayerStack, Medium, NacreError, Principal};
use num_complex::Complex64;

use crate::{
    OpticsError,
    lanes::{LANES, Lanes, Pair, filled},
    wave::{Plane, Wave},
};

/// Wavelengths and indices, block by block: all that does not depend on the angle.
pub(crate) struct Table {
    /// How many wavelengths were asked for.
    pub(crate) wavelengths: usize,
    /// 2 / wavelength, `[block]`: half turns of phase per nm of path in vacuum.
    pub(crate) half_turns_per_nm: Vec<Lanes<f64>>,
    /// `[block]`, or one for all where no medium is dispersive.
    indices: Vec<Indices>,
    /// No medium is dispersive.
    pub(crate) is_constant: bool,
    /// In aragonite all polarisations have the same phase.
    pub(crate) is_isotropic: bool,
    /// A layer has an extinction coefficient.
    pub(crate) absorbs: bool,
}

/// The media's indices at a block of wavelengths.
struct Indices {
    ambient: Principals,
    aragonite: Principals,
    protein: Principals,
    substrate: Principals,
}

struct Principals {
    ordinary: Pair,
    extraordinary: Pair,
}

/// What `N` polarisations at one angle meet at a block of wavelengths.
#[derive(Clone)]
pub(crate) struct Media<const N: usize> {
    pub(crate) waves: [Waves; N],
    /// Light runs through the ambient and all layers: none absorbs, and in none is it evanescent.
    pub(crate) is_lossless: bool,
}

/// One polarisation in each medium.
#[derive(Clone)]
pub(crate) struct Waves {
    /// Admittances, in units of that of vacuum.
    pub(crate) ambient: Pair,
    pub(crate) aragonite: Pair,
    pub(crate) substrate: Pair,
    /// Of the substrate in units of aragonite's, as fields inside the stack are.
    pub(crate) substrate_ratio: Pair,
    /// q, that of protein in units of aragonite's, and 1 / q.
    pub(crate) q: Pair,
    pub(crate) per_q: Pair,
    /// Components of the wave vector along the normal, in units of that in vacuum.
    pub(crate) aragonite_along: Pair,
    pub(crate) protein_along: Pair,
}

/// Below this, fields in units of an admittance overflow; no medium has so small an index.
const LEAST_N: f64 = 1e-3;

impl Table {
    pub(crate) fn new(stack: &LayerStack, wavelength_nm: &[f64]) -> Result<Self, OpticsError> {
        let media = [stack.ambient(), stack.aragonite(), stack.protein(), stack.substrate()];
        let is_constant = media.iter().all(|medium| medium.constant().is_some());
        let blocks: Vec<Lanes<f64>> = wavelength_nm.chunks(LANES).map(filled).collect();
        let asked = if is_constant { blocks.len().min(1) } else { blocks.len() };
        let indices = blocks[..asked].iter().map(|nm| Indices::of(stack, nm));
        let indices = indices.collect::<Result<Vec<_>, _>>()?;
        if indices.iter().any(|media| !media.ambient.is_isotropic()) {
            return Err(OpticsError::Anisotropic { medium: "ambient" });
        }
        Ok(Self {
            wavelengths: wavelength_nm.len(),
            half_turns_per_nm: blocks.iter().map(|nm| nm.map(|nm| 2.0 / nm)).collect(),
            is_isotropic: indices.iter().all(|media| media.aragonite.is_isotropic()),
            absorbs: indices
                .iter()
                .any(|media| !(media.aragonite.is_real() && media.protein.is_real())),
            indices,
            is_constant,
        })
    }

    /// The most phase that a nm of aragonite gives to any wave.
    pub(crate) fn most_half_turns_per_nm(&self) -> f64 {
        let of_block = |(block, half_turns_per_nm): (usize, &Lanes<f64>)| {
            let indices = &self.indices[if self.is_constant { 0 } else { block }];
            let n = indices.aragonite.ordinary.re;
            (0..LANES).fold(0.0, |most: f64, i| most.max(n[i] * half_turns_per_nm[i]))
        };
        self.half_turns_per_nm.iter().enumerate().map(of_block).fold(0.0, f64::max)
    }

    /// The media at an angle, at one block of wavelengths, or at any where they are constant.
    pub(crate) fn at<const N: usize>(
        &self,
        planes: [Plane; N],
        cos_angle: f64,
        block: usize,
    ) -> Media<N> {
        let (block, lanes) = if self.is_constant { (0, 1) } else { (block, LANES) };
        // In place: these are kilobytes.
        let mut media = Media { waves: [const { Waves::EMPTY }; N], is_lossless: true };
        for (waves, plane) in media.waves.iter_mut().zip(planes) {
            meet(&self.indices[block], plane, &[cos_angle; LANES], lanes, waves);
            if self.is_constant {
                waves.spread();
            }
            media.is_lossless &= waves.are_lossless();
        }
        media
    }

    /// The media where each lane has an angle of its own, and one of the first block's wavelengths.
    pub(crate) fn at_points<const N: usize>(
        &self,
        planes: [Plane; N],
        cos_angle: &Lanes<f64>,
        wavelength: &Lanes<usize>,
    ) -> Media<N> {
        let gathered;
        let indices = if self.is_constant {
            &self.indices[0]
        } else {
            gathered = self.indices[0].gathered(wavelength);
            &gathered
        };
        let mut media = Media { waves: [const { Waves::EMPTY }; N], is_lossless: true };
        for (waves, plane) in media.waves.iter_mut().zip(planes) {
            meet(indices, plane, cos_angle, LANES, waves);
            media.is_lossless &= waves.are_lossless();
        }
        media
    }
}

impl Indices {
    fn of(stack: &LayerStack, wavelength_nm: &Lanes<f64>) -> Result<Self, OpticsError> {
        let principals = |name, medium| Principals::of(name, medium, wavelength_nm);
        Ok(Self {
            ambient: principals("ambient", stack.ambient())?,
            aragonite: principals("aragonite", stack.aragonite())?,
            protein: principals("protein", stack.protein())?,
            substrate: principals("substrate", stack.substrate())?,
        })
    }

    fn gathered(&self, from: &Lanes<usize>) -> Self {
        Self {
            ambient: self.ambient.gathered(from),
            aragonite: self.aragonite.gathered(from),
            protein: self.protein.gathered(from),
            substrate: self.substrate.gathered(from),
        }
    }
}

impl Principals {
    fn of(name: &str, medium: &Medium, wavelength_nm: &Lanes<f64>) -> Result<Self, OpticsError> {
        let mut found = Self { ordinary: Pair::ZERO, extraordinary: Pair::ZERO };
        for (lane, &nm) in wavelength_nm.iter().enumerate() {
            let Principal { ordinary, extraordinary } = medium.at(name, nm)?;
            for index in [ordinary, extraordinary] {
                if index.n() < LEAST_N {
                    let (quantity, value) = (format!("{name}: n"), index.n());
                    let allowed = "0.001 to 100 for exact optics";
                    return Err(NacreError::OutOfRange { quantity, value, allowed }.into());
                }
            }
            found.ordinary.set(lane, ordinary.complex());
            found.extraordinary.set(lane, extraordinary.complex());
        }
        Ok(found)
    }

    fn gathered(&self, from: &Lanes<usize>) -> Self {
        Self {
            ordinary: self.ordinary.gathered(from),
            extraordinary: self.extraordinary.gathered(from),
        }
    }

    fn is_isotropic(&self) -> bool {
        self.ordinary == self.extraordinary
    }

    fn is_real(&self) -> bool {
        self.ordinary.is_real() && self.extraordinary.is_real()
    }

    #[inline(always)]
    fn at(&self, i: usize) -> (Complex64, Complex64) {
        (self.ordinary.at(i), self.extraordinary.at(i))
    }
}

impl Waves {
    const EMPTY: Self = Self {
        ambient: Pair::ZERO,
        aragonite: Pair::ZERO,
        substrate: Pair::ZERO,
        substrate_ratio: Pair::ZERO,
        q: Pair::ZERO,
        per_q: Pair::ZERO,
        aragonite_along: Pair::ZERO,
        protein_along: Pair::ZERO,
    };

    /// The first lane's in all of them.
    fn spread(&mut self) {
        for pair in [
            &mut self.ambient,
            &mut self.aragonite,
            &mut self.substrate,
            &mut self.substrate_ratio,
            &mut self.q,
            &mut self.per_q,
            &mut self.aragonite_along,
            &mut self.protein_along,
        ] {
            *pair = Pair { re: [pair.re[0]; LANES], im: [pair.im[0]; LANES] };
        }
    }

    fn are_lossless(&self) -> bool {
        let pairs =
            [&self.ambient, &self.aragonite, &self.aragonite_along, &self.q, &self.protein_along];
        pairs.iter().all(|pair| pair.is_real())
    }
}

/// Snell and Fresnel for the first `lanes` wavelengths. Nothing is fused here, so the numbers are everywhere the same.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
fn meet(indices: &Indices, plane: Plane, cos_angle: &Lanes<f64>, lanes: usize, waves: &mut Waves) {
    for i in 0..lanes {
        let n_0 = indices.ambient.ordinary.at(i);
        let ambient = Wave::incident(plane, n_0, cos_angle[i]);
        let refracted =
            |medium: &Principals| Wave::refracted(plane, medium.at(i), n_0, ambient.along);
        let aragonite = refracted(&indices.aragonite);
        let protein = refracted(&indices.protein);
        let substrate = refracted(&indices.substrate);
        waves.ambient.set(i, ambient.admittance);
        waves.aragonite.set(i, aragonite.admittance);
        waves.substrate.set(i, substrate.admittance);
        waves.substrate_ratio.set(i, substrate.admittance / aragonite.admittance);
        waves.q.set(i, protein.admittance / aragonite.admittance);
        waves.per_q.set(i, aragonite.admittance / protein.admittance);
        waves.aragonite_along.set(i, aragonite.along);
        waves.protein_along.set(i, protein.along);
    }
}
