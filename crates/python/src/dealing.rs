//! The bindings of answers dealt anew to people.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use nacreous_scaling::{Dealing, Stratum};
use numpy::{
    IntoPyArray, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;

use crate::{refused, watched::watched};

/// How far people differ, [1 + deals, 2]: as they are, then in each deal; of all axes of the metric and
/// of the first. pair and end: of each stratum; person and value: of each of its answers. `report` hears
/// how many deals are done.
#[pyfunction]
#[allow(clippy::too_many_arguments)]
pub fn spread_of_people<'py>(
    py: Python<'py>,
    people: usize,
    pair: PyReadonlyArray2<'_, i64>,
    end: PyReadonlyArray1<'_, i64>,
    person: PyReadonlyArray1<'_, i64>,
    value: PyReadonlyArray1<'_, f64>,
    metric: PyReadonlyArray2<'_, f64>,
    deals: usize,
    seed: u64,
    report: Option<Py<PyAny>>,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let index = |i: &i64| u32::try_from(*i).unwrap_or(u32::MAX);
    let strata = pair
        .as_array()
        .rows()
        .into_iter()
        .zip(end.as_array())
        .map(|(row, &end)| Stratum { pair: [index(&row[0]), index(&row[1])], end: end as usize })
        .collect();
    let dealing = Dealing {
        people,
        stimuli: metric.shape()[0],
        strata,
        person: person.as_array().iter().map(index).collect(),
        value: value.as_array().to_vec(),
        axes: metric.as_array().columns().into_iter().map(|axis| axis.to_vec()).collect(),
        seed,
    };
    let dealing = dealing.checked().map_err(refused)?;
    let (stop, done) = (AtomicBool::new(false), AtomicUsize::new(0));
    let look_up = || match &report {
        Some(report) => report.call1(py, (done.load(Ordering::Relaxed),)).map(drop),
        None => Ok(()),
    };
    let work = || dealing.run(deals, &stop, &done);
    let dealt = watched(py, look_up, || stop.store(true, Ordering::Relaxed), work)?;
    let rows = std::iter::once(dealing.as_they_are()).chain(dealt.map_err(refused)?);
    rows.flatten().collect::<Vec<f64>>().into_pyarray(py).reshape([1 + deals, 2])
}
