use std::{
    f64::consts::FRAC_PI_2,
    sync::atomic::{AtomicBool, Ordering},
};

use multiversion::multiversion;
use nacreous_nacre::LayerStack;
use num_complex::Complex64;
use rayon::prelude::*;

use crate::{OpticsError, cycle::cos_sin, error::within, fresnel::boundary};

/// Wavelengths computed side by side, a multiple of every processor's vector length.
const LANES: usize = 16;

/// The illuminant model of the paper, section 3: nacre lit from within.
///
/// Light that has entered spreads through the whole nacre, so every point of it sends light in every
/// direction. What reaches the eye interferes within its coherence length and depends on the view
/// angle alone, not on where the lamp is.
///
/// The answer is a relative spectral intensity, dimensionless: the light sent up from below one
/// protein layer counts as 1, and the intensities of all start layers are added. It does not conserve
/// energy; only its shape and its change with angle mean something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IlluminantModel {
    /// Waves interfere while their optical path difference is below this; 5000 nm in the paper.
    pub coherence_nm: f64,
    /// The sum ends where the light going down falls below this share; 0.05 in the paper.
    pub threshold: f64,
    /// D of equation (4): the share scattered diffusely at each layer.
    pub diffuse_loss: f64,
}

impl IlluminantModel {
    /// Spectral intensity `[view angle, wavelength]` as one flat row-major table.
    ///
    /// View angles from 0 to pi/2 (theta_0), wavelengths from 1 to 1e6 nm. Time and memory grow with
    /// layers, not with layers times coherence length: the coherent sums telescope.
    ///
    /// # Errors
    /// [`OpticsError`] for a value out of range, an absorbing medium, or layers thinner optically than
    /// the ambient.
    ///
    /// ```
    /// use nacreous_nacre::{Index, LayerStack};
    /// use nacreous_optics::IlluminantModel;
    /// let index = |n| Index::new("medium", n, 0.0);
    /// let stack = LayerStack::new(vec![420.0; 100], 20.0, index(1.53)?, index(1.43)?, index(1.0)?, index(1.53)?)?;
    /// let model = IlluminantModel { coherence_nm: 5000.0, threshold: 0.05, diffuse_loss: 0.02 };
    /// let table = model.spectra(&stack, &[0.0, 0.5], &[450.0, 550.0, 650.0])?;
    /// assert_eq!(table.len(), 2 * 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn spectra(
        &self,
        stack: &LayerStack,
        view_angle_rad: &[f64],
        wavelength_nm: &[f64],
    ) -> Result<Vec<f64>, OpticsError> {
        let found =
            self.spectra_unless(stack, view_angle_rad, wavelength_nm, &AtomicBool::new(false))?;
        // Nobody else holds that flag, so nobody can have stopped the work.
        Ok(found.unwrap_or_default())
    }

    /// [`Self::spectra`], or `None` once another thread has set `stop`.
    ///
    /// # Errors
    /// Those of [`Self::spectra`].
    pub fn spectra_unless(
        &self,
        stack: &LayerStack,
        view_angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Vec<f64>>, OpticsError> {
        let indices = self.check(stack, view_angle_rad, wavelength_nm)?;
        let mut table = vec![0.0; view_angle_rad.len() * wavelength_nm.len()];
        if !table.is_empty() {
            table.par_chunks_mut(wavelength_nm.len()).zip(view_angle_rad).for_each(
                |(row, &theta_0)| {
                    if !stop.load(Ordering::Relaxed) {
                        self.row(stack, indices, theta_0, wavelength_nm, row);
                    }
                },
            );
        }
        Ok((!stop.load(Ordering::Relaxed)).then_some(table))
    }

    fn check(
        &self,
        stack: &LayerStack,
        view_angle_rad: &[f64],
        wavelength_nm: &[f64],
    ) -> Result<Indices, OpticsError> {
        within("coherence_nm", self.coherence_nm, 0.0..=1e9, "0 to 1e9 nm")?;
        within("threshold", self.threshold, 0.0..=1.0, "0 to 1")?;
        within("diffuse_loss", self.diffuse_loss, 0.0..=1.0, "0 to 1")?;
        for &angle in view_angle_rad {
            within("angle_rad", angle, 0.0..=FRAC_PI_2, "0 to pi/2")?;
        }
        for &wavelength in wavelength_nm {
            within("wavelength_nm", wavelength, 1.0..=1e6, "1 to 1000000 nm")?;
        }
        Indices::of(stack)
    }

    /// One view angle. The step numbers are those of section 3 of docs/model.md.
    fn row(
        &self,
        stack: &LayerStack,
        indices: Indices,
        theta_0: f64,
        wavelength_nm: &[f64],
        row: &mut [f64],
    ) {
        // Steps 1 and 2: Snell and Fresnel.
        let ray = Ray::seen_at(indices, stack.protein_nm(), theta_0);
        // Step 4: path below the surface, so that xi between two layers is a difference of two of these.
        let path_nm: Vec<f64> = stack
            .thickness_nm()
            .iter()
            .scan(0.0, |below_nm, d| {
                *below_nm += 2.0 * ray.n1_cos_theta_1 * d;
                Some(*below_nm)
            })
            .collect();
        let ends = self.window_ends(&path_nm);
        let mut sums = vec![([0.0; LANES], [0.0; LANES]); path_nm.len() + 1];
        for (lanes, out) in wavelength_nm.chunks(LANES).zip(row.chunks_mut(LANES)) {
            let block = std::array::from_fn(|i| lanes[i.min(lanes.len() - 1)]);
            let intensity = interference(self, &ray, &path_nm, &ends, &block, &mut sums);
            out.copy_from_slice(&intensity[..lanes.len()]);
        }
    }

    /// For each start layer l the first layer that no longer belongs to its interference: here the
    /// coherence length is applied. A window always holds its start layer.
    fn window_ends(&self, path_nm: &[f64]) -> Vec<usize> {
        let mut end = 0;
        let coherent = |from: f64, to: f64| to - from < self.coherence_nm;
        (0..path_nm.len())
            .map(|l| {
                end = end.max(l + 1);
                while end < path_nm.len() && coherent(path_nm[l], path_nm[end]) {
                    end += 1;
                }
                end
            })
            .collect()
    }
}

