//! An iterated local search: kicks and repairs.

use std::sync::Arc;

use super::{
    local::LocalSearch,
    problem::{Problem, Stop, Tour},
};
use crate::kernel::{State, rng::Stream};

/// A tour that is kicked and repaired again and again: an iterated local search (Lourenço, Martin and Stützle 2003).
#[derive(Debug, Clone, State)]
pub struct Kicks {
    #[state(shared)]
    problem: Arc<Problem>,
    local: LocalSearch,
    row: Vec<Stop>,
    /// As before the kick.
    #[state(skip)]
    kept: LocalSearch,
    #[state(skip)]
    kept_row: Vec<Stop>,
    /// Kicks so far.
    made: u64,
}

impl Kicks {
    /// For tours of a problem.
    pub fn new(problem: &Arc<Problem>) -> Self {
        let local = LocalSearch::new(problem);
        let row = Tour::first(problem).row;
        Self { made: 0, problem: Arc::clone(problem), kept: local.clone(), local, kept_row: row.clone(), row }
    }

    /// See [`LocalSearch::polish`].
    pub fn polish(&mut self, tour: &mut Tour) {
        self.local.polish(tour);
    }

    /// Kicks a tour so often; what a kick and the moves after it made longer is undone.
    pub fn improve(&mut self, tour: &mut Tour, kicks: usize, rng: &mut Stream) {
        self.made += kicks as u64;
        let Self { local, row, kept, kept_row, .. } = self;
        row.copy_from_slice(&tour.row);
        local.load(row);
        kept.copy_from(local);
        kept_row.copy_from_slice(row);
        for _ in 0..kicks {
            let added = local.kick(row, rng);
            // Equally long tours are taken: they lead away from where it has been.
            if added - local.descend(row) <= 0.0 {
                kept.copy_from(local);
                kept_row.copy_from_slice(row);
            } else {
                local.copy_from(kept);
                row.copy_from_slice(kept_row);
            }
        }
        tour.row.copy_from_slice(kept_row);
        tour.settle(&self.problem);
    }

    /// How many moves and kicks it has measured so far.
    pub fn tried(&self) -> u64 {
        self.local.tried() + self.made
    }
}
