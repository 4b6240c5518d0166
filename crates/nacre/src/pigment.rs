use std::sync::LazyLock;

const ROWS: usize = 41;
const FIRST_NM: f64 = 380.0;
const STEP_NM: f64 = 10.0;

/// What colours the nacre of a pearl, and how strongly it absorbs at each wavelength.
///
/// ```
/// use nacreous_nacre::Pigment;
/// let gold = Pigment::named("gold").unwrap();
/// assert!(gold.absorption_per_mm(420.0) > 10.0 * gold.absorption_per_mm(600.0));
/// assert_eq!(Pigment::named("none").unwrap().absorption_per_mm(550.0), 0.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pigment {
    /// Per mm at strength 1, from 380 to 780 nm by 10 nm.
    absorption_per_mm: [f64; ROWS],
}

static TABLE: LazyLock<Vec<Pigment>> =
    LazyLock::new(|| columns(include_str!("../../../data/pigments.csv")));

/// One pigment for each column behind the wavelength, in the order of [`Pigment::NAMES`] after `none`.
fn columns(text: &str) -> Vec<Pigment> {
    let rows = text.lines().filter(|line| !line.starts_with('#')).skip(1);
    // The file is part of the program, and a test reads all of it.
    let cells = |row: &str| row.split(',').map(|cell| cell.parse().expect("a number")).collect();
    let rows: Vec<Vec<f64>> = rows.map(cells).collect();
    (1..Pigment::NAMES.len())
        .map(|column| Pigment { absorption_per_mm: std::array::from_fn(|row| rows[row][column]) })
        .collect()
}

impl Pigment {
    /// The pigments that [`Pigment::named`] knows; sources in `data/pigments.csv`. `none` absorbs
    /// nothing at all, as no pearl does.
    pub const NAMES: [&'static str; 7] =
        ["none", "white", "cream", "pink", "gold", "black-lip", "dyed-blue"];

    /// A pigment by its name.
    pub fn named(name: &str) -> Option<Self> {
        let place = Self::NAMES.iter().position(|known| *known == name)?;
        let none = Self { absorption_per_mm: [0.0; ROWS] };
        Some(place.checked_sub(1).map_or(none, |column| TABLE[column]))
    }

    /// Kubelka and Munk's absorption coefficient K at strength 1, by straight lines between the rows of
    /// the table; below 380 and above 780 nm it stays as it is there.
    pub fn absorption_per_mm(&self, wavelength_nm: f64) -> f64 {
        let place = ((wavelength_nm - FIRST_NM) / STEP_NM).clamp(0.0, (ROWS - 1) as f64);
        let row = (place as usize).min(ROWS - 2);
        let (from, to) = (self.absorption_per_mm[row], self.absorption_per_mm[row + 1]);
        from + (to - from) * (place - row as f64)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_a_column_of_the_table_and_every_row_stands_where_it_should() {
        let text = include_str!("../../../data/pigments.csv");
        let mut rows = text.lines().filter(|line| !line.starts_with('#'));
        let names: Vec<&str> = rows.next().unwrap().split(',').skip(1).collect();
        assert_eq!(names, Pigment::NAMES[1..]);
        let mut seen = 0;
        for row in rows {
            let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
            assert_eq!(cells.len(), Pigment::NAMES.len());
            assert!((cells[0] - (FIRST_NM + STEP_NM * f64::from(seen))).abs() < 1e-9);
            for (name, cell) in names.iter().zip(&cells[1..]) {
                let found = Pigment::named(name).unwrap().absorption_per_mm(cells[0]);
                assert!(found.to_bits() == cell.to_bits(), "{name} at {} nm", cells[0]);
                assert!(found >= 0.0);
            }
            seen += 1;
        }
        assert_eq!(seen, 41);
    }

    #[test]
    fn between_rows_are_straight_lines_and_beyond_the_ends_nothing_changes() {
        let gold = Pigment::named("gold").unwrap();
        let at = |nm| gold.absorption_per_mm(nm);
        assert!((at(405.0) - 0.5 * (at(400.0) + at(410.0))).abs() < 1e-15);
        assert!((at(777.5) - (0.25 * at(770.0) + 0.75 * at(780.0))).abs() < 1e-15);
        assert_eq!((at(300.0), at(900.0)), (at(380.0), at(780.0)));
    }

    #[test]
    fn published_bands_are_where_absorption_is_high() {
        // Pearl Science Laboratory: black-lip near 400, 500 and 700 nm.
        let black = Pigment::named("black-lip").unwrap();
        for (inside, outside) in [(400.0, 450.0), (500.0, 450.0), (500.0, 560.0), (700.0, 580.0)] {
            assert!(black.absorption_per_mm(inside) > black.absorption_per_mm(outside));
        }
        // Mamangkey 2010: gold's dip about 700 nm.
        let gold = Pigment::named("gold").unwrap();
        assert!(gold.absorption_per_mm(700.0) > gold.absorption_per_mm(640.0));
        assert!(gold.absorption_per_mm(700.0) > gold.absorption_per_mm(760.0));
        assert!(Pigment::named("golden").is_none());
    }
}
