//! What a kind of scene must be able to do. A kind is a type that implements [`SceneBody`], and an id.
//!
//! Only what every scene is asked for is a method here. Readers, exact optima, file formats, generators and followers name
//! a kind by its id instead, so that a build without them does not contain them.

use std::{any::Any, sync::Arc};

use serde::Serialize;
use serde_json::Value;

use crate::geometry::{Bounds, Disc, YAxis};

use super::{Error, Solution};

/// Which kind a scene is of: the name that scene files use, e.g. `grid`. Entries say which kinds they are for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct SceneKindId(pub &'static str);

impl SceneKindId {
    /// The name that scene files use.
    pub const fn name(self) -> &'static str {
        self.0
    }
}

/// How good a solution really is, whatever cost the planner gave it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// The path's length; `None` where there is no path.
    pub length: Option<f64>,
    /// It breaks nothing.
    pub feasible: bool,
    /// The smallest distance to an obstacle, negative inside; `None` without obstacles.
    pub clearance: Option<f64>,
}

impl Verdict {
    /// Of a solution that is no path here, so that it breaks nothing.
    pub const NO_PATH: Self = Self { length: None, feasible: true, clearance: None };
}

/// The content of a scene: where something is planned, and what a solution is worth there.
///
/// It does not change once it is in a [`Scene`](super::Scene).
pub trait SceneBody: Any + Send + Sync {
    /// The kind that this type stands for.
    fn kind_id() -> SceneKindId
    where
        Self: Sized;

    /// The kind of this body: [`SceneBody::kind_id`] of its type.
    fn kind(&self) -> SceneKindId;

    /// Refuses a body that is not valid; `stored` is the optimum that the scene's file gives.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong.
    fn check(&self, stored: Option<&Value>) -> Result<(), Error>;

    /// Measures and checks a solution. [`Verdict::NO_PATH`] for what means nothing here.
    fn judge(&self, solution: &Solution) -> Verdict;

    /// The part of the plane that a picture should show.
    fn view(&self) -> Bounds;

    /// Adds its fields in the order in which a file lists them. Two bodies that write the same are equal.
    fn write(&self, out: &mut Vec<(&'static str, Value)>);

    /// What lies under all layers of a picture, piece by piece from bottom to top.
    fn backdrop(&self, _draw: &mut dyn FnMut(Backdrop)) {}

    /// The plane with obstacles that paths lead through, if it is one.
    fn plane(&self) -> Option<&dyn Plane> {
        None
    }

    /// Where a tour calls.
    fn stops(&self) -> Stops {
        Stops { field: "stops", places: Vec::new() }
    }

    /// The least value of a function to minimise; `None` where it is a path that is looked for.
    fn minimum(&self) -> Option<f64> {
        None
    }

    /// The same with another start and goal.
    ///
    /// # Errors
    /// [`Error::Refused`] for a kind that cannot change them; of those that ship, grids can.
    fn between(&self, _ends: [[f64; 2]; 2]) -> Result<Arc<dyn SceneBody>, Error> {
        Err(Error::refused("kind", self.kind().name(), "grid"))
    }
}

/// A plane with obstacles, and paths through it.
pub trait Plane: Send + Sync {
    /// Where a path begins, and where it must lead.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is missing, where there are only stops.
    fn ends(&self) -> Result<([f64; 2], [f64; 2]), Error>;

    /// Where corners of a path may lie.
    fn bounds(&self) -> Bounds;

    /// Whether the robot can go straight from one point to another; it may touch.
    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool;

    /// Which way y grows in pictures.
    fn y_axis(&self) -> YAxis {
        YAxis::Up
    }
}

/// Where a tour calls.
#[derive(Debug, Clone, PartialEq)]
pub struct Stops {
    /// The field of the scene's file that lists them.
    pub field: &'static str,
    /// Where they are; empty where there are none.
    pub places: Vec<[f64; 2]>,
}

/// A piece of what lies under all layers, in the scene's unit.
#[derive(Debug, Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum Backdrop {
    /// The border of what is planned in.
    Border(Bounds),
    /// A disc in the way.
    Disc(Disc),
    /// A box in the way, with its outline.
    Block(Bounds),
    /// Blocked cells, which join their neighbours without an outline between them.
    Cells(Bounds),
    /// How near to a box the robot's centre cannot come: the box and this distance around it, round at the corners.
    Margin(Bounds, f64),
}
