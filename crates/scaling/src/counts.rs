use crate::{Model, ScalingError};

/// How often each pair was shown and what was answered: one row an ordered pair.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Counts {
    /// How many stimuli there are.
    pub stimuli: usize,
    /// (left, right) of each row.
    pub pairs: Vec<[u32; 2]>,
    /// Left chosen, right chosen, ties, of each row; fractions are allowed.
    pub answers: Vec<[f64; 3]>,
}

impl Counts {
    /// Checks indices and counts.
    ///
    /// # Errors
    /// [`ScalingError::Length`], [`ScalingError::Index`] or [`ScalingError::Count`].
    pub fn new(
        stimuli: usize,
        pairs: Vec<[u32; 2]>,
        answers: Vec<[f64; 3]>,
    ) -> Result<Self, ScalingError> {
        if pairs.len() != answers.len() {
            let (found, expected) = (answers.len(), pairs.len());
            return Err(ScalingError::Length { table: "answers", found, expected });
        }
        if let Some(&found) = pairs.iter().flatten().find(|&&i| i as usize >= stimuli) {
            let most = last(stimuli);
            return Err(ScalingError::Index { table: "pairs", found: found as usize, most });
        }
        if let Some(&bad) = answers.iter().flatten().find(|c| !(c.is_finite() && **c >= 0.0)) {
            return Err(ScalingError::Count(bad));
        }
        Ok(Self { stimuli, pairs, answers })
    }

    /// As the model sees them: ties halved unless it knows ties, sides forgotten unless it knows
    /// sides, empty rows left out.
    #[must_use]
    pub fn seen_by(&self, model: &Model) -> Self {
        let rows = self.pairs.iter().zip(&self.answers);
        let mut rows: Vec<([u32; 2], [f64; 3])> = rows
            .map(|(&pair, &answers)| seen(model, pair, answers))
            .filter(|(pair, answers)| pair[0] != pair[1] && answers.iter().sum::<f64>() > 0.0)
            .collect();
        rows.sort_by_key(|(pair, _)| *pair); // stable: sums keep their order
        rows.dedup_by(|(pair, more), (kept_pair, kept)| {
            let same = pair == kept_pair;
            if same {
                for k in 0..3 {
                    kept[k] += more[k];
                }
            }
            same
        });
        let (pairs, answers) = rows.into_iter().unzip();
        Self { stimuli: self.stimuli, pairs, answers }
    }

    /// How many answers there are.
    pub fn total(&self) -> f64 {
        self.answers.iter().flatten().sum()
    }

    /// How often left and right were chosen and how many ties there are.
    pub fn totals(&self) -> [f64; 3] {
        self.answers.iter().fold([0.0; 3], |sum, row| std::array::from_fn(|k| sum[k] + row[k]))
    }
}

/// A pair and its answers as the model sees them.
pub fn seen(model: &Model, pair: [u32; 2], answers: [f64; 3]) -> ([u32; 2], [f64; 3]) {
    let [left, right, ties] = answers;
    let answers = if model.ties { answers } else { [left + 0.5 * ties, right + 0.5 * ties, 0.0] };
    if model.order || pair[0] < pair[1] {
        (pair, answers)
    } else {
        ([pair[1], pair[0]], [answers[1], answers[0], answers[2]])
    }
}

/// The last index of so many, -1 if there are none.
pub fn last(many: usize) -> i64 {
    i64::try_from(many).unwrap_or(i64::MAX) - 1
}
