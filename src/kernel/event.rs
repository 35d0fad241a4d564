//! What happened in a run in simulated time.

use serde::Serialize;

use super::State;

/// Something that happened in a run in simulated time, or that was decided, and why.
#[derive(Debug, Clone, PartialEq, Serialize, State)]
pub struct Event {
    /// The iteration after which it is known.
    pub iteration: u64,
    /// When, in seconds of simulated time.
    pub time: f64,
    /// Where the robot was, in the scene's unit.
    pub place: [f64; 2],
    /// What: one of the entry's `events`.
    pub kind: &'static str,
    /// The number of the moving obstacle that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub obstacle: Option<usize>,
    /// Why, in a sentence.
    pub reason: String,
}
