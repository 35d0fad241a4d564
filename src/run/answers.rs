//! What the subtasks of a run found, kept for the way back.

use std::{collections::BTreeMap, sync::Arc};

use crate::{
    describe::Registry,
    kernel::{Error, Scene, Subtask, SubtaskResult},
};

/// Runs subtasks on a scene.
pub(super) type RunSubtasks = fn(&Arc<Registry>, &Arc<Scene>, &[Subtask]) -> Result<Vec<SubtaskResult>, Error>;

/// What the subtasks of a run found, by the iteration whose step they were for.
pub(super) struct Answers {
    found: BTreeMap<u64, Vec<SubtaskResult>>,
    /// They are kept for the way back; otherwise until they are used.
    kept: bool,
    /// Who carries them out, if anybody does.
    runner: Option<(Arc<Registry>, Arc<Scene>, RunSubtasks)>,
}

impl Answers {
    pub(super) fn new(kept: bool, runner: Option<(Arc<Registry>, Arc<Scene>, RunSubtasks)>) -> Self {
        Self { found: BTreeMap::new(), kept, runner }
    }

    /// Whether the subtasks of an iteration were carried out.
    pub(super) fn knows(&self, iteration: u64) -> bool {
        self.found.contains_key(&iteration)
    }

    /// Takes what was found elsewhere.
    pub(super) fn keep(&mut self, iteration: u64, found: Vec<SubtaskResult>) {
        self.found.insert(iteration, found);
    }

    /// What these subtasks of an iteration find.
    pub(super) fn of(&mut self, iteration: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        let known = if self.kept { self.found.get(&iteration).cloned() } else { self.found.remove(&iteration) };
        known.unwrap_or_else(|| {
            // What starting could refuse was refused for the run itself; a failure now finds nothing.
            let found = self.runner.as_ref().and_then(|(registry, scene, run)| run(registry, scene, subtasks).ok()).unwrap_or_default();
            if self.kept {
                self.found.insert(iteration, found.clone());
            }
            found
        })
    }
}
