//! What is wrong in a run, and what to do about it.

use crate::kernel::Error;

const START: &str = "Let `start` accept all that the entry allows, or narrow the parameters and kinds of scene in the entry.";

/// What is wrong in a run, at an iteration.
#[derive(Debug)]
pub struct Fault {
    pub found: String,
    pub remedy: &'static str,
    pub iteration: u64,
}

pub type Checked = Result<(), Fault>;

impl Fault {
    pub fn new(remedy: &'static str, found: impl Into<String>) -> Self {
        Self { found: found.into(), remedy, iteration: 0 }
    }

    /// The same, at the iteration where a run is.
    pub fn at(self, iteration: u64) -> Self {
        Self { iteration, ..self }
    }
}

/// A fault unless something holds.
pub fn ensure(holds: bool, remedy: &'static str, found: impl FnOnce() -> String) -> Checked {
    if holds { Ok(()) } else { Err(Fault::new(remedy, found())) }
}

/// `start` refuses what the entry allows.
pub fn refusal(error: &Error) -> Fault {
    Fault::new(START, format!("`start` refuses the run: {error}"))
}
