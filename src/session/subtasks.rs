//! Runs of planners for planners: one after another, or natively side by side.

use std::sync::Arc;

use crate::{
    describe::CONVERGED,
    kernel::{Error, Status, Subtask, SubtaskResult},
    scene::Scene,
};

use super::{run::Session, setup::Setup};

/// Carries a run out to its end.
///
/// # Errors
/// Whatever [`Session::new`] refuses.
pub fn run_to_end(setup: Setup) -> Result<SubtaskResult, Error> {
    let mut session = Session::with_keyframes(setup, 0)?;
    while session.step(u64::MAX) == Status::Running {}
    let converged = session.readings().of(CONVERGED).unwrap_or(session.iteration() as f64);
    // A swarm's best may still touch an obstacle: then nothing was found.
    let best = session.best().filter(|best| session.scene.judge(&best.solution).feasible);
    let cost = best.as_ref().map(|best| best.cost);
    let path = best.and_then(|best| best.solution.path().map(<[_]>::to_vec)).unwrap_or_default();
    Ok(SubtaskResult { cost, converged, path })
}

/// Carries jobs out, with the feature `parallel` on all cores. The findings are in the jobs' order, whoever was first.
///
/// # Errors
/// The first job's that is refused.
pub fn run_subtasks(scene: &Arc<Scene>, jobs: &[Subtask]) -> Result<Vec<SubtaskResult>, Error> {
    let one = |job: &Subtask| {
        let scene = match job.ends {
            Some(ends) => Arc::new(scene.between(ends)?),
            None => Arc::clone(scene),
        };
        run_to_end(Setup { planner: job.planner.to_owned(), scene, params: job.params.clone(), seed: job.seed })
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        jobs.par_iter().map(one).collect()
    }
    #[cfg(not(feature = "parallel"))]
    jobs.iter().map(one).collect()
}
