//! The contract of scene kinds. A kind is a type that implements [`SceneBody`], and an id.
//!
//! Only what every scene needs is a method here. Readers, exact optima, file formats, generators and followers name a kind by
//! its id instead, so that a build without them does not contain them.

use std::{any::Any, sync::Arc};

use serde::Serialize;
use serde_json::Value;

use crate::geometry::{Bounds, Disc, ObstacleField, YAxis};

use super::{Error, Message, Minimum, Solution};

/// The id of a scene kind: the name that scene files use, e.g. `grid`. Entries list the kinds that they are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Kind"))]
pub struct SceneKindId(pub &'static str);

impl SceneKindId {
    /// The name that scene files use.
    pub const fn name(self) -> &'static str {
        self.0
    }
}

/// The measured quality of a solution, whatever cost the planner gave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// The path's length, in the scene's unit; `None` if there is no path.
    pub length: Option<f64>,
    /// Whether it satisfies all constraints.
    pub feasible: bool,
    /// The smallest distance to an obstacle, in the scene's unit and negative inside; `None` without obstacles.
    pub clearance: Option<f64>,
}

impl Verdict {
    /// The verdict on a solution that is no path in this scene: it violates nothing.
    pub const NO_PATH: Self = Self { length: None, feasible: true, clearance: None };
}

/// The content of a scene of some kind, which also measures and checks solutions.
///
/// It does not change once it is in a [`Scene`](super::Scene).
pub trait SceneBody: Any + Send + Sync {
    /// The kind that this type implements.
    fn kind_id() -> SceneKindId
    where
        Self: Sized;

    /// The kind of this body: [`SceneBody::kind_id`] of its type.
    fn kind(&self) -> SceneKindId;

    /// Refuses invalid content; `stored` is the optimum stated in the scene file.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong.
    fn check(&self, stored: Option<&Value>) -> Result<(), Error>;

    /// Measures and checks a solution; [`Verdict::NO_PATH`] for a solution of another kind of scene.
    fn judge(&self, solution: &Solution) -> Verdict;

    /// The part of the plane that a picture should show.
    fn view(&self) -> Bounds;

    /// Adds its fields in the order in which a file lists them. Two bodies that write the same are equal.
    fn write(&self, out: &mut Vec<(&'static str, Value)>);

    /// Whether part of it is code, which neither a file nor a link can hold.
    fn is_code(&self) -> bool {
        false
    }

    /// Draws what lies under all layers of a picture, piece by piece from bottom to top.
    fn backdrop(&self, _draw: &mut dyn FnMut(Backdrop)) {}

    /// The plane with obstacles that paths lead through, if it is one.
    fn plane(&self) -> Option<&dyn Plane> {
        None
    }

    /// The stops of a tour.
    fn stops(&self) -> Stops {
        Stops { field: "stops", places: Vec::new() }
    }

    /// The minimum of a function; `None` for other kinds, and where it is not known.
    fn minimum(&self) -> Option<Minimum> {
        None
    }

    /// The same content with another start and goal.
    ///
    /// # Errors
    /// [`Error::Refused`] for a kind that cannot change them; of those that ship, grids can.
    fn between(&self, _ends: [[f64; 2]; 2]) -> Result<Arc<dyn SceneBody>, Error> {
        Err(Error::refused("kind", self.kind().name(), Message::verbatim("grid")))
    }
}

/// A plane with obstacles, and paths through it.
pub trait Plane: Send + Sync {
    /// Start and goal of a path.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is missing, where there are only stops.
    fn ends(&self) -> Result<([f64; 2], [f64; 2]), Error>;

    /// The region in which the corners of a path may lie.
    fn bounds(&self) -> Bounds;

    /// Whether the robot can go straight from one point to another; it may touch.
    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool;

    /// Its obstacles, for planners that let a path cut them at a price; `None` where that is not measured.
    fn obstacle_field(&self) -> Option<Arc<dyn ObstacleField>> {
        None
    }

    /// The direction in which y grows in pictures.
    fn y_axis(&self) -> YAxis {
        YAxis::Up
    }
}

/// The stops of a tour.
#[derive(Debug, Clone, PartialEq)]
pub struct Stops {
    /// The field of the scene file that lists them.
    pub field: &'static str,
    /// Their positions, in the scene's unit; empty if there are none.
    pub places: Vec<[f64; 2]>,
}

/// A piece of what lies under all layers, in the scene's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Backdrop {
    /// The border of the scene.
    Border(Bounds),
    /// A disc obstacle.
    Disc(Disc),
    /// A box obstacle with its outline.
    Block(Bounds),
    /// Blocked cells, which join their neighbours without an outline between them.
    Cells(Bounds),
    /// The region that the robot's centre cannot enter: a box and this distance around it, with round corners.
    Margin(Bounds, f64),
}
