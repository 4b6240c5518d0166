//! The bindings of scaling.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use nacreous_scaling::{
    Answers, Bootstrap, Counts, Design, Existence, Kind, Model, Outcome, Source,
};
use numpy::{
    IntoPyArray, PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2,
    PyUntypedArrayMethods,
};
use pyo3::prelude::*;
use pyo3::types::{PyTuple, PyType};

use crate::{refused, threads::detached, watched::watched};

type Row<'py> = Bound<'py, PyArray1<f64>>;
type Table<'py> = Bound<'py, PyArray2<f64>>;
type Column<'py> = Bound<'py, PyArray1<i64>>;

/// So many pairs are fitted before anybody could press Ctrl-C, in less time than a thread may take to
/// be woken.
const SHORT: usize = 1000;

/// A model of paired comparisons and the counts it is fitted to.
#[pyclass(frozen, module = "nacreous._core")]
pub struct PairModel {
    model: Model,
    counts: Counts,
}

#[pymethods]
impl PairModel {
    #[new]
    #[pyo3(signature = (link, stimuli, left, right, answers, ties, order, prior, design))]
    #[allow(clippy::too_many_arguments)]
    fn new(
        link: &str,
        stimuli: usize,
        left: PyReadonlyArray1<'_, i64>,
        right: PyReadonlyArray1<'_, i64>,
        answers: PyReadonlyArray2<'_, f64>,
        ties: bool,
        order: bool,
        prior: Option<f64>,
        design: Option<PyReadonlyArray2<'_, f64>>,
    ) -> PyResult<Self> {
        let design = design.map(|table| Design {
            columns: table.shape()[1],
            values: table.as_array().iter().copied().collect(),
        });
        let link = link.parse().map_err(refused)?;
        let model = Model { link, ties, order, prior, design };
        let answers = answers.as_array();
        let rows = answers.rows().into_iter().map(|row| [row[0], row[1], row[2]]).collect();
        let counts = Counts::new(stimuli, pairs(&left, &right), rows).map_err(refused)?;
        Ok(Self { model, counts })
    }

    /// The class and the arguments from which a pickle of any protocol makes it again.
    fn __reduce__<'py>(
        slf: &Bound<'py, Self>,
    ) -> PyResult<(Bound<'py, PyType>, Bound<'py, PyTuple>)> {
        let (py, Self { model, counts }) = (slf.py(), slf.get());
        let side = |which: usize| -> Column<'py> {
            let indices: Vec<i64> = counts.pairs.iter().map(|pair| pair[which].into()).collect();
            indices.into_pyarray(py)
        };
        let answers = counts.answers.as_flattened().to_vec().into_pyarray(py);
        let answers = answers.reshape([counts.answers.len(), 3])?;
        let design = model.design.as_ref().map(|design| {
            let values = design.values.clone().into_pyarray(py);
            values.reshape([counts.stimuli, design.columns])
        });
        let (link, prior) = (model.link.name(), model.prior);
        let (ties, order, design) = (model.ties, model.order, design.transpose()?);
        let arguments =
            (link, counts.stimuli, side(0), side(1), answers, ties, order, prior, design);
        Ok((slf.get_type(), arguments.into_pyobject(py)?))
    }

    /// The part of each stimulus in which all can be reached from all by "was preferred to"; a part
    /// was never preferred to one of a higher number.
    fn components<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<u32>> {
        nacreous_scaling::components(&self.counts.seen_by(&self.model)).into_pyarray(py)
    }

    /// "exists", "apart", "order" or "ties".
    fn existence(&self, py: Python<'_>) -> &'static str {
        match detached(py, || nacreous_scaling::existence(&self.model, &self.counts)) {
            Existence::Exists => "exists",
            Existence::Apart => "apart",
            Existence::Order => "order",
            Existence::Ties => "ties",
        }
    }

    /// (parameters, values with mean 0, log-likelihood, steps) at the maximum.
    fn fit<'py>(&self, py: Python<'py>) -> PyResult<(Row<'py>, Row<'py>, f64, usize)> {
        let stop = AtomicBool::new(false);
        let work = || nacreous_scaling::fit(&self.model, &self.counts, &stop);
        let fit = if self.counts.pairs.len() <= SHORT {
            py.detach(work)
        } else {
            watched(py, || Ok(()), || stop.store(true, Ordering::Relaxed), work)?
        };
        let fit = fit.map_err(refused)?;
        let (parameters, values) = (fit.parameters.into_pyarray(py), fit.values.into_pyarray(py));
        Ok((parameters, values, fit.log_likelihood, fit.steps))
    }

    /// Fisher's information at some parameters, expected or observed.
    fn information<'py>(
        &self,
        py: Python<'py>,
        parameters: PyReadonlyArray1<'_, f64>,
        expected: bool,
    ) -> PyResult<Table<'py>> {
        let parameters = self.checked(&parameters)?;
        let kind = if expected { Kind::Expected } else { Kind::Observed };
        let size = parameters.len();
        let matrix = detached(py, || {
            nacreous_scaling::information(&self.model, &self.counts, &parameters, kind)
        });
        matrix.into_pyarray(py).reshape([size, size])
    }

    /// The log-likelihood at some parameters, without constant terms and prior.
    fn log_likelihood(
        &self,
        py: Python<'_>,
        parameters: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<f64> {
        let parameters = self.checked(&parameters)?;
        let work = || nacreous_scaling::log_likelihood(&self.model, &self.counts, &parameters);
        Ok(detached(py, work))
    }

    /// How likely left, right and a tie are, [lead, 3], for some leads of the left one (its order
    /// effect included) and a width of ties.
    fn probabilities<'py>(
        &self,
        py: Python<'py>,
        lead: PyReadonlyArray1<'_, f64>,
        width: f64,
    ) -> PyResult<Table<'py>> {
        let of = |&a: &f64| nacreous_scaling::probabilities(&self.model, a, width);
        let rows: Result<Vec<_>, _> = lead.as_array().iter().map(of).collect();
        let rows = rows.map_err(refused)?;
        rows.as_flattened().to_vec().into_pyarray(py).reshape([rows.len(), 3])
    }

    /// The slopes of the log-likelihood of each person's answers, [person, parameter].
    fn scores<'py>(
        &self,
        py: Python<'py>,
        answers: &PersonalAnswers,
        parameters: PyReadonlyArray1<'_, f64>,
    ) -> PyResult<Table<'py>> {
        let parameters = self.checked(&parameters)?;
        let (model, stimuli) = (&self.model, self.counts.stimuli);
        let (answers, people) = (&answers.answers, answers.people);
        let scores = detached(py, || {
            nacreous_scaling::person_scores(model, answers, stimuli, people, &parameters)
        });
        scores.into_pyarray(py).reshape([people, parameters.len()])
    }

    /// Scales of samples drawn from `answers` by people, or from the counts: values [sample, n], their
    /// standard errors [sample, n or 0], order effect and ties [sample, 2], and how many samples had no
    /// maximum. `report` hears how many are done.
    #[allow(clippy::too_many_arguments)]
    fn bootstrap<'py>(
        &self,
        py: Python<'py>,
        parameters: PyReadonlyArray1<'_, f64>,
        answers: Option<&PersonalAnswers>,
        samples: usize,
        seed: u64,
        studentised: bool,
        report: Option<Py<PyAny>>,
    ) -> PyResult<(Table<'py>, Table<'py>, Table<'py>, usize)> {
        let parameters = self.checked(&parameters)?;
        let (model, stimuli) = (&self.model, self.counts.stimuli);
        let (stop, done) = (AtomicBool::new(false), AtomicUsize::new(0));
        let work = || {
            let source = match answers {
                Some(known) => Source::People(known.answers.ledger(model, stimuli, known.people)),
                None => Source::Answers(self.counts.clone()),
            };
            let (source, parameters) = (&source, &parameters[..]);
            Bootstrap { model, source, parameters, samples, seed, studentised }.run(&stop, &done)
        };
        let look_up = || match &report {
            Some(report) => report.call1(py, (done.load(Ordering::Relaxed),)).map(drop),
            None => Ok(()),
        };
        let found = watched(py, look_up, || stop.store(true, Ordering::Relaxed), work)?;
        let found = found.map_err(refused)?;
        let table = |part: Vec<f64>| {
            let columns = part.len() / samples.max(1);
            part.into_pyarray(py).reshape([samples, columns])
        };
        let values = found.iter().flat_map(|sample| sample.values.iter().copied()).collect();
        let se = found.iter().flat_map(|sample| sample.se.iter().copied()).collect();
        let effects = found.iter().flat_map(|sample| [sample.order, sample.ties]).collect();
        let unplaced = found.iter().filter(|sample| !sample.placed).count();
        Ok((table(values)?, table(se)?, table(effects)?, unplaced))
    }
}

