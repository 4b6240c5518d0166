//! A pixel that shows no pearl.
//!
//! One sample in each row and column; where they differ, the others too. Several lines of sight at a time.
//! Left out: windows seen straight, which are looked at line by line.

use crate::{
    picture::{detail::Range, sampler::Sampler, tent::rook},
    rgb::{self, Rgb},
    surroundings::weave::LANES,
};

impl Sampler {
    /// The light of a pixel that shows no pearl; `lights` is where its samples are kept.
    pub(super) fn open(&self, at: (usize, usize), lights: &mut Vec<Rgb>) -> Rgb {
        let side = self.samples_side();
        let is_few = |sample: usize| sample % side == rook(sample / side, side);
        lights.clear();
        lights.resize(side * side, [0.0; 3]);
        self.look(at, (0..side).map(|i| i * side + rook(i, side)), lights);
        let mut range = Range::default();
        let (mut few, mut all) = ([0.0; 3], [0.0; 3]);
        for i in 0..side {
            let light = lights[i * side + rook(i, side)];
            range.add(light);
            rgb::add(&mut few, rgb::scaled(light, self.weight()));
        }
        if range.is_narrow(self.exposure) {
            return rgb::scaled(few, side as f64);
        }
        self.look(at, (0..side * side).filter(|sample| !is_few(*sample)), lights);
        for light in lights {
            rgb::add(&mut all, rgb::scaled(*light, self.weight()));
        }
        all
    }

    /// Puts what some samples of a pixel show, by number, into its lights.
    fn look(&self, at: (usize, usize), samples: impl Iterator<Item = usize>, lights: &mut [Rgb]) {
        let side = self.samples_side();
        let ray =
            |sample: usize| self.ray(at, self.offsets[sample / side], self.offsets[sample % side]);
        let mut samples = samples.peekable();
        while let Some(&first) = samples.peek() {
            // Where fewer are left, the first counts for those that are missing.
            let (mut numbers, mut wide_rad) = ([first; LANES], [0.0; LANES]);
            let mut rays = [ray(first); LANES];
            for i in 0..LANES {
                if let Some(sample) = samples.next() {
                    (numbers[i], rays[i]) = (sample, ray(sample));
                }
                wide_rad[i] = self.wide_rad(&rays[i], self.width_px);
            }
            let seen = self.surroundings.sceneries(&rays, wide_rad);
            for (number, light) in numbers.into_iter().zip(seen) {
                lights[number] = light;
            }
        }
    }
}
