//! What the subtasks of a run found, kept for the way back.

use crate::kernel::{State, Subtask, SubtaskResult};

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
    /// The memory that they take, in bytes, and how much they may: the earliest are dropped first, and carried out again on the way
    /// back. With 0 they are kept until they are used.
    bytes: usize,
    budget: usize,
    /// Who carries them out, if anybody does.
    carrier: Option<Box<dyn Carrier>>,
}

impl Answers {
    pub(super) fn new(budget: usize, carrier: Option<Box<dyn Carrier>>) -> Self {
        Self { found: Vec::new(), bytes: 0, budget, carrier }
    }

    /// Whether the subtasks of an iteration were carried out.
    pub(super) fn knows(&self, iteration: u64) -> bool {
        self.place(iteration).is_ok()
    }

    /// Takes what was found elsewhere.
    pub(super) fn keep(&mut self, iteration: u64, found: Vec<SubtaskResult>) {
        if let Ok(at) = self.place(iteration) {
            self.drop(at);
        }
        self.bytes += found.heap_size();
        let at = self.place(iteration).unwrap_or_else(|at| at);
        self.found.insert(at, (iteration, found));
        while self.bytes > self.budget
            && let Some(other) = (0..self.found.len()).find(|&other| self.found[other].0 != iteration)
        {
            self.drop(other);
        }
    }

    fn drop(&mut self, at: usize) -> Vec<SubtaskResult> {
        let (_, found) = self.found.remove(at);
        self.bytes -= found.heap_size();
        found
    }

    /// Where an iteration is, or belongs.
    fn place(&self, iteration: u64) -> Result<usize, usize> {
        self.found.binary_search_by_key(&iteration, |(known, _)| *known)
    }

    /// What is known to have been found for an iteration.
    fn known(&mut self, iteration: u64) -> Option<Vec<SubtaskResult>> {
        let at = self.place(iteration).ok()?;
        Some(if self.budget > 0 { self.found[at].1.clone() } else { self.drop(at) })
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
        if self.budget > 0 {
            self.keep(iteration, found.clone());
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn found(points: usize) -> Vec<SubtaskResult> {
        vec![SubtaskResult { cost: Some(1.0), converged: 1.0, path: vec![[0.0; 2]; points] }]
    }

    #[test]
    fn the_earliest_are_dropped_first_and_never_what_was_just_found() {
        let each = found(100).heap_size();
        let mut answers = Answers::new(3 * each, None);
        for iteration in [0, 1, 2, 3, 4] {
            answers.keep(iteration, found(100));
        }
        let known = |answers: &Answers| (0..6).filter(|&iteration| answers.knows(iteration)).collect::<Vec<_>>();
        assert_eq!((known(&answers), answers.bytes), (vec![2, 3, 4], 3 * each));
        answers.keep(0, found(100));
        assert_eq!(known(&answers), [0, 3, 4]);
        answers.keep(5, found(1000));
        assert_eq!(known(&answers), [5]);
        assert_eq!(answers.of(5, &[]), found(1000));
        assert!(answers.knows(5));
    }

    #[test]
    fn without_memory_they_are_kept_until_they_are_used() {
        let mut answers = Answers::new(0, None);
        answers.keep(3, found(10));
        assert_eq!((answers.part_of(3, &[]), answers.knows(3), answers.bytes), (Some(found(10)), false, 0));
    }
}
