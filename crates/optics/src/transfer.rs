use std::f64::consts::{FRAC_PI_2, LOG2_E, PI};
use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::LayerStack;
use num_complex::Complex64;
use rayon::prelude::*;

use crate::{
    OpticsError, absorbing,
    error::within,
    lanes::{LANES, Lanes},
    lossless, phase,
    real::{Real, Split},
    wave::{Indices, Plane, Polarisation, Wave},
};

/// The exact answer: every wave in every layer, all reflections included, by 2x2 transfer matrices.
///
/// Layers are plane, smooth and coherent; media isotropic or uniaxial with their axis along the normal,
/// dispersive, absorbing, metals; total reflection is nothing special.
///
/// Source: M. Born and E. Wolf, Principles of Optics, 1.6, for the matrices; the admittances of a
/// uniaxial layer from its Maxwell equations (docs/optics.md).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TransferModel {
    /// Of the incoming light.
    pub polarisation: Polarisation,
    /// `Single` computes stacks of lossless layers in single precision.
    pub precision: Precision,
}

/// How exactly to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// Right to about 1e-13.
    #[default]
    Double,
    /// Faster, and right to 2e-4 (1e-5 rms) for 400 bilayers; for pictures that follow a hand.
    Single,
}

impl std::str::FromStr for Precision {
    type Err = OpticsError;

    fn from_str(name: &str) -> Result<Self, OpticsError> {
        match name {
            "double" => Ok(Self::Double),
            "single" => Ok(Self::Single),
            other => Err(OpticsError::Precision(other.chars().take(40).collect())),
        }
    }
}

/// Shares of the incoming energy, `[angle, wavelength]`, flat and row-major.
///
/// They add up to 1 wherever the ambient is lossless. In an absorbing ambient the incoming and the
/// reflected wave exchange energy, and shares of it lose their meaning.
#[derive(Debug, Clone, PartialEq)]
pub struct Energies {
    /// What comes back.
    pub reflectance: Vec<f64>,
    /// What arrives just inside the substrate.
    pub transmittance: Vec<f64>,
    /// What stays in the layers.
    pub absorptance: Vec<f64>,
}

/// R, T and A of one block of wavelengths.
type Shares = [Lanes<f64>; 3];

impl TransferModel {
    /// R, T and A for angles of incidence from 0 to pi/2 and wavelengths from 1 to 1e6 nm.
    ///
    /// `None` once `stop` is set, which is looked at every few hundred microseconds.
    ///
    /// # Errors
    /// [`OpticsError`] for a value out of range, a medium that is not known at a wavelength, or an
    /// ambient whose index depends on direction.
    ///
    /// ```
    /// use nacreous_nacre::{LayerStack, Medium};
    /// use nacreous_optics::TransferModel;
    /// let named = |name| Medium::named(name).unwrap();
    /// let air = nacreous_nacre::Index::new("ambient", 1.0, 0.0)?;
    /// let stack = LayerStack::new(vec![380.0; 100], 20.0, named("aragonite"), named("chitin"), air, named("aragonite"))?;
    /// let shares = TransferModel::default().energies(&stack, &[0.0, 0.5], &[450.0, 550.0], &Default::default())?.unwrap();
    /// assert!((shares.reflectance[3] + shares.transmittance[3] - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn energies(
        &self,
        stack: &LayerStack,
        angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Energies>, OpticsError> {
        for &angle in angle_rad {
            within("angle_rad", angle, 0.0..=FRAC_PI_2, "0 to pi/2")?;
        }
        for &wavelength in wavelength_nm {
            within("wavelength_nm", wavelength, 1.0..=1e6, "1 to 1000000 nm")?;
        }
        let table = Table::new(stack, wavelength_nm)?;
        let values = angle_rad.len() * wavelength_nm.len();
        let mut shares = vec![[0.0; 3]; values];
        if values > 0 {
            shares.par_chunks_mut(wavelength_nm.len()).zip(angle_rad).for_each(|(row, angle)| {
                row.par_chunks_mut(LANES).enumerate().with_min_len(4).for_each(|(block, out)| {
                    if !stop.load(Ordering::Relaxed) {
                        let found = self.block(&table, *angle, block * LANES);
                        for (i, slot) in out.iter_mut().enumerate() {
                            *slot = found.map(|share| share[i]);
                        }
                    }
                });
            });
        }
        let column = |i: usize| shares.iter().map(|share| share[i]).collect();
        Ok((!stop.load(Ordering::Relaxed)).then(|| Energies {
            reflectance: column(0),
            transmittance: column(1),
            absorptance: column(2),
        }))
    }

    fn block(self, table: &Table<'_>, angle_rad: f64, from: usize) -> Shares {
        let cos = angle_rad.cos();
        match self.polarisation {
            Polarisation::S => self.planes(&table.waves([Plane::S], cos, from)),
            Polarisation::P => self.planes(&table.waves([Plane::P], cos, from)),
            Polarisation::Unpolarised => self.planes(&table.waves([Plane::S, Plane::P], cos, from)),
        }
    }

