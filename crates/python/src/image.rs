//! The binding of linear light to codes for a screen.

use nacreous_colour::{Gamut, RgbSpace};
use nacreous_image::eight_bit;
use numpy::{IntoPyArray, PyArrayMethods, PyReadonlyArray3};
use pyo3::prelude::*;

use crate::{InputError, refused, threads::detached};

/// (codes [row, column, rgb] as uint8 or uint16, share of pixels out of gamut) of linear light.
#[pyfunction]
pub fn develop<'py>(
    py: Python<'py>,
    linear: PyReadonlyArray3<'py, f32>,
    space: &str,
    gamut: &str,
    bits: u8,
) -> PyResult<(Bound<'py, PyAny>, f64)> {
    let shape = linear.as_array().dim();
    if shape.2 != 3 {
        return Err(InputError::new_err(format!("linear has {} channels; allowed: 3", shape.2)));
    }
    let light = linear.as_array().iter().copied().collect::<Vec<_>>();
    if light.iter().any(|channel| !channel.is_finite()) {
        return Err(InputError::new_err("linear has a value that is not finite"));
    }
    let space: RgbSpace = space.parse().map_err(refused)?;
    let gamut: Gamut = gamut.parse().map_err(refused)?;
    let developed = detached(py, || nacreous_image::develop(&light, space, gamut));
    let shape = [shape.0, shape.1, 3];
    let codes = match bits {
        8 => eight_bit(&developed.codes).into_pyarray(py).reshape(shape)?.into_any(),
        16 => developed.codes.into_pyarray(py).reshape(shape)?.into_any(),
        _ => return Err(InputError::new_err(format!("bits is {bits}; allowed: 8, 16"))),
    };
    Ok((codes, developed.out_of_gamut))
}
