//! The media of a stack at blocks of wavelengths.

use nacreous_nacre::{LayerStack, Medium, NacreError, Principal};
use num_complex::Complex64;

use crate::{
    OpticsError,
    lanes::{LANES, Lanes, Pair, filled},
    transfer::Origin,
    wave::Plane,
    waves::Media,
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
    origin: Origin,
}

/// The media's indices at a block of wavelengths.
pub(crate) struct Indices {
    pub(crate) ambient: Principals,
    pub(crate) aragonite: Principals,
    pub(crate) protein: Principals,
    pub(crate) substrate: Principals,
    pub(crate) are_real: bool,
}

pub(crate) struct Principals {
    pub(crate) ordinary: Pair,
    pub(crate) extraordinary: Pair,
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
            origin: Origin::Ambient,
        })
    }

    /// The same for light from somewhere else.
    pub(crate) fn seen_from(self, origin: Origin) -> Self {
        Self { origin, ..self }
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
        let cos_angle = &[cos_angle; LANES];
        self.met(if self.is_constant {
            Media::of::<1>(planes, &self.indices[0], cos_angle)
        } else {
            Media::of::<LANES>(planes, &self.indices[block], cos_angle)
        })
    }

    /// The media where each lane has an angle of its own, and one of the first block's wavelengths.
    pub(crate) fn at_points<const N: usize>(
        &self,
        planes: [Plane; N],
        cos_angle: &Lanes<f64>,
        wavelength: &Lanes<usize>,
    ) -> Media<N> {
        self.met(if self.is_constant {
            Media::of::<LANES>(planes, &self.indices[0], cos_angle)
        } else {
            Media::of::<LANES>(planes, &self.indices[0].gathered(wavelength), cos_angle)
        })
    }

    /// Light from aragonite comes through a medium of aragonite's admittance.
    fn met<const N: usize>(&self, mut media: Media<N>) -> Media<N> {
        if self.origin == Origin::Aragonite {
            for waves in &mut media.waves {
                waves.ambient.clone_from(&waves.aragonite);
            }
        }
        media
    }
}

impl Indices {
    pub(crate) fn of(stack: &LayerStack, wavelength_nm: &Lanes<f64>) -> Result<Self, OpticsError> {
        let principals = |name, medium| Principals::of(name, medium, wavelength_nm);
        let [ambient, aragonite, protein, substrate] = [
            principals("ambient", stack.ambient())?,
            principals("aragonite", stack.aragonite())?,
            principals("protein", stack.protein())?,
            principals("substrate", stack.substrate())?,
        ];
        let are_real =
            [&ambient, &aragonite, &protein, &substrate].iter().all(|medium| medium.is_real());
        Ok(Self { ambient, aragonite, protein, substrate, are_real })
    }

    fn gathered(&self, from: &Lanes<usize>) -> Self {
        Self {
            ambient: self.ambient.gathered(from),
            aragonite: self.aragonite.gathered(from),
            protein: self.protein.gathered(from),
            substrate: self.substrate.gathered(from),
            are_real: self.are_real,
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
    pub(crate) fn at(&self, i: usize) -> (Complex64, Complex64) {
        (self.ordinary.at(i), self.extraordinary.at(i))
    }
}
