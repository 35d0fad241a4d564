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

/// Runs subtasks, with the feature `parallel` on all cores. The results are in the order of the subtasks.
///
/// # Errors
/// What is refused of the first subtask that is.
pub fn run_subtasks(scene: &Arc<Scene>, subtasks: &[Subtask]) -> Result<Vec<SubtaskResult>, Error> {
    let one = |subtask: &Subtask| {
        let scene = match subtask.ends {
            Some(ends) => Arc::new(scene.between(ends)?),
            None => Arc::clone(scene),
        };
        run_to_end(Setup { planner: subtask.planner.to_owned(), scene, params: subtask.params.clone(), seed: subtask.seed })
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        subtasks.par_iter().map(one).collect()
    }
    #[cfg(not(feature = "parallel"))]
    subtasks.iter().map(one).collect()
}
