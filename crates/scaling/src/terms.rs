//! What the answers to one pair add to the likelihood, as a function of two numbers.
//!
//! `a` is by how much the left one leads, order effect included; `s` says how wide ties are.
//!
//! Probit: e is normal with spread 1; left wins if a + e > τ, right if a + e < -τ, else a tie; s = τ
//! (Glenn and David 1960). Logit: left, right and tie stand as exp(a/2) : exp(-a/2) : ν; s = ln ν
//! (Davidson 1970, with the order effect of Davidson and Beaver 1977; their ν is ours times
//! exp(-order / 2), the same family). Both log-likelihoods are concave in (a, s).

use crate::{
    Link, Model, Outcome, ScalingError,
    normal::{self, density, log_density, log_interval, mills, slope_and_bend},
};

/// A part of the log-likelihood with its derivatives in a and s.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Terms {
    /// Log-likelihood.
    pub value: f64,
    /// Its slopes along a and s.
    pub slope: [f64; 2],
    /// Minus its second derivatives: aa, as, ss.
    pub bend: [f64; 3],
}

impl Terms {
    fn add(&mut self, count: f64, other: &Self) {
        self.value += count * other.value;
        for (sum, part) in self.slope.iter_mut().zip(other.slope) {
            *sum += count * part;
        }
        for (sum, part) in self.bend.iter_mut().zip(other.bend) {
            *sum += count * part;
        }
    }
}

/// All answers to one pair: (left, right, tie) of them.
pub fn of_counts(model: &Model, a: f64, s: f64, counts: &[f64; 3]) -> Terms {
    match (model.link, model.ties) {
        (Link::Probit, false) => probit_without_ties(a, counts),
        (Link::Logit, false) => logit_without_ties(a, counts),
        _ => {
            let mut sum = Terms::default();
            for (outcome, &count) in Outcome::ALL.into_iter().zip(counts) {
                if count > 0.0 {
                    sum.add(count, &of_outcome(model, a, s, outcome));
                }
            }
            sum
        }
    }
}

/// One answer.
pub fn of_outcome(model: &Model, a: f64, s: f64, outcome: Outcome) -> Terms {
    let mut counts = [0.0; 3];
    counts[outcome as usize] = 1.0;
    match (model.link, model.ties) {
        (Link::Probit, true) => probit_with_ties(a, s, outcome),
        (Link::Logit, true) => logit_with_ties(a, s, outcome),
        (Link::Probit, false) => probit_without_ties(a, &counts),
        (Link::Logit, false) => logit_without_ties(a, &counts),
    }
}

/// What `answers` answers to one pair are expected to tell: aa, as, ss of Fisher's information.
pub fn expected_bend(model: &Model, a: f64, s: f64, answers: f64) -> [f64; 3] {
    if (model.link, model.ties) == (Link::Probit, false) {
        // φ² / Φ(a) Φ(-a)
        return [answers * slope_and_bend(a).0 * slope_and_bend(-a).0, 0.0, 0.0];
    }
    if model.link == Link::Logit {
        return of_counts(model, a, s, &[answers, 0.0, 0.0]).bend; // the same whatever is answered
    }
    let mut sum = [0.0; 3];
    for outcome in Outcome::ALL {
        let Terms { value, slope: [u, v], .. } = of_outcome(model, a, s, outcome);
        let weight = answers * libm::exp(value);
        if weight > 0.0 {
            sum[0] += weight * u * u;
            sum[1] += weight * u * v;
            sum[2] += weight * v * v;
        }
    }
    sum
}

/// How likely left, right and a tie are.
///
/// # Errors
/// [`ScalingError::OutOfRange`] for a width that ties cannot have.
pub fn probabilities(model: &Model, a: f64, s: f64) -> Result<[f64; 3], ScalingError> {
    let s = model.checked_width(s)?;
    Ok(match (model.link, model.ties) {
        (Link::Probit, false) => [normal::cdf(a), normal::cdf(-a), 0.0],
        (Link::Logit, false) => [logistic(a), logistic(-a), 0.0],
        _ => Outcome::ALL.map(|outcome| libm::exp(of_outcome(model, a, s, outcome).value)),
    })
}

