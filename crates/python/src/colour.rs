//! The bindings of colour: arrays `[..., 3]` and `[..., 401]` in, the same shapes out.
#![expect(clippy::needless_pass_by_value, reason = "Python hands its arguments over by value")]

use std::ops::RangeInclusive;

use nacreous_colour::{
    self as colour, ColourError, Gamut, Hvc, Illuminant, Observer, RgbSpace, SAMPLES, Spectrum,
    matrix,
};
use numpy::{
    PyArray1, PyArrayDyn, PyArrayMethods, PyReadonlyArray1, PyReadonlyArrayDyn,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::InputError;

/// What numbers an array may hold. Larger ones are no colours, and their powers might leave the range
/// of `f64`.
struct Allowed {
    range: RangeInclusive<f64>,
    text: &'static str,
}

const ANY: Allowed = Allowed { range: -1e12..=1e12, text: "-1e12 to 1e12" };
const NOT_NEGATIVE: Allowed = Allowed { range: 0.0..=1e12, text: "0 to 1e12" };
const WHITE: Allowed = Allowed { range: 1e-6..=1e12, text: "1e-6 to 1e12 each" };

type Colours<'py> = Bound<'py, PyArrayDyn<f64>>;

fn refused(error: ColourError) -> PyErr {
    InputError::new_err(error.to_string())
}

/// The numbers of an array whose last axis has `COUNT` entries: `[..., COUNT]`.
fn rows<const COUNT: usize>(
    quantity: &str,
    array: &PyReadonlyArrayDyn<'_, f64>,
    allowed: &Allowed,
) -> PyResult<Vec<[f64; COUNT]>> {
    let shape = array.shape();
    if shape.last() != Some(&COUNT) {
        return Err(InputError::new_err(format!(
            "{quantity} has shape {shape:?}; allowed: [..., {COUNT}]"
        )));
    }
    let values = array
        .as_slice()
        .map_err(|_| InputError::new_err(format!("{quantity} is not contiguous in memory")))?;
    if let Some(at) = values.iter().position(|value| !allowed.range.contains(value)) {
        return Err(InputError::new_err(format!(
            "{quantity}{:?} is {:?}; allowed: {}",
            place(at, shape),
            values[at],
            allowed.text
        )));
    }
    // The length is a multiple of COUNT, the last axis.
    Ok(values.chunks_exact(COUNT).map(|row| std::array::from_fn(|entry| row[entry])).collect())
}

/// The index of a number in an array of that shape.
fn place(mut flat: usize, shape: &[usize]) -> Vec<usize> {
    let mut index: Vec<usize> = shape
        .iter()
        .rev()
        .map(|&length| {
            let entry = flat % length;
            flat /= length;
            entry
        })
        .collect();
    index.reverse();
    index
}

fn triples(quantity: &str, array: &PyReadonlyArrayDyn<'_, f64>) -> PyResult<Vec<[f64; 3]>> {
    rows(quantity, array, &ANY)
}

/// Colours of the same shape as `like`, but for the last axis, which is the colour.
fn colours<'py>(
    py: Python<'py>,
    like: &PyReadonlyArrayDyn<'py, f64>,
    colours: &[[f64; 3]],
) -> PyResult<Colours<'py>> {
    let mut shape = like.shape().to_vec();
    if let Some(last) = shape.last_mut() {
        *last = 3;
    }
    PyArray1::from_slice(py, colours.as_flattened()).reshape(shape)
}

/// Each colour of an array by itself.
fn each<'py>(
    py: Python<'py>,
    quantity: &str,
    array: &PyReadonlyArrayDyn<'py, f64>,
    convert: impl Fn([f64; 3]) -> [f64; 3] + Sync,
) -> PyResult<Colours<'py>> {
    let mut values = triples(quantity, array)?;
    py.detach(|| values.iter_mut().for_each(|colour| *colour = convert(*colour)));
    colours(py, array, &values)
}

/// A white whose components can be divided by.
fn white(quantity: &str, array: [f64; 3]) -> PyResult<[f64; 3]> {
    if array.iter().all(|component| WHITE.range.contains(component)) {
        Ok(array)
    } else {
        Err(InputError::new_err(format!("{quantity} is {array:?}; allowed: {}", WHITE.text)))
    }
}

fn spectrum(values: &PyReadonlyArray1<'_, f64>) -> PyResult<Spectrum> {
    let values = values
        .as_slice()
        .map_err(|_| InputError::new_err("spectrum is not contiguous in memory"))?;
    Spectrum::from_values(values).map_err(refused)
}

