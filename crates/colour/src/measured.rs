//! A spectrum as instruments write it: two columns among other lines, in any language's decimals.

use crate::spectrum::{FIRST_NM, LAST_NM, SAMPLES, WAVELENGTH_NM};
use crate::{
    ColourError,
    rows::{Sample, samples},
};

/// Larger numbers than this are no light, and their powers might leave the range of `f64`.
pub(crate) const LARGEST: f64 = 1e12;
/// Noise around zero, as a share of the largest value, counts as zero **(ours)**.
const NOISE: f64 = 0.05;
/// What a measurement must cover. Beyond its ends the nearest value stands, as CIE 015 (7.2.3)
/// allows; many instruments measure 400 to 700 nm.
const NEEDED_NM: [f64; 2] = [400.0, 700.0];
/// Samples closer than this are averaged, not picked.
const FINE_NM: f64 = 0.9;

/// The values at 380 to 780 nm by 1 nm; what `Spectrum::from_csv` promises.
pub(crate) fn values(text: &str, place: &str) -> Result<[f64; SAMPLES], ColourError> {
    let mut samples = samples(text, place)?;
    if let [first, .., last] = &samples[..]
        && first.nm > last.nm
    {
        check_order(&samples, place, "below", |before, after| after < before)?;
        samples.reverse();
    } else {
        check_order(&samples, place, "above", |before, after| after > before)?;
    }
    check_range(&samples, place)?;
    quieten(&mut samples, place)?;
    Ok(resampled(&samples))
}

fn check_order(
    samples: &[Sample],
    place: &str,
    side: &str,
    goes_on: fn(f64, f64) -> bool,
) -> Result<(), ColourError> {
    let Some(pair) = samples.windows(2).find(|pair| !goes_on(pair[0].nm, pair[1].nm)) else {
        return Ok(());
    };
    let (before, after) = (pair[0].nm, pair[1].nm);
    let problem = format!("wavelength_nm is {after:?}; allowed: {side} {before:?}, the last");
    Err(ColourError::Line { place: place.to_owned(), line: pair[1].line, problem })
}

/// A wavelength of another unit in nm.
type ToNm = fn(f64) -> f64;

/// The unit in which a range that is none in nm would hold most of what the eye sees.
fn other_unit(from: f64, to: f64) -> Option<&'static str> {
    let seen = |ends: [f64; 2]| ends[0].min(ends[1]) <= 450.0 && ends[0].max(ends[1]) >= 650.0;
    let units: [(&str, ToNm); 4] = [
        ("um", |um| 1e3 * um),
        ("angstrom", |angstrom| 0.1 * angstrom),
        ("1/cm, a wavenumber", |per_cm| 1e7 / per_cm),
        ("eV, an energy", |ev| 1239.84 / ev), // h c / e in nm
    ];
    if seen([from, to]) {
        return None;
    }
    let found = units.iter().find(|(_, nm)| seen([nm(from), nm(to)])).map(|(unit, _)| *unit);
    found.or((to < 20.0).then_some("um"))
}

fn check_range(samples: &[Sample], place: &str) -> Result<(), ColourError> {
    let [from_nm, to_nm] = [samples[0].nm, samples[samples.len() - 1].nm];
    let range = format!("wavelength_nm is {from_nm:?} to {to_nm:?}");
    let problem = if let Some(unit) = other_unit(from_nm, to_nm) {
        format!("{range}; allowed: nm, not {unit}")
    } else {
        let mut missing = Vec::new();
        if from_nm > NEEDED_NM[0] {
            missing.push(format!("{:?} to {from_nm:?} nm", NEEDED_NM[0]));
        }
        if to_nm < NEEDED_NM[1] {
            missing.push(format!("{to_nm:?} to {:?} nm", NEEDED_NM[1]));
        }
        if missing.is_empty() {
            return Ok(());
        }
        format!("{range}; missing: {}", missing.join(" and "))
    };
    Err(ColourError::Table { place: place.to_owned(), problem })
}

/// Puts noise below zero to zero.
fn quieten(samples: &mut [Sample], place: &str) -> Result<(), ColourError> {
    let seen = |sample: &&Sample| (FIRST_NM..=LAST_NM).contains(&sample.nm);
    let most = samples.iter().filter(seen).map(|sample| sample.value).fold(0.0, f64::max);
    let least = -NOISE * most;
    for Sample { line, nm, value } in samples {
        if !(FIRST_NM - 1.0..=LAST_NM + 1.0).contains(nm) && *value < 0.0 {
            *value = 0.0; // of no consequence: what detectors say where they see nothing
        }
        if !(least..=LARGEST).contains(value) {
            let allowed = if most > 0.0 && *value < 0.0 {
                format!("0 to 1e12 (noise down to {least:?} counts as 0)")
            } else {
                "0 to 1e12".to_owned()
            };
            let problem = format!("value is {value:?}; allowed: {allowed}");
            return Err(ColourError::Line { place: place.to_owned(), line: *line, problem });
        }
        *value = value.max(0.0);
    }
    Ok(())
}

