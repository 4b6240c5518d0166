use crate::ScalingError;

/// How a lead becomes a probability.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Link {
    /// The normal distribution: Thurstone 1927, case V, a difference of 1 being 1 z.
    #[default]
    Probit,
    /// The logistic distribution: Bradley and Terry 1952.
    Logit,
}

impl Link {
    /// The name that [`str::parse`] takes.
    pub fn name(self) -> &'static str {
        match self {
            Self::Probit => "probit",
            Self::Logit => "logit",
        }
    }
}

impl std::str::FromStr for Link {
    type Err = ScalingError;

    fn from_str(name: &str) -> Result<Self, ScalingError> {
        match name {
            "probit" => Ok(Self::Probit),
            "logit" => Ok(Self::Logit),
            _ => Err(ScalingError::Link(name.to_owned())),
        }
    }
}

/// What is fitted: the values of the stimuli, and what else may have moved the answers.
///
/// The parameters stand in one row: coefficients, then the order effect, then the width of ties.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Model {
    /// Normal or logistic.
    pub link: Link,
    /// Whether ties have a probability of their own; else each is half a choice for either.
    pub ties: bool,
    /// Whether being on the left may help.
    pub order: bool,
    /// Spread of a normal prior around 0 on each coefficient; none by default.
    pub prior: Option<f64>,
    /// What the stimuli's values are made of; by default each has one of its own, with mean 0.
    pub design: Option<Design>,
}

/// A table [stimulus, coefficient]: values = table x coefficients.
#[derive(Debug, Clone, PartialEq)]
pub struct Design {
    /// Row after row.
    pub values: Vec<f64>,
    /// How many coefficients.
    pub columns: usize,
}

impl Design {
    /// The row of a stimulus.
    pub fn row(&self, stimulus: usize) -> &[f64] {
        &self.values[stimulus * self.columns..][..self.columns]
    }
}

impl Model {
    /// How many coefficients make the values of so many stimuli.
    pub fn coefficients(&self, stimuli: usize) -> usize {
        self.design.as_ref().map_or(stimuli, |design| design.columns)
    }

    /// Where the order effect stands among the parameters.
    pub fn order_at(&self, stimuli: usize) -> Option<usize> {
        self.order.then(|| self.coefficients(stimuli))
    }

    /// Where the width of ties stands among the parameters.
    pub fn ties_at(&self, stimuli: usize) -> Option<usize> {
        self.ties.then(|| self.coefficients(stimuli) + usize::from(self.order))
    }

    /// How many parameters there are.
    pub fn parameters(&self, stimuli: usize) -> usize {
        self.coefficients(stimuli) + usize::from(self.order) + usize::from(self.ties)
    }

    /// Parameters as many as there are, with a width of ties that can be.
    ///
    /// # Errors
    /// [`ScalingError::Length`] and [`ScalingError::OutOfRange`].
    pub fn checked<'a>(
        &self,
        parameters: &'a [f64],
        stimuli: usize,
    ) -> Result<&'a [f64], ScalingError> {
        let (found, expected) = (parameters.len(), self.parameters(stimuli));
        if found != expected {
            return Err(ScalingError::Length { table: "parameters", found, expected });
        }
        self.ties_at(stimuli).map_or(Ok(0.0), |i| self.checked_width(parameters[i]))?;
        Ok(parameters)
    }

    /// A width of ties: of probit a threshold, of logit a logarithm; without ties anything is one.
    ///
    /// # Errors
    /// [`ScalingError::OutOfRange`] for a threshold below 0, between whose ends nothing lies.
    pub fn checked_width(&self, width: f64) -> Result<f64, ScalingError> {
        let (fits, allowed) = match self.link {
            Link::Probit => (width >= 0.0, "0 or more"),
            Link::Logit => (width < f64::INFINITY, "a number"),
        };
        if self.ties && !fits {
            return Err(ScalingError::OutOfRange {
                quantity: "width of ties",
                value: width,
                allowed,
            });
        }
        Ok(width)
    }

    /// The values of the stimuli, with mean 0.
    pub fn values(&self, parameters: &[f64], stimuli: usize) -> Vec<f64> {
        let mut values: Vec<f64> = match &self.design {
            None => parameters[..stimuli].to_vec(),
            Some(design) => (0..stimuli)
                .map(|i| design.row(i).iter().zip(parameters).map(|(x, b)| x * b).sum())
                .collect(),
        };
        centre(&mut values);
        values
    }
}

/// Takes the mean away.
pub fn centre(values: &mut [f64]) {
    let mean = values.iter().sum::<f64>() / values.len().max(1) as f64;
    for value in values {
        *value -= mean;
    }
}
