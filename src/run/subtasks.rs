//! Runs of planners for planners: one after another, or natively side by side.

use std::sync::Arc;

use crate::{
    describe::{CONVERGED, Registry},
    kernel::{Error, Scene, Status, Subtask, SubtaskResult},
};

use super::{setup::Setup, stepping::Run};

/// Carries a run out to its end.
///
/// # Errors
/// Whatever [`Run::new`] refuses.
pub fn run_to_end(registry: &Arc<Registry>, setup: Setup) -> Result<SubtaskResult, Error> {
    let mut run = Run::with_keyframes(registry, setup, 0)?;
    while run.step(u64::MAX) == Status::Running {}
    let converged = run.readings().of(CONVERGED).unwrap_or(run.iteration() as f64);
    // A swarm's best may still touch an obstacle: then nothing was found.
    let best = run.best().filter(|best| run.scene.judge(&best.solution).feasible);
    let cost = best.as_ref().map(|best| best.cost);
    let path = best.and_then(|best| best.solution.path().map(<[_]>::to_vec)).unwrap_or_default();
    Ok(SubtaskResult { cost, converged, path })
}

/// Runs subtasks, with the feature `parallel` on all cores. The results are in the order of the subtasks.
///
/// # Errors
/// What is refused of the first subtask that is.
pub fn run_subtasks(registry: &Arc<Registry>, scene: &Arc<Scene>, subtasks: &[Subtask]) -> Result<Vec<SubtaskResult>, Error> {
    let one = |subtask: &Subtask| {
        let scene = match subtask.ends {
            Some(ends) => Arc::new(scene.between(ends)?),
            None => Arc::clone(scene),
        };
        run_to_end(registry, Setup { planner: subtask.planner.to_owned(), scene, params: subtask.params.clone(), seed: subtask.seed })
    };
    #[cfg(feature = "parallel")]
    {
        use rayon::prelude::*;
        subtasks.par_iter().map(one).collect()
    }
    #[cfg(not(feature = "parallel"))]
    subtasks.iter().map(one).collect()
}