/// The colours of an array of hue, value and chroma.
fn hvcs(array: &PyReadonlyArrayDyn<'_, f64>) -> PyResult<Vec<Hvc>> {
    let triples = triples("hvc", array)?;
    if let Some(at) = triples.iter().position(|hvc| hvc[2] < 0.0) {
        return Err(InputError::new_err(format!(
            "hvc{:?} (chroma) is {:?}; allowed: 0 or more",
            place(3 * at + 2, array.shape()),
            triples[at][2]
        )));
    }
    Ok(triples.into_iter().map(|[hue_rad, value, chroma]| Hvc { hue_rad, value, chroma }).collect())
}

fn each_hvc<'py>(
    py: Python<'py>,
    array: &PyReadonlyArrayDyn<'py, f64>,
    convert: fn(Hvc) -> [f64; 3],
) -> PyResult<Colours<'py>> {
    let hvcs = hvcs(array)?;
    let converted: Vec<[f64; 3]> = py.detach(|| hvcs.into_iter().map(convert).collect());
    colours(py, array, &converted)
}

fn triple_from_hvc(Hvc { hue_rad, value, chroma }: Hvc) -> [f64; 3] {
    [hue_rad, value, chroma]
}

/// 380 to 780 nm by 1 nm.
#[pyfunction]
pub fn spectrum_wavelength_nm(py: Python<'_>) -> Bound<'_, PyArray1<f64>> {
    PyArray1::from_slice(py, colour::WAVELENGTH_NM.as_slice())
}

/// The relative spectrum of an illuminant, by name.
#[pyfunction]
pub fn illuminant_spectrum<'py>(
    py: Python<'py>,
    name: &str,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let illuminant: Illuminant = name.parse().map_err(refused)?;
    Ok(PyArray1::from_slice(py, illuminant.spectrum().values()))
}

/// The spectrum in the text of a table; `place` is what messages call it.
#[pyfunction]
pub fn spectrum_from_csv<'py>(
    py: Python<'py>,
    text: &str,
    place: &str,
) -> PyResult<Bound<'py, PyArray1<f64>>> {
    let spectrum = Spectrum::from_csv(text, place).map_err(refused)?;
    Ok(PyArray1::from_slice(py, spectrum.values()))
}

/// XYZ of spectra under an illuminant, Y = 1 for the perfect diffuser.
#[pyfunction]
pub fn xyz_from_spectrum<'py>(
    py: Python<'py>,
    spectra: PyReadonlyArrayDyn<'py, f64>,
    illuminant: PyReadonlyArray1<'py, f64>,
    observer: &str,
) -> PyResult<Colours<'py>> {
    let observer: Observer = observer.parse().map_err(refused)?;
    let weights = observer.weights(&spectrum(&illuminant)?).map_err(refused)?;
    let values = rows::<SAMPLES>("spectra", &spectra, &NOT_NEGATIVE)?;
    let xyz: Vec<[f64; 3]> =
        py.detach(|| values.iter().map(|row| colour::xyz_from_spectrum(&weights, row)).collect());
    colours(py, &spectra, &xyz)
}

/// L*, a*, b* of XYZ, relative to a white.
#[pyfunction]
pub fn lab_from_xyz<'py>(
    py: Python<'py>,
    xyz: PyReadonlyArrayDyn<'py, f64>,
    white_xyz: [f64; 3],
) -> PyResult<Colours<'py>> {
    let white = white("white", white_xyz)?;
    each(py, "xyz", &xyz, |xyz| colour::lab_from_xyz(xyz, white))
}

/// XYZ of L*, a*, b*, relative to a white.
#[pyfunction]
pub fn xyz_from_lab<'py>(
    py: Python<'py>,
    lab: PyReadonlyArrayDyn<'py, f64>,
    white_xyz: [f64; 3],
) -> PyResult<Colours<'py>> {
    let white = white("white", white_xyz)?;
    each(py, "lab", &lab, |lab| colour::xyz_from_lab(lab, white))
}

/// CIEDE2000 difference of two equally long lists of colours.
#[pyfunction]
pub fn delta_e_2000<'py>(
    py: Python<'py>,
    first: PyReadonlyArrayDyn<'py, f64>,
    second: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    if first.shape() != second.shape() {
        return Err(InputError::new_err(format!(
            "second has shape {:?}; allowed: that of first, {:?}",
            second.shape(),
            first.shape()
        )));
    }
    let pairs = (triples("first", &first)?, triples("second", &second)?);
    let difference: Vec<f64> = py.detach(|| {
        pairs.0.into_iter().zip(pairs.1).map(|(a, b)| colour::delta_e_2000(a, b)).collect()
    });
    // `triples` has seen a last axis.
    PyArray1::from_vec(py, difference).reshape(first.shape()[..first.ndim() - 1].to_vec())
}

