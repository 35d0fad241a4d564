//! How long it takes until a target is reached, counted in evaluations.

use serde::Serialize;

use super::{RESAMPLES, bootstrap};
use crate::kernel::rng::Stream;

/// How a run went towards a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Attempt {
    /// After how many evaluations it was reached; `None`: never.
    pub hit: Option<f64>,
    /// How many evaluations there were.
    pub spent: f64,
}

/// The expected running time: all evaluations until the target, or until the end of runs that never reached it, for each success (Auger
/// and Hansen, CEC 2005). `None` if no run reached it.
///
/// ```
/// use forage::statistics::{Attempt, expected_running_time};
/// let runs = [Attempt { hit: Some(300.0), spent: 500.0 }, Attempt { hit: None, spent: 1000.0 }];
/// assert_eq!(expected_running_time(&runs), Some(1300.0));
/// ```
pub fn expected_running_time(runs: &[Attempt]) -> Option<f64> {
    let successes = runs.iter().filter(|run| run.hit.is_some()).count();
    let all: f64 = runs.iter().map(|run| run.hit.unwrap_or(run.spent)).sum();
    (successes > 0).then(|| all / successes as f64)
}

/// An [expected running time](expected_running_time) with its interval.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct RunningTime {
    /// Evaluations for each success.
    pub expected: f64,
    /// The 95 % [bootstrap](bootstrap) interval; an end is `None` if too many resamples have no success for it to be finite. `None` for
    /// a single run.
    pub interval: Option<[Option<f64>; 2]>,
}

impl RunningTime {
    /// Of some runs; `None` if no run reached the target.
    pub fn of(runs: Vec<Attempt>) -> Option<Self> {
        let expected = expected_running_time(&runs)?;
        let several = runs.len() > 1;
        let statistic = |groups: &[Vec<Attempt>]| expected_running_time(&groups[0]).unwrap_or(f64::INFINITY);
        let interval = if several { bootstrap(&[runs], RESAMPLES, &mut Stream::new(1, 0), statistic) } else { None };
        Some(Self { expected, interval: interval.map(|ends| ends.map(|end| Some(end).filter(|end| end.is_finite()))) })
    }
}

/// The performance ratios of each solver in ascending order: its cost divided by the least cost, on the problems that it solved (Dolan and
/// Moré 2002). `costs` holds, problem by problem, the solvers' costs, none below 0; `None` for a failure. A performance profile at τ is the
/// number of ratios up to τ divided by the number of problems.
///
/// ```
/// use forage::statistics::performance_ratios;
/// let costs = [vec![Some(10.0), Some(20.0)], vec![Some(9.0), Some(3.0)], vec![Some(5.0), None]];
/// assert_eq!(performance_ratios(&costs), [vec![1.0, 1.0, 3.0], vec![1.0, 2.0]]);
/// assert_eq!(performance_ratios(&[vec![Some(0.0), Some(2.0)]]), [vec![1.0], vec![f64::INFINITY]]);
/// ```
pub fn performance_ratios(costs: &[Vec<Option<f64>>]) -> Vec<Vec<f64>> {
    let solvers = costs.iter().map(Vec::len).max().unwrap_or(0);
    let mut ratios = vec![Vec::new(); solvers];
    for problem in costs {
        let best = problem.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        for (ratios, cost) in ratios.iter_mut().zip(problem) {
            // A cost of 0 is the best, whatever the others are.
            ratios.extend(cost.map(|cost| if cost == best { 1.0 } else { cost / best }));
        }
    }
    ratios.iter_mut().for_each(|ratios| crate::math::sort_numbers(ratios));
    ratios
}
