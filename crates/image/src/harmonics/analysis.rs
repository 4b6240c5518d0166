use std::f64::consts::PI;

use glam::DVec3;

use crate::harmonics::{
    coefficients::{CHANNELS, Coefficients},
    legendre::{LANES, Recursion, Scaled, legendre},
};

/// The directions of a grid of `rows` rows and twice as many columns, row by row, each with the solid
/// angle that it stands for: those where [`super::synthesise`] gives the field.
pub fn directions_of_grid(rows: usize) -> impl Iterator<Item = (DVec3, f64)> {
    let step = PI / rows as f64;
    (0..rows).flat_map(move |row| {
        let (sin, cos) = libm::sincos((row as f64 + 0.5) * step);
        let solid_angle = 2.0 * sin * libm::sin(0.5 * step) * step;
        (0..2 * rows).map(move |column| {
            let (up, along) = libm::sincos(column as f64 * step);
            (DVec3::new(sin * along, sin * up, cos), solid_angle)
        })
    })
}

/// The coefficients up to degree `top` of the fields whose values at [`directions_of_grid`] are given.
///
/// Right for fields without detail between the rows: a grid cannot tell it from coarser waves.
pub fn analyse(rows: usize, values: &[[f64; CHANNELS]], top: usize) -> Coefficients {
    debug_assert!(values.len() == 2 * rows * rows && top < rows);
    let step = PI / rows as f64;
    let waves: Vec<[f64; 2]> = (0..2 * rows)
        .map(|i| {
            let (sin, cos) = libm::sincos(i as f64 * step);
            [cos, sin]
        })
        .collect();
    let recursion = Recursion::new(top);
    let mut coefficients = Coefficients::zero(top);
    for (row, ring) in values.chunks_exact(2 * rows).enumerate() {
        let (sin, cos) = libm::sincos((row as f64 + 0.5) * step);
        let solid_angle = 2.0 * sin * libm::sin(0.5 * step) * step;
        let (sin, cos) = ([sin; LANES], [cos; LANES]);
        let mut sectoral = Scaled::start();
        let mut column = vec![[0.0; LANES]; top + 1];
        for m in 0..=top {
            let Some(seen) = legendre(recursion.column(m), &cos, &sectoral, &mut column) else {
                break;
            };
            let wave = ring_wave(ring, &waves, m);
            for l in m + seen..=top {
                let factor = solid_angle * column[l - m][0];
                for (sum, part) in coefficients.at_mut(l, m).iter_mut().zip(wave) {
                    sum[0] += factor * part[0];
                    sum[1] += factor * part[1];
                }
            }
            sectoral.step(m, &sin);
        }
    }
    coefficients
}

/// The coefficients up to degree `top` of unit light from one direction, alike in all fields.
pub fn point(direction: DVec3, top: usize) -> Coefficients {
    let across = (direction.x * direction.x + direction.y * direction.y).sqrt();
    let (sin, cos) = ([across; LANES], [direction.z; LANES]);
    let turn =
        if across > 0.0 { [direction.x / across, -direction.y / across] } else { [1.0, 0.0] };
    let recursion = Recursion::new(top);
    let mut coefficients = Coefficients::zero(top);
    let (mut sectoral, mut wave) = (Scaled::start(), [1.0, 0.0]);
    let mut column = vec![[0.0; LANES]; top + 1];
    for m in 0..=top {
        let Some(seen) = legendre(recursion.column(m), &cos, &sectoral, &mut column) else { break };
        for l in m + seen..=top {
            *coefficients.at_mut(l, m) = [wave.map(|part| part * column[l - m][0]); CHANNELS];
        }
        sectoral.step(m, &sin);
        wave = [wave[0] * turn[0] - wave[1] * turn[1], wave[0] * turn[1] + wave[1] * turn[0]];
    }
    coefficients
}

/// The sum of a ring's values times exp(-i m phi).
fn ring_wave(ring: &[[f64; CHANNELS]], waves: &[[f64; 2]], m: usize) -> [[f64; 2]; CHANNELS] {
    let mut sums = [[0.0; 2]; CHANNELS];
    for (i, value) in ring.iter().enumerate() {
        let [cos, sin] = waves[(i * m) % waves.len()];
        for (sum, channel) in sums.iter_mut().zip(value) {
            sum[0] += channel * cos;
            sum[1] -= channel * sin;
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::harmonics::synthesis::synthesise;

    #[test]
    fn what_is_synthesised_is_found_again() {
        let (rows, top) = (48, 12);
        let mut truth = Coefficients::zero(top);
        for l in 0..=top {
            for m in 0..=l {
                let part = |k: usize| ((7 * l + 3 * m + k) % 11) as f64 / 11.0 - 0.4;
                let imaginary = if m == 0 { 0.0 } else { 1.0 };
                *truth.at_mut(l, m) = [0, 1, 2].map(|k| [part(k), imaginary * part(k + 5)]);
            }
        }
        let mut grid = vec![[0.0; CHANNELS]; 2 * rows * rows];
        synthesise(&truth, top, (rows, 2 * rows), |texel| texel, &mut grid);
        let mut found = analyse(rows, &grid, top);
        for l in 0..=top {
            for m in 0..=l {
                let (a, b) = (*truth.at_mut(l, m), *found.at_mut(l, m));
                for (a, b) in a.iter().flatten().zip(b.iter().flatten()) {
                    // The rule in theta is of second order in the step.
                    assert!((a - b).abs() < 0.02, "l {l} m {m}: {a} {b}");
                }
            }
        }
    }

    #[test]
    fn the_grid_covers_the_sphere_once() {
        let whole: f64 = directions_of_grid(32).map(|(_, solid_angle)| solid_angle).sum();
        assert!((whole - 4.0 * PI).abs() < 1e-12);
    }
}