/// Straight lines between samples; where those around are finer than 1 nm, the mean over the nm around.
fn resampled(samples: &[Sample]) -> [f64; SAMPLES] {
    let mut until = vec![0.0];
    for pair in samples.windows(2) {
        let area = 0.5 * (pair[1].nm - pair[0].nm) * (pair[0].value + pair[1].value);
        until.push(until[until.len() - 1] + area);
    }
    let area_until = |nm: f64| {
        let below = samples.partition_point(|sample| sample.nm < nm).saturating_sub(1);
        let from = &samples[below];
        until[below] + 0.5 * (nm - from.nm) * (from.value + at(samples, nm))
    };
    WAVELENGTH_NM.map(|nm| {
        if is_fine(samples, nm) {
            (area_until(nm + 0.5) - area_until(nm - 0.5)).max(0.0)
        } else {
            at(samples, nm)
        }
    })
}

/// Whether any samples in the nm around lie closer than 1 nm, wherever the file is coarser.
fn is_fine(samples: &[Sample], nm: f64) -> bool {
    let from = samples.partition_point(|sample| sample.nm <= nm - 0.5).saturating_sub(1);
    let to = samples.partition_point(|sample| sample.nm < nm + 0.5);
    let around = &samples[from..samples.len().min(to + 1)];
    around.windows(2).any(|pair| pair[1].nm - pair[0].nm < FINE_NM)
}

/// The value on the straight line between neighbours, beyond the ends the nearest.
fn at(samples: &[Sample], nm: f64) -> f64 {
    let above = samples.partition_point(|sample| sample.nm < nm);
    if above == 0 {
        return samples[0].value;
    }
    let from = &samples[above - 1];
    let Some(to) = samples.get(above) else { return from.value };
    from.value + (to.value - from.value) * (nm - from.nm) / (to.nm - from.nm)
}

#[cfg(test)]
#[expect(clippy::float_cmp, reason = "exact where nothing is computed")]
mod tests {
    use super::*;

    fn problem(text: &str) -> String {
        values(text, "lamp.csv").unwrap_err().to_string()
    }

    /// 380 to 780 nm by 10, a ramp of 0.05 a step with a decimal comma where asked.
    fn ramp(separator: &str, decimal: char) -> String {
        let line = |i: i32| {
            let value = format!("{:.2}", 0.05 * f64::from(i)).replace('.', &decimal.to_string());
            format!("{}{decimal}0{separator}{value}", 380 + 10 * i)
        };
        (0..=40).map(line).collect::<Vec<_>>().join("\n")
    }

    #[test]
    fn every_separator_and_decimal_sign_says_the_same() {
        let expected = values(&ramp(",", '.'), "ramp.csv").unwrap();
        assert!((expected[5] - 0.025).abs() < 1e-15);
        for (separator, decimal) in
            [(";", ','), (";", '.'), ("\t", ','), ("\t", '.'), (" ", ','), ("  ", '.'), (", ", '.')]
        {
            let text = ramp(separator, decimal);
            assert_eq!(values(&text, "ramp.csv").unwrap(), expected, "{text}");
            assert_eq!(values(&text.replace('\n', ";\r\n"), "r").is_ok(), separator == ";");
        }
        let quoted = ramp("\",\"", ',').replace('\n', "\"\n\"");
        assert_eq!(values(&format!("\"{quoted}\""), "ramp.csv").unwrap(), expected);
    }

    #[test]
    fn descending_wavelengths_are_turned_and_words_around_are_passed() {
        let text = ramp(";", ',');
        let expected = values(&text, "ramp.csv").unwrap();
        let turned: Vec<&str> = text.lines().rev().collect();
        let head = "sep=;\nSpectrometer: B-17\nIntegration time [ms];100\n2048 pixels in file\n\n\
                    Wavelength [nm];Reflectance\n>>>>>Begin<<<<<\n";
        let text = format!("{head}{}\n>>>>>End<<<<<\n", turned.join("\n"));
        assert_eq!(values(&text, "ramp.csv").unwrap(), expected);
    }

