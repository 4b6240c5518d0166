//! The inner loop of the illuminant model: coherent sums over windows of layers, added by intensity.
//!
//! The sums telescope. With P_k the running sum of the first k waves, a window from l to m is
//! |P_m - P_l|^2; so time grows with layers, not with layers times window, and only as many sums are
//! kept as the widest window spans.

use multiversion::multiversion;

use crate::{
    IlluminantModel,
    lanes::{LANES, Lanes},
    phase::cos_sin_of_turns,
    sight::Sight,
    window::Ends,
};

/// The latest running sums, in a ring.
pub(crate) struct Sums {
    ring: Vec<Sum>,
    latest: Sum,
    /// The ring's length, a power of two, less one.
    mask: usize,
}

#[derive(Clone)]
struct Sum {
    re: Lanes<f64>,
    im: Lanes<f64>,
}

impl Sums {
    pub(crate) fn for_windows(widest: usize) -> Self {
        let length = (widest + 1).next_power_of_two();
        let none = Sum { re: [0.0; LANES], im: [0.0; LANES] };
        Self { ring: vec![none.clone(); length], latest: none, mask: length - 1 }
    }

    #[inline(always)]
    fn at(&self, k: usize) -> &Sum {
        &self.ring[k & self.mask]
    }

    /// P_(k + 1): one more wave, delayed by so many turns per nm of depth.
    #[inline(always)]
    fn add_wave(&mut self, k: usize, depth_nm: f64, turns_per_nm: &Lanes<f64>) {
        let next = &mut self.ring[(k + 1) & self.mask];
        for i in 0..LANES {
            let (cos_xi, sin_xi) = cos_sin_of_turns(depth_nm * turns_per_nm[i]);
            self.latest.re[i] += cos_xi;
            self.latest.im[i] += sin_xi;
            (next.re[i], next.im[i]) = (self.latest.re[i], self.latest.im[i]);
        }
    }

    /// The intensity of a window.
    #[inline(always)]
    fn window<E: Ends>(&self, start: usize, ends: E) -> Lanes<f64> {
        let (before, last) = (self.at(start), self.at(ends.last()));
        let mut squares = [0.0; LANES];
        for i in 0..LANES {
            let after = if E::ARE_ALIKE { last } else { self.at(ends.at(i)) };
            let (re, im) = (after.re[i] - before.re[i], after.im[i] - before.im[i]);
            squares[i] = re * re + im * im;
        }
        squares
    }
}

/// One polarisation of the light on its way down.
struct Beam {
    /// |a|^2, the intensity that one protein layer sends up.
    echo: Lanes<f64>,
    /// What passing one layer down and up again leaves.
    passing: Lanes<f64>,
    light: Lanes<f64>,
    intensity: Lanes<f64>,
}

impl Beam {
    /// Step 3: the waves from top and bottom of a protein layer, r2 of opposite signs, so
    /// |a|^2 = |r2 (1 - exp(i delta))|^2 = (2 r2 sin(delta / 2))^2, exact for the thinnest layer too.
    /// All protein layers are alike, hence one a for all.
    #[inline(always)]
    fn new(
        r2: &Lanes<f64>,
        sight: &Sight,
        wavelength_nm: &Lanes<f64>,
        model: &IlluminantModel,
    ) -> Self {
        let (mut echo, mut passing) = ([0.0; LANES], [0.0; LANES]);
        for i in 0..LANES {
            let (_, sin_half_delta) =
                cos_sin_of_turns(0.5 * sight.protein_path_nm[i] / wavelength_nm[i]);
            echo[i] = (2.0 * r2[i] * sin_half_delta).powi(2);
            passing[i] = (1.0 - echo[i] - model.diffuse_loss).max(0.0).powi(2);
        }
        Self { echo, passing, light: [1.0; LANES], intensity: [0.0; LANES] }
    }

    /// False once no wavelength has light above the threshold any more.
    #[inline(always)]
    fn add_and_descend(&mut self, window: &Lanes<f64>, threshold: f64) -> bool {
        let mut most = 0.0;
        for i in 0..LANES {
            self.intensity[i] += self.light[i] * self.echo[i] * window[i];
            let light = self.light[i] * self.passing[i];
            let light = if light < threshold { 0.0 } else { light };
            self.light[i] = light;
            most = if light > most { light } else { most };
        }
        most > 0.0
    }
}

/// Steps 3 to 7 of section 3 of docs/model.md for a block of wavelengths. Nothing is fused here, so
/// every processor gives the same bits.
#[multiversion(targets(
    "x86_64+avx512f+avx512dq+avx512vl+avx512bw+avx512cd+avx2+fma",
    "x86_64+avx2+fma"
))]
pub(crate) fn interference<E: Ends>(
    model: &IlluminantModel,
    sight: &Sight,
    depth_nm: &[f64],
    ends: &[E],
    wavelength_nm: &Lanes<f64>,
    sums: &mut Sums,
) -> Lanes<f64> {
    let mut s = Beam::new(&sight.r2_s, sight, wavelength_nm, model);
    let mut p = Beam::new(&sight.r2_p, sight, wavelength_nm, model);
    let mut turns_per_nm = [0.0; LANES];
    for i in 0..LANES {
        turns_per_nm[i] = sight.path_per_nm[i] / wavelength_nm[i];
    }
    let mut summed = 0;
    for (l, &end) in ends.iter().enumerate() {
        // Steps 4 and 5: running sums, as far as this window reaches.
        while summed < end.last() {
            sums.add_wave(summed, depth_nm[summed], &turns_per_nm);
            summed += 1;
        }
        let window = sums.window(l, end);
        // Step 6: add the intensity of this start layer, then let the light go one layer deeper.
        let s_goes_on = s.add_and_descend(&window, model.threshold);
        let p_goes_on = p.add_and_descend(&window, model.threshold);
        if !(s_goes_on | p_goes_on) {
            break;
        }
    }
    // Step 7, for natural light.
    let mut intensity = [0.0; LANES];
    for i in 0..LANES {
        intensity[i] = 0.5 * sight.t1[i] * (s.intensity[i] + p.intensity[i]);
    }
    intensity
}