/// n0, n1, n2 of the paper: real, constant, and none below n0.
#[derive(Clone, Copy)]
struct Indices([f64; 3]);

impl Indices {
    fn of(stack: &LayerStack) -> Result<Self, OpticsError> {
        let ambient_n = stack.ambient().index("ambient")?.n();
        let media = [
            ("ambient", stack.ambient()),
            ("aragonite", stack.aragonite()),
            ("protein", stack.protein()),
        ];
        let mut indices = [0.0; 3];
        for ((medium, of), slot) in media.into_iter().zip(&mut indices) {
            let index = of.index(medium)?;
            if !index.is_lossless() {
                return Err(OpticsError::Absorbing { medium, k: index.k() });
            }
            if index.n() < ambient_n {
                return Err(OpticsError::TotalReflection {
                    medium,
                    n: index.n(),
                    ambient: ambient_n,
                });
            }
            *slot = index.n();
        }
        Ok(Self(indices))
    }
}

/// What does not change along one line of sight.
struct Ray {
    n1_cos_theta_1: f64,
    /// 2 n2 d_p cos(theta_2): path difference of the two faces of a protein layer.
    protein_path_nm: f64,
    t1: f64,
    r2_s: f64,
    r2_p: f64,
}

impl Ray {
    fn seen_at(Indices([n0, n1, n2]): Indices, protein_nm: f64, theta_0: f64) -> Self {
        // Not quite 0 at grazing, where a medium that is no denser than its neighbour gives 0 / 0.
        let cos2 = |n: f64| 1.0 - (n0 / n * theta_0.sin()).powi(2);
        let snell = |n: f64| cos2(n).max(f64::MIN_POSITIVE).sqrt();
        let (cos_theta_1, cos_theta_2) = (snell(n1), snell(n2));
        // T1 is the same both ways; from outside it is exact at grazing, where theta_1 loses digits.
        let surface = boundary(Complex64::from(n0), Complex64::from(n1), theta_0.cos());
        let inner = boundary(Complex64::from(n1), Complex64::from(n2), cos_theta_1);
        Self {
            n1_cos_theta_1: n1 * cos_theta_1,
            protein_path_nm: 2.0 * n2 * protein_nm * cos_theta_2,
            t1: surface.T().max(0.0),
            r2_s: inner.r_s.re,
            r2_p: inner.r_p.re,
        }
    }
}

