//! How many iterations a swarm has taken and when it stops.

use crate::{
    kernel::{Planner, Progress, Started, State, Status},
    params::Parameters,
};

use super::{parameters::ITERATIONS, paths::EARLY_STOP};

/// The iterations of a run, and its two reasons to stop.
#[derive(Debug, Clone, Copy, PartialEq, State)]
pub(super) struct Clock {
    pub(super) iteration: u64,
    #[state(shared)]
    pub(super) limit: u64,
    /// Stop when the best has not changed for this many iterations; 0: never.
    #[state(shared)]
    early_stop: u64,
    /// For how many iterations it has not.
    pub(super) unchanged: u64,
    best: [f64; 2],
}

impl Clock {
    /// With the settings `iterations` and `early_stop`; `best` are the best costs, with and without penalty, before the first
    /// iteration.
    pub(super) fn new(settings: &Parameters, best: [f64; 2]) -> Self {
        Self { iteration: 0, limit: settings[ITERATIONS], early_stop: settings[EARLY_STOP], unchanged: 0, best }
    }

    /// A run of a planner that stops by this clock.
    pub(super) fn start(self, planner: impl Planner) -> Started {
        let started = Started::new(planner, self.limit);
        if self.early_stop > 0 { started.open_ended() } else { started }
    }

    /// Counts an iteration that ended with these best costs, and says whether the best has stood still for too long.
    pub(super) fn tick(&mut self, best: [f64; 2]) -> Progress {
        self.iteration += 1;
        self.unchanged = if best[0] < self.best[0] || best[1] < self.best[1] { 0 } else { self.unchanged + 1 };
        self.best = best;
        let stops = self.early_stop > 0 && self.unchanged >= self.early_stop;
        if stops { Progress::Done(Status::Exhausted) } else { Progress::Continue }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_run_stops_when_the_best_has_stood_still() {
        let clock = |early_stop| Clock { iteration: 0, limit: 99, early_stop, unchanged: 0, best: [9.0, f64::INFINITY] };
        let run = |mut clock: Clock, costs: &[f64]| {
            let stops = costs.iter().position(|&cost| clock.tick([cost, f64::INFINITY]) != Progress::Continue);
            stops.map_or(costs.len(), |last| last + 1)
        };
        let costs = [9.0, 8.0, 8.0, 8.0, 7.0, 7.0, 7.0, 7.0];
        assert_eq!(run(clock(0), &costs), 8);
        assert_eq!(run(clock(1), &costs), 1, "the first iteration brought nothing");
        assert_eq!(run(clock(2), &costs), 4);
        assert_eq!(run(clock(3), &costs), 8);
        let mut clock = clock(1);
        assert_eq!(clock.tick([9.0, 12.0]), Progress::Continue, "what is reported got better");
    }
}