impl PairModel {
    /// Parameters that the model can have.
    fn checked(&self, parameters: &PyReadonlyArray1<'_, f64>) -> PyResult<Vec<f64>> {
        let parameters = parameters.as_array().to_vec();
        self.model.checked(&parameters, self.counts.stimuli).map_err(refused)?;
        Ok(parameters)
    }
}

/// Answers one by one with who gave them.
#[pyclass(frozen)]
pub struct PersonalAnswers {
    answers: Answers,
    people: usize,
}

#[pymethods]
impl PersonalAnswers {
    #[new]
    fn new(
        stimuli: usize,
        left: PyReadonlyArray1<'_, i64>,
        right: PyReadonlyArray1<'_, i64>,
        outcome: PyReadonlyArray1<'_, i8>,
        person: PyReadonlyArray1<'_, i64>,
        people: usize,
    ) -> PyResult<Self> {
        let answers = Answers {
            pairs: pairs(&left, &right),
            outcomes: outcome.as_array().iter().map(|&sign| Outcome::from(sign)).collect(),
            people: person.as_array().iter().map(|&person| person as u32).collect(),
        };
        Ok(Self { answers: answers.checked(stimuli, people).map_err(refused)?, people })
    }
}

/// ln Φ, right in both tails.
#[pyfunction]
pub fn log_normal_cdf<'py>(py: Python<'py>, x: PyReadonlyArray1<'_, f64>) -> Row<'py> {
    let found: Vec<f64> = x.as_array().iter().map(|&x| nacreous_scaling::log_cdf(x)).collect();
    found.into_pyarray(py)
}

/// What is below 0 or beyond 32 bits becomes an index that no table has.
fn pairs(left: &PyReadonlyArray1<'_, i64>, right: &PyReadonlyArray1<'_, i64>) -> Vec<[u32; 2]> {
    let index = |&i: &i64| u32::try_from(i).unwrap_or(u32::MAX);
    let (left, right) = (left.as_array(), right.as_array());
    left.iter().zip(right).map(|(l, r)| [index(l), index(r)]).collect()
}
