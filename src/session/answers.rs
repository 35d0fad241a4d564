//! What the subtasks of a run found, kept for the way back.

use std::{collections::BTreeMap, sync::Arc};

use crate::{
    kernel::{Error, Subtask, SubtaskResult},
    scene::Scene,
};

/// Runs subtasks on a scene.
pub(super) type RunSubtasks = fn(&Arc<Scene>, &[Subtask]) -> Result<Vec<SubtaskResult>, Error>;

/// What the subtasks of a run found, by the iteration whose step they were for.
pub(super) struct Answers {
    scene: Arc<Scene>,
    found: BTreeMap<u64, Vec<SubtaskResult>>,
    /// They are kept for the way back; otherwise until they are used.
    kept: bool,
    run: RunSubtasks,
}

impl Answers {
    pub(super) fn new(scene: Arc<Scene>, kept: bool, run: RunSubtasks) -> Self {
        Self { scene, found: BTreeMap::new(), kept, run }
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
    pub(super) fn of(&mut self, iteration: u64, jobs: &[Subtask]) -> Vec<SubtaskResult> {
        let known = if self.kept { self.found.get(&iteration).cloned() } else { self.found.remove(&iteration) };
        known.unwrap_or_else(|| {
            // What starting could refuse was refused for the run itself; a failure now finds nothing.
            let found = (self.run)(&self.scene, jobs).unwrap_or_default();
            if self.kept {
                self.found.insert(iteration, found.clone());
            }
            found
        })
    }
}
