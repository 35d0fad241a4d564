//! Convergence of many runs: bands of their best values, and the share of them that has reached the optimum.

use serde::{Deserialize, Serialize};

use crate::{
    kernel::{
        Error, Message,
        error::{finite, list_of},
    },
    math, message,
};

use super::{
    running_time::{Attempt, RunningTime},
    summary::{proportion, quantile},
};

/// A run's best values, each with the number of evaluations after which it was found; in this order.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
pub struct Curve {
    /// Evaluations.
    pub evaluations: Vec<f64>,
    /// Values.
    pub values: Vec<f64>,
}

/// Quartiles of the best values of several groups of runs, over evaluations: step functions.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Bands {
    /// The places of the quartiles: wherever a value changed, or, if that is at more than 400, about 400 of them, denser at the beginning,
    /// with the first and each group's end.
    pub evaluations: Vec<f64>,
    /// The quartiles of each group.
    pub groups: Vec<Band>,
}

/// The quartiles of a group of runs at each place; `None` where one falls on runs without a result, and after the last end.
#[derive(Debug, Clone, Default, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Band {
    /// The lower quartile.
    pub lower: Vec<Option<f64>>,
    /// The median.
    pub median: Vec<Option<f64>>,
    /// The upper quartile.
    pub upper: Vec<Option<f64>>,
}

/// The empirical distribution of running times (ECDF): which share of a group's runs had reached the target after so many evaluations.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Reached {
    /// Evaluations.
    pub evaluations: Vec<f64>,
    /// Shares, 0 to 1.
    pub shares: Vec<f64>,
    /// The 95 % interval of the last share, by Wilson's score; `None` without runs.
    pub interval: Option<[f64; 2]>,
    /// How many evaluations a success takes; `None` if there was none, or if it is not known how many evaluations the runs took.
    pub running_time: Option<RunningTime>,
}

/// More places than these cannot be seen. The first one and the groups' ends may be added to them.
const MOST_PLACES: usize = 400;
/// The bands of groups of runs; `ends` says after how many evaluations the longest run of each group ended. A run without a feasible
/// result yet counts as worse than all others; one that is over keeps its result.
///
/// # Errors
/// [`Error::Refused`] for another number of `ends` than of groups, another number of values than of evaluations, evaluations that are
/// not in order, and numbers that are not finite.
///
/// ```
/// use forage::statistics::{Curve, bands};
/// let run = |values: [f64; 2]| Curve { evaluations: vec![10.0, 20.0], values: values.to_vec() };
/// let found = bands(&[vec![run([9.0, 5.0]), run([8.0, 7.0]), run([6.0, 6.0])]], &[20.0])?;
/// assert_eq!((found.evaluations, &found.groups[0].median), (vec![10.0, 20.0], &vec![Some(8.0), Some(6.0)]));
/// # Ok::<(), forage::Error>(())
/// ```
pub fn bands(groups: &[Vec<Curve>], ends: &[f64]) -> Result<Bands, Error> {
    if ends.len() != groups.len() {
        return Err(Error::refused("ends", list_of(ends.len()), list_of(groups.len())));
    }
    check_finite("ends", ends)?;
    for (i, group) in groups.iter().enumerate() {
        group.iter().enumerate().try_for_each(|(j, curve)| check(curve, &format!("groups[{i}][{j}]")))?;
    }
    let evaluations = places(groups, ends);
    let groups = groups.iter().zip(ends).map(|(group, &end)| Band::of(group, &evaluations, end)).collect();
    Ok(Bands { evaluations, groups })
}

fn check_finite(field: &str, numbers: &[f64]) -> Result<(), Error> {
    match numbers.iter().position(|number| !number.is_finite()) {
        Some(k) => Err(refused(field, numbers, k, finite())),
        None => Ok(()),
    }
}

/// Refuses a number of a list.
fn refused(field: &str, numbers: &[f64], at: usize, allowed: Message) -> Error {
    Error::refused(format!("{field}[{at}]"), numbers[at], allowed)
}

