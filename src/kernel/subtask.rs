//! Subtasks: runs of other planners that a step needs, and their results.

use serde::Serialize;
use serde_json::Value;

use crate::{geometry::Bounds, message, params::Overrides};

use super::{Error, Fields, State, fields};

/// Runs of other planners that a planner's steps need. The planner does not run them; its run does, one after another, in
/// parallel or elsewhere. The result is the same.
pub trait Subtasks {
    /// The runs that the next step needs; none if it needs none.
    fn requests(&self) -> Vec<Subtask>;
    /// Takes the results of these runs, in their order; the next step uses them.
    fn provide(&mut self, found: Vec<SubtaskResult>);
}

/// A run of another planner on the same scene that the next step needs.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(
    feature = "types",
    derive(ts_rs::TS),
    ts(rename = "Job", type = "Configured & { seed: number; /** Start and goal, if they are not the scene's. */ ends?: [Point, Point] }")
)]
pub struct Subtask {
    /// The planner's name.
    pub planner: &'static str,
    /// Parameters that differ from its defaults.
    pub params: Overrides,
    /// The seed.
    pub seed: u64,
    /// Start and goal, if they are not the scene's.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ends: Option<[[f64; 2]; 2]>,
}

/// The result of a [`Subtask`].
#[derive(Debug, Clone, PartialEq, Serialize, State)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Finding"))]
pub struct SubtaskResult {
    /// The best cost; `None` if nothing feasible was found.
    pub cost: Option<f64>,
    /// The iteration in which the best was found.
    pub converged: f64,
    /// The best path; empty if nothing feasible was found.
    pub path: Vec<[f64; 2]>,
}

impl SubtaskResult {
    /// Reads a list of results; `path` is the list's field.
    ///
    /// # Errors
    /// [`Error::Refused`] for anything else.
    pub fn read_list(path: &str, found: Value) -> Result<Vec<Self>, Error> {
        match found {
            Value::Array(found) => fields::each(path, found, Self::read),
            other => Err(Error::refused(path, fields::shown(&other), message!("error-list", "a list"))),
        }
    }

    /// The iteration may be missing where nothing was found.
    fn read(path: &str, found: Value) -> Result<Self, Error> {
        let mut fields = Fields::of(path, found, message!("error-finding", "an object with cost, converged and path"))?;
        let number = |fields: &mut Fields, name| match fields.take(name) {
            Value::Null => Ok(None),
            found => fields::number(fields.path(name), &found).map(Some),
        };
        let cost = number(&mut fields, "cost")?;
        let converged = number(&mut fields, "converged")?.unwrap_or(f64::NAN);
        let path = fields.points("path")?;
        fields.end()?;
        Ok(Self { cost, converged, path })
    }

    /// Refuses numbers that are not finite, and points outside the part of the plane in which the run is. `path` is its field.
    pub(crate) fn check(&self, path: &str, view: Bounds) -> Result<(), Error> {
        let finite = |name: &str, number: f64| {
            if number.is_finite() { Ok(()) } else { Err(Error::refused(format!("{path}.{name}"), number, super::error::finite())) }
        };
        if let Some(cost) = self.cost {
            finite("cost", cost)?;
            finite("converged", self.converged)?;
        }
        for (i, point) in self.path.iter().enumerate() {
            for (axis, &at) in point.iter().enumerate() {
                let (low, high) = (view.min[axis], view.max[axis]);
                // What is computed may round beyond the border.
                let slack = (high - low) * 1e-6;
                if !(low - slack..=high + slack).contains(&at) {
                    return Err(Error::refused(
                        format!("{path}.path[{i}][{axis}]"),
                        at,
                        message!("error-number-from-to", "a number from {low} to {high}", low, high),
                    ));
                }
            }
        }
        Ok(())
    }
}

/// Parameters that a tuning planner recommends for another planner.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(type = "Configured"))]
pub struct Recommendation {
    /// The planner that they are for.
    pub planner: &'static str,
    /// The parameters that were searched and those that were given.
    pub params: Overrides,
}
