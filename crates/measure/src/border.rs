//! Whether a spot has a border: what a pearl mirrors by its facets has none.

use std::collections::HashSet;

use libm::sqrt;

/// How far to both sides of a border the difference is read, in radii **(ours)**: facets lean by 0.03 radians and
/// more, which blurs what they mirror by as many radii.
const ASIDE: f64 = 0.03;
const LEAST_ASIDE_PX: f64 = 1.5;
/// A spot loses this share of its difference there, along all but the softest quarter of its border **(ours)**: an
/// edge of light that is blurred by 0.06 radii loses half.
const LEAST_FALL: f64 = 0.65;
const SOFTEST: f64 = 0.25;
/// Steps along the way across.
const STEPS: usize = 4;
/// How far around a place of the border its direction is worked out, in pixels.
const AROUND: isize = 2;

/// A map of differences in CIELAB.
pub struct Differences<'a> {
    pub residual: &'a [[f64; 3]],
    pub held: &'a [bool],
    /// What lies on the pearl and is not looked at: the lamp's image, clipped light.
    pub hidden: &'a [bool],
    pub width: usize,
    /// The pearl's radius, in pixels of the map.
    pub radius: f64,
}

impl Differences<'_> {
    /// Whether most of a spot's difference is gone a little beyond its outline, nearly all along it.
    pub fn has_border(&self, spot: &[usize]) -> bool {
        let own: HashSet<usize> = spot.iter().copied().collect();
        let mut falls: Vec<f64> = spot.iter().filter_map(|&at| self.fall(at, &own)).collect();
        falls.sort_by(f64::total_cmp);
        let at = (SOFTEST * falls.len() as f64) as usize;
        falls.get(at).is_some_and(|fall| *fall > LEAST_FALL)
    }

    /// The share of the difference that is lost across the border at a pixel of it; None of a pixel within, and
    /// where the rim cuts the spot off.
    fn fall(&self, at: usize, own: &HashSet<usize>) -> Option<f64> {
        let near = [at.wrapping_sub(1), at + 1, at.wrapping_sub(self.width), at + self.width];
        if near.iter().all(|place| own.contains(place)) {
            return None;
        }
        let (column, row) = ((at % self.width).cast_signed(), (at / self.width).cast_signed());
        let (right, down) = self.outwards(column, row, own)?;
        let aside = (ASIDE * self.radius).max(LEAST_ASIDE_PX);
        let place = |share: f64| {
            let (x, y) = (aside * share * right, aside * share * down);
            self.place(column + x.round() as isize, row + y.round() as isize)
        };
        // What goes on behind the lamp's image is its glow.
        if place(1.0).is_some_and(|beyond| self.hidden[beyond]) {
            return Some(0.0);
        }
        let across = |share: f64| {
            place(share).filter(|&place| self.held[place]).map(|place| self.residual[place])
        };
        let steps = |sign: f64| (0..=STEPS).map(move |step| sign * step as f64 / STEPS as f64);
        let inside: Vec<[f64; 3]> = steps(-1.0).filter_map(across).collect();
        let outside: Vec<[f64; 3]> = steps(1.0).map(across).collect::<Option<_>>()?;
        let square = |one: &[f64; 3]| one.iter().map(|part| part * part).sum::<f64>();
        let most = inside.iter().max_by(|one, other| square(one).total_cmp(&square(other)))?;
        let along = |one: &[f64; 3]| (0..3).map(|i| one[i] * most[i]).sum::<f64>() / square(most);
        let least = outside.iter().map(along).fold(1.0, f64::min);
        Some(1.0 - least)
    }

    /// The direction away from what belongs to the spot; None where it lies on all sides alike.
    fn outwards(&self, column: isize, row: isize, own: &HashSet<usize>) -> Option<(f64, f64)> {
        let (mut right, mut down) = (0.0, 0.0);
        for y in -AROUND..=AROUND {
            for x in -AROUND..=AROUND {
                if self.place(column + x, row + y).is_none_or(|place| !own.contains(&place)) {
                    right += x as f64;
                    down += y as f64;
                }
            }
        }
        let length = sqrt(right * right + down * down);
        (length > 0.0).then(|| (right / length, down / length))
    }

    fn place(&self, column: isize, row: isize) -> Option<usize> {
        let height = (self.held.len() / self.width).cast_signed();
        let inside = (0..self.width.cast_signed()).contains(&column) && (0..height).contains(&row);
        inside.then(|| row.cast_unsigned() * self.width + column.cast_unsigned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Whether a spot of 8 pixels of radius has a border, on a pearl of 64, when it fades over so many pixels.
    fn is_bordered(fade_px: f64, hidden_from: usize) -> bool {
        let width = 64;
        let away = |at: usize| ((at % width) as f64 - 32.0).hypot((at / width) as f64 - 32.0);
        let light = |at| [10.0 * (0.5 + (8.0 - away(at)) / fade_px).clamp(0.0, 1.0), 0.0, 0.0];
        let residual: Vec<[f64; 3]> = (0..width * width).map(light).collect();
        let hidden: Vec<bool> = (0..width * width).map(|at| at % width >= hidden_from).collect();
        let held: Vec<bool> = hidden.iter().map(|hidden| !hidden).collect();
        let spot: Vec<usize> =
            (0..width * width).filter(|&at| held[at] && residual[at][0] >= 5.0).collect();
        let (residual, held, hidden) = (&residual[..], &held[..], &hidden[..]);
        Differences { residual, held, hidden, width, radius: 64.0 }.has_border(&spot)
    }

    #[test]
    fn a_spot_has_a_border_and_what_fades_or_is_cut_off_by_the_lamp_has_none() {
        assert!(is_bordered(1.0, 64) && is_bordered(3.0, 64));
        assert!(!is_bordered(14.0, 64));
        assert!(!is_bordered(1.0, 32));
    }
}
