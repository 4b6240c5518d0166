use nacreous_colour::{delta_e_2000, lab_from_xyz};
use nacreous_optics::OpticsError;

use crate::rgb;

/// A colour (three numbers that add like light) by the cosine of an angle: nodes evenly from cosine 0,
/// the rim of a ball, to 1, its middle; straight lines between them.
#[derive(Debug, Clone, PartialEq)]
pub struct ByAngle(Vec<[f64; 3]>);

/// The largest difference of colour, CIEDE2000, that straight lines may make half-way between nodes.
const TOLERANCE: f64 = 0.2;
const FEWEST_STEPS: usize = 64;
/// For what never becomes straight: spectra of hundreds of equal layers.
const MOST_STEPS: usize = 4096;

impl ByAngle {
    /// Cosines of `steps + 1` nodes.
    pub fn cosines(steps: usize) -> impl Iterator<Item = f64> {
        (0..=steps).map(move |step| step as f64 / steps as f64)
    }

    /// Two nodes or more, at the cosines that [`Self::cosines`] gives.
    pub(crate) fn new(nodes: Vec<[f64; 3]>) -> Self {
        debug_assert!(nodes.len() >= 2);
        Self(nodes)
    }

    /// The colour at each node.
    pub fn nodes(&self) -> &[[f64; 3]] {
        &self.0
    }

    /// The colour at a cosine.
    pub fn at(&self, cosine: f64) -> [f64; 3] {
        let last = self.0.len() - 1;
        let x = cosine.clamp(0.0, 1.0) * last as f64;
        let i = (x as usize).min(last - 1);
        rgb::mix(self.0[i], self.0[i + 1], x - i as f64)
    }

    /// Every node times a factor.
    pub(crate) fn scaled(mut self, factor: f64) -> Self {
        for node in &mut self.0 {
            *node = rgb::scaled(*node, factor);
        }
        self
    }

    /// `K` tables of XYZ on one grid, halved until it is fine enough: half-way between the nodes of the
    /// last grid but one, straight lines were right to CIEDE2000 0.2 against `white`.
    ///
    /// `xyz_at` answers for a row of cosines, or `None` to give up.
    pub(crate) fn refined<const K: usize>(
        white: [f64; 3],
        mut xyz_at: impl FnMut(&[f64]) -> Result<Option<Vec<[[f64; 3]; K]>>, OpticsError>,
    ) -> Result<Option<[Self; K]>, OpticsError> {
        let mut steps = FEWEST_STEPS;
        let Some(mut nodes) = xyz_at(&Self::cosines(steps).collect::<Vec<_>>())? else {
            return Ok(None);
        };
        while steps < MOST_STEPS {
            let odd: Vec<f64> = Self::cosines(2 * steps).skip(1).step_by(2).collect();
            let Some(between) = xyz_at(&odd)? else { return Ok(None) };
            let error = worst_error(white, &nodes, &between);
            nodes = interleaved(&nodes, &between);
            steps *= 2;
            if error <= TOLERANCE {
                break;
            }
        }
        let table = |k: usize| Self(nodes.iter().map(|colours| colours[k]).collect());
        Ok(Some(std::array::from_fn(table)))
    }
}

/// The largest CIEDE2000 between what lies half-way between nodes and the straight line there.
fn worst_error<const K: usize>(
    white: [f64; 3],
    nodes: &[[[f64; 3]; K]],
    between: &[[[f64; 3]; K]],
) -> f64 {
    let lab = |xyz| lab_from_xyz(xyz, white);
    let error = |k: usize, i: usize| {
        let straight = rgb::mix(nodes[i][k], nodes[i + 1][k], 0.5);
        delta_e_2000(lab(straight), lab(between[i][k]))
    };
    let errors = |i: usize| (0..K).map(move |k| error(k, i)).fold(0.0, f64::max);
    (0..between.len()).map(errors).fold(0.0, f64::max)
}

fn interleaved<T: Copy>(nodes: &[T], between: &[T]) -> Vec<T> {
    let pairs = nodes.iter().zip(between).flat_map(|(node, next)| [*node, *next]);
    pairs.chain(nodes.last().copied()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    type Answer = Result<Option<Vec<[[f64; 3]; 1]>>, OpticsError>;

    /// Rings, `waves` from rim to middle.
    fn rings(waves: f64) -> impl FnMut(&[f64]) -> Answer {
        let colour = move |c: &f64| [[0.5, 0.5 + 0.3 * (waves * c).sin(), 0.4]];
        move |cosines| Ok(Some(cosines.iter().map(colour).collect()))
    }

    #[test]
    fn refinement_goes_on_until_straight_lines_will_do() {
        for waves in [1.0, 30.0, 300.0] {
            let [table] = ByAngle::refined([1.0; 3], rings(waves)).unwrap().unwrap();
            let fine: Vec<f64> = ByAngle::cosines(4 * (table.nodes().len() - 1)).collect();
            for (cosine, [truth]) in fine.iter().zip(rings(waves)(&fine).unwrap().unwrap()) {
                let [first, second] =
                    [table.at(*cosine), truth].map(|xyz| lab_from_xyz(xyz, [1.0; 3]));
                assert!(delta_e_2000(first, second) < TOLERANCE, "{waves} {cosine}");
            }
        }
    }

    #[test]
    fn what_never_becomes_straight_ends_at_the_finest_grid() {
        let [table] = ByAngle::refined([1.0; 3], rings(1e6)).unwrap().unwrap();
        assert_eq!(table.nodes().len(), MOST_STEPS + 1);
    }

    #[test]
    fn giving_up_gives_no_table() {
        let given_up = ByAngle::refined::<1>([1.0; 3], |_| Ok(None)).unwrap();
        assert!(given_up.is_none());
    }
}
