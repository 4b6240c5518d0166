//! Whether the likelihood has one maximum at finite values.
//!
//! Without effects of side and ties it does if, and only if, everyone who can be reached by "was
//! preferred to" can be reached back (Ford 1957, Amer. Math. Monthly 64, 28), ties counting both ways;
//! the normal distribution in place of the logistic changes nothing. With effects there must be no
//! direction in all parameters along which no answer becomes less likely: a system of differences.

use crate::{
    Counts, Model,
    recession::{Edge, negative_circle},
};

/// What can be said before fitting.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Existence {
    /// There is one maximum.
    Exists,
    /// Some stimuli were only ever preferred to the rest, or never met it.
    Apart,
    /// Side and values cannot be told from each other, or the side decides everything.
    Order,
    /// Ties can be as wide as one likes.
    Ties,
}

/// Whether the maximum exists, for a model with a value for each stimulus.
///
/// A prior holds the values, so only side and ties are left to ask about. A model of ties without a
/// tie has its maximum at width 0, which is for the caller to see.
pub fn existence(model: &Model, counts: &Counts) -> Existence {
    existence_of_seen(model, &counts.seen_by(model))
}

/// As [`existence`], of counts as the model sees them.
pub fn existence_of_seen(model: &Model, counts: &Counts) -> Existence {
    let held = model.prior.is_some();
    if !held && components(counts).iter().any(|&part| part != 0) {
        return Existence::Apart;
    }
    // With the values held, nothing but side and ties can move: one node.
    let nodes = if held { 1 } else { counts.stimuli };
    let ties = model.ties && counts.totals()[2] > 0.0;
    if model.order {
        for direction in [1.0, -1.0] {
            let edges = edges(counts, held, 0.0, direction);
            if negative_circle(nodes, &edges, 0.0).is_none() {
                return Existence::Order;
            }
        }
    }
    if ties && !ties_are_held(nodes, &edges(counts, held, 1.0, 0.0), model.order) {
        return Existence::Ties;
    }
    Existence::Exists
}

/// Whether ties cannot widen, whatever side does with it: half lines of its share are cut away by
/// circles until none is left, or a solution is found.
fn ties_are_held(nodes: usize, edges: &[Edge], order: bool) -> bool {
    let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
    let mut x = 0.0;
    for _ in 0..200 {
        let Some((fixed, slope)) = negative_circle(nodes, edges, x) else { return false };
        if !order || slope == 0.0 {
            return true;
        }
        let end = -fixed / slope;
        if slope > 0.0 {
            low = low.max(end);
        } else {
            high = high.min(end);
        }
        if low > high {
            return true;
        }
        x = match (low.is_finite(), high.is_finite()) {
            (true, true) => 0.5 * (low + high),
            (true, false) => low + 1.0,
            _ => high - 1.0,
        };
    }
    false
}

/// What a direction d of values with `width` of ties and `side` + x of order has to satisfy so that
/// no answer becomes less likely: left chosen, d_l - d_r + side >= width; right chosen,
/// d_l - d_r + side <= -width; a tie, |d_l - d_r + side| <= width.
fn edges(counts: &Counts, held: bool, width: f64, side: f64) -> Vec<Edge> {
    let slope = f64::from(side == 0.0);
    let mut edges = Vec::with_capacity(2 * counts.pairs.len());
    for (&[left, right], &[left_wins, right_wins, ties]) in counts.pairs.iter().zip(&counts.answers)
    {
        let (left, right) = if held { (0, 0) } else { (left, right) };
        // d_r <= d_l + side - width, and d_l <= d_r - side - width
        let mut down =
            |width: f64| edges.push(Edge { from: left, to: right, fixed: side - width, slope });
        if left_wins > 0.0 {
            down(width);
        }
        if ties > 0.0 {
            down(-width);
        }
        let mut up = |width: f64| {
            edges.push(Edge { from: right, to: left, fixed: -side - width, slope: -slope });
        };
        if right_wins > 0.0 {
            up(width);
        }
        if ties > 0.0 {
            up(-width);
        }
    }
    edges
}

/// The part each stimulus belongs to, in which all can be reached from all by "was preferred to";
/// a part was never preferred to one of a higher number (Tarjan 1972).
pub fn components(counts: &Counts) -> Vec<u32> {
    let below = Neighbours::of(counts);
    let n = counts.stimuli;
    let mut search = Search {
        order: vec![0; n],
        lowest: vec![0; n],
        part: vec![u32::MAX; n],
        waiting: Vec::new(),
        parts: 0,
        seen: 0,
    };
    for root in 0..n {
        if search.order[root] == 0 {
            search.from(root, &below);
        }
    }
    search.part
}

struct Search {
    order: Vec<u32>,
    lowest: Vec<u32>,
    part: Vec<u32>,
    waiting: Vec<u32>,
    parts: u32,
    seen: u32,
}

