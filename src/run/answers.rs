//! What the subtasks of a run found, kept for the way back.

use std::sync::Arc;

use crate::{
    describe::Registry,
    kernel::{Error, Scene, Subtask, SubtaskResult},
};

/// Runs subtasks on a scene.
pub(super) type RunSubtasks = fn(&Arc<Registry>, &Arc<Scene>, &[Subtask]) -> Result<Vec<SubtaskResult>, Error>;

/// What the subtasks of a run found, in the order of the iterations whose steps they were for.
pub(super) struct Answers {
    found: Vec<(u64, Vec<SubtaskResult>)>,
    /// They are kept for the way back; otherwise until they are used.
    kept: bool,
    /// Who carries them out, if anybody does.
    runner: Option<(Arc<Registry>, Arc<Scene>, RunSubtasks)>,
}

impl Answers {
    pub(super) fn new(kept: bool, runner: Option<(Arc<Registry>, Arc<Scene>, RunSubtasks)>) -> Self {
        Self { found: Vec::new(), kept, runner }
    }

    /// Whether the subtasks of an iteration were carried out.
    pub(super) fn knows(&self, iteration: u64) -> bool {
        self.place(iteration).is_ok()
    }

    /// Takes what was found elsewhere.
    pub(super) fn keep(&mut self, iteration: u64, found: Vec<SubtaskResult>) {
        match self.place(iteration) {
            Ok(at) => self.found[at].1 = found,
            Err(at) => self.found.insert(at, (iteration, found)),
        }
    }

    /// Where an iteration is, or belongs.
    fn place(&self, iteration: u64) -> Result<usize, usize> {
        self.found.binary_search_by_key(&iteration, |(known, _)| *known)
    }

    /// What these subtasks of an iteration find.
    pub(super) fn of(&mut self, iteration: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        let place = self.place(iteration).ok();
        let known = place.map(|at| if self.kept { self.found[at].1.clone() } else { self.found.remove(at).1 });
        known.unwrap_or_else(|| {
            // What starting could refuse was refused for the run itself; a failure now finds nothing.
            let found = self.runner.as_ref().and_then(|(registry, scene, run)| run(registry, scene, subtasks).ok()).unwrap_or_default();
            if self.kept {
                self.keep(iteration, found.clone());
            }
            found
        })
    }
}
