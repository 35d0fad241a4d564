//! Scenes of kind `tour`: stops to call at, as points in the plane or as a matrix of distances.

use std::sync::{Arc, OnceLock};

use serde_json::Value;

use crate::{
    error::Error,
    exact::{Exact, shortest_tour},
    math,
    planner::{Round, Solution},
};

use super::{Bounds, Distances, Metric, Verdict, coordinate};

/// The most stops of a tour.
pub const MAX_STOPS: usize = 2000;

/// Stops to call at.
#[derive(Debug, Clone)]
pub struct TourScene {
    /// Where the stops are; empty if only their distances are known.
    pub points: Vec<[f64; 2]>,
    /// How far it is from one to another, if no matrix says it.
    pub metric: Metric,
    /// The distances, if they are given.
    pub matrix: Option<Arc<Distances>>,
    /// Whether a tour goes back to where it began.
    pub closed: bool,
    derived: OnceLock<Arc<Distances>>,
}

impl PartialEq for TourScene {
    fn eq(&self, other: &Self) -> bool {
        self.points == other.points && self.metric == other.metric && self.matrix == other.matrix && self.closed == other.closed
    }
}

impl TourScene {
    /// Closed tours through points.
    pub fn through(points: Vec<[f64; 2]>, metric: Metric) -> Self {
        Self { points, metric, matrix: None, closed: true, derived: OnceLock::new() }
    }

    /// Closed tours by given distances; `points` are for pictures, and may be empty.
    pub fn by(matrix: Distances, points: Vec<[f64; 2]>) -> Self {
        Self { points, metric: Metric::default(), matrix: Some(Arc::new(matrix)), closed: true, derived: OnceLock::new() }
    }

    /// How many stops.
    pub fn len(&self) -> usize {
        self.matrix.as_ref().map_or(self.points.len(), |matrix| matrix.len())
    }

    /// Whether there are none; a scene that exists has two at least.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The distances of all stops.
    pub fn distances(&self) -> &Arc<Distances> {
        let computed = || {
            self.derived
                .get_or_init(|| Arc::new(Distances::of(self.points.len(), |i, j| self.metric.distance(self.points[i], self.points[j]))))
        };
        self.matrix.as_ref().unwrap_or_else(computed)
    }

    /// Where each stop is drawn; of stops without a place, evenly on a circle.
    pub fn places(&self) -> Vec<[f64; 2]> {
        if !self.points.is_empty() {
            return self.points.clone();
        }
        let n = self.len();
        let turn = |i: usize, quarter: f64| math::cos_turns(i as f64 / n as f64 + quarter);
        (0..n).map(|i| [turn(i, -0.25), turn(i, 0.0)]).collect()
    }

    /// What a tour's ends are unless a planner is told otherwise.
    pub fn round(&self) -> Round {
        if self.closed { Round::Closed } else { Round::Open }
    }

    pub(super) fn check(&self) -> Result<(), Error> {
        let field = if self.matrix.is_some() { "matrix" } else { "points" };
        let n = self.len();
        if !(2..=MAX_STOPS).contains(&n) {
            return Err(Error::refused(field, format!("a list of {n}"), format!("2 to {MAX_STOPS} stops")));
        }
        if !self.points.is_empty() && self.points.len() != n {
            return Err(Error::refused(
                "points",
                format!("a list of {}", self.points.len()),
                format!("left out, or {n}: a point for each row"),
            ));
        }
        for (i, &point) in self.points.iter().enumerate() {
            (0..2).try_for_each(|axis| coordinate(&format!("points[{i}]"), point, axis))?;
        }
        Ok(())
    }

    /// All places, with a margin.
    pub(super) fn view(&self) -> Bounds {
        let mut bounds = Bounds { min: [f64::INFINITY; 2], max: [f64::NEG_INFINITY; 2] };
        for place in self.places() {
            for (axis, c) in place.into_iter().enumerate() {
                bounds.min[axis] = bounds.min[axis].min(c);
                bounds.max[axis] = bounds.max[axis].max(c);
            }
        }
        let side = (bounds.max[0] - bounds.min[0]).max(bounds.max[1] - bounds.min[1]);
        let margin = if side > 0.0 { 0.05 * side } else { 1.0 };
        Bounds { min: bounds.min.map(|c| c - margin), max: bounds.max.map(|c| c + margin) }
    }

    /// The shortest tour; of more stops than can be computed the one that the file gives, if it has the scene's own ends.
    pub(super) fn exact_tour(&self, round: Round, stored: Option<&Value>) -> Option<Exact> {
        let places = self.places();
        let path = |order: &[usize]| {
            let back = order.first().filter(|_| round.closes());
            order.iter().chain(back).map(|&stop| places[stop]).collect::<Vec<_>>()
        };
        if let Some((order, length)) = shortest_tour(self.distances(), round) {
            return Some(Exact { length, path: path(&order), order, stored: false });
        }
        let stored = stored.filter(|_| round == self.round())?;
        let order: Option<Vec<usize>> = stored
            .get("order")
            .and_then(Value::as_array)
            .map(|order| order.iter().map(|stop| stop.as_f64().map_or(usize::MAX, |stop| stop as usize)).collect());
        // What the file claims counts only as far as it can be checked: an order has the length that it has.
        match order.filter(|order| round.allows(order, self.len())) {
            Some(order) => Some(Exact { length: self.distances().length(&order, round.closes()), path: path(&order), order, stored: true }),
            None => stored.get("length").and_then(Value::as_f64).map(|length| Exact { stored: true, ..Exact::way(length, Vec::new()) }),
        }
    }

    pub(super) fn judge(&self, solution: &Solution) -> Verdict {
        let Solution::Tour { order, round, .. } = solution else {
            return Verdict { length: None, feasible: true, clearance: None };
        };
        let feasible = round.allows(order, self.len());
        let length = feasible.then(|| self.distances().length(order, round.closes()));
        Verdict { length, feasible, clearance: None }
    }
}
