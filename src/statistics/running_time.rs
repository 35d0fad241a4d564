//! How long it takes until a target is reached, counted in evaluations.

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

/// The ratios of performance profiles (Dolan and Moré 2002): of each solver, in ascending order, how many times more than the best it needed
/// on the problems that it solved. `costs` are problem by problem the costs of all solvers, above 0, and `None` where one failed. The share
/// of problems on which a solver needs at most τ times the best is the number of its ratios up to τ, divided by that of all problems.
///
/// ```
/// use forage::statistics::performance_ratios;
/// let costs = [vec![Some(10.0), Some(20.0)], vec![Some(9.0), Some(3.0)], vec![Some(5.0), None]];
/// assert_eq!(performance_ratios(&costs), [vec![1.0, 1.0, 3.0], vec![1.0, 2.0]]);
/// ```
pub fn performance_ratios(costs: &[Vec<Option<f64>>]) -> Vec<Vec<f64>> {
    let solvers = costs.iter().map(Vec::len).max().unwrap_or(0);
    let mut ratios = vec![Vec::new(); solvers];
    for problem in costs {
        let best = problem.iter().flatten().copied().fold(f64::INFINITY, f64::min);
        for (ratios, cost) in ratios.iter_mut().zip(problem) {
            ratios.extend(cost.map(|cost| cost / best));
        }
    }
    ratios.iter_mut().for_each(|ratios| crate::math::sort_numbers(ratios));
    ratios
}