    #[test]
    fn fine_steps_are_averaged_over_the_nm_around_and_nothing_is_lost() {
        // One line of 0.2 nm: picked at whole nm it would be missed, or count as 1 nm.
        let line = |i: i32| {
            let nm = 380.0 + 0.1 * f64::from(i);
            format!("{nm:.1}\t{}", if i == 1204 { 5.0 } else { 0.0 })
        };
        let text = (0..=4000).map(line).collect::<Vec<_>>().join("\n");
        let spectrum = values(&text, "line.csv").unwrap();
        assert!((spectrum.iter().sum::<f64>() - 0.5).abs() < 1e-9);
        assert!((spectrum[120] - 0.5).abs() < 1e-9);
        let constant = (0..=4000).map(|i| format!("{:.1};7\n", 380.0 + 0.1 * f64::from(i)));
        let constant = values(&constant.collect::<String>(), "7.csv").unwrap();
        assert!(constant.iter().all(|value| (value - 7.0).abs() < 1e-9));
    }

    #[test]
    fn fineness_counts_where_it_is_and_not_in_the_mean_of_the_file() {
        // By 0.5 nm, then by 5 far into the infrared, as spectrometers of two detectors write.
        let fine = (0..=1200).map(|i| 200.0 + 0.5 * f64::from(i));
        let coarse = (1..=340).map(|i| 800.0 + 5.0 * f64::from(i));
        let value = |nm: f64| if nm == 546.5 { 5.0 } else { 0.0 };
        let lines = fine.chain(coarse).map(|nm| format!("{nm:.1};{}\n", value(nm)));
        let spectrum = values(&lines.collect::<String>(), "wide.csv").unwrap();
        assert!((spectrum.iter().sum::<f64>() - 2.5).abs() < 1e-9);
        // A fine part does not blur what is coarse elsewhere.
        let spectrum = values("380;0\n400;0\n401;8\n402;0\n500;0\n500.5;0\n700;0", "k.csv");
        assert_eq!(spectrum.unwrap()[21], 8.0);
    }

    #[test]
    fn beyond_400_to_700_nm_the_nearest_value_stands() {
        let spectrum = values("400;2\n700;5", "short.csv").unwrap();
        assert_eq!((spectrum[0], spectrum[20], spectrum[320], spectrum[400]), (2.0, 2.0, 5.0, 5.0));
        assert_eq!(
            problem("410,1\n690,1"),
            "lamp.csv: wavelength_nm is 410.0 to 690.0; missing: 400.0 to 410.0 nm and 690.0 to 700.0 nm"
        );
        assert_eq!(
            problem("0.38,1\n0.78,1"),
            "lamp.csv: wavelength_nm is 0.38 to 0.78; allowed: nm, not um"
        );
    }

    #[test]
    fn a_range_that_would_be_visible_in_another_unit_is_told_by_that_unit() {
        for (text, unit) in [
            ("3800,1\n7800,1", "angstrom"),
            ("7800,1\n3800,1", "angstrom"),
            ("12820.5,1\n26315.8,1", "1/cm, a wavenumber"),
            ("1.59,1\n3.26,1", "eV, an energy"),
            ("0.3,1\n2.5,1", "um"),
            ("2.5,1\n16,1", "um"),
        ] {
            let message = problem(text);
            assert!(message.ends_with(&format!("allowed: nm, not {unit}")), "{message}");
        }
        assert!(problem("900,1\n2500,1").contains("missing: 400.0 to 900.0 nm"));
    }

    #[test]
    fn noise_below_zero_is_zero_and_more_than_noise_is_refused() {
        let spectrum = values("200,-9\n380,-0.04\n500,1\n780,-0.01", "noise.csv").unwrap();
        assert_eq!((spectrum[0], spectrum[120], spectrum[400]), (0.0, 1.0, 0.0));
        assert_eq!(
            problem("380,-0.06\n500,1\n780,1"),
            "lamp.csv, line 1: value is -0.06; allowed: 0 to 1e12 (noise down to -0.05 counts as 0)"
        );
    }

    #[test]
    fn every_refusal_names_file_line_and_value() {
        assert_eq!(
            problem("380;1;2\n381;1;2"),
            "lamp.csv, line 1: 3 columns; allowed: 2, wavelength and value"
        );
        assert_eq!(
            problem("380,1\n381,dark"),
            "lamp.csv, line 2: a cell is \"dark\"; allowed: a finite number"
        );
        assert_eq!(
            problem("380,1\npause\n381,1"),
            "lamp.csv, line 2: a cell is \"pause\"; allowed: a finite number"
        );
        assert_eq!(
            problem("a,b\nc,d"),
            "lamp.csv: 0 rows of numbers, and line 1 has \"a\"; allowed: at least 2 of numbers alone"
        );
        assert_eq!(
            problem("780,1\n500,1\n500,1\n380,1"),
            "lamp.csv, line 3: wavelength_nm is 500.0; allowed: below 500.0, the last"
        );
    }
}
