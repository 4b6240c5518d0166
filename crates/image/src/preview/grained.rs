//! Grain on a preview's light, in single precision.
//!
//! The transform to Munsell's hue, value and chroma of `nacreous-colour`, its way back by two steps of Newton's method from
//! the hue before: grain turns hues by little.
//! Left out: hues that it turns by more than a few tenths of a radian, which come out less turned.

use nacreous_colour::{Matrix, WHITE_C, hvc_from_rgb, matrix::inverse, xyz_from_hvc};

use crate::{
    pearl::skin::Grain,
    preview::lanes::{LANES, Lanes, larger},
};

/// How grain changes light.
pub(super) struct Grained {
    /// From linear sRGB to XYZ relative to white under illuminant C, and back.
    to_relative: [[f32; 3]; 3],
    from_relative: [[f32; 3]; 3],
}

impl Grained {
    pub(super) fn new() -> Self {
        let relative = |i: usize| {
            let unit = std::array::from_fn(|k| f64::from(u8::from(k == i)));
            let xyz = xyz_from_hvc(hvc_from_rgb(unit));
            [0, 1, 2].map(|k| xyz[k] / WHITE_C[k])
        };
        let columns = [0, 1, 2].map(relative);
        let to: Matrix = [0, 1, 2].map(|row| columns.map(|column| column[row]));
        let single = |matrix: Matrix| matrix.map(|row| row.map(|value| value as f32));
        Self { to_relative: single(to), from_relative: single(inverse(&to)) }
    }

    /// Lays the grain of pixels side by side on what is mirrored and on what comes from inside, both as light in the
    /// finished picture.
    pub(super) fn lay(&self, grains: &Grains, mirror: &mut [Lanes; 3], diffuse: &mut [Lanes; 3]) {
        for lane in 0..LANES {
            let light = [0, 1, 2].map(|i| mirror[i][lane]);
            let mirrored = lightness(apply(&self.to_relative, light)[1]).clamp(0.0, 10.0) * 0.1;
            let glint = larger(1.0 + mirrored * grains.value[lane], 0.0);
            let light = [0, 1, 2].map(|i| diffuse[i][lane]);
            let turned = self.turned(light, grains.hue_rad[lane], grains.chroma[lane]);
            for i in 0..3 {
                mirror[i][lane] *= glint;
                diffuse[i][lane] = turned[i];
            }
        }
    }

    /// A colour whose hue is turned, and its chroma changed, in proportion to its lightness. Without branches.
    #[inline]
    fn turned(&self, colour: [f32; 3], turn_rad: f32, stretch: f32) -> [f32; 3] {
        let [x, value, z] = apply(&self.to_relative, colour).map(lightness);
        let lit = value.clamp(0.0, 10.0) * 0.1;
        let (m1, m2) = (x - value, 0.4 * (z - value));
        let m = (m1 * m1 + m2 * m2).sqrt();
        // A grey has no hue to turn; any will do.
        let from = if m > GREY { [m1 / m, m2 / m] } else { [1.0, 0.0] };
        let goal = opponents(from);
        let length = (goal[0] * goal[0] + goal[1] * goal[1]).sqrt();
        let (sin, cos) = sin_cos(turn_rad * lit);
        let wanted = rotated([goal[0] / length, goal[1] / length], [cos, sin]);
        let found = direction_of(rotated(from, [cos, sin]), wanted);
        let gain = opponents(found);
        let gain = (gain[0] * gain[0] + gain[1] * gain[1]).sqrt();
        let m = m * length * larger(1.0 + lit * stretch, 0.0) / gain;
        let relative = [value + m * found[0], value, value + m * found[1] / 0.4];
        apply(&self.from_relative, relative.map(ratio))
    }
}

/// Below this, the transform's M is rounding.
const GREY: f32 = 1e-6;

/// Grain of pixels side by side, times its weights.
#[derive(Default)]
pub(super) struct Grains {
    hue_rad: Lanes,
    value: Lanes,
    chroma: Lanes,
}

impl Grains {
    pub(super) fn set(&mut self, lane: usize, weights: Option<&Grain>, grain: [f32; 3]) {
        let [hue, value, chroma] = grain;
        let weight = |of: fn(&Grain) -> f64| weights.map_or(0.0, |weights| of(weights) as f32);
        self.hue_rad[lane] = hue * weight(|weights| weights.hue_rad);
        self.value[lane] = value * weight(|weights| weights.value);
        self.chroma[lane] = chroma * weight(|weights| weights.chroma);
    }
}

