//! The layers that a planner draws.

use serde::Serialize;

use crate::{
    kernel::{Role, SceneKindId},
    params::When,
};

/// A layer that a planner draws.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Layer {
    /// What it shows.
    pub role: Role,
    /// For a legend.
    pub title: &'static str,
    /// A sentence.
    pub help: &'static str,
    /// Drawn without being asked for.
    pub on: bool,
    /// Its pieces can be inspected.
    pub pickable: bool,
    /// A parameter's value without which there is nothing to draw.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub when: Option<When>,
    /// The kinds of scene on which there is something to draw; empty: all that the planner runs on.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub kinds: &'static [SceneKindId],
}

impl Layer {
    /// A layer that there is whatever the parameters are.
    pub const fn new(role: Role, title: &'static str, on: bool, pickable: bool, help: &'static str) -> Self {
        Self { role, title, help, on, pickable, when: None, kinds: &[] }
    }
}
