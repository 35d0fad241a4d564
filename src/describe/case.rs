//! A case: a run that shows something.

use serde::Serialize;

use crate::{
    kernel::words,
    params::{Fixed, Overrides},
};

use super::preset::{fixed, overrides};

/// A case: a planner on a shipped scene, with parameters and a seed with which there is something to see.
///
/// ```
/// use forage::describe::Case;
/// const MAZE: Case = Case::new("rooms", "Rooms", "Cells toward the goal are settled first.", "rooms-20", &[]).seed(3);
/// assert_eq!((MAZE.seed, MAZE.given().iter().count()), (3, 0));
/// ```
#[derive(Debug, Clone, Copy, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Case {
    /// Its name among the planner's cases.
    pub name: &'static str,
    /// Its title: a few plain words.
    pub title: &'static str,
    /// What there is to see, in one or two sentences.
    pub help: &'static str,
    /// A shipped scene.
    #[cfg_attr(feature = "types", ts(type = "SceneName"))]
    pub scene: &'static str,
    /// The seed.
    #[cfg_attr(feature = "types", ts(type = "number"))]
    pub seed: u64,
    /// The values that differ from the defaults.
    #[serde(rename = "params", serialize_with = "fixed")]
    #[cfg_attr(feature = "types", ts(type = "Record<string, ParameterValue>"))]
    pub values: &'static [(&'static str, Fixed)],
}

impl Case {
    /// A case with its name, its title, what there is to see, its scene, and values that differ from the defaults.
    pub const fn new(
        name: &'static str,
        title: &'static str,
        help: &'static str,
        scene: &'static str,
        values: &'static [(&'static str, Fixed)],
    ) -> Self {
        Self { name, title: words(title), help: words(help), scene, seed: 1, values }
    }

    /// The same with another seed than 1.
    #[must_use]
    pub const fn seed(self, seed: u64) -> Self {
        Self { seed, ..self }
    }

    /// The values as overrides.
    pub fn given(&self) -> Overrides {
        overrides(self.values)
    }
}
