//! Long steps in parts.

use std::ops::Range;

use super::{Progress, State};

/// How much of a long step is done. A planner whose step may take longer than a tenth of a second does a part of it at a time, where its
/// work can be divided, and returns [`Progress::Partly`] until the step is over: so it can be interrupted. The result is the same
/// whatever the parts; a planner keeps this as `#[state(skip)]`.
///
/// ```
/// # use forage::kernel::{Part, Progress};
/// # struct Planner { part: Part, members: Vec<f64> }
/// # impl Planner {
/// fn advance(&mut self) -> Progress {
///     for i in self.part.take(1000, self.members.len()) {
///         self.members[i] += 1.0;
///     }
///     self.part.progress()
/// }
/// # }
/// # let mut planner = Planner { part: Part::default(), members: vec![0.0; 2500] };
/// assert_eq!([(); 3].map(|()| planner.advance()), [Progress::Partly, Progress::Partly, Progress::Continue]);
/// assert_eq!(planner.members, [1.0; 2500]);
/// ```
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, State)]
pub struct Part {
    done: usize,
}

impl Part {
    /// The next `most` (one at least) of a step's `all` pieces of work. With the last of them the step is over: the next call begins
    /// another one.
    #[inline]
    pub fn take(&mut self, most: usize, all: usize) -> Range<usize> {
        let from = self.done.min(all);
        let to = from.saturating_add(Self::at_most(most)).min(all);
        self.done = if to == all { 0 } else { to };
        from..to
    }

    /// How many pieces of work are a part, if so many may be; tests make them smaller.
    #[inline]
    pub(crate) fn at_most(most: usize) -> usize {
        #[cfg(not(target_arch = "wasm32"))]
        let most = most.min(MOST.get());
        most.max(1)
    }

    /// Whether a step has begun and is not over.
    #[inline]
    pub fn is_under_way(self) -> bool {
        self.done > 0
    }

    /// What the planner says of it.
    pub fn progress(self) -> Progress {
        if self.is_under_way() { Progress::Partly } else { Progress::Continue }
    }
}

#[cfg(not(target_arch = "wasm32"))]
pub(crate) use limit::{MOST, with_parts_of};

/// How large parts are in tests: only small ones show that a result does not depend on them.
#[cfg(not(target_arch = "wasm32"))]
mod limit {
    use std::cell::Cell;

    thread_local! {
        /// The largest part that this thread's planners take.
        pub(crate) static MOST: Cell<usize> = const { Cell::new(usize::MAX) };
    }

    /// Does something with parts of at most `most` pieces of work, on this thread.
    pub(crate) fn with_parts_of<T>(most: usize, work: impl FnOnce() -> T) -> T {
        /// Ends the limit after a panic as well, which the conformance suite survives.
        struct Before(usize);
        impl Drop for Before {
            fn drop(&mut self) {
                MOST.set(self.0);
            }
        }
        let _before = Before(MOST.replace(most));
        work()
    }
}
