//! One pixel's light in parts, and the grain laid on it.
//!
//! The paper, section 4.4: hue, chroma and brightness change in proportion to lightness, which is that of
//! exposed light: white has exposure times its radiance equal to 1 **(ours)**.
//! Left out: grain on what interference adds.

use nacreous_colour::{hvc_from_rgb, rgb_from_hvc, value_from_rgb};

use crate::{
    pearl::{model::Pearl, shade::Shade},
    rgb::{self, Rgb},
};

/// One pixel's light in parts, averaged over its samples.
#[derive(Debug, Clone, Copy, Default)]
pub(crate) struct Pixel {
    pub(crate) interference: Rgb,
    diffuse: Rgb,
    mirror: Rgb,
    surroundings: Rgb,
    texture: Rgb,
    coverage: f64,
    /// Share of the table's light behind the pearls that they take away.
    pub(crate) shadow: f64,
}

impl Pixel {
    /// A pixel of what lies behind the pearls.
    pub(crate) fn of_surroundings(surroundings: Rgb) -> Self {
        Self { surroundings, ..Self::default() }
    }

    /// Adds a sample that covers `weight` of the pixel.
    pub(crate) fn add(&mut self, shade: &Shade, weight: f64) {
        rgb::add(&mut self.interference, rgb::scaled(shade.interference, weight));
        rgb::add(&mut self.diffuse, rgb::scaled(shade.diffuse, weight));
        rgb::add(&mut self.mirror, rgb::scaled(shade.mirror, weight));
        rgb::add(&mut self.texture, rgb::scaled(shade.texture, weight));
        self.coverage += weight;
    }

    /// Counts its samples so many times.
    pub(crate) fn brighten(&mut self, times: f64) {
        let parts =
            [&mut self.interference, &mut self.diffuse, &mut self.mirror, &mut self.texture];
        for part in parts {
            *part = rgb::scaled(*part, times);
        }
        self.coverage *= times;
    }

    /// Grain of the one pearl that the samples so far show: H and C of the body colour and the
    /// brightness of what is mirrored, each changed in proportion to lightness (paper, section 4.4).
    /// Once a pixel, for its samples share the texture. How light a part is, the finished picture says: its
    /// light times `exposure`.
    pub(crate) fn lay_texture(&mut self, pearl: &Pearl, exposure: f64) {
        let weights = pearl.skin.grain;
        if self.coverage <= 0.0 || pearl.skin.texture.is_none() {
            return;
        }
        let [hue, value, chroma] = self.texture.map(|t| t / self.coverage);
        let exposed = exposure / self.coverage;
        let lightness =
            |part: Rgb| value_from_rgb(rgb::scaled(part, exposed)).clamp(0.0, 10.0) / 10.0;
        let glint = 1.0 + weights.value * lightness(self.mirror) * value;
        let mut body = hvc_from_rgb(rgb::scaled(self.diffuse, exposed));
        let light = body.value.clamp(0.0, 10.0) / 10.0;
        body.hue_rad += weights.hue_rad * light * hue;
        body.chroma *= (1.0 + weights.chroma * light * chroma).max(0.0);
        self.diffuse = rgb::scaled(rgb_from_hvc(body), self.coverage / exposure);
        self.mirror = rgb::scaled(self.mirror, glint.max(0.0));
        self.texture = [hue, value, chroma];
    }

    /// Adds what another pearl shows of the same pixel. The texture is the mean over what all cover.
    pub(crate) fn join(&mut self, other: &Self) {
        rgb::add(&mut self.interference, other.interference);
        rgb::add(&mut self.diffuse, other.diffuse);
        rgb::add(&mut self.mirror, other.mirror);
        self.coverage += other.coverage;
        if other.coverage > 0.0 {
            self.texture = rgb::mix(self.texture, other.texture, other.coverage / self.coverage);
        }
    }

    pub(crate) fn store(&self, out: &mut [f32]) {
        let parts = [
            self.interference,
            self.diffuse,
            self.mirror,
            self.surroundings,
            self.texture,
            [self.coverage, self.shadow, 0.0],
        ];
        for (channel, value) in out.iter_mut().zip(parts.into_iter().flatten()) {
            *channel = value as f32;
        }
    }
}
