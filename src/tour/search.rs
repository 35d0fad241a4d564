//! How a planner searches the order of the stops.

use std::sync::Arc;

use crate::{
    kernel::{Inspection, Label, Progress, Readings, State, rng::Stream},
    params::Parameters,
};

use super::problem::{Problem, Tour};

/// How a planner searches the order of the stops: an own one is a planner by [`start`](super::start). It evaluates its first tours when
/// it begins; where that takes long, the rest of them in its first parts. It may have members: tours that it improves side by side.
/// Roads, drawing, readings and explanations that hold for every tour come without it.
pub trait Search: State + CopySearch + Send {
    /// Takes one step, or a part of one that is long: then [`Search::progress`] is [`Progress::Partly`] until it is over, see
    /// [`Part`](crate::kernel::Part).
    fn step(&mut self);
    /// Whether it has something left to do.
    fn progress(&self) -> Progress {
        Progress::Continue
    }
    /// How many tours it has evaluated.
    fn evaluations(&self) -> u64;
    /// The shortest tour so far; settled, see [`Tour::settle`].
    fn best(&self) -> Option<&Tour>;
    /// How many search side by side.
    fn members(&self) -> usize {
        0
    }
    /// The tour of one of them.
    fn member(&self, _i: usize) -> Option<&Tour> {
        None
    }
    /// Its stream of random numbers, so that a step can be supposed with others; `None`: it draws none.
    fn rng(&mut self) -> Option<&mut Stream> {
        None
    }
    /// What can be supposed of a member's last step besides other random numbers.
    fn suppositions(&self, _i: usize) -> Vec<Label> {
        Vec::new()
    }
    /// Lets one of these be so in the next step, for this member alone.
    fn suppose(&mut self, _i: usize, _supposition: &str) {}
    /// Adds numbers of its own to the readings.
    fn read(&self, _out: &mut Readings) {}
    /// Adds a member's numbers, those of the entry's `members` in their order.
    fn read_member(&self, _i: usize, _out: &mut Vec<f64>) {}
    /// What a member did in the last step: completes the explanation that every tour has (its title, its order compared with the best).
    fn explain(&self, _i: usize, _told: &mut Inspection) {}
}

/// Copies a boxed search. Every search that can be cloned has it.
pub trait CopySearch {
    /// A copy of the whole state.
    fn copy(&self) -> Box<dyn Search>;
}

impl<S: Search + Clone + 'static> CopySearch for S {
    fn copy(&self) -> Box<dyn Search> {
        Box::new(self.clone())
    }
}

impl Clone for Box<dyn Search> {
    fn clone(&self) -> Self {
        (**self).copy()
    }
}

/// How a search begins: with the problem, the parameters, and its stream of random numbers.
pub type Begin = fn(&Arc<Problem>, &Parameters, Stream) -> Box<dyn Search>;

/// The mean length of the tours of those that search side by side.
pub(super) fn mean(search: &dyn Search) -> f64 {
    lengths(search).sum::<f64>() / search.members() as f64
}

/// How many members are a part of a step, if one takes so many steps of a loop.
pub(super) fn portion(work: usize) -> usize {
    200_000 / work.max(1)
}

pub(super) fn lengths(search: &dyn Search) -> impl Iterator<Item = f64> {
    (0..search.members()).filter_map(|i| search.member(i)).map(|tour| tour.length)
}
