//! A run that stops when it has spent a budget of evaluations, whatever its planner takes for an iteration.

use std::sync::Arc;

use forage::{
    Error, Registry, Run, Setup, Value,
    run::{ITERATIONS, Spending},
};

/// So often a run begins again with more iterations because its limit came before the budget was spent.
const RESTARTS: usize = 4;

/// Where a run ended.
#[derive(Debug, Clone, Copy)]
pub(crate) struct RunEnd {
    iteration: u64,
    limit: u64,
    evaluations: u64,
}

impl RunEnd {
    /// Of a run that is over.
    pub(crate) fn of(run: &Run) -> Self {
        Self { iteration: run.iteration(), limit: run.limit(), evaluations: run.evaluations() }
    }
}

/// Runs `attempt` so that it spends `budget` evaluations. `iterations` is estimated from the first step; where the limit is reached before
/// the budget is spent, the run starts again with more iterations, at most [`RESTARTS`] times. A setup that sets `iterations` keeps it.
/// `None` if `attempt` gives `None`: it was stopped.
///
/// # Errors
/// What the planner refuses, and those of `attempt`.
pub(crate) fn run_within_budget<T>(
    registry: &Arc<Registry>,
    mut setup: Setup,
    budget: u64,
    mut attempt: impl FnMut(Setup) -> Result<Option<(T, RunEnd)>, Error>,
) -> Result<Option<T>, Error> {
    if setup.params.get(ITERATIONS).is_some() || registry.planner(&setup.planner)?.parameter(ITERATIONS).is_none() {
        return Ok(attempt(setup)?.map(|(found, _)| found));
    }
    let spending = Spending::of(registry, &setup)?;
    let mut iterations = spending.iterations(budget);
    for again in 0..=RESTARTS {
        setup.params.insert(ITERATIONS, Value::Number(iterations as f64));
        let Some((found, reached)) = attempt(setup.clone())? else { break };
        let early = reached.evaluations < budget && reached.iteration >= reached.limit && iterations < spending.most;
        if again == RESTARTS || !early {
            return Ok(Some(found));
        }
        let more = iterations as f64 * (budget as f64 / reached.evaluations.max(1) as f64).min(100.0) * 1.1;
        iterations = (more as u64).max(iterations + 1).min(spending.most);
    }
    Ok(None)
}
