//! Which blemishes lie near a place.
//!
//! Cells on the faces of a cube around the pearl.
//! Left out: nothing; a cell lists whatever may reach into it.

use glam::DVec3;

use crate::coat::blemish::Blemish;

/// Blemishes, by cells of directions.
#[derive(Debug)]
pub(crate) struct Spots {
    all: Vec<Blemish>,
    cells: Vec<Vec<u16>>,
}

/// Cells along an edge of a face.
const SIDE: usize = 24;

/// The widest a cell is from its middle, as a chord on a sphere of radius 1.
const CELL: f64 = 1.5 / SIDE as f64;

impl Spots {
    /// Blemishes of a pearl of `pearl_mm`, its radius.
    pub(crate) fn new(all: Vec<Blemish>, pearl_mm: f64) -> Self {
        let cell = |i: usize| {
            let middle = middle(i);
            let near = |blemish: &Blemish| {
                blemish.middle.distance(middle) < CELL + 1.1 * blemish.reach_mm() / pearl_mm
            };
            (0..).zip(&all).filter(|(_, blemish)| near(blemish)).map(|(i, _)| i).collect()
        };
        let cells = (0..6 * SIDE * SIDE).map(cell).collect();
        Self { all, cells }
    }

    /// Those that may reach a direction.
    pub(crate) fn near(&self, direction: DVec3) -> impl Iterator<Item = &Blemish> {
        self.cells[number(direction)].iter().map(|i| &self.all[usize::from(*i)])
    }
}

/// The cell of a direction.
fn number(direction: DVec3) -> usize {
    let size = direction.abs();
    let (face, u, v) = if size.x >= size.y && size.x >= size.z {
        (usize::from(direction.x < 0.0), direction.y / size.x, direction.z / size.x)
    } else if size.y >= size.z {
        (2 + usize::from(direction.y < 0.0), direction.x / size.y, direction.z / size.y)
    } else {
        (4 + usize::from(direction.z < 0.0), direction.x / size.z, direction.y / size.z)
    };
    let cell = |x: f64| ((0.5 * (x + 1.0) * SIDE as f64) as usize).min(SIDE - 1);
    (face * SIDE + cell(v)) * SIDE + cell(u)
}

/// The direction in the middle of a cell.
fn middle(number: usize) -> DVec3 {
    let (face, v, u) = (number / (SIDE * SIDE), number / SIDE % SIDE, number % SIDE);
    let at = |i: usize| (2.0 * i as f64 + 1.0) / SIDE as f64 - 1.0;
    let (u, v, sense) = (at(u), at(v), if face % 2 == 0 { 1.0 } else { -1.0 });
    match face / 2 {
        0 => DVec3::new(sense, u, v),
        1 => DVec3::new(u, sense, v),
        _ => DVec3::new(u, v, sense),
    }
    .normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::view::direction::directions;

    #[test]
    fn every_direction_lies_in_its_cell() {
        for (direction, _) in directions(60) {
            assert!(middle(number(direction)).distance(direction) < CELL, "{direction}");
        }
    }
}
