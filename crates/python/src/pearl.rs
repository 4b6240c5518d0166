//! The binding of a pearl's numbers: what the render room makes of its keys.

use nacreous_render::{
    Core, columns_of, core_under, diary_of, dimensions_of, outer_um_of, reflectance_of,
    resolved_of,
    spec::{
        from_json,
        nacre::{GrowthSpec, NacreSpec},
        pearl::{PearlSpec, TransportSpec},
    },
    stack_of, texture_seed_of,
};
use numpy::{IntoPyArray, PyArray1};
use pyo3::{prelude::*, types::PyDict};

use crate::{InputError, nacre::Stack, refused};

type Row<'py, T> = Bound<'py, PyArray1<T>>;

/// (stack, whether its core is the crystal of its layers) of a `[nacre]` in JSON.
#[pyfunction]
pub fn stack_of_nacre(nacre: &str) -> PyResult<(Stack, bool)> {
    let nacre: NacreSpec = from_json(nacre).map_err(refused)?;
    let aragonite = match &nacre {
        NacreSpec::Growth(growth) => &growth.aragonite,
        NacreSpec::Listed(listed) => &listed.aragonite,
    };
    let crystal = core_under(aragonite) == Core::Crystal;
    Ok((Stack(stack_of(&nacre).map_err(refused)?), crystal))
}

/// (day, thickness_nm) of each layer of a growth in JSON, in the order of growth.
#[pyfunction]
pub fn grow<'py>(py: Python<'py>, growth: &str) -> PyResult<(Row<'py, u32>, Row<'py, f64>)> {
    let growth: GrowthSpec = from_json(growth).map_err(refused)?;
    let diary = diary_of(&growth, growth.seed).map_err(refused)?;
    let (days, thickness_nm): (Vec<_>, Vec<_>) =
        diary.deposits().iter().map(|deposit| (deposit.day, deposit.thickness_nm)).unzip();
    Ok((days.into_pyarray(py), thickness_nm.into_pyarray(py)))
}

/// The columns of the film of a pearl in JSON, each by the thickness of its layers. `outer_um` is the film's
/// depth, the pearl's own where it is None.
#[pyfunction]
pub fn film_columns<'py>(
    py: Python<'py>,
    pearl: &str,
    outer_um: Option<f64>,
) -> PyResult<Vec<Row<'py, f64>>> {
    let pearl = transport(pearl)?;
    let outer_um = outer_um.unwrap_or_else(|| outer_um_of(&pearl));
    let columns = columns_of(&pearl.nacre, &pearl.film, outer_um).map_err(refused)?;
    Ok(columns.iter().map(|column| PyArray1::from_slice(py, column.thickness_nm())).collect())
}

/// Reflectance [401] of the body of a pearl in JSON, whose layers are so thick together.
#[pyfunction]
pub fn body_reflectance<'py>(
    py: Python<'py>,
    pearl: &str,
    of_layers_mm: f64,
) -> PyResult<Row<'py, f64>> {
    let reflectance = reflectance_of(&transport(pearl)?, of_layers_mm).map_err(refused)?;
    Ok(PyArray1::from_slice(py, &reflectance))
}

/// What each key that a pearl in JSON may leave open comes to, by the key's path.
#[pyfunction]
pub fn resolved_keys<'py>(py: Python<'py>, pearl: &str) -> PyResult<Bound<'py, PyDict>> {
    let pearl: PearlSpec = from_json(pearl).map_err(refused)?;
    let keys = PyDict::new(py);
    for (key, value) in resolved_of(&pearl) {
        keys.set_item(key, value)?;
    }
    Ok(keys)
}

/// (diameter variation, asymmetry, height over width, taper, grooves) of the form of a pearl in JSON, as shares.
#[pyfunction]
pub fn shape_dimensions(pearl: &str) -> PyResult<(f64, f64, f64, f64, usize)> {
    let found = dimensions_of(&transport(pearl)?);
    let shares = (found.diameter_variation, found.asymmetry, found.height_over_width, found.taper);
    Ok((shares.0, shares.1, shares.2, shares.3, found.grooves))
}

/// The seed of the grain of a pearl in JSON.
#[pyfunction]
pub fn texture_seed(pearl: &str) -> PyResult<u64> {
    Ok(texture_seed_of(&from_json(pearl).map_err(refused)?))
}

fn transport(pearl: &str) -> PyResult<TransportSpec> {
    match from_json(pearl).map_err(refused)? {
        PearlSpec::Transport(pearl) => Ok(*pearl),
        PearlSpec::Illuminant(_) => {
            Err(InputError::new_err("model is \"illuminant\"; allowed here: \"transport\""))
        }
    }
}
