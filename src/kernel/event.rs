//! Events of a run in simulated time.

use serde::Serialize;

use super::{Message, State};

/// An event in simulated time: what happened or was decided, and why.
#[derive(Debug, Clone, PartialEq, Serialize, State)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "RunEvent"))]
pub struct Event {
    /// The iteration after which it is known.
    pub iteration: u64,
    /// The simulated time, in seconds.
    pub time: f64,
    /// The robot's position, in the scene's unit.
    pub place: [f64; 2],
    /// The name of its kind, one of the entry's `events`.
    pub kind: &'static str,
    /// The index of the moving obstacle that it is about.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    pub obstacle: Option<usize>,
    /// The reason, in a sentence. It follows from the rest, so that no hash depends on its words.
    #[state(skip)]
    pub reason: Message,
}
