//! The binding of measures.

use nacreous_measure::{Circle, Given, Picture};
use numpy::{PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::{InputError, refused, threads::detached};

/// What is measured in linear light [row, column, rgb], as JSON; circle: x, y and radius in pixels.
#[pyfunction]
pub fn measure(
    py: Python<'_>,
    linear: PyReadonlyArray3<'_, f32>,
    white: [f64; 3],
    circle: Option<[f64; 3]>,
    mm_per_pixel: Option<f64>,
    clipped_at: Option<f64>,
) -> PyResult<String> {
    let &[height, width, channels] = linear.shape() else {
        return Err(InputError::new_err("linear has not 3 dimensions"));
    };
    if channels != 3 {
        return Err(InputError::new_err(format!("linear has {channels} channels; allowed: 3")));
    }
    let circle = circle.map(|[x_px, y_px, radius_px]| Circle { x_px, y_px, radius_px });
    let given = Given { circle, white, mm_per_pixel, clipped_at };
    let array = linear.as_array();
    let copied: Vec<f32>;
    let light = if let Some(light) = array.as_slice() {
        light
    } else {
        copied = array.iter().copied().collect();
        &copied
    };
    let found = detached(py, || {
        let picture = Picture::new(light, width, height)?;
        nacreous_measure::measure(&picture, &given)
    });
    serde_json::to_string(&found.map_err(refused)?).map_err(refused)
}
