//! A follower's entry: what is known of who follows a path, a robot or an arm, and the function that does.

use std::{any::Any, fmt, sync::Arc};

use serde::{Serialize, Serializer};
use serde_json::Value;

use crate::{
    kernel::{Error, Scene, SceneKindId, Solution, words},
    params::{Object, Overrides, Parameter, Parameters},
};

use super::Formula;

/// A follower's entry: how a robot drives along a path, or an arm moves.
#[derive(Debug, Clone, Copy)]
pub struct Follower {
    /// The name in commands, outcomes and the catalogue.
    pub name: &'static str,
    /// A few words: `How a robot drives along a path`.
    pub title: &'static str,
    /// The kind of scenes that it is for.
    pub kind: SceneKindId,
    /// What it needs there, for a message: `a scene with an arm`.
    pub needs: &'static str,
    /// Whether a scene has that.
    pub applies: fn(&Scene) -> bool,
    /// Where it comes from.
    pub source: &'static str,
    /// A summary in one or two sentences.
    pub summary: &'static str,
    /// Its parameters, in lists.
    pub parameters: &'static [&'static [Parameter]],
    /// The numbers that are recorded for each moment.
    pub columns: &'static [Column],
    /// The equations that it computes.
    pub formulas: &'static [Formula],
    /// Follows a solution; `None` where it does not apply, and without a path. Refuses parameters in any case.
    pub follow: Follow,
}

/// Follows a solution in a scene, with these parameters.
pub type Follow = fn(&Scene, Option<&Solution>, &Overrides) -> Result<Option<Box<dyn FollowedPath>>, Error>;

/// A number that is recorded for each moment of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "DriveColumn"))]
pub struct Column {
    /// An identifier.
    pub name: &'static str,
    /// The title, a few words.
    pub title: &'static str,
    /// The symbol, in TeX.
    pub symbol: &'static str,
    /// The unit: `s`, `m`, `rad/s`, …; empty for a bare number. `m` means the scene's unit.
    pub unit: &'static str,
}

impl Column {
    /// A number with its name, symbol, title and unit.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, unit: &'static str) -> Self {
        Self { name, title: words(title), symbol: words(symbol), unit }
    }
}

/// A path that was followed, moment by moment.
pub trait FollowedPath: Any + Send {
    /// The columns' numbers for each moment, row by row.
    fn rows(&self) -> &[f64];
    /// How it went.
    fn outcome(&self) -> Arc<dyn FollowOutcome>;
    /// Every parameter's value.
    fn parameters(&self) -> &Parameters;
    /// What else a drawing of it needs, by name.
    fn extra(&self) -> Vec<(&'static str, Extra<'_>)>;
}

impl fmt::Debug for dyn FollowedPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.outcome().fmt(f)
    }
}

/// Something that a drawing needs.
#[derive(Debug, Clone, PartialEq)]
pub enum Extra<'a> {
    /// Numbers, so many for each moment.
    Rows(&'a [f64]),
    /// Numbers by name.
    Named(Vec<(&'static str, f64)>),
}

/// How following a path went.
pub trait FollowOutcome: Any + Send + Sync {
    /// All there is to say, as `forage run --json` prints it.
    fn fields(&self) -> Vec<(&'static str, Value)>;
}

impl fmt::Debug for dyn FollowOutcome {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(self.fields()).finish()
    }
}

impl Serialize for dyn FollowOutcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        Object(&self.fields()).serialize(serializer)
    }
}

/// How the followers of a scene fared on a path.
#[derive(Debug, Clone, Default)]
pub struct FollowOutcomes(Vec<(&'static str, Arc<dyn FollowOutcome>)>);

impl FollowOutcomes {
    /// The outcome of this type, if there is one.
    pub fn get<T: FollowOutcome>(&self) -> Option<&T> {
        self.0.iter().find_map(|(_, outcome)| (&**outcome as &dyn Any).downcast_ref())
    }

    /// Puts the outcome of a follower in the place of the one that is there; `None` takes it away.
    pub fn set(&mut self, follower: &'static str, outcome: Option<Arc<dyn FollowOutcome>>) {
        self.0.retain(|(name, _)| *name != follower);
        self.0.extend(outcome.map(|outcome| (follower, outcome)));
    }

    /// Each with its follower's name.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, &dyn FollowOutcome)> {
        self.0.iter().map(|(name, outcome)| (*name, &**outcome))
    }
}
