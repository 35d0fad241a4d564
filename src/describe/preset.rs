//! A preset: a named set of parameters.

use serde::{Serialize, Serializer};

use crate::{
    kernel::words,
    params::{Fixed, Object, Overrides, Value},
};

/// The name of the preset for pairwise paths between stops: sizes with which 66 runs take seconds.
pub const ROAD: &str = "road";

/// The name of the preset with the parameters of a planner's paper.
pub const PAPER: &str = "paper";

/// A preset: a named set of parameters.
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Preset {
    /// The name in commands: `paper`, `fitted`.
    pub name: &'static str,
    /// The title, e.g. As in the text.
    pub title: &'static str,
    /// What it is for, and what it is based on.
    pub help: &'static str,
    /// A shipped scene on which to try it.
    #[cfg_attr(feature = "types", ts(type = "SceneName"))]
    pub scene: &'static str,
    /// The values that differ from the defaults.
    #[serde(rename = "params", serialize_with = "fixed")]
    #[cfg_attr(feature = "types", ts(type = "Record<string, ParameterValue>"))]
    pub values: &'static [(&'static str, Fixed)],
}

pub(super) fn fixed<S: Serializer>(values: &[(&'static str, Fixed)], serializer: S) -> Result<S::Ok, S::Error> {
    Object(&values.iter().map(|&(name, value)| (name, Value::from(value))).collect::<Vec<_>>()).serialize(serializer)
}

/// Fixed values as overrides.
pub(super) fn overrides(values: &[(&'static str, Fixed)]) -> Overrides {
    values.iter().map(|&(name, value)| (name, Value::from(value))).collect()
}

impl Preset {
    /// A preset with its name, title, help text, the scene to try it on, and its values.
    pub const fn new(
        name: &'static str,
        title: &'static str,
        help: &'static str,
        scene: &'static str,
        values: &'static [(&'static str, Fixed)],
    ) -> Self {
        Self { name, title: words(title), help: words(help), scene: words(scene), values }
    }

    /// The values as overrides.
    pub fn given(&self) -> Overrides {
        overrides(self.values)
    }
}
