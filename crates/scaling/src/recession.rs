//! Systems of differences: is there a d with d[to] <= d[from] + length for every edge?

/// A directed edge and its length, which depends on one number: fixed + slope x.
#[derive(Debug, Clone, Copy)]
pub struct Edge {
    pub from: u32,
    pub to: u32,
    pub fixed: f64,
    pub slope: f64,
}

/// (fixed, slope) of a circle of edges that is shorter than 0 at x; none if there is a solution.
///
/// Bellman 1958 and Ford 1956, from a source at distance 0 of every node.
pub fn negative_circle(nodes: usize, edges: &[Edge], x: f64) -> Option<(f64, f64)> {
    let mut distance = vec![0.0_f64; nodes];
    let mut reached_by: Vec<Option<u32>> = vec![None; nodes];
    for _ in 0..=nodes {
        let mut changed = false;
        for (e, edge) in edges.iter().enumerate() {
            let length = distance[edge.from as usize] + edge.fixed + edge.slope * x;
            if length < distance[edge.to as usize] - 1e-9 {
                distance[edge.to as usize] = length;
                reached_by[edge.to as usize] = Some(e as u32);
                changed = true;
            }
        }
        if !changed {
            return None;
        }
        if let Some(found) = circle(nodes, edges, &reached_by) {
            return Some(found);
        }
    }
    None
}

/// A circle among the last edges that reached each node: it is always a negative one.
fn circle(nodes: usize, edges: &[Edge], reached_by: &[Option<u32>]) -> Option<(f64, f64)> {
    let mut seen = vec![0_u32; nodes];
    for start in 0..nodes {
        let mark = start as u32 + 1;
        let mut at = start;
        while seen[at] == 0 {
            seen[at] = mark;
            let Some(e) = reached_by[at] else { break };
            at = edges[e as usize].from as usize;
        }
        if seen[at] == mark && reached_by[at].is_some() {
            return Some(around(edges, reached_by, at));
        }
    }
    None
}

fn around(edges: &[Edge], reached_by: &[Option<u32>], first: usize) -> (f64, f64) {
    let (mut fixed, mut slope, mut at) = (0.0, 0.0, first);
    while let Some(e) = reached_by[at] {
        let edge = edges[e as usize];
        fixed += edge.fixed;
        slope += edge.slope;
        at = edge.from as usize;
        if at == first {
            break;
        }
    }
    (fixed, slope)
}
