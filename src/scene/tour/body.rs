//! Scenes of kind `tour`: stops to visit, as points in the plane or as a matrix of distances.

use std::sync::{Arc, OnceLock};

use serde_json::Value;

use crate::{
    exact::{Distances, MAX_MATRIX, Metric, shortest_tour},
    geometry::Bounds,
    kernel::{Error, Exact, Message, SceneKindId, Solution, TourEnds, Verdict, error::list_of, fields::shown},
    math, message,
    scene::check::up_to,
};

/// The id of the kind in scene files.
pub const ID: SceneKindId = SceneKindId("tour");

/// The largest number of stops of a tour.
pub const MAX_STOPS: usize = 100_000;
/// The largest coordinate of a stop: lengths of tours keep their digits.
pub const FARTHEST: f64 = 1e9;

/// A scene of stops to visit.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TourScene {
    /// The stops' positions; empty if only their distances are known.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<[f64; 2]>>"))]
    pub points: Vec<[f64; 2]>,
    /// The metric of their distances, unless `matrix` is given.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Metric>"))]
    pub metric: Metric,
    /// The distances, if they are given as a matrix.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<Vec<f64>>>"))]
    pub matrix: Option<Arc<Distances>>,
    /// Whether a tour returns to its first stop.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<bool>"))]
    pub closed: bool,
    /// Pairs of stops that follow each other in every tour, at no cost; only of at most [`MAX_MATRIX`] stops.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<[usize; 2]>>"))]
    pub fixed: Vec<[usize; 2]>,
    #[cfg_attr(feature = "types", ts(skip))]
    derived: OnceLock<Arc<Distances>>,
}

impl PartialEq for TourScene {
    fn eq(&self, other: &Self) -> bool {
        let key = |s: &Self| (s.metric, s.closed);
        key(self) == key(other) && self.points == other.points && self.matrix == other.matrix && self.fixed == other.fixed
    }
}

impl TourScene {
    /// Closed tours through points.
    pub fn through(points: Vec<[f64; 2]>, metric: Metric) -> Self {
        Self { points, metric, matrix: None, closed: true, fixed: Vec::new(), derived: OnceLock::new() }
    }

    /// Closed tours by given distances; `points` are for pictures, and may be empty.
    pub fn by(matrix: Distances, points: Vec<[f64; 2]>) -> Self {
        Self {
            points,
            metric: Metric::default(),
            matrix: Some(Arc::new(matrix)),
            closed: true,
            fixed: Vec::new(),
            derived: OnceLock::new(),
        }
    }

    /// The number of stops.
    pub fn len(&self) -> usize {
        self.matrix.as_ref().map_or(self.points.len(), |matrix| matrix.len())
    }

    /// Whether there are no stops; a valid scene has at least two.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// The distances of all stops, with the fixed edges.
    pub fn distances(&self) -> &Arc<Distances> {
        let computed = || {
            self.derived.get_or_init(|| {
                let between = |i: usize, j: usize| match &self.matrix {
                    Some(matrix) => matrix.between(i, j),
                    None => self.metric.distance(self.points[i], self.points[j]),
                };
                Arc::new(match self.len() {
                    n if n > MAX_MATRIX => Distances::through(&self.points, self.metric),
                    n => Distances::of(n, between).fixing(&self.fixed),
                })
            })
        };
        self.matrix.as_ref().filter(|_| self.fixed.is_empty()).unwrap_or_else(computed)
    }

    /// The position at which each stop is drawn; stops without positions are placed evenly on a circle.
    pub fn places(&self) -> Vec<[f64; 2]> {
        if !self.points.is_empty() {
            return self.points.clone();
        }
        let n = self.len();
        let turn = |i: usize, quarter: f64| math::cos_turns(i as f64 / n as f64 + quarter);
        (0..n).map(|i| [turn(i, -0.25), turn(i, 0.0)]).collect()
    }

    /// Where a tour begins and ends by default.
    pub fn ends(&self) -> TourEnds {
        if self.closed { TourEnds::Closed } else { TourEnds::Open }
    }

    pub(super) fn check_fields(&self, stored: Option<&Value>) -> Result<(), Error> {
        let field = if self.matrix.is_some() { "matrix" } else { "points" };
        let n = self.len();
        if !(2..=MAX_STOPS).contains(&n) {
            return Err(Error::refused(field, list_of(n), message!("scene-tour-stops", "2 to {most} stops", most = MAX_STOPS)));
        }
        if !self.points.is_empty() && self.points.len() != n {
            let allowed = message!("scene-tour-points", "left out, or {n}: a point for each row", n);
            return Err(Error::refused("points", list_of(self.points.len()), allowed));
        }
        let fits = |c: &f64| c.abs() <= FARTHEST;
        if let Some(at) = self.points.iter().flatten().position(|c| !fits(c)) {
            return up_to(&format!("points[{}][{}]", at / 2, at % 2), self.points[at / 2][at % 2], FARTHEST);
        }
        self.check_fixed()?;
        stored.map_or(Ok(()), |stored| self.check_stored(stored))
    }

