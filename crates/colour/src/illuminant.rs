//! Lights by name or by colour temperature.

use std::fmt;
use std::str::FromStr;
use std::sync::LazyLock;

use libm::exp;

use crate::table::rows;
use crate::{ColourError, Lamp, SAMPLES, Spectrum};

/// Second radiation constant c2, in nm K, as CIE 015 takes it for colorimetry.
const RADIATION_NM_KELVIN: f64 = 1.4388e7;
/// Every illuminant is 1 here.
const REFERENCE_NM: f64 = 560.0;
/// Daylight is defined from here upward; a lower temperature is a glowing body.
const DAYLIGHT_FROM: f64 = 4000.0;

/// A colour temperature, 1000 to 25000 K.
///
/// ```
/// use nacreous_colour::Kelvin;
/// assert_eq!(Kelvin::new(5500.0)?.get(), 5500.0);
/// assert!(Kelvin::new(500.0).is_err());
/// # Ok::<(), nacreous_colour::ColourError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kelvin(f64);

impl Kelvin {
    /// The temperature of that many kelvin.
    ///
    /// # Errors
    /// Outside 1000 to 25000 K.
    pub fn new(kelvin: f64) -> Result<Self, ColourError> {
        if (1000.0..=25000.0).contains(&kelvin) {
            Ok(Self(kelvin))
        } else {
            Err(ColourError::Temperature { kelvin })
        }
    }

    /// The number of kelvin.
    pub fn get(self) -> f64 {
        self.0
    }
}

/// A light, by its relative spectrum. Read from and written as `A`, `D50`, `D65`, `E`, `5500K`, or
/// the name of a [`Lamp`], such as `D55` or `FL11`.
///
/// ```
/// use nacreous_colour::Illuminant;
/// let lamp: Illuminant = "2700K".parse()?;
/// let [blue, red] = [450, 650].map(|nm| lamp.spectrum().values()[nm - 380]);
/// assert!(red > 3.0 * blue);
/// # Ok::<(), nacreous_colour::ColourError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Illuminant {
    /// CIE illuminant A: a tungsten lamp.
    A,
    /// CIE illuminant D50: daylight of the graphic arts.
    D50,
    /// CIE illuminant D65: noon daylight, the white of screens.
    D65,
    /// Equal energy at every wavelength.
    E,
    /// Another light that the CIE tabulates.
    Lamp(Lamp),
    /// A colour temperature: daylight from 4000 K up, Planck's law below. The two loci differ a
    /// little where they meet: at 4000 K daylight is greener.
    Cct(Kelvin),
}

impl Illuminant {
    /// The relative spectrum, 1 at 560 nm.
    pub fn spectrum(self) -> Spectrum {
        match self {
            // ISO/CIE 11664-2 fixes A by these two numbers, from before c2 was revised.
            Self::A => planck(1.435e7 / 2848.0),
            Self::D50 => tabulated(include_str!("../../../data/cie_d50.csv")),
            Self::D65 => tabulated(include_str!("../../../data/cie_d65.csv")),
            Self::E => Spectrum::from_fn(|_| 1.0),
            Self::Lamp(lamp) => lamp.spectrum(),
            Self::Cct(Kelvin(kelvin)) if kelvin < DAYLIGHT_FROM => {
                planck(RADIATION_NM_KELVIN / kelvin)
            }
            Self::Cct(Kelvin(kelvin)) => daylight(kelvin),
        }
    }
}

fn tabulated(text: &str) -> Spectrum {
    // The tables are part of the program; the tests of this file read both.
    let percent = Spectrum::from_csv(text, "illuminant").expect("the table in data/ is complete");
    Spectrum(percent.values().map(|value| value / 100.0))
}

/// Planck's law relative to its value at 560 nm; `scale_nm` is c2 / temperature.
fn planck(scale_nm: f64) -> Spectrum {
    let photon = |nm: f64| exp(scale_nm / nm) - 1.0;
    let reference = photon(REFERENCE_NM);
    Spectrum::from_fn(|nm| {
        let ratio = REFERENCE_NM / nm;
        ratio * ratio * ratio * ratio * ratio * reference / photon(nm)
    })
}

/// S0, S1 and S2 of CIE 015.
static DAYLIGHT_COMPONENTS: LazyLock<[[f64; SAMPLES]; 3]> = LazyLock::new(|| {
    // The table is part of the program; the tests of this file read it.
    let rows = rows::<4>(include_str!("../../../data/cie_daylight_components.csv"), "daylight")
        .expect("the table in data/ is well formed");
    std::array::from_fn(|component| std::array::from_fn(|i| rows[i].cells[component + 1]))
});

/// Daylight of a correlated colour temperature, 4000 to 25000 K (CIE 015, 4.1.2).
///
/// The factors of S1 and S2 are not rounded to three decimals, as the CIE did for its tables, so
/// that the spectrum changes smoothly with temperature **(ours)**.
fn daylight(kelvin: f64) -> Spectrum {
    let t = 1000.0 / kelvin;
    let x = if kelvin <= 7000.0 {
        0.244_063 + t * (0.099_11 + t * (2.967_8 - t * 4.607_0))
    } else {
        0.237_040 + t * (0.247_48 + t * (1.901_8 - t * 2.006_4))
    };
    let y = -0.275 + x * (2.870 - x * 3.000);
    let divisor = 0.024_1 + 0.256_2 * x - 0.734_1 * y;
    let factor_1 = (-1.351_5 - 1.770_3 * x + 5.911_4 * y) / divisor;
    let factor_2 = (0.030_0 - 31.442_4 * x + 30.071_7 * y) / divisor;
    let [s0, s1, s2] = &*DAYLIGHT_COMPONENTS;
    Spectrum(std::array::from_fn(|index| {
        (s0[index] + factor_1 * s1[index] + factor_2 * s2[index]) / 100.0
    }))
}