    fn planes<const N: usize>(self, block: &Block<'_, N>) -> Shares {
        let shares = if !block.is_lossless {
            block.absorbing()
        } else if self.precision == Precision::Single {
            let single = block.lossless::<f32>();
            // Media of extreme contrast overflow it; double precision holds what is allowed.
            let good = single.iter().flatten().flatten().all(|share| share.is_finite());
            if good { single } else { block.lossless::<f64>() }
        } else {
            block.lossless::<f64>()
        };
        let mean = |k: usize, i: usize| {
            shares.iter().map(|plane| plane[k][i]).sum::<f64>() / shares.len() as f64
        };
        std::array::from_fn(|k| std::array::from_fn(|i| mean(k, i)))
    }
}

/// A stack and all that does not depend on the angle.
struct Table<'a> {
    stack: &'a LayerStack,
    wavelength_nm: &'a [f64],
    ambient: Indices,
    aragonite: Indices,
    protein: Indices,
    substrate: Indices,
    /// No medium is dispersive.
    is_constant: bool,
}

/// One block of wavelengths at one angle, for `N` polarisations.
struct Block<'a, const N: usize> {
    stack: &'a LayerStack,
    wavelength_nm: Lanes<f64>,
    waves: [[Media; LANES]; N],
    /// No layer absorbs and none is evanescent; the substrate may.
    is_lossless: bool,
    /// In aragonite all polarisations have the same phase.
    is_isotropic: bool,
}

/// The wave in each medium.
#[derive(Clone, Copy)]
struct Media {
    ambient: Wave,
    aragonite: Wave,
    protein: Wave,
    substrate: Wave,
}

impl<'a> Table<'a> {
    fn new(stack: &'a LayerStack, wavelength_nm: &'a [f64]) -> Result<Self, OpticsError> {
        let ambient = Indices::of("ambient", stack.ambient(), wavelength_nm)?;
        if !ambient.is_isotropic() {
            return Err(OpticsError::AnisotropicAmbient);
        }
        let media = [stack.ambient(), stack.aragonite(), stack.protein(), stack.substrate()];
        Ok(Self {
            stack,
            wavelength_nm,
            is_constant: media.iter().all(|medium| medium.constant().is_some()),
            ambient,
            aragonite: Indices::of("aragonite", stack.aragonite(), wavelength_nm)?,
            protein: Indices::of("protein", stack.protein(), wavelength_nm)?,
            substrate: Indices::of("substrate", stack.substrate(), wavelength_nm)?,
        })
    }

    /// The last wavelength again where the table ends within the block.
    fn waves<const N: usize>(&self, planes: [Plane; N], cos: f64, from: usize) -> Block<'a, N> {
        let index = |lane: usize| (from + lane).min(self.wavelength_nm.len() - 1);
        let waves = planes.map(|plane| {
            let at = |i: usize| {
                let n_0 = self.ambient.ordinary[i];
                let ambient = Wave::incident(plane, n_0, cos);
                let refracted = |medium: &Indices| {
                    let principal = (medium.ordinary[i], medium.extraordinary[i]);
                    Wave::refracted(plane, principal, n_0, ambient.along)
                };
                let [aragonite, protein, substrate] =
                    [&self.aragonite, &self.protein, &self.substrate].map(refracted);
                Media { ambient, aragonite, protein, substrate }
            };
            if self.is_constant {
                [at(0); LANES]
            } else {
                std::array::from_fn(|lane| at(index(lane)))
            }
        });
        let runs = |wave: &Wave| wave.along.im == 0.0 && wave.admittance.im == 0.0;
        Block {
            stack: self.stack,
            wavelength_nm: std::array::from_fn(|lane| self.wavelength_nm[index(lane)]),
            is_lossless: waves.iter().flatten().all(|media: &Media| {
                runs(&media.ambient) && runs(&media.aragonite) && runs(&media.protein)
            }),
            is_isotropic: self.aragonite.is_isotropic(),
            waves,
        }
    }
}

