//! A pixel that shows no pearl.
//!
//! One sample in each row and column; where they differ, the others too. Several lines of sight at a time.
//! Left out: windows seen straight, which are looked at line by line.

use crate::{
    picture::{detail::Range, sampler::Sampler, tent::rook},
    rgb::{self, Rgb},
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
        let rays = samples.map(|sample| {
            let ray = self.ray(at, self.offsets[sample / side], self.offsets[sample % side]);
            (sample, ray, self.wide_rad(&ray, self.width_px))
        });
        self.surroundings.each_scenery(rays, |sample, light| lights[sample] = light);
    }
}