    /// Fixed edges must be of different stops, and must not meet in a stop with a third one, nor go round. Returns from each end of a
    /// chain of fixed edges its other end; a stop alone is both, and one that is not at an end has [`INSIDE`].
    fn check_fixed(&self) -> Result<Vec<usize>, Error> {
        // Of two stops there is one tour anyway, and of more than fit into a matrix none can be fixed.
        let few = if (3..=MAX_MATRIX).contains(&self.len()) { self.len() } else { 0 };
        let mut other: Vec<usize> = (0..few).collect();
        for (i, &[a, b]) in self.fixed.iter().enumerate() {
            match (other.get(a), other.get(b)) {
                (Some(&x), Some(&y)) if x != INSIDE && y != INSIDE && x != b && a != b => {
                    (other[a], other[b]) = (INSIDE, INSIDE);
                    (other[x], other[y]) = (y, x);
                }
                _ => return Err(Error::refused(format!("fixed[{i}]"), list_of(2), fixed_edges())),
            }
        }
        Ok(other)
    }

    /// Whether tours with all fixed edges can have such ends: from an end one way leads at most, and fixed edges from one to the other leave
    /// no other stop out.
    pub fn can_have(&self, ends: TourEnds) -> bool {
        let (other, last) = (self.check_fixed().unwrap_or_default(), self.len() - 1);
        let at = |stop: usize| other.get(stop).copied().unwrap_or(stop);
        let through = ends == TourEnds::FirstToLast;
        let begins = through || ends == TourEnds::FromFirst;
        let short = through && at(0) == last && self.fixed.len() < last;
        !(short || begins && at(0) == INSIDE || through && at(last) == INSIDE)
    }

    /// A stored optimum must be a tour, and as long as it says.
    fn check_stored(&self, stored: &Value) -> Result<(), Error> {
        let length = stored.get("length").filter(|length| !length.is_null());
        if let Some(length) = length.filter(|length| !length.as_f64().is_some_and(|length| (0.0..f64::MAX).contains(&length))) {
            return Err(Error::refused("exact.length", shown(length), message!("scene-tour-length", "a length: a number, not negative")));
        }
        let Some(order) = stored.get("order").filter(|order| !order.is_null()) else {
            return Ok(());
        };
        let wrong = |field: &str, found: &Value| {
            let allowed = message!("scene-tour-order", "each stop from 0 to {last} once", last = self.len() - 1);
            Error::refused(field, shown(found), allowed)
        };
        let items = order.as_array().filter(|items| items.len() == self.len()).ok_or_else(|| {
            let allowed = message!("scene-stops", "{n} stops", n = self.len());
            Error::refused("exact.order", message!("scene-no-such-list", "no such list"), allowed)
        })?;
        let mut called = vec![false; self.len()];
        let mut stops = Vec::with_capacity(items.len());
        for (i, item) in items.iter().enumerate() {
            let stop = item.as_f64().filter(|stop| stop.fract() == 0.0 && *stop >= 0.0).map(|stop| stop as usize);
            let free = stop.and_then(|stop| called.get_mut(stop)).filter(|called| !**called);
            *free.ok_or_else(|| wrong(&format!("exact.order[{i}]"), item))? = true;
            stops.extend(stop);
        }
        if !self.distances().has_fixed(&stops, self.closed) {
            return Err(Error::refused("exact.order", list_of(stops.len()), fixed_edges()));
        }
        let measured = self.distances().length(&stops, self.closed);
        // Of unrounded distances the last digits may have been added in another order.
        match length.and_then(Value::as_f64).filter(|length| (length - measured).abs() > 1e-9 * measured) {
            Some(length) => {
                let allowed = message!("scene-tour-measured", "{length}, what exact.order adds up to", length = measured);
                Err(Error::refused("exact.length", length, allowed))
            }
            None => Ok(()),
        }
    }

