//! The binding of measures.

use nacreous_measure::{Circle, Given, Picture, measure_cut_out};
use numpy::{PyReadonlyArray2, PyReadonlyArray3, PyUntypedArrayMethods};
use pyo3::prelude::*;

use crate::{InputError, refused, threads::detached};

/// What is measured in linear light [row, column, rgb], as JSON; circle: x, y and radius in pixels;
/// opacity: [row, column], 1 on the pearl and 0 beside it, where the picture says so.
#[pyfunction]
pub fn measure(
    py: Python<'_>,
    linear: PyReadonlyArray3<'_, f32>,
    white: [f64; 3],
    circle: Option<[f64; 3]>,
    mm_per_pixel: Option<f64>,
    clipped_at: Option<f64>,
    opacity: Option<PyReadonlyArray2<'_, f32>>,
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
    let grey: Option<([usize; 2], Vec<f32>)> = opacity.map(|opacity| {
        let array = opacity.as_array();
        let size = [array.ncols(), array.nrows()];
        (size, array.iter().flat_map(|&share| [share; 3]).collect())
    });
    let found = detached(py, || {
        let picture = Picture::new(light, width, height)?;
        let Some(([width, height], grey)) = &grey else {
            return nacreous_measure::measure(&picture, &given);
        };
        measure_cut_out(&picture, &Picture::new(grey, *width, *height)?, &given)
    });
    serde_json::to_string(&found.map_err(refused)?).map_err(refused)
}
