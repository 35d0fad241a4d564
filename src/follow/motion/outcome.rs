//! What came of following a path.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    describe::{Extra, FollowOutcome, FollowedPath},
    kernel::Message,
    params::Parameters,
};

/// How the arm follows a path.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct MotionOutcome {
    /// Seconds from start to end.
    pub time: f64,
    /// How far the tip goes.
    pub length: f64,
    /// Every point of the path has a posture: the tip comes to the goal.
    pub arrived: bool,
    /// No link touches a cuboid or the column, all along: between the rows too.
    pub free: bool,
    /// When the first touch is.
    #[cfg_attr(feature = "types", ts(optional))]
    pub touched_at: Option<f64>,
    /// The smallest distance of a link from a cuboid at the rows; negative: overlap. `None` without cuboids.
    pub clearance: Option<f64>,
    /// The largest turn of a joint from one row to the next, in degrees.
    pub largest_step: f64,
    /// The largest distance of the tip from the path.
    pub max_error: f64,
    /// How many points had no posture and were replaced by their mirror image, [ARM-RRT](crate#papers) step 4.
    pub mirrored: u64,
    /// How many were replaced by random joints between their neighbours', [ARM-RRT](crate#papers) step 6.
    pub drawn: u64,
    /// Where it ends, and why, if it does not arrive; where the tip first leaves the path by more than a centimetre, if it does.
    #[cfg_attr(feature = "types", ts(optional, rename = "trouble", as = "Option<String>"))]
    pub failure: Option<Message>,
}

/// An arm following a path.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The columns' numbers for each moment.
    pub rows: Vec<f64>,
    /// Base, shoulder, elbow, wrist and tip, three numbers each, for each row.
    pub skeletons: Vec<f64>,
    /// How it went.
    pub outcome: MotionOutcome,
    /// Every parameter's value.
    pub parameters: Parameters,
}

impl FollowedPath for Motion {
    fn rows(&self) -> &[f64] {
        &self.rows
    }

    fn outcome(&self) -> Arc<dyn FollowOutcome> {
        Arc::new(self.outcome.clone())
    }

    fn parameters(&self) -> &Parameters {
        &self.parameters
    }

    fn extra(&self) -> Vec<(&'static str, Extra<'_>)> {
        vec![("skeletons", Extra::Rows(&self.skeletons))]
    }
}

impl FollowOutcome for MotionOutcome {
    fn fields(&self) -> Vec<(&'static str, Value)> {
        let mut fields = vec![
            ("time", Value::from(self.time)),
            ("length", self.length.into()),
            ("arrived", self.arrived.into()),
            ("free", self.free.into()),
            ("clearance", self.clearance.into()),
            ("largest_step", self.largest_step.into()),
            ("max_error", self.max_error.into()),
            ("mirrored", self.mirrored.into()),
            ("drawn", self.drawn.into()),
        ];
        fields.extend(self.touched_at.map(|time| ("touched_at", time.into())));
        fields.extend(self.failure.as_ref().map(|failure| ("trouble", failure.text().into())));
        fields
    }
}
