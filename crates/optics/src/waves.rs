//! One polarisation in each medium of a stack, as light of a block of points meets them.

use multiversion::multiversion;

use crate::{
    lanes::{LANES, Lanes, Pair},
    media::Indices,
    wave::{Plane, Wave},
};

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

impl<const N: usize> Media<N> {
    /// Of the first `W` lanes; where that is one, they are all alike.
    pub(crate) fn of<const W: usize>(
        planes: [Plane; N],
        indices: &Indices,
        cos_angle: &Lanes<f64>,
    ) -> Self {
        // In place: these are kilobytes.
        let mut media = Self { waves: [const { Waves::EMPTY }; N], is_lossless: true };
        for (waves, plane) in media.waves.iter_mut().zip(planes) {
            meet::<W>(indices, plane, cos_angle, waves);
            if W == 1 {
                waves.spread();
            }
            media.is_lossless &= waves.are_lossless();
        }
        media
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

    /// The same of light that comes through a medium of aragonite's admittance.
    pub(crate) fn within_aragonite(&self) -> Self {
        Self { ambient: self.aragonite.clone(), ..self.clone() }
    }

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
        let (mut protein, mut substrate_along) = (Pair::ZERO, Pair::ZERO);
        for i in 0..W {
            let incident = Wave::incident(plane, ambient.at(i), cos_angle[i]);
            self.ambient.set(i, incident.admittance);
        }
        for (medium, along, admittance) in [
            (&indices.aragonite, &mut self.aragonite_along, &mut self.aragonite),
            (&indices.protein, &mut self.protein_along, &mut protein),
            (&indices.substrate, &mut substrate_along, &mut self.substrate),
        ] {
            for i in 0..W {
                let n_0 = ambient.re[i];
                let wave = Wave::refracted(plane, medium.at(i), n_0, n_0 * cos_angle[i]);
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

    pub(crate) fn are_lossless(&self) -> bool {
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
    use nacreous_nacre::{LayerStack, Medium};

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
