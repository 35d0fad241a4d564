//! What can happen in a run in simulated time.

use serde::Serialize;

/// A kind of event in simulated time.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct EventKind {
    /// An identifier.
    pub name: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it means.
    pub help: &'static str,
    /// How it is to be taken.
    pub tone: Tone,
}

/// How an event is to be taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Tone {
    /// Something came about.
    Plain,
    /// Something was seen or foreseen that calls for a decision.
    Warning,
    /// A decision.
    Decision,
    /// Something went as it should.
    Good,
    /// Something must not happen and did.
    Bad,
}