fn probit_without_ties(a: f64, &[left, right, _]: &[f64; 3]) -> Terms {
    let (for_it, against) = if a < 0.0 { (right, left) } else { (left, right) };
    let lead = a.abs();
    let (mills, density) = (mills(lead), density(lead));
    let upset = mills * density; // how likely the trailing one is to be chosen
    let mut sum = Terms::default();
    if for_it > 0.0 {
        let slope = density / (1.0 - upset);
        sum.value += for_it * libm::log1p(-upset);
        sum.slope[0] += for_it * slope;
        sum.bend[0] += for_it * slope * (slope + lead);
    }
    if against > 0.0 {
        let (slope, bend) = slope_and_bend(-lead);
        sum.value += against * (libm::log(mills) + log_density(lead));
        sum.slope[0] -= against * slope;
        sum.bend[0] += against * bend;
    }
    if a < 0.0 {
        sum.slope[0] = -sum.slope[0];
    }
    sum
}

fn logistic(a: f64) -> f64 {
    if a < 0.0 { libm::exp(a) / (1.0 + libm::exp(a)) } else { 1.0 / (1.0 + libm::exp(-a)) }
}

fn logit_without_ties(a: f64, &[left, right, _]: &[f64; 3]) -> Terms {
    let small = libm::exp(-a.abs());
    let trailing = small / (1.0 + small);
    let (for_left, for_right) =
        if a < 0.0 { (trailing, 1.0 - trailing) } else { (1.0 - trailing, trailing) };
    let normaliser = libm::log1p(small);
    Terms {
        value: -(left + right) * normaliser + if a < 0.0 { left * a } else { -right * a },
        slope: [left * for_right - right * for_left, 0.0],
        bend: [(left + right) * trailing / (1.0 + small), 0.0, 0.0],
    }
}

/// Φ(a - τ), Φ(-a - τ) or what lies between: in u = a + τ and v = a - τ, then turned to a and τ.
fn probit_with_ties(a: f64, threshold: f64, outcome: Outcome) -> Terms {
    let (u, v) = (a + threshold, a - threshold);
    match outcome {
        Outcome::Left => {
            let (slope, bend) = slope_and_bend(v);
            turned(normal::log_cdf(v), [0.0, slope], [0.0, 0.0, bend])
        }
        Outcome::Right => {
            let (slope, bend) = slope_and_bend(-u);
            turned(normal::log_cdf(-u), [-slope, 0.0], [bend, 0.0, 0.0])
        }
        Outcome::Tie => {
            let value = log_interval(v, u);
            let high = libm::exp(log_density(u) - value);
            let low = libm::exp(log_density(v) - value);
            let bend = [high * (u + high), -high * low, low * (low - v)];
            turned(value, [high, -low], bend)
        }
    }
}

fn turned(value: f64, [u, v]: [f64; 2], [uu, uv, vv]: [f64; 3]) -> Terms {
    Terms { value, slope: [u + v, u - v], bend: [uu + 2.0 * uv + vv, uu - vv, uu - 2.0 * uv + vv] }
}