impl<const N: usize> Block<'_, N> {
    fn lossless<T: Real>(&self) -> [Shares; N] {
        let mut layers: [_; N] = std::array::from_fn(|_| lossless::Layers::<T>::new());
        let mut fields: [_; N] = std::array::from_fn(|_| lossless::Field::<T>::new());
        for n in 0..N {
            for i in 0..LANES {
                let Media { aragonite, protein, substrate, .. } = self.waves[n][i];
                let (layer, field) = (&mut layers[n], &mut fields[n]);
                let half_turns_per_nm = 2.0 / self.wavelength_nm[i];
                let turn = Split::<T>::of(aragonite.along.re * half_turns_per_nm);
                layer.aragonite_per_nm[i] = turn.high;
                layer.aragonite_per_nm_low[i] = turn.low;
                let f = self.stack.protein_nm() * protein.along.re * half_turns_per_nm;
                let (cos, sin) = phase::cos_sin::<false>(f - f.round());
                let q = protein.admittance.re / aragonite.admittance.re;
                layer.protein_cos[i] = T::near(cos);
                layer.protein_sin_per_q[i] = T::near(sin / q);
                layer.protein_q_sin[i] = T::near(q * sin);
                // At the substrate B = 1, C = its admittance.
                let c = substrate.admittance / aragonite.admittance.re;
                field.re_b[i] = T::ONE;
                field.re_c[i] = T::near(c.re);
                field.im_c[i] = T::near(c.im);
            }
        }
        let thickness_nm = self.stack.thickness_nm();
        if self.is_isotropic {
            lossless::ascend::<T, N, true>(thickness_nm, &layers, &mut fields);
        } else {
            lossless::ascend::<T, N, false>(thickness_nm, &layers, &mut fields);
        }
        std::array::from_fn(|n| {
            let mut shares = [[0.0; LANES]; 3];
            for i in 0..LANES {
                [shares[0][i], shares[1][i]] = self.waves[n][i].lossless_shares(&fields[n].at(i));
            }
            shares
        })
    }

    fn absorbing(&self) -> [Shares; N] {
        let mut layers: [_; N] = std::array::from_fn(|_| absorbing::Layers::EMPTY);
        let mut fields: [_; N] = std::array::from_fn(|_| absorbing::Field::DARK);
        for n in 0..N {
            for i in 0..LANES {
                let Media { aragonite, protein, substrate, .. } = self.waves[n][i];
                let (layer, field) = (&mut layers[n], &mut fields[n]);
                layer.aragonite_per_nm[i] = 2.0 * aragonite.along.re / self.wavelength_nm[i];
                layer.aragonite_power_per_nm[i] = self.power_per_nm(i, aragonite);
                let f = 2.0 * protein.along.re / self.wavelength_nm[i] * self.stack.protein_nm();
                let power = self.power_per_nm(i, protein) * self.stack.protein_nm();
                let [cos, sin] = absorbing::cos_and_sin(f, power);
                let q = protein.admittance / aragonite.admittance;
                layer.protein_cos.put(i, cos);
                layer.protein_sin_per_q.put(i, sin / q);
                layer.protein_q_sin.put(i, sin * q);
                field.b.put(i, Complex64::ONE);
                field.c.put(i, substrate.admittance / aragonite.admittance);
            }
        }
        let thickness_nm = self.stack.thickness_nm();
        if self.is_isotropic {
            absorbing::ascend::<N, true>(thickness_nm, &layers, &mut fields);
        } else {
            absorbing::ascend::<N, false>(thickness_nm, &layers, &mut fields);
        }
        let aragonite_nm: f64 = thickness_nm.iter().sum();
        let protein_nm = thickness_nm.len() as f64 * self.stack.protein_nm();
        std::array::from_fn(|n| {
            let mut shares = [[0.0; LANES]; 3];
            for i in 0..LANES {
                let media = &self.waves[n][i];
                let power = self.power_per_nm(i, media.aragonite) * aragonite_nm
                    + self.power_per_nm(i, media.protein) * protein_nm;
                let weight =
                    fields[n].weight[i] * (1.0 + phase::power_of_two_less_one::<false>(power));
                [shares[0][i], shares[1][i], shares[2][i]] =
                    media.shares(fields[n].b.get(i), fields[n].c.get(i), weight);
            }
            shares
        })
    }

    /// Halvings of the energy per nm of a medium, negative.
    fn power_per_nm(&self, lane: usize, wave: Wave) -> f64 {
        -4.0 * PI * LOG2_E * wave.along.im / self.wavelength_nm[lane]
    }
}

impl Media {
    /// (R, T) from the field at the surface, of any scale: the energy that goes in is what T lets out.
    fn lossless_shares(&self, [re_b, im_b, re_c, im_c]: &[f64; 4]) -> [f64; 2] {
        let q = self.ambient.admittance.re / self.aragonite.admittance.re;
        let away = (q * re_b - re_c).powi(2) + (q * im_b - im_c).powi(2);
        let towards = (q * re_b + re_c).powi(2) + (q * im_b + im_c).powi(2);
        let goes_in = 4.0 * q * (re_b * re_c + im_b * im_c) / towards;
        let transmits = self.substrate.admittance.re != 0.0;
        [away / towards, if transmits { goes_in.max(0.0) } else { 0.0 }]
    }

    /// (R, T, A) from the field at the surface, that at the substrate being (1, admittance) times the
    /// root of `weight`.
    fn shares(&self, b: Complex64, c: Complex64, weight: f64) -> [f64; 3] {
        let q = self.ambient.admittance;
        let c = c * self.aragonite.admittance;
        let (towards, away) = (q * b + c, q * b - c);
        // Energy per incoming energy |towards / 2 q|^2 Re q.
        let share =
            |energy: f64| (4.0 * q.norm_sqr() / q.re * energy / towards.norm_sqr()).max(0.0);
        let (goes_in, comes_out) = ((b * c.conj()).re, self.substrate.admittance.re * weight);
        [away.norm_sqr() / towards.norm_sqr(), share(comes_out), share(goes_in - comes_out)]
    }
}
