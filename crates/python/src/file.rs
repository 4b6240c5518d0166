//! The bindings of picture files.

use std::fs::File;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use nacreous_colour::RgbSpace;
use nacreous_file::exr::{self, Channels, Plane};
use nacreous_file::panorama;
use nacreous_file::photograph;
use nacreous_file::picture::{LinearPicture, PictureFileError};
use nacreous_file::png::{self, PngPixels};
use numpy::ndarray::{Array3, ArrayView3, CowArray, Ix3};
use numpy::{IntoPyArray, PyArray3, PyReadonlyArray3, PyUntypedArray, PyUntypedArrayMethods};
use pyo3::exceptions::PyOSError;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

use crate::InputError;

pub type Text = Vec<(String, String)>;

/// Writes integer pixels [row, column, rgb or rgba], uint8 or uint16, as a PNG; space is "srgb" or
/// "display-p3". Raises `OSError` where the system refuses, for nacreous.file to translate.
#[pyfunction]
pub fn write_png(
    py: Python<'_>,
    path: PathBuf,
    pixels: &Bound<'_, PyAny>,
    space: &str,
    text: Text,
) -> PyResult<()> {
    with_pixels(py, pixels, space, |size, pixels, space| {
        save_png(&path, size, pixels, space, &text)
    })
}

/// The bytes of such a PNG.
#[pyfunction]
pub fn png_bytes<'py>(
    py: Python<'py>,
    pixels: &Bound<'py, PyAny>,
    space: &str,
    text: Text,
) -> PyResult<Bound<'py, PyBytes>> {
    let file = with_pixels(py, pixels, space, |(width, height), pixels, space| {
        let mut file = Vec::new();
        png::write_png(&mut file, width, height, pixels, space, &text).map_err(raised)?;
        Ok(file)
    })?;
    Ok(PyBytes::new(py, &file))
}

/// Does something with integer pixels of (width, height), without Python.
fn with_pixels<T: Send>(
    py: Python<'_>,
    pixels: &Bound<'_, PyAny>,
    space: &str,
    work: impl FnOnce((u32, u32), PngPixels<'_>, RgbSpace) -> PyResult<T> + Send,
) -> PyResult<T> {
    let space: RgbSpace = space.parse().map_err(crate::refused)?;
    if let Ok(array) = pixels.extract::<PyReadonlyArray3<'_, u8>>() {
        let (size, samples) = (picture_size(array.shape())?, in_order(array.as_array()));
        return py.detach(|| work(size, PngPixels::Eight(slice(&samples)), space));
    }
    if let Ok(array) = pixels.extract::<PyReadonlyArray3<'_, u16>>() {
        let (size, samples) = (picture_size(array.shape())?, in_order(array.as_array()));
        return py.detach(|| work(size, PngPixels::Sixteen(slice(&samples)), space));
    }
    let given = describe(pixels);
    let message = format!("pixels are {given}; allowed: uint8 or uint16 [row, column, 3 or 4]");
    Err(InputError::new_err(message))
}

/// Writes integer pixels of (width, height) as a PNG.
pub fn save_png(
    path: &Path,
    (width, height): (u32, u32),
    pixels: PngPixels<'_>,
    space: RgbSpace,
    text: &Text,
) -> PyResult<()> {
    let mut out = BufWriter::new(File::create(path).map_err(refused)?);
    png::write_png(&mut out, width, height, pixels, space, text).map_err(raised)?;
    out.flush().map_err(refused)
}