/// `path` is the curve's field.
fn check(Curve { evaluations, values }: &Curve, path: &str) -> Result<(), Error> {
    if values.len() != evaluations.len() {
        return Err(Error::refused(format!("{path}.values"), list_of(values.len()), list_of(evaluations.len())));
    }
    let field = format!("{path}.evaluations");
    check_finite(&field, evaluations)?;
    check_finite(&format!("{path}.values"), values)?;
    match evaluations.windows(2).position(|two| two[1] < two[0]) {
        Some(k) => Err(refused(&field, evaluations, k + 1, message!("statistics-in-order", "no smaller than the number before it"))),
        None => Ok(()),
    }
}

fn places(groups: &[Vec<Curve>], ends: &[f64]) -> Vec<f64> {
    let changes = groups.iter().flatten().flat_map(|curve| curve.evaluations.iter().copied());
    let all = in_order(ends.iter().copied().chain(changes).collect());
    let (&[first, ..], &[.., last]) = (&all[..], &all[..]) else { return all };
    if all.len() <= MOST_PLACES {
        return all;
    }
    let (half, least) = (MOST_PLACES / 2, first.max(1.0));
    let spread = (0..half).flat_map(|k| {
        let share = k as f64 / (half - 1) as f64;
        [first + (last - first) * share, least * math::exp(share * math::ln(last / least))]
    });
    let places = ends.iter().copied().chain([first]).chain(spread.map(f64::round));
    in_order(places.filter(|at| (first..=last).contains(at)).collect())
}

/// Each number once, in order.
fn in_order(mut numbers: Vec<f64>) -> Vec<f64> {
    math::sort_numbers(&mut numbers);
    numbers.dedup();
    numbers
}

impl Band {
    fn of(group: &[Curve], evaluations: &[f64], end: f64) -> Self {
        let mut next = vec![0; group.len()];
        let mut present = vec![f64::INFINITY; group.len()];
        let mut sorted = present.clone();
        let mut band = Self::default();
        for &at in evaluations {
            for (curve, (next, present)) in group.iter().zip(next.iter_mut().zip(&mut present)) {
                while let Some((_, &value)) = curve.evaluations.get(*next).filter(|&&found| found <= at).zip(curve.values.get(*next)) {
                    *present = value;
                    *next += 1;
                }
            }
            sorted.copy_from_slice(&present);
            math::sort_numbers(&mut sorted);
            for (line, share) in [(&mut band.lower, 0.25), (&mut band.median, 0.5), (&mut band.upper, 0.75)] {
                let value = quantile(&sorted, share);
                line.push((at <= end && value.is_finite()).then_some(value));
            }
        }
        band
    }
}