impl FromStr for Illuminant {
    type Err = ColourError;

    fn from_str(name: &str) -> Result<Self, ColourError> {
        match name {
            "A" => return Ok(Self::A),
            "D50" => return Ok(Self::D50),
            "D65" => return Ok(Self::D65),
            "E" => return Ok(Self::E),
            _ => {}
        }
        if let Some(lamp) = Lamp::named(name) {
            return Ok(Self::Lamp(lamp));
        }
        match name.strip_suffix('K').map(|number| number.trim_end().parse()) {
            Some(Ok(kelvin)) => Ok(Self::Cct(Kelvin::new(kelvin)?)),
            _ => Err(ColourError::Name {
                quantity: "illuminant",
                value: name.chars().take(24).collect(),
                allowed: "A, C, D50, D55, D65, D75, E, FL1 to FL12, LED-B1 to LED-B5, LED-BH1, LED-RGB1, \
                          LED-V1, LED-V2, or a colour temperature such as 5500K (1000K to 25000K)",
            }),
        }
    }
}

impl fmt::Display for Illuminant {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::A => formatter.write_str("A"),
            Self::D50 => formatter.write_str("D50"),
            Self::D65 => formatter.write_str("D65"),
            Self::E => formatter.write_str("E"),
            Self::Lamp(lamp) => formatter.write_str(lamp.name()),
            Self::Cct(Kelvin(kelvin)) => write!(formatter, "{kelvin}K"),
        }
    }
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exact where nothing is computed")]
mod tests {
    use proptest::prelude::*;

    use super::*;
    use crate::{Observer, WAVELENGTH_NM, xyz};

    #[test]
    fn tables_stand_on_the_working_grid() {
        let text = include_str!("../../../data/cie_daylight_components.csv");
        let wavelengths: Vec<f64> =
            rows::<4>(text, "daylight").unwrap().iter().map(|row| row.cells[0]).collect();
        assert_eq!(wavelengths, WAVELENGTH_NM);
        for illuminant in [Illuminant::D50, Illuminant::D65] {
            assert_eq!(illuminant.spectrum().values()[560 - 380], 1.0);
        }
    }

    #[test]
    fn illuminant_a_has_its_published_values() {
        // ISO/CIE 11664-2, table 1, relative to 100 at 560 nm.
        let values = *Illuminant::A.spectrum().values();
        for (nm, published) in [(380, 9.7951), (450, 33.0859), (650, 165.028), (780, 241.675)] {
            assert!((100.0 * values[nm - 380] - published).abs() < 5e-4, "{nm} nm");
        }
    }

    #[test]
    fn daylight_of_6504_kelvin_is_d65() {
        let daylight = Illuminant::Cct(Kelvin(6504.0)).spectrum();
        for (made, table) in daylight.values().iter().zip(Illuminant::D65.spectrum().values()) {
            assert!((made - table).abs() < 1e-3);
        }
    }

    proptest! {
        #[test]
        fn hotter_light_is_bluer_on_either_locus(
            body in 1000.0..3900.0_f64,
            sky in 4000.0..24000.0_f64,
        ) {
            let blueness = |kelvin| {
                let [x, _, z] = xyz(&Illuminant::Cct(Kelvin(kelvin)).spectrum(), Observer::Cie1931);
                z / x
            };
            for kelvin in [body, sky] {
                prop_assert!(blueness(kelvin * 1.02) > blueness(kelvin));
            }
        }

        #[test]
        fn wien_gives_the_peak_of_planck(kelvin in 3750.0..7500.0_f64) {
            let spectrum = planck(RADIATION_NM_KELVIN / kelvin);
            let peak = (0..SAMPLES)
                .max_by(|&a, &b| spectrum.values()[a].total_cmp(&spectrum.values()[b]))
                .unwrap();
            let wien_nm = RADIATION_NM_KELVIN / 4.965_114_231_744_276 / kelvin;
            prop_assert!((WAVELENGTH_NM[peak] - wien_nm.clamp(380.0, 780.0)).abs() <= 0.51);
        }

        #[test]
        fn names_are_read_as_written(kelvin in 1000.0..25000.0) {
            let illuminant = Illuminant::Cct(Kelvin(kelvin));
            prop_assert_eq!(illuminant.to_string().parse(), Ok(illuminant));
        }
    }

    #[test]
    fn unknown_lights_are_refused_with_the_names_that_exist() {
        let error = |name: &str| name.parse::<Illuminant>().unwrap_err().to_string();
        assert_eq!(
            error("F13"),
            "illuminant is \"F13\"; allowed: A, C, D50, D55, D65, D75, E, FL1 to FL12, LED-B1 to LED-B5, \
             LED-BH1, LED-RGB1, LED-V1, LED-V2, or a colour temperature such as 5500K (1000K to 25000K)"
        );
        assert_eq!(error("500K"), "colour temperature is 500.0 K; allowed: 1000 to 25000 K");
        assert_eq!(error("nanK"), "colour temperature is NaN K; allowed: 1000 to 25000 K");
    }
}