/// Writes float32 planes [row, column, channel] of 1, 3 or 4 channels as an EXR; the picture
/// itself is named "". Raises `OSError` where the system refuses.
#[pyfunction]
pub fn write_exr(
    py: Python<'_>,
    path: PathBuf,
    planes: Vec<(String, Bound<'_, PyAny>)>,
    text: Text,
) -> PyResult<()> {
    let (arrays, (height, width)) = float_planes(planes)?;
    let planes: Vec<(String, Channels, CowArray<'_, f32, Ix3>)> = arrays
        .iter()
        .map(|(name, channels, plane)| (name.clone(), *channels, in_order(plane.as_array())))
        .collect();
    py.detach(|| {
        let planes: Vec<Plane<'_>> = planes
            .iter()
            .map(|(name, channels, samples)| Plane {
                name: name.clone(),
                channels: *channels,
                samples: slice(samples).into(),
            })
            .collect();
        save_exr(&path, (width, height), &planes, &text)
    })
}

/// Writes planes of (width, height) as an EXR.
pub fn save_exr(
    path: &Path,
    (width, height): (usize, usize),
    planes: &[Plane<'_>],
    text: &Text,
) -> PyResult<()> {
    let mut out = BufWriter::new(File::create(path).map_err(refused)?);
    exr::write_exr(&mut out, width, height, planes, text).map_err(raised)?;
    out.flush().map_err(refused)
}

type FloatPlane<'py> = (String, Channels, PyReadonlyArray3<'py, f32>);

/// The planes as arrays, and their common (height, width).
fn float_planes<'py>(
    planes: Vec<(String, Bound<'py, PyAny>)>,
) -> PyResult<(Vec<FloatPlane<'py>>, (usize, usize))> {
    let mut arrays: Vec<FloatPlane<'py>> = Vec::new();
    let mut common = (0, 0);
    for (name, array) in planes {
        let plane = array.extract::<PyReadonlyArray3<'py, f32>>().ok().and_then(|found| {
            Channels::of_count(found.shape()[2]).map(|channels| (channels, found))
        });
        let Some((channels, plane)) = plane else {
            let given = describe(&array);
            let allowed = "float32 [row, column, channel] with 1, 3 or 4 channels";
            let message = format!("layer {name:?} is {given}; allowed: {allowed}");
            return Err(InputError::new_err(message));
        };
        let (rows, columns) = (plane.shape()[0], plane.shape()[1]);
        if arrays.is_empty() {
            common = (rows, columns);
        } else if common != (rows, columns) {
            let given = format!("layer {name:?} has {rows} rows of {columns} pixels");
            let allowed = format!("{} rows of {}, as the first", common.0, common.1);
            return Err(InputError::new_err(format!("{given}; allowed: {allowed}")));
        }
        arrays.push((name, channels, plane));
    }
    Ok((arrays, common))
}

/// A photograph (PNG, JPEG, TIFF) as linear-light sRGB, float32 [row, column, rgb].
#[pyfunction]
pub fn read_photograph(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyArray3<f32>>> {
    let picture = py.detach(|| photograph::read_photograph(&path)).map_err(raised)?;
    array(py, picture)
}

/// A panorama (.hdr, .exr) as linear-light sRGB, float32 [row, column, rgb].
#[pyfunction]
pub fn read_panorama(py: Python<'_>, path: PathBuf) -> PyResult<Bound<'_, PyArray3<f32>>> {
    let picture = py.detach(|| panorama::read_panorama(&path)).map_err(raised)?;
    array(py, picture)
}

/// The texts in a PNG as (keyword, text).
#[pyfunction]
pub fn read_png_text(py: Python<'_>, path: PathBuf) -> PyResult<Text> {
    py.detach(|| png::read_png_text(&path)).map_err(raised)
}

/// The texts in an EXR as (keyword, text).
#[pyfunction]
pub fn read_exr_text(py: Python<'_>, path: PathBuf) -> PyResult<Text> {
    py.detach(|| exr::read_exr_text(&path)).map_err(raised)
}

/// What the system refused to write is an `OSError`, all else is the user's to mend.
fn raised(problem: PictureFileError) -> PyErr {
    match problem {
        PictureFileError::Unwritable(refusal) => refused(refusal),
        other => InputError::new_err(other.to_string()),
    }
}

/// The `OSError` with its number, so that Python can tell a full disk from a closed folder.
fn refused(refusal: io::Error) -> PyErr {
    match refusal.raw_os_error() {
        Some(number) => PyOSError::new_err((number, refusal.to_string())),
        None => refusal.into(),
    }
}

/// (width, height) of [row, column, rgb or rgba].
fn picture_size(shape: &[usize]) -> PyResult<(u32, u32)> {
    match *shape {
        [height, width, 3 | 4] if height.min(width) > 0 => {
            u32::try_from(width).ok().zip(u32::try_from(height).ok())
        }
        _ => None,
    }
    .ok_or_else(|| {
        let message = format!("pixels have the shape {shape:?}; allowed: [row, column, 3 or 4]");
        InputError::new_err(message)
    })
}

/// The same array with its values one after the other, copied only if they are not.
fn in_order<T: Clone>(view: ArrayView3<'_, T>) -> CowArray<'_, T, Ix3> {
    if view.is_standard_layout() {
        view.into()
    } else {
        view.as_standard_layout().into_owned().into()
    }
}

/// The values of an array from [`in_order`].
fn slice<'a, T>(array: &'a CowArray<'_, T, Ix3>) -> &'a [T] {
    array.as_slice().unwrap_or_default() // always there: the layout is standard
}

fn describe(value: &Bound<'_, PyAny>) -> String {
    match value.cast::<PyUntypedArray>() {
        Ok(array) => format!("{} of shape {:?}", array.dtype(), array.shape()),
        Err(_) => format!("no array but {}", value.get_type()),
    }
}

fn array(py: Python<'_>, picture: LinearPicture) -> PyResult<Bound<'_, PyArray3<f32>>> {
    let shape = (picture.height, picture.width, 3);
    let array = Array3::from_shape_vec(shape, picture.rgb)
        .map_err(|problem| InputError::new_err(problem.to_string()))?;
    Ok(array.into_pyarray(py))
}
