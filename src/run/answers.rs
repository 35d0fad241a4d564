//! What the subtasks of a run found, kept for the way back.

use crate::kernel::{Answer, State, Subtask, SubtaskResult, Subtasks};

/// Carries out subtasks. What starting could refuse was refused for the run itself; a failure now finds nothing.
pub(super) trait SubtaskRunner: Send {
    /// Carries out those of an iteration, or what is left of them.
    fn complete(&mut self, iteration: u64, subtasks: &[Subtask]) -> Vec<SubtaskResult>;
    /// Whether those of an iteration have begun and are not over.
    fn is_under_way(&self, iteration: u64) -> bool;
    /// Begins those of an iteration; others that have begun are given up.
    fn begin(&mut self, iteration: u64, subtasks: Vec<Subtask>);
    /// Carries out a part of those that have begun; what they found when all are carried out.
    fn part(&mut self) -> Option<Vec<SubtaskResult>>;
}

/// What the subtasks of a run found, in the order of the iterations whose steps they were for.
pub(super) struct Answers {
    found: Vec<(u64, Vec<SubtaskResult>)>,
    /// The memory that they take, in bytes, and how much they may: the earliest are dropped first, and carried out again on the way
    /// back. With 0 they are kept until they are used.
    bytes: usize,
    budget: usize,
    /// Who carries them out, if anybody does.
    runner: Option<Box<dyn SubtaskRunner>>,
}

impl Answers {
    pub(super) fn new(budget: usize, runner: Option<Box<dyn SubtaskRunner>>) -> Self {
        Self { found: Vec::new(), bytes: 0, budget, runner }
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
            let found = self.runner.as_mut().map_or_else(Vec::new, |runner| runner.complete(iteration, subtasks));
            self.found_now(iteration, found)
        })
    }

    /// The same, a part at a time. The requests are made once, when the first of them begins.
    pub(super) fn part_of(&mut self, iteration: u64, subtasks: &dyn Subtasks) -> Answer {
        if let Some(known) = self.known(iteration) {
            return Answer::Found(known);
        }
        let is_under_way = self.runner.as_ref().is_some_and(|runner| runner.is_under_way(iteration));
        if !is_under_way {
            let requests = subtasks.requests();
            if requests.is_empty() {
                return Answer::Unneeded;
            }
            if let Some(runner) = &mut self.runner {
                runner.begin(iteration, requests);
            }
        }
        match self.runner.as_mut().map_or_else(|| Some(Vec::new()), |runner| runner.part()) {
            Some(found) => Answer::Found(self.found_now(iteration, found)),
            None => Answer::Partly,
        }
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

    /// A step that needs no subtasks.
    struct NoRequests;

    impl Subtasks for NoRequests {
        fn requests(&self) -> Vec<Subtask> {
            Vec::new()
        }

        fn provide(&mut self, _: Vec<SubtaskResult>) {}
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
        assert_eq!((answers.part_of(3, &NoRequests), answers.knows(3), answers.bytes), (Answer::Found(found(10)), false, 0));
    }
}
