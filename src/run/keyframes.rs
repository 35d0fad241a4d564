//! Copies of past states, thinned as history grows so that they stay under a budget.

use crate::kernel::Stepper;

/// States at multiples of a stride, in order.
pub(super) struct Keyframes {
    /// With the memory that each added when it was kept. What states share is counted with the first of them, and no more once
    /// that one is dropped: one copy at most of what does not change.
    states: Vec<(Stepper, usize)>,
    stride: u64,
    bytes: usize,
    budget: usize,
}

/// A state is kept every so many iterations to begin with: a step back then replays at most this many.
const STRIDE: u64 = 16;

impl Keyframes {
    pub(super) fn new(budget: usize) -> Self {
        Self { states: Vec::new(), stride: STRIDE, bytes: 0, budget }
    }

    /// Keeps a copy if the state is due and new. Iteration 0 is never kept: the run can always start again.
    pub(super) fn offer(&mut self, state: &Stepper) {
        let iteration = state.iteration;
        let newest = self.states.last().map_or(0, |(state, _)| state.iteration);
        if !iteration.is_multiple_of(self.stride) || iteration <= newest {
            return;
        }
        let bytes = state.size();
        if bytes > self.budget {
            return;
        }
        while self.bytes + bytes > self.budget {
            self.stride *= 2;
            let stride = self.stride;
            self.states.retain(|(state, _)| state.iteration.is_multiple_of(stride));
            self.bytes = self.states.iter().map(|(_, bytes)| bytes).sum();
            if !iteration.is_multiple_of(stride) {
                return;
            }
        }
        self.bytes += bytes;
        self.states.push((state.clone(), bytes));
    }

    /// The latest kept state at or before iteration `k`.
    pub(super) fn at_or_before(&self, k: u64) -> Option<&Stepper> {
        let after = self.states.partition_point(|(state, _)| state.iteration <= k);
        self.states.get(after.checked_sub(1)?).map(|(state, _)| state)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Run, Setup, shipped, standard};

    fn state(iteration: u64) -> Stepper {
        let setup = Setup { planner: "pso".into(), scene: shipped("sphere").unwrap(), params: crate::Overrides::default(), seed: 1 };
        let mut run = Run::with_keyframes(standard(), setup, 0).unwrap();
        run.step(iteration);
        run.at
    }

    #[test]
    fn memory_stays_under_the_budget_while_history_grows() {
        let size = state(0).size();
        let mut keyframes = Keyframes::new(10 * size);
        let mut run = state(0);
        for _ in 0..900 {
            run.step(|_| Vec::new());
            keyframes.offer(&run);
            assert!(keyframes.states.len() <= 10 && keyframes.bytes <= 10 * size);
        }
        assert!(keyframes.states.len() >= 5, "thinning must not throw nearly all away");
        let at = keyframes.at_or_before(500).unwrap().iteration;
        assert!(at <= 500 && at > 300);
        assert!(keyframes.at_or_before(0).is_none());
    }

    #[test]
    fn a_state_larger_than_the_budget_is_not_kept() {
        let mut keyframes = Keyframes::new(10);
        keyframes.offer(&state(STRIDE));
        assert!(keyframes.states.is_empty());
    }
}