/// Linear RGB of XYZ relative to D65.
#[pyfunction]
pub fn rgb_from_xyz<'py>(
    py: Python<'py>,
    xyz: PyReadonlyArrayDyn<'py, f64>,
    space: &str,
) -> PyResult<Colours<'py>> {
    let space: RgbSpace = space.parse().map_err(refused)?;
    each(py, "xyz", &xyz, |xyz| space.rgb_from_xyz(xyz))
}

/// XYZ relative to D65 of linear RGB.
#[pyfunction]
pub fn xyz_from_rgb<'py>(
    py: Python<'py>,
    rgb: PyReadonlyArrayDyn<'py, f64>,
    space: &str,
) -> PyResult<Colours<'py>> {
    let space: RgbSpace = space.parse().map_err(refused)?;
    each(py, "rgb", &rgb, |rgb| space.xyz_from_rgb(rgb))
}

/// Code values of linear RGB.
#[pyfunction]
pub fn encode_rgb<'py>(
    py: Python<'py>,
    rgb: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    each(py, "rgb", &rgb, |rgb| rgb.map(colour::encode))
}

/// Linear RGB of code values.
#[pyfunction]
pub fn decode_rgb<'py>(
    py: Python<'py>,
    encoded: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    each(py, "encoded", &encoded, |encoded| encoded.map(colour::decode))
}

/// XYZ as they look under another white.
#[pyfunction]
pub fn adapt_xyz<'py>(
    py: Python<'py>,
    xyz: PyReadonlyArrayDyn<'py, f64>,
    from_white: [f64; 3],
    to_white: [f64; 3],
) -> PyResult<Colours<'py>> {
    let whites = (white("from_white", from_white)?, white("to_white", to_white)?);
    let adaptation = colour::adaptation(whites.0, whites.1).map_err(refused)?;
    each(py, "xyz", &xyz, |xyz| matrix::apply(&adaptation, xyz))
}

/// Linear RGB within 0..1.
#[pyfunction]
pub fn map_to_gamut<'py>(
    py: Python<'py>,
    rgb: PyReadonlyArrayDyn<'py, f64>,
    method: &str,
    space: &str,
) -> PyResult<Colours<'py>> {
    let gamut: Gamut = method.parse().map_err(refused)?;
    let space: RgbSpace = space.parse().map_err(refused)?;
    each(py, "rgb", &rgb, |rgb| gamut.map(space, rgb))
}

/// The share of colours outside 0..1.
#[pyfunction]
pub fn out_of_gamut_share(rgb: PyReadonlyArrayDyn<'_, f64>) -> PyResult<f64> {
    Ok(colour::out_of_gamut_share(triples("rgb", &rgb)?))
}

/// Hue in radians, value and chroma of linear sRGB.
#[pyfunction]
pub fn hvc_from_rgb<'py>(
    py: Python<'py>,
    rgb: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    each(py, "rgb", &rgb, |rgb| triple_from_hvc(colour::hvc_from_rgb(rgb)))
}

/// Linear sRGB of hue in radians, value and chroma.
#[pyfunction]
pub fn rgb_from_hvc<'py>(
    py: Python<'py>,
    hvc: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    each_hvc(py, &hvc, colour::rgb_from_hvc)
}

/// Hue in radians, value and chroma of XYZ under illuminant C.
#[pyfunction]
pub fn hvc_from_xyz<'py>(
    py: Python<'py>,
    xyz: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    each(py, "xyz", &xyz, |xyz| triple_from_hvc(colour::hvc_from_xyz(xyz)))
}

/// XYZ under illuminant C of hue in radians, value and chroma.
#[pyfunction]
pub fn xyz_from_hvc<'py>(
    py: Python<'py>,
    hvc: PyReadonlyArrayDyn<'py, f64>,
) -> PyResult<Colours<'py>> {
    each_hvc(py, &hvc, colour::xyz_from_hvc)
}

/// Munsell notation of each colour, as a flat list.
#[pyfunction]
pub fn munsell_notation(hvc: PyReadonlyArrayDyn<'_, f64>) -> PyResult<Vec<String>> {
    Ok(hvcs(&hvc)?.iter().map(Hvc::notation).collect())
}