/// The shares of runs that had reached the optimum; `None` for a run that never did. `spent`: how many evaluations each run took in all.
///
/// # Errors
/// For more or fewer numbers in `spent` than runs.
pub fn reached(runs: &[Option<f64>], spent: Option<&[f64]>) -> Result<Reached, Error> {
    let running_time = match spent {
        Some(spent) if spent.len() != runs.len() => return Err(Error::refused("spent", list_of(spent.len()), list_of(runs.len()))),
        Some(spent) => RunningTime::of(runs.iter().zip(spent).map(|(&hit, &spent)| Attempt { hit, spent }).collect()),
        None => None,
    };
    let mut evaluations: Vec<f64> = runs.iter().flatten().copied().collect();
    math::sort_numbers(&mut evaluations);
    let interval = proportion(evaluations.len(), runs.len());
    let mut found = Reached { evaluations: Vec::new(), shares: Vec::new(), interval, running_time };
    for (k, &at) in evaluations.iter().enumerate() {
        if evaluations.get(k + 1) != Some(&at) {
            found.evaluations.push(at);
            found.shares.push((k + 1) as f64 / runs.len() as f64);
        }
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn curve(evaluations: &[f64], values: &[f64]) -> Curve {
        Curve { evaluations: evaluations.to_vec(), values: values.to_vec() }
    }

    #[test]
    fn runs_without_a_result_count_as_worst_and_have_no_quartile() {
        let runs = vec![curve(&[1.0, 4.0], &[10.0, 5.0]), curve(&[2.0], &[8.0]), curve(&[3.0], &[6.0]), curve(&[], &[])];
        let Bands { evaluations, groups } = bands(&[runs], &[6.0]).unwrap();
        assert_eq!(evaluations, [1.0, 2.0, 3.0, 4.0, 6.0]);
        assert_eq!(groups[0].median, [None, None, Some(9.0), Some(7.0), Some(7.0)], "two results of four are not enough for the middle");
        assert!(groups[0].upper.iter().all(Option::is_none), "the fourth run never finds anything");
        assert_eq!(groups[0].lower[0], None);
        assert!((groups[0].lower[4].unwrap() - quantile(&[5.0, 6.0, 8.0, f64::INFINITY], 0.25)).abs() < 1e-12);
    }

    #[test]
    fn after_its_end_a_group_has_no_band() {
        let found = bands(&[vec![curve(&[1.0], &[2.0])], vec![curve(&[3.0], &[1.0])], Vec::new()], &[2.0, 5.0, 4.0]).unwrap();
        assert_eq!(found.evaluations, [1.0, 2.0, 3.0, 4.0, 5.0]);
        assert_eq!(found.groups[0].median, [Some(2.0), Some(2.0), None, None, None]);
        assert_eq!(found.groups[1].median, [None, None, Some(1.0), Some(1.0), Some(1.0)]);
        assert_eq!(found.groups[2].median, [None; 5]);
    }

    #[test]
    fn inconsistent_curves_are_refused_by_their_field() {
        let good = || curve(&[1.0, 4.0], &[10.0, 5.0]);
        let refused = |groups: &[Vec<Curve>], ends: &[f64]| {
            let error = bands(groups, ends).unwrap_err();
            (error.field().to_owned(), error.value().to_owned(), error.allowed().into_owned())
        };
        let refusal = |field: &str, value: &str, allowed: &str| (field.to_owned(), value.to_owned(), allowed.to_owned());
        assert_eq!(refused(&[vec![good()], vec![good()]], &[6.0]), refusal("ends", "a list of 1", "a list of 2"));
        assert_eq!(refused(&[vec![good()]], &[f64::NAN]), refusal("ends[0]", "NaN", "a finite number"));
        let short = curve(&[1.0, 4.0], &[10.0]);
        assert_eq!(refused(&[vec![], vec![good(), short]], &[6.0, 6.0]), refusal("groups[1][1].values", "a list of 1", "a list of 2"));
        let back = curve(&[1.0, 4.0, 4.0, 3.0], &[10.0, 5.0, 4.0, 3.0]);
        let before = "no smaller than the number before it";
        assert_eq!(refused(&[vec![good(), back]], &[6.0]), refusal("groups[0][1].evaluations[3]", "3", before));
        assert_eq!(refused(&[vec![curve(&[1.0], &[f64::INFINITY])]], &[6.0]).0, "groups[0][0].values[0]");
    }

    #[test]
    fn a_long_curve_is_thinned_in_order_with_both_ends() {
        let evaluations: Vec<f64> = (5..3005).map(f64::from).collect();
        let many = places(&[vec![curve(&evaluations, &[1.0; 3000])]], &[3700.0]);
        assert!(many.len() <= MOST_PLACES + 1 && many.is_sorted(), "{}", many.len());
        assert_eq!((many[0], many[many.len() - 1]), (5.0, 3700.0));
    }

    #[test]
    fn runs_that_miss_the_target_keep_the_share_below_one() {
        let found = reached(&[Some(30.0), None, Some(10.0), Some(30.0)], Some(&[40.0; 4])).unwrap();
        assert_eq!((found.evaluations, found.shares), (vec![10.0, 30.0], vec![0.25, 0.75]));
        assert_eq!(found.interval, proportion(3, 4));
        // Until the target 30 + 10 + 30, and all 40 of the run that never reached it.
        let RunningTime { expected, interval } = found.running_time.unwrap();
        assert!((expected - 110.0 / 3.0).abs() < 1e-12);
        let [low, high] = interval.unwrap();
        assert!(low.unwrap() < expected && expected < high.unwrap(), "{low:?} {high:?}");
        let nothing = reached(&[None, None], None).unwrap();
        assert_eq!((nothing.evaluations, nothing.running_time), (vec![], None));
        let error = reached(&[None, None], Some(&[1.0])).unwrap_err();
        assert_eq!(error.to_string(), "spent: a list of 1 is not allowed; it must be a list of 2");
    }
}