/// One polarisation of the light on its way down, for `LANES` wavelengths.
struct Beam {
    /// |a|^2, the intensity that one protein layer sends up.
    echo: [f64; LANES],
    /// What passing one layer down and up again leaves.
    passing: [f64; LANES],
    light: [f64; LANES],
    intensity: [f64; LANES],
}

impl Beam {
    /// Step 3: the waves from top and bottom of a protein layer, r2 of opposite signs, so
    /// |a|^2 = |r2 (1 - exp(i delta))|^2 = (2 r2 sin(delta / 2))^2, exact for the thinnest layer too.
    /// All protein layers are alike, hence one a for all.
    #[inline(always)]
    fn new(r2: f64, ray: &Ray, wavelength_nm: &[f64; LANES], diffuse_loss: f64) -> Self {
        let echo = wavelength_nm.map(|wavelength| {
            let (_, sin_half_delta) = cos_sin(0.5 * ray.protein_path_nm / wavelength);
            (2.0 * r2 * sin_half_delta).powi(2)
        });
        let passing = echo.map(|a2| (1.0 - a2 - diffuse_loss).max(0.0).powi(2));
        Self { echo, passing, light: [1.0; LANES], intensity: [0.0; LANES] }
    }

    /// False once no wavelength has light above the threshold any more.
    #[inline(always)]
    fn add_and_descend(&mut self, window: &[f64; LANES], threshold: f64) -> bool {
        for i in 0..LANES {
            self.intensity[i] += self.light[i] * self.echo[i] * window[i];
            let light = self.light[i] * self.passing[i];
            self.light[i] = if light < threshold { 0.0 } else { light };
        }
        self.light.iter().any(|&light| light > 0.0)
    }
}

/// Steps 3 to 7 for `LANES` wavelengths at once. Wider vectors change no bit: nothing is fused here.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
fn interference(
    model: &IlluminantModel,
    ray: &Ray,
    path_nm: &[f64],
    ends: &[usize],
    wavelength_nm: &[f64; LANES],
    sums: &mut [([f64; LANES], [f64; LANES])],
) -> [f64; LANES] {
    let (mut s, mut p) = (
        Beam::new(ray.r2_s, ray, wavelength_nm, model.diffuse_loss),
        Beam::new(ray.r2_p, ray, wavelength_nm, model.diffuse_loss),
    );
    let per_nm = wavelength_nm.map(f64::recip);
    let mut summed = 0;
    for (l, &end) in ends.iter().enumerate() {
        // Step 5: P_k, the running sum of exp(i xi_1k), as far as this window reaches.
        while summed < end {
            let (before, after) = sums.split_at_mut(summed + 1);
            running_sum(&before[summed], path_nm[summed], &per_nm, &mut after[0]);
            summed += 1;
        }
        let window = squared_difference(&sums[end], &sums[l]);
        // Step 6: add the intensity of this start layer, then let the light go one layer deeper.
        let s_goes_on = s.add_and_descend(&window, model.threshold);
        let p_goes_on = p.add_and_descend(&window, model.threshold);
        if !(s_goes_on || p_goes_on) {
            break;
        }
    }
    // Step 7, for natural light.
    std::array::from_fn(|i| 0.5 * ray.t1 * (s.intensity[i] + p.intensity[i]))
}

/// The next running sum: one more wave, delayed by `path_nm`.
#[inline(always)]
fn running_sum(
    (re, im): &([f64; LANES], [f64; LANES]),
    path_nm: f64,
    per_nm: &[f64; LANES],
    (next_re, next_im): &mut ([f64; LANES], [f64; LANES]),
) {
    for i in 0..LANES {
        let (cos_xi, sin_xi) = cos_sin(path_nm * per_nm[i]);
        next_re[i] = re[i] + cos_xi;
        next_im[i] = im[i] + sin_xi;
    }
}

#[inline(always)]
fn squared_difference(
    (re_a, im_a): &([f64; LANES], [f64; LANES]),
    (re_b, im_b): &([f64; LANES], [f64; LANES]),
) -> [f64; LANES] {
    std::array::from_fn(|i| (re_a[i] - re_b[i]).powi(2) + (im_a[i] - im_b[i]).powi(2))
}