impl Search {
    /// Depth first, with a stack of its own: 5000 stimuli in a chain are no trouble.
    fn from(&mut self, root: usize, below: &Neighbours) {
        let mut path = vec![(root, below.first[root])];
        self.enter(root);
        while let Some((at, next)) = path.last_mut() {
            let at = *at;
            if *next < below.first[at + 1] {
                let to = below.to[*next] as usize;
                *next += 1;
                if self.order[to] == 0 {
                    self.enter(to);
                    path.push((to, below.first[to]));
                } else if self.part[to] == u32::MAX {
                    self.lowest[at] = self.lowest[at].min(self.order[to]);
                }
            } else {
                path.pop();
                if let Some(&(parent, _)) = path.last() {
                    self.lowest[parent] = self.lowest[parent].min(self.lowest[at]);
                }
                self.close(at);
            }
        }
    }

    fn enter(&mut self, at: usize) {
        self.seen += 1;
        self.order[at] = self.seen;
        self.lowest[at] = self.seen;
        self.waiting.push(at as u32);
    }

    fn close(&mut self, at: usize) {
        if self.lowest[at] != self.order[at] {
            return;
        }
        while let Some(member) = self.waiting.pop() {
            self.part[member as usize] = self.parts;
            if member as usize == at {
                break;
            }
        }
        self.parts += 1;
    }
}

/// Whom each stimulus was preferred to, or tied with.
struct Neighbours {
    first: Vec<usize>,
    to: Vec<u32>,
}

impl Neighbours {
    fn of(counts: &Counts) -> Self {
        let mut edges = Vec::with_capacity(2 * counts.pairs.len());
        for (&[left, right], &[left_wins, right_wins, ties]) in
            counts.pairs.iter().zip(&counts.answers)
        {
            if left_wins + ties > 0.0 {
                edges.push([left, right]);
            }
            if right_wins + ties > 0.0 {
                edges.push([right, left]);
            }
        }
        let mut first = vec![0; counts.stimuli + 1];
        for [from, _] in &edges {
            first[*from as usize + 1] += 1;
        }
        for i in 0..counts.stimuli {
            first[i + 1] += first[i];
        }
        let (mut next, mut to) = (first.clone(), vec![0; edges.len()]);
        for [from, end] in edges {
            to[next[from as usize]] = end;
            next[from as usize] += 1;
        }
        Self { first, to }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn counts(stimuli: usize, rows: &[(u32, u32, [f64; 3])]) -> Counts {
        let (pairs, answers) = rows.iter().map(|&(l, r, a)| ([l, r], a)).unzip();
        Counts::new(stimuli, pairs, answers).expect("counts")
    }

    #[test]
    fn a_circle_of_wins_has_a_maximum_and_a_chain_has_none() {
        let wins = [1.0, 0.0, 0.0];
        let circle = counts(3, &[(0, 1, wins), (1, 2, wins), (2, 0, wins)]);
        assert_eq!(existence(&Model::default(), &circle), Existence::Exists);
        let chain = counts(3, &[(0, 1, wins), (1, 2, wins)]);
        assert_eq!(existence(&Model::default(), &chain), Existence::Apart);
        assert_eq!(components(&chain), [2, 1, 0]);
        let held = Model { prior: Some(1.0), ..Model::default() };
        assert_eq!(existence(&held, &chain), Existence::Exists);
    }

    #[test]
    fn an_order_effect_must_be_told_from_the_values() {
        let order = Model { order: true, ..Model::default() };
        let one_sided = counts(2, &[(0, 1, [3.0, 2.0, 0.0])]);
        assert_eq!(existence(&order, &one_sided), Existence::Order);
        let both_sides = counts(2, &[(0, 1, [3.0, 2.0, 0.0]), (1, 0, [2.0, 2.0, 0.0])]);
        assert_eq!(existence(&order, &both_sides), Existence::Exists);
        let left_always = counts(2, &[(0, 1, [3.0, 0.0, 0.0]), (1, 0, [2.0, 0.0, 0.0])]);
        assert_eq!(existence(&order, &left_always), Existence::Order);
    }

    #[test]
    fn ties_must_not_be_all_or_explain_all() {
        let model = Model { ties: true, ..Model::default() };
        let ties_only = counts(2, &[(0, 1, [0.0, 0.0, 3.0])]);
        assert_eq!(existence(&model, &ties_only), Existence::Ties);
        let mixed = counts(2, &[(0, 1, [2.0, 1.0, 3.0])]);
        assert_eq!(existence(&model, &mixed), Existence::Exists);
        // 0 over 1 over 2, each also tied with its neighbour: wider ties and wider steps fit ever better.
        let steps = counts(3, &[(0, 1, [2.0, 0.0, 1.0]), (1, 2, [2.0, 0.0, 1.0])]);
        assert_eq!(existence(&model, &steps), Existence::Ties);
        let both = Model { order: true, ..model };
        assert_eq!(existence(&both, &steps), Existence::Order);
    }
}
