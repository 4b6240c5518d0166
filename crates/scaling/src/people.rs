//! Answers by person, for what treats people as clusters.

use std::collections::BTreeMap;

use crate::{
    Counts, Model, Outcome, ScalingError,
    counts::{last, seen},
    likelihood::{leads, to_parameters},
    terms,
};

/// Answers one by one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Answers {
    /// (left, right) of each answer.
    pub pairs: Vec<[u32; 2]>,
    /// What was answered.
    pub outcomes: Vec<Outcome>,
    /// Who answered, from 0.
    pub people: Vec<u32>,
}

/// The answers of each person, counted by the rows of the counts that the model sees.
#[derive(Debug, Clone, PartialEq)]
pub struct Ledger {
    /// Who was shown what, by all people together.
    pub counts: Counts,
    /// Where each person's entries begin.
    pub first: Vec<usize>,
    /// Row, and how often left, right and tie were answered there.
    pub entries: Vec<(u32, [f32; 3])>,
}

impl Answers {
    /// Checks lengths and indices.
    ///
    /// # Errors
    /// [`ScalingError::Length`] or [`ScalingError::Index`].
    pub fn checked(self, stimuli: usize, people: usize) -> Result<Self, ScalingError> {
        let expected = self.pairs.len();
        for (table, found) in [("outcomes", self.outcomes.len()), ("people", self.people.len())] {
            if found != expected {
                return Err(ScalingError::Length { table, found, expected });
            }
        }
        let beyond = |&&i: &&u32, most: usize| i as usize >= most;
        let pair = self.pairs.iter().flatten().find(|i| beyond(i, stimuli));
        if let Some(&found) = pair {
            let (found, most) = (found as usize, last(stimuli));
            return Err(ScalingError::Index { table: "pairs", found, most });
        }
        if let Some(&found) = self.people.iter().find(|i| beyond(i, people)) {
            let (found, most) = (found as usize, last(people));
            return Err(ScalingError::Index { table: "people", found, most });
        }
        Ok(self)
    }

    /// Counted by person and row, as the model sees them.
    pub fn ledger(&self, model: &Model, stimuli: usize, people: usize) -> Ledger {
        // Of millions of answers: whole and half numbers, which this type holds up to 8 million.
        let mut entries: Vec<(u32, [u32; 2], [f32; 3])> = (0..self.pairs.len())
            .map(|i| {
                let mut one = [0.0; 3];
                one[self.outcomes[i] as usize] = 1.0;
                let (pair, answers) = seen(model, self.pairs[i], one);
                (self.people[i], pair, answers.map(|count| count as f32))
            })
            .collect();
        entries.sort_unstable_by_key(|&(person, pair, _)| (person, pair)); // halves add exactly
        entries.dedup_by(|more, kept| {
            let same = (more.0, more.1) == (kept.0, kept.1);
            if same {
                for k in 0..3 {
                    kept.2[k] += more.2[k];
                }
            }
            same
        });
        let mut sums: BTreeMap<[u32; 2], [f64; 3]> = BTreeMap::new();
        for (_, pair, answers) in &entries {
            let sum = sums.entry(*pair).or_default();
            for k in 0..3 {
                sum[k] += f64::from(answers[k]);
            }
        }
        let (pairs, answers) = sums.into_iter().unzip();
        let counts = Counts { stimuli, pairs, answers }.seen_by(model);
        let mut first = vec![0; people + 1];
        for (person, ..) in &entries {
            first[*person as usize + 1] += 1;
        }
        for i in 0..people {
            first[i + 1] += first[i];
        }
        // Each is there: the counts were made of these pairs.
        let row = |pair| counts.pairs.binary_search(pair).unwrap_or_default() as u32;
        let entries = entries.iter().map(|(_, pair, answers)| (row(pair), *answers)).collect();
        Ledger { counts, first, entries }
    }
}

impl Ledger {
    /// What a person answered.
    pub fn of(&self, person: usize) -> &[(u32, [f32; 3])] {
        &self.entries[self.first[person]..self.first[person + 1]]
    }

    /// How many people there are.
    pub fn people(&self) -> usize {
        self.first.len() - 1
    }

    /// The slopes of the log-likelihood of each person's answers, [person, parameter].
    pub fn scores(&self, model: &Model, parameters: &[f64]) -> Vec<f64> {
        let n = self.counts.stimuli;
        let (leads, width) = leads(model, &self.counts.pairs, n, parameters);
        let mut scores = vec![0.0; self.people() * parameters.len()];
        for (person, score) in scores.chunks_mut(parameters.len()).enumerate() {
            for &(row, answers) in self.of(person) {
                let answers = answers.map(f64::from);
                let slope = terms::of_counts(model, leads[row as usize], width, &answers).slope;
                to_parameters(model, n, self.counts.pairs[row as usize], slope, score);
            }
        }
        scores
    }
}

/// The slopes of the log-likelihood of each person's answers, [person, parameter].
pub fn person_scores(
    model: &Model,
    answers: &Answers,
    stimuli: usize,
    people: usize,
    parameters: &[f64],
) -> Vec<f64> {
    answers.ledger(model, stimuli, people).scores(model, parameters)
}
