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
    are_real: bool,
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
        let cos_angle = &[cos_angle; LANES];
        // In place: these are kilobytes.
        let mut media = Media { waves: [const { Waves::EMPTY }; N], is_lossless: true };
        for (waves, plane) in media.waves.iter_mut().zip(planes) {
            if self.is_constant {
                meet::<1>(&self.indices[0], plane, cos_angle, waves);
                waves.spread();
            } else {
                meet::<LANES>(&self.indices[block], plane, cos_angle, waves);
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
            meet::<LANES>(indices, plane, cos_angle, waves);
            media.is_lossless &= waves.are_lossless();
        }
        media
    }
}

impl Indices {
    fn of(stack: &LayerStack, wavelength_nm: &Lanes<f64>) -> Result<Self, OpticsError> {
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

    fn pairs(&mut self) -> [&mut Pair; 8] {
        [
            &mut self.ambient,
            &mut self.aragonite,
            &mut self.substrate,
            &mut self.substrate_ratio,
            &mut self.q,
            &mut self.per_q,
            &mut self.aragonite_along,
            &mut self.protein_along,
        ]
    }

    /// The first lane's in all of them.
    fn spread(&mut self) {
        for pair in self.pairs() {
            *pair = Pair { re: [pair.re[0]; LANES], im: [pair.im[0]; LANES] };
        }
    }

    #[inline(always)]
    fn meet<const W: usize>(&mut self, plane: Plane, indices: &Indices, cos_angle: &Lanes<f64>) {
        if !(indices.are_real && self.meet_real::<W>(plane, indices, cos_angle)) {
            self.meet_any::<W>(plane, indices, cos_angle);
        }
    }

    /// Without complex arithmetic, which takes three times as long; the imaginary parts stay 0. Not so, and
    /// nothing to use, where a wave is evanescent.
    #[inline(always)]
    fn meet_real<const W: usize>(
        &mut self,
        plane: Plane,
        indices: &Indices,
        cos_angle: &Lanes<f64>,
    ) -> bool {
        let ambient = &indices.ambient.ordinary.re;
        let (mut incident_along, mut protein) = ([0.0; LANES], [0.0; LANES]);
        let mut substrate_along = [0.0; LANES];
        for i in 0..W {
            (incident_along[i], self.ambient.re[i]) =
                Wave::incident_real(plane, ambient[i], cos_angle[i]);
        }
        let mut runs = true;
        for (medium, along, admittance) in [
            (&indices.aragonite, &mut self.aragonite_along.re, &mut self.aragonite.re),
            (&indices.protein, &mut self.protein_along.re, &mut protein),
            (&indices.substrate, &mut substrate_along, &mut self.substrate.re),
        ] {
            for i in 0..W {
                let n = (medium.ordinary.re[i], medium.extraordinary.re[i]);
                (along[i], admittance[i]) =
                    Wave::refracted_real(plane, n, ambient[i], incident_along[i]);
                runs &= along[i] > 0.0;
            }
        }
        for i in 0..W {
            self.substrate_ratio.re[i] = self.substrate.re[i] / self.aragonite.re[i];
            self.q.re[i] = protein[i] / self.aragonite.re[i];
            self.per_q.re[i] = self.aragonite.re[i] / protein[i];
        }
        runs
    }

    #[inline(always)]
    fn meet_any<const W: usize>(
        &mut self,
        plane: Plane,
        indices: &Indices,
        cos_angle: &Lanes<f64>,
    ) {
        let ambient = &indices.ambient.ordinary;
        let (mut incident_along, mut protein, mut substrate_along) =
            (Pair::ZERO, Pair::ZERO, Pair::ZERO);
        for i in 0..W {
            let incident = Wave::incident(plane, ambient.at(i), cos_angle[i]);
            incident_along.set(i, incident.along);
            self.ambient.set(i, incident.admittance);
        }
        for (medium, along, admittance) in [
            (&indices.aragonite, &mut self.aragonite_along, &mut self.aragonite),
            (&indices.protein, &mut self.protein_along, &mut protein),
            (&indices.substrate, &mut substrate_along, &mut self.substrate),
        ] {
            for i in 0..W {
                let (n, n_0) = (medium.at(i), ambient.at(i));
                let wave = Wave::refracted(plane, n, n_0, incident_along.at(i));
                along.set(i, wave.along);
                admittance.set(i, wave.admittance);
            }
        }
        for i in 0..W {
            let (aragonite, protein) = (self.aragonite.at(i), protein.at(i));
            self.substrate_ratio.set(i, self.substrate.at(i) / aragonite);
            self.q.set(i, protein / aragonite);
            self.per_q.set(i, aragonite / protein);
        }
    }

    fn are_lossless(&self) -> bool {
        let pairs =
            [&self.ambient, &self.aragonite, &self.aragonite_along, &self.q, &self.protein_along];
        pairs.iter().all(|pair| pair.is_real())
    }
}

/// Snell and Fresnel for the first `W` lanes. Nothing is fused here, so the numbers are everywhere the same.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
fn meet<const W: usize>(
    indices: &Indices,
    plane: Plane,
    cos_angle: &Lanes<f64>,
    waves: &mut Waves,
) {
    // One loop for each plane, for a choice within it would keep the lanes apart.
    match plane {
        Plane::S => waves.meet::<W>(Plane::S, indices, cos_angle),
        Plane::P => waves.meet::<W>(Plane::P, indices, cos_angle),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const MEDIA: [[f64; 4]; 3] =
        [[1.0, 1.683, 1.43, 1.6], [1.33, 1.53, 1.34, 2.5], [1.7, 1.3, 1.0, 1.2]];

    fn indices([ambient, aragonite, protein, substrate]: [f64; 4]) -> Indices {
        let medium = |n: f64| nacreous_nacre::Index::new("medium", n, 0.0).unwrap();
        let uniaxial = Medium::uniaxial(medium(aragonite), medium(0.95 * aragonite));
        let [ambient, protein, substrate] = [ambient, protein, substrate].map(medium);
        let stack = LayerStack::new(vec![400.0], 20.0, uniaxial, protein, ambient, substrate);
        Indices::of(&stack.unwrap(), &[550.0; LANES]).unwrap()
    }

    /// Each plane met with and without complex arithmetic, and whether the latter was enough.
    fn both(media: [f64; 4], plane: Plane, cos_angle: &Lanes<f64>) -> (bool, Waves, Waves) {
        let (mut real, mut any) = (Waves::EMPTY, Waves::EMPTY);
        let runs = real.meet_real::<LANES>(plane, &indices(media), cos_angle);
        any.meet_any::<LANES>(plane, &indices(media), cos_angle);
        (runs, real, any)
    }

    #[test]
    fn without_complex_arithmetic_only_rounding_differs() {
        let cos_angle = std::array::from_fn(|lane| 1.0 - 0.01 * lane as f64);
        for media in MEDIA {
            for plane in [Plane::S, Plane::P] {
                let (runs, mut real, mut any) = both(media, plane, &cos_angle);
                assert_eq!(runs, any.are_lossless() && any.substrate.is_real());
                if !runs {
                    continue;
                }
                for (a, b) in real.pairs().into_iter().zip(any.pairs()) {
                    assert!(a.is_real() && b.is_real());
                    for (a, b) in a.re.iter().zip(b.re) {
                        assert!((a - b).abs() <= 1e-15 * b.abs(), "{a} {b}");
                    }
                }
            }
        }
    }

    #[test]
    fn total_reflection_in_any_medium_and_lane_needs_complex_arithmetic() {
        for (medium, n) in [(1, 1.2), (2, 1.2), (3, 1.2)] {
            let mut media = [1.7; 4];
            media[medium] = n;
            for lane in [0, LANES - 1] {
                let mut cos_angle = [1.0; LANES];
                for plane in [Plane::S, Plane::P] {
                    cos_angle[lane] = 1.0;
                    assert!(both(media, plane, &cos_angle).0);
                    cos_angle[lane] = 0.1;
                    assert!(!both(media, plane, &cos_angle).0);
                }
            }
        }
    }
}