/// The direction of M whose opponents point to where they shall, from one near it.
#[inline]
fn direction_of(mut near: [f32; 2], wanted: [f32; 2]) -> [f32; 2] {
    for _ in 0..2 {
        let [x, y] = near;
        let at = opponents(near);
        let slope = [-y * (8.880 + 1.932 * x), x * (8.025 + 5.116 * y)];
        let step =
            (at[1] * wanted[0] - at[0] * wanted[1]) / (slope[1] * wanted[0] - slope[0] * wanted[1]);
        let next = [x + y * step, y - x * step];
        let unit = 1.0 / (1.0 + step * step).sqrt();
        near = next.map(|part| part * unit);
    }
    near
}

/// (S1, S2) of the transform for M in a direction.
#[inline]
fn opponents([cos, sin]: [f32; 2]) -> [f32; 2] {
    [(8.880 + 0.966 * cos) * cos, (8.025 + 2.558 * sin) * sin]
}

#[inline]
fn rotated([x, y]: [f32; 2], [cos, sin]: [f32; 2]) -> [f32; 2] {
    [x * cos - y * sin, x * sin + y * cos]
}

/// Of a small angle.
#[inline]
fn sin_cos(rad: f32) -> (f32, f32) {
    let square = rad * rad;
    let cos = 1.0 - square * (0.5 - square * (1.0 / 24.0 - square * (1.0 / 720.0)));
    (rad * (1.0 - square * (1.0 / 6.0 - square * (1.0 / 120.0))), cos)
}

#[inline]
fn apply(matrix: &[[f32; 3]; 3], v: [f32; 3]) -> [f32; 3] {
    matrix.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// V: lightness on the Munsell scale, L* / 10.
#[inline]
fn lightness(ratio: f32) -> f32 {
    11.6 * if ratio > 0.008_856_452 { root(ratio) } else { ratio * 7.787_037 + 0.137_931_03 } - 1.6
}

#[inline]
fn ratio(lightness: f32) -> f32 {
    let root = (lightness + 1.6) / 11.6;
    if root > 0.206_896_55 { root * root * root } else { (root - 0.137_931_03) * 0.128_418_55 }
}

/// The cube root of a number above 0: a third of its exponent, then two steps of Newton's method.
#[inline]
fn root(x: f32) -> f32 {
    let mut y = f32::from_bits(x.to_bits() / 3 + 0x2a51_4067);
    for _ in 0..2 {
        y -= (y * y * y - x) / (3.0 * y * y);
    }
    y
}

#[cfg(test)]
mod tests {
    use nacreous_colour::{hvc_from_rgb, rgb_from_hvc, value_from_rgb};

    use super::*;

    #[test]
    fn grain_is_that_of_the_picture() {
        let grained = Grained::new();
        let weights = Grain { hue_rad: 0.9, chroma: 1.5, value: 1.2, relief_rad: 0.0 };
        for i in 0..600_i32 {
            let part = |k: i32| f64::from((i * k) % 89) / 89.0;
            let diffuse = [0.5 + 0.4 * part(7), 0.5 + 0.4 * part(11), 0.45 + 0.4 * part(13)];
            let mirror = [part(3), part(5), part(17)].map(|channel| 0.5 * channel);
            let grain = [0.4 * part(19) - 0.2, part(23) - 0.5, 0.8 * part(29) - 0.4];
            let mut body = hvc_from_rgb(diffuse);
            let light = body.value.clamp(0.0, 10.0) / 10.0;
            body.hue_rad += weights.hue_rad * light * grain[0];
            body.chroma *= (1.0 + weights.chroma * light * grain[2]).max(0.0);
            let glint = 1.0 + weights.value * value_from_rgb(mirror) / 10.0 * grain[1];
            let expected = [mirror.map(|channel| channel * glint.max(0.0)), rgb_from_hvc(body)];
            let single = |rgb: [f64; 3]| rgb.map(|channel| channel as f32);
            let mut grains = Grains::default();
            grains.set(5, Some(&weights), single(grain));
            let [mut mirror, mut diffuse] =
                [mirror, diffuse].map(|light| single(light).map(|channel| [channel; LANES]));
            grained.lay(&grains, &mut mirror, &mut diffuse);
            let found = mirror.iter().chain(&diffuse).map(|channel| f64::from(channel[5]));
            for (found, expected) in found.zip(expected.iter().flatten()) {
                assert!((found - expected).abs() < 2e-3, "{i}: {found} {expected}");
            }
        }
    }
}
