//! Kinds of events in simulated time.

use serde::Serialize;

use crate::kernel::words;

/// A kind of event in simulated time.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct EventKind {
    /// An identifier.
    pub name: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// What it means.
    pub help: &'static str,
    /// Its tone.
    #[cfg_attr(feature = "types", ts(inline))]
    pub tone: Tone,
}

impl EventKind {
    /// A kind of event with its name, title, tone and what it means.
    pub const fn new(name: &'static str, title: &'static str, tone: Tone, help: &'static str) -> Self {
        Self { name, title: words(title), help: words(help), tone }
    }
}

/// The tone of an event, which pictures show by colour and sign.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub enum Tone {
    /// Something happened.
    Plain,
    /// Something was detected or predicted that calls for a decision.
    Warning,
    /// A decision.
    Decision,
    /// Something went as intended.
    Good,
    /// Something happened that must not happen.
    Bad,
}
