//! What the subtasks of a run found, kept for the way back.

use crate::kernel::{Subtask, SubtaskResult};

/// Carries out subtasks.
pub(super) trait Carrier: Send {
    /// All of them. What starting could refuse was refused for the run itself; a failure now finds nothing.
    fn whole(&self, subtasks: &[Subtask]) -> Vec<SubtaskResult>;
    /// A part of those of an iteration; what they found when all are carried out.
    fn part(&mut self, iteration: u64, subtasks: &[Subtask]) -> Option<Vec<SubtaskResult>>;
}

/// What the subtasks of a run found, in the order of the iterations whose steps they were for.
pub(super) struct Answers {
    found: Vec<(u64, Vec<SubtaskResult>)>,
    /// They are kept for the way back; otherwise until they are used.
    kept: bool,
    /// Who carries them out, if anybody does.
    carrier: Option<Box<dyn Carrier>>,
}

impl Answers {
    pub(super) fn new(kept: bool, carrier: Option<Box<dyn Carrier>>) -> Self {
        Self { found: Vec::new(), kept, carrier }
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

    /// What is known to have been found for an iteration.
    fn known(&mut self, iteration: u64) -> Option<Vec<SubtaskResult>> {
        let at = self.place(iteration).ok()?;
        Some(if self.kept { self.found[at].1.clone() } else { self.found.remove(at).1 })
    }

    /// What these subtasks of an iteration find.
    pub(super) fn of(&mut self, iteration: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult> {
        self.known(iteration).unwrap_or_else(|| {
            let found = self.carrier.as_ref().map_or_else(Vec::new, |carrier| carrier.whole(subtasks));
            self.found_now(iteration, found)
        })
    }

    /// The same, a part at a time: `None` if there is more to do.
    pub(super) fn part_of(&mut self, iteration: u64, subtasks: &[Subtask]) -> Option<Vec<SubtaskResult>> {
        let known = self.known(iteration);
        if known.is_some() {
            return known;
        }
        let found = match &mut self.carrier {
            Some(carrier) => carrier.part(iteration, subtasks)?,
            None => Vec::new(),
        };
        Some(self.found_now(iteration, found))
    }

    fn found_now(&mut self, iteration: u64, found: Vec<SubtaskResult>) -> Vec<SubtaskResult> {
        if self.kept {
            self.keep(iteration, found.clone());
        }
        found
    }
}
