//! The CIE's tabulated lights other than D50 and D65.

use std::sync::LazyLock;

use crate::table::rows;
use crate::{SAMPLES, Spectrum, WAVELENGTH_NM};

/// Columns of `data/cie_lamps.csv` behind the wavelength.
const NAMES: [&str; 24] = [
    "C", "D55", "D75", "FL1", "FL2", "FL3", "FL4", "FL5", "FL6", "FL7", "FL8", "FL9", "FL10",
    "FL11", "FL12", "LED-B1", "LED-B2", "LED-B3", "LED-B4", "LED-B5", "LED-BH1", "LED-RGB1",
    "LED-V1", "LED-V2",
];

/// A light that the CIE tabulates every 5 nm: illuminants C, D55 and D75, fluorescent lamps FL1 to
/// FL12 (F1 to F12 in older texts), and white LEDs: phosphor LED-B1 to LED-B5, hybrid LED-BH1, of
/// three colours LED-RGB1, violet-pumped LED-V1 and LED-V2 (CIE 015:2018, tables 5, 6, 10 and 12).
///
/// ```
/// use nacreous_colour::Lamp;
/// let shop = Lamp::named("F11").unwrap();
/// assert_eq!(shop.name(), "FL11");
/// assert_eq!(shop.spectrum().values()[560 - 380], 1.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lamp(usize);

impl Lamp {
    /// The light of that name.
    pub fn named(name: &str) -> Option<Self> {
        let modern = name.strip_prefix('F').filter(|rest| !rest.starts_with('L'));
        let modern = modern.map(|number| format!("FL{number}"));
        let wanted = modern.as_deref().unwrap_or(name);
        NAMES.iter().position(|&known| known == wanted).map(Self)
    }

    /// The CIE's name.
    pub fn name(self) -> &'static str {
        NAMES[self.0]
    }

    /// The relative spectrum, 1 at 560 nm.
    pub fn spectrum(self) -> Spectrum {
        TABLE[self.0].clone()
    }
}

/// By 1 nm on straight lines, as CIE 015 has it for its illuminants.
static TABLE: LazyLock<[Spectrum; NAMES.len()]> = LazyLock::new(|| {
    // The table is part of the program; the tests of this file read it.
    let rows = rows::<{ NAMES.len() + 1 }>(include_str!("../../../data/cie_lamps.csv"), "lamps")
        .expect("the table in data/ is well formed");
    std::array::from_fn(|lamp| {
        let at = |nm: f64| {
            let above = rows.partition_point(|row| row.cells[0] < nm);
            let (from, to) = (&rows[above.max(1) - 1].cells, &rows[above].cells);
            let share = if above == 0 { 0.0 } else { (nm - from[0]) / (to[0] - from[0]) };
            from[lamp + 1] + share * (to[lamp + 1] - from[lamp + 1])
        };
        let reference = at(560.0);
        let values: [f64; SAMPLES] = WAVELENGTH_NM.map(|nm| at(nm) / reference);
        Spectrum(values)
    })
});

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exact where nothing is computed")]
mod tests {
    use super::*;

    #[test]
    fn the_columns_of_the_table_are_the_names() {
        let text = include_str!("../../../data/cie_lamps.csv");
        let header = text.lines().find(|line| !line.starts_with('#')).unwrap();
        assert_eq!(header, format!("wavelength_nm,{}", NAMES.join(",")));
    }

    #[test]
    fn every_light_is_known_from_end_to_end_and_by_its_older_name() {
        for name in NAMES {
            let lamp = Lamp::named(name).unwrap();
            assert_eq!(lamp.name(), name);
            let values = *lamp.spectrum().values();
            assert_eq!(values[560 - 380], 1.0);
            assert!(values.iter().all(|value| (0.0..100.0).contains(value)), "{name}");
        }
        assert_eq!(Lamp::named("F7"), Lamp::named("FL7"));
        for name in ["F", "F0", "F13", "FL13", "FFL1", "LED", "c", ""] {
            assert_eq!(Lamp::named(name), None, "{name}");
        }
    }
}