    /// All places, with a margin.
    pub(super) fn surroundings(&self) -> Bounds {
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
    pub(super) fn shortest_tour(&self, ends: TourEnds, stored: Option<&Value>) -> Option<Exact> {
        let places = self.places();
        let path = |order: &[usize]| {
            let back = order.first().filter(|_| ends.closes());
            order.iter().chain(back).map(|&stop| places[stop]).collect::<Vec<_>>()
        };
        if let Some((order, length)) = shortest_tour(self.distances(), ends) {
            return Some(Exact { length, path: path(&order), order, tip_path: Vec::new(), stored: false });
        }
        let stored = stored.filter(|_| ends == self.ends())?;
        let order: Option<Vec<usize>> = stored
            .get("order")
            .and_then(Value::as_array)
            .map(|order| order.iter().map(|stop| stop.as_f64().map_or(usize::MAX, |stop| stop as usize)).collect());
        // What the file claims counts only as far as it can be checked: an order has the length that it has.
        match order.filter(|order| ends.allows(order, self.len()) && self.distances().has_fixed(order, ends.closes())) {
            Some(order) => Some(Exact {
                length: self.distances().length(&order, ends.closes()),
                path: path(&order),
                order,
                tip_path: Vec::new(),
                stored: true,
            }),
            None => stored.get("length").and_then(Value::as_f64).map(|length| Exact { stored: true, ..Exact::way(length, Vec::new()) }),
        }
    }

    pub(super) fn judge_solution(&self, solution: &Solution) -> Verdict {
        let Solution::Tour { order, ends, .. } = solution else {
            return Verdict { length: None, feasible: true, clearance: None };
        };
        let feasible = ends.allows(order, self.len()) && self.distances().has_fixed(order, ends.closes());
        let length = feasible.then(|| self.distances().length(order, ends.closes()));
        Verdict { length, feasible, clearance: None }
    }
}

/// In [`TourScene::check_fixed`], a stop with two fixed edges.
const INSIDE: usize = usize::MAX;

/// What is allowed of fixed edges, and of an order in view of them.
#[cold]
pub(super) fn fixed_edges() -> Message {
    message!(
        "scene-fixed",
        "two different stops, of 3 to {most}, that follow each other in every tour: at most two fixed edges meet in a stop, and they do not go round",
        most = MAX_MATRIX
    )
}

#[cfg(test)]
mod tests {
    use crate::{Scene, kernel::TourEnds, standard};

    /// Four stops at the corners of a unit square, and what the file says of the shortest tour.
    fn square(exact: &str) -> Result<Scene, crate::Error> {
        standard().read_scene(&format!(
            r#"{{"format": "forage-scene", "version": 1, "kind": "tour", "name": "s", "title": "S",
                "points": [[0, 0], [1, 0], [1, 1], [0, 1]], "exact": {exact}}}"#
        ))
    }

    #[test]
    fn a_stored_optimum_must_be_a_tour_and_as_long_as_it_says() {
        let refused = |exact: &str| square(exact).unwrap_err().field().to_owned();
        assert_eq!(refused(r#"{"length": -5}"#), "exact.length");
        assert_eq!(refused(r#"{"length": "four"}"#), "exact.length");
        assert_eq!(refused(r#"{"order": [0, 1, 2]}"#), "exact.order");
        assert_eq!(refused(r#"{"order": [0, 1, 1, 3]}"#), "exact.order[2]");
        assert_eq!(refused(r#"{"order": [0, 0.7, 2, 3]}"#), "exact.order[1]");
        assert_eq!(refused(r#"{"order": [0, 1, 2, 4]}"#), "exact.order[3]");
        assert_eq!(refused(r#"{"length": 3, "order": [0, 1, 2, 3]}"#), "exact.length");
        assert!(square(r#"{"length": 4, "order": [0, 1, 2, 3]}"#).is_ok());
        assert!(square(r#"{"length": 4}"#).is_ok());
    }

    #[test]
    fn fixed_edges_that_no_tour_can_have_are_refused() {
        let read = |stops: usize, fixed: &str| {
            let points: Vec<_> = (0..stops).map(|i| [i % 40, i / 40]).collect();
            standard().read_scene(&format!(
                r#"{{"format": "forage-scene", "version": 1, "kind": "tour", "name": "s", "title": "S",
                    "points": {points:?}, "fixed": {fixed}}}"#
            ))
        };
        for (stops, fixed, at) in [
            (4, "[[0, 0]]", 0),
            (4, "[[0, 1], [0, 0]]", 1),
            (4, "[[0, 1], [0, 2], [0, 3]]", 2),
            (4, "[[0, 1], [1, 2], [2, 0]]", 2),
            (4, "[[0, 4]]", 0),
            (4, "[[0, 1.5]]", 0),
            (2, "[[0, 1]]", 0),
            (2001, "[[0, 1]]", 0),
        ] {
            assert_eq!(read(stops, fixed).unwrap_err().field(), format!("fixed[{at}]"), "{fixed} of {stops}");
        }
        let allowed = |fixed: &str| {
            let scene = read(4, fixed).unwrap();
            TourEnds::ALL.map(|ends| scene.get::<super::TourScene>().unwrap().can_have(ends))
        };
        // Closed, open, from the first, from the first to the last.
        assert_eq!(allowed("[[0, 3]]"), [true, true, true, false]);
        assert_eq!(allowed("[[0, 1], [1, 3]]"), [true, true, true, false]);
        assert_eq!(allowed("[[0, 1], [1, 2], [2, 3]]"), [true; 4]);
        assert_eq!(allowed("[[1, 0], [0, 2]]"), [true, true, false, false]);
        assert_eq!(allowed("[[1, 3], [3, 2]]"), [true, true, true, false]);
        assert_eq!(allowed("[[1, 2]]"), [true; 4]);
        assert!(read(3, "[[0, 1], [1, 2]]").is_ok() && read(2000, "[[0, 1999]]").is_ok());
    }
}