fn logit_with_ties(a: f64, log_width: f64, outcome: Outcome) -> Terms {
    let exponents = [0.5 * a, -0.5 * a, log_width];
    let highest = exponents.into_iter().fold(f64::NEG_INFINITY, f64::max);
    let weights = exponents.map(|exponent| libm::exp(exponent - highest));
    let total: f64 = weights.iter().sum();
    let [left, right, tie] = weights.map(|weight| weight / total);
    let own = match outcome {
        Outcome::Left => [0.5, 0.0],
        Outcome::Right => [-0.5, 0.0],
        Outcome::Tie => [0.0, 1.0],
    };
    Terms {
        value: exponents[outcome as usize] - highest - libm::log(total),
        slope: [own[0] - 0.5 * (left - right), own[1] - tie],
        bend: [
            left * right + 0.25 * tie * (left + right),
            -0.5 * tie * (left - right),
            tie * (left + right),
        ],
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn models() -> impl Strategy<Value = Model> {
        (any::<bool>(), any::<bool>()).prop_map(|(probit, ties)| Model {
            link: if probit { Link::Probit } else { Link::Logit },
            ties,
            ..Model::default()
        })
    }

    proptest! {
        #[test]
        fn slopes_and_bends_are_derivatives(
            model in models(), a in -4.0..4.0_f64, s in 0.2..1.5_f64,
            counts in prop::array::uniform3(0.0..9.0_f64),
        ) {
            let h = 1e-5;
            let at = |da: f64, ds: f64| of_counts(&model, a + da, s + ds, &counts);
            let here = at(0.0, 0.0);
            for (k, (da, ds)) in [(h, 0.0), (0.0, h)].into_iter().enumerate() {
                let (after, before) = (at(da, ds), at(-da, -ds));
                let slope = (after.value - before.value) / (2.0 * h);
                prop_assert!((here.slope[k] - slope).abs() < 1e-6 * (1.0 + slope.abs()));
                for m in 0..2 {
                    let bend = (before.slope[m] - after.slope[m]) / (2.0 * h);
                    prop_assert!((here.bend[k + m] - bend).abs() < 1e-6 * (1.0 + bend.abs()));
                }
            }
        }

        #[test]
        fn probabilities_add_to_one_and_slopes_cancel(
            model in models(), a in -20.0..20.0_f64, s in 0.05..2.0_f64,
        ) {
            let p = probabilities(&model, a, s).unwrap();
            prop_assert!((p.iter().sum::<f64>() - 1.0).abs() < 1e-14);
            for k in 0..2 {
                let mean: f64 = (0..3)
                    .filter(|&i| p[i] > 0.0)
                    .map(|i| p[i] * of_outcome(&model, a, s, Outcome::ALL[i]).slope[k])
                    .sum();
                prop_assert!(mean.abs() < 1e-13);
            }
        }

        #[test]
        fn a_width_that_ties_cannot_have_is_refused(a in -9.0..9.0_f64, below in 1e-300..9.0_f64) {
            let probit = Model { ties: true, ..Model::default() };
            for width in [-below, f64::NAN] {
                prop_assert!(probabilities(&probit, a, width).is_err());
                prop_assert!(probit.checked(&[0.0, 0.0, width], 2).is_err());
                prop_assert!(probabilities(&Model::default(), a, width).is_ok()); // it has no ties
            }
            let logit = Model { link: Link::Logit, ..probit.clone() };
            prop_assert!(probabilities(&logit, a, -below).is_ok());
            prop_assert!(probabilities(&logit, a, f64::NAN).is_err());
            prop_assert!(probabilities(&probit, a, 0.0).unwrap()[2].abs() < 1e-15);
        }

        #[test]
        fn expected_information_is_the_mean_of_the_observed(
            model in models(), a in -3.0..3.0_f64, s in 0.1..2.0_f64,
        ) {
            let mean = of_counts(&model, a, s, &probabilities(&model, a, s).unwrap()).bend;
            let expected = expected_bend(&model, a, s, 1.0);
            for (mean, expected) in mean.into_iter().zip(expected) {
                prop_assert!((mean - expected).abs() < 1e-12);
            }
        }

        #[test]
        fn mirrored_answers_have_mirrored_terms(
            model in models(), a in -9.0..9.0_f64, s in 0.1..2.0_f64,
        ) {
            for outcome in Outcome::ALL {
                let (one, other) =
                    (of_outcome(&model, a, s, outcome), of_outcome(&model, -a, s, outcome.mirrored()));
                prop_assert!((one.value - other.value).abs() <= 1e-13 * one.value.abs());
                prop_assert!((one.slope[0] + other.slope[0]).abs() < 1e-12 * (1.0 + one.slope[0].abs()));
            }
        }
    }
}
