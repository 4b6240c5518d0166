//! Columns of tablets whose thickness is told by a few nodes, the same for all of them, and the rest.

use nacreous_nacre::LayerStack;

use crate::media::Table;

/// Stacks of the same media and of one thickness of protein.
pub(crate) struct Columns<'a> {
    pub(crate) stacks: &'a [LayerStack],
    /// Where phases are to be looked up in a table.
    pub(crate) tablets: Option<Tablets>,
}

/// Tablets of some columns.
pub(crate) struct Tablets {
    pub(crate) step_nm: f64,
    /// Every thickness at which a table is needed.
    pub(crate) nodes_nm: Vec<f64>,
    /// `[column, tablet]`, surface first.
    pub(crate) columns: Vec<Vec<Tablet>>,
}

/// An aragonite layer.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(crate) struct Tablet {
    /// Of [`Tablets::nodes_nm`], the nearest.
    pub(crate) node: usize,
    /// Thickness beyond it, within half a step.
    pub(crate) beyond_nm: f32,
}

/// The most phase, in half turns, from a node to the middle between two: the cubic in the tangent's place is
/// right to 1.4e-7 there, a rounding of single precision.
const REACH: f64 = 0.035;

impl Tablets {
    /// Nodes are multiples of a step that the media and wavelengths alone decide, so no column's result
    /// depends on its neighbours.
    pub(crate) fn new(stacks: &[LayerStack], media: &Table) -> Self {
        let step_nm = 2.0 * REACH / media.most_half_turns_per_nm();
        let whole = |nm: &f64| (nm / step_nm).round();
        let mut nodes: Vec<f64> =
            stacks.iter().flat_map(LayerStack::thickness_nm).map(whole).collect();
        nodes.sort_unstable_by(f64::total_cmp);
        nodes.dedup();
        let tablet = |nm: &f64| {
            let node = nodes.partition_point(|&node| node < whole(nm));
            Tablet { node, beyond_nm: (nm - whole(nm) * step_nm) as f32 }
        };
        let columns =
            stacks.iter().map(|stack| stack.thickness_nm().iter().map(tablet).collect()).collect();
        let nodes_nm = nodes.iter().map(|node| node * step_nm).collect();
        Self { step_nm, nodes_nm, columns }
    }
}
