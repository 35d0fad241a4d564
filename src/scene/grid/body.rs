//! Scenes of kind `grid`: free and blocked cells, a robot with a size, a start and a goal or stops, [LTQPSO](crate#papers) §4.

use std::sync::{Arc, OnceLock};

use crate::{
    exact::{Distances, MAX_EXACT_STOPS, shortest_on_grid, shortest_over_cells, shortest_tour},
    geometry::{self, Bounds, Cells, Field, YAxis},
    kernel::{Error, Exact, ReferenceOptimum, SceneKindId, TourEnds, Track, Verdict, digits::coordinates, error::list_of},
    message,
    scene::{
        check::{LARGEST, coordinate, finite, from_to, nothing, positive},
        moving::{MAX_MOVING, Moving},
    },
};

/// The id of the kind in scene files.
pub const ID: SceneKindId = SceneKindId("grid");

/// The largest number of rows and of columns of a grid.
pub const MAX_SIDE: usize = 2048;

/// The largest number of cells of a grid whose exact optimum is computed: a few seconds' work. Results on larger grids have
/// none.
pub const MAX_EXACT_CELLS: usize = 512 * 512;

/// The largest number of stops on a grid: there is a path for each pair of them.
pub const MAX_GRID_STOPS: usize = 200;

/// The smallest side of a cell, in the scene's unit.
pub const SMALLEST_CELL: f64 = 1e-6;

/// The overlap of the robot and a moving obstacle, in cells, that counts as rounding.
pub const CONTACT: f64 = 1e-9;

/// The robot of a grid; what is not given is `None`.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(optional_fields))]
pub struct Robot {
    /// The length of its outline, along its heading, in the scene's unit.
    pub length: Option<f64>,
    /// The width of its outline, in the scene's unit.
    pub width: Option<f64>,
    /// Its speed, in the scene's unit per second.
    pub speed: Option<f64>,
    /// The turn-in-place time, in seconds.
    pub turn_time: Option<f64>,
    /// The sensor range, in the scene's unit.
    pub sensor: Option<f64>,
    /// Its radius against moving obstacles, in the scene's unit.
    #[cfg_attr(feature = "types", ts(rename = "radius"))]
    pub disc: Option<f64>,
    /// The safety margin beyond that radius, in the scene's unit.
    pub margin: Option<f64>,
    /// The prediction horizon, in seconds.
    pub look_ahead: Option<f64>,
}

impl Robot {
    /// What its margin and its sensor range may be, and its radius as far as it fits, in cells. These and the next two hold for scenes and
    /// for the parameters of drives: what one takes, the other takes.
    pub const LENGTHS: [f64; 2] = [0.0, 1e9];
    /// What its speed may be, in cells per second.
    pub const SPEEDS: [f64; 2] = [1e-9, 1e9];
    /// What its turn-in-place time and its prediction horizon may be, in seconds.
    pub const TIMES: [f64; 2] = [0.0, LARGEST];

    /// The fields by name.
    pub fn fields(&self) -> [(&'static str, Option<f64>); 8] {
        let Self { length, width, speed, turn_time, sensor, disc, margin, look_ahead } = *self;
        [
            ("length", length),
            ("width", width),
            ("speed", speed),
            ("turn_time", turn_time),
            ("sensor", sensor),
            ("radius", disc),
            ("margin", margin),
            ("look_ahead", look_ahead),
        ]
    }

    /// The radius of its circumscribed circle; 0 for a robot without a size.
    pub fn radius(&self) -> f64 {
        let (length, width) = (self.length.unwrap_or(0.0), self.width.unwrap_or(0.0));
        (length * length + width * width).sqrt() / 2.0
    }
}

/// A grid of free and blocked cells.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct GridScene {
    /// The side of a cell, in the scene's unit.
    pub cell: f64,
    /// Cells per row.
    #[cfg_attr(feature = "types", ts(skip))]
    pub columns: usize,
    /// Blocked cells, row by row. Row `k` covers `k · cell ≤ y ≤ (k + 1) · cell`, whichever way y grows.
    #[cfg_attr(feature = "types", ts(rename = "rows", as = "Vec<String>"))]
    pub blocked: Vec<bool>,
    /// The direction in which y grows.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<YAxis>"))]
    pub y_axis: YAxis,
    /// The start of a path.
    #[cfg_attr(feature = "types", ts(optional))]
    pub start: Option<[f64; 2]>,
    /// The goal of a path.
    #[cfg_attr(feature = "types", ts(optional))]
    pub goal: Option<[f64; 2]>,
    /// The stops of a tour.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<[f64; 2]>>"))]
    pub stops: Vec<[f64; 2]>,
    /// Whether a diagonal move may cut a blocked cell's corner.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<bool>"))]
    pub corner_cutting: bool,
    /// The robot.
    #[cfg_attr(feature = "types", ts(optional))]
    pub robot: Option<Robot>,
    /// The moving obstacles.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<Moving>>"))]
    pub moving: Vec<Moving>,
    /// What follows from the rest.
    #[cfg_attr(feature = "types", ts(skip))]
    pub(crate) derived: Derived,
}

/// What is made of a grid when it is first asked for. A copy of a grid makes its own: it may be changed.
#[derive(Debug, Default)]
pub(crate) struct Derived {
    /// The blocked cells grown by the robot.
    field: OnceLock<Arc<Field>>,
    /// The steps from cell to cell.
    cells: OnceLock<Arc<Cells>>,
}

impl Clone for Derived {
    fn clone(&self) -> Self {
        Self::default()
    }
}

impl PartialEq for GridScene {
    fn eq(&self, other: &Self) -> bool {
        let key = |s: &Self| (s.cell, s.columns, s.y_axis, s.start, s.goal, s.corner_cutting, s.robot);
        key(self) == key(other) && self.blocked == other.blocked && self.stops == other.stops && self.moving == other.moving
    }
}

impl GridScene {
    /// A grid of these cells, without ends, stops, robot or moving obstacles.
    pub fn new(cell: f64, columns: usize, blocked: Vec<bool>) -> Self {
        Self {
            cell,
            columns,
            blocked,
            y_axis: YAxis::default(),
            start: None,
            goal: None,
            stops: Vec::new(),
            corner_cutting: false,
            robot: None,
            moving: Vec::new(),
            derived: Derived::default(),
        }
    }

    /// Puts points that miss the far border only by rounding (0.9 where 6 · 0.15 is 0.8999999999999999) on it.
    pub(super) fn snapped(mut self) -> Self {
        let max = self.bounds().max;
        let snap = |point: &mut [f64; 2]| {
            for (c, most) in point.iter_mut().zip(max) {
                if *c > most && *c <= most * (1.0 + 1e-12) {
                    *c = most;
                }
            }
        };
        self.start.iter_mut().chain(&mut self.goal).chain(&mut self.stops).for_each(snap);
        self
    }

    /// The same grid with other ends. What follows from the cells is shared: it is made once for all.
    #[must_use]
    pub fn with_ends(&self, [start, goal]: [[f64; 2]; 2]) -> Self {
        let derived = Derived { field: self.derived.field.clone(), cells: self.derived.cells.clone() };
        Self { start: Some(start), goal: Some(goal), derived, ..self.clone() }
    }

    /// The number of rows.
    pub fn rows(&self) -> usize {
        self.blocked.len() / self.columns.max(1)
    }

    /// The rows as a file lists them: top row first.
    pub fn lines(&self) -> Vec<String> {
        let lines = self.blocked.chunks(self.columns.max(1)).map(|row| row.iter().map(|&b| if b { '#' } else { '.' }).collect());
        match self.y_axis {
            YAxis::Down => lines.collect(),
            YAxis::Up => lines.rev().collect(),
        }
    }

    /// The whole grid.
    pub fn bounds(&self) -> Bounds {
        Bounds { min: [0.0, 0.0], max: [self.columns as f64 * self.cell, self.rows() as f64 * self.cell] }
    }

    /// The robot's radius; 0 where there is no robot or it has no size.
    pub fn radius(&self) -> f64 {
        self.robot.map_or(0.0, |robot| robot.radius())
    }

    /// The robot's length and width, if it has both.
    pub fn outline(&self) -> Option<[f64; 2]> {
        self.robot.and_then(|robot| Some([robot.length?, robot.width?]))
    }

    /// The blocked cells, inflated exactly by the radius of the robot's circumscribed circle.
    pub fn field(&self) -> &Arc<Field> {
        self.derived.field.get_or_init(|| Arc::new(Field::new(self.cell, self.columns, &self.blocked, self.radius(), self.corner_cutting)))
    }

    /// The free cells and the moves between them.
    pub fn cells(&self) -> &Arc<Cells> {
        self.derived.cells.get_or_init(|| Arc::new(self.new_cells()))
    }

    /// Start and goal.
    ///
    /// # Errors
    /// [`Error::Refused`] if the scene has none; it may have stops.
    pub fn ends(&self) -> Result<([f64; 2], [f64; 2]), Error> {
        let allowed = || message!("scene-needs-ends", "a point: this planner goes from start to goal");
        let one = |name, point: Option<_>| point.ok_or_else(|| Error::refused(name, nothing(), allowed()));
        Ok((one("start", self.start)?, one("goal", self.goal)?))
    }

    pub(super) fn check_fields(&self) -> Result<(), Error> {
        positive("cell", self.cell)?;
        if self.cell < SMALLEST_CELL {
            return Err(Error::refused("cell", self.cell, from_to(SMALLEST_CELL, LARGEST)));
        }
        for (name, count) in [("rows", self.rows()), ("rows[0]", self.columns)] {
            if !(1..=MAX_SIDE).contains(&count) {
                return Err(Error::refused(name, count, from_to(1.0, MAX_SIDE as f64)));
            }
        }
        self.check_robot()?;
        let point = || message!("error-point", "a point, [x, y]");
        match (self.start, self.goal) {
            (Some(_), None) if self.stops.is_empty() => return Err(Error::refused("goal", nothing(), point())),
            (None, Some(_)) => return Err(Error::refused("start", nothing(), point())),
            (None, None) if self.stops.is_empty() => {
                return Err(Error::refused("start", nothing(), message!("scene-ends-or-stops", "a start and a goal, or stops")));
            }
            _ => {}
        }
        for (name, point) in [("start", self.start), ("goal", self.goal)] {
            point.iter().try_for_each(|&point| self.check_point(name, point))?;
        }
        if self.stops.len() > MAX_GRID_STOPS {
            let allowed = message!("scene-most-stops", "at most {most} stops", most = MAX_GRID_STOPS);
            return Err(Error::refused("stops", list_of(self.stops.len()), allowed));
        }
        self.stops.iter().enumerate().try_for_each(|(i, &stop)| self.check_point(&format!("stops[{i}]"), stop))?;
        if self.moving.len() > MAX_MOVING {
            let allowed = message!("scene-most-moving", "at most {most} moving obstacles", most = MAX_MOVING);
            return Err(Error::refused("moving", list_of(self.moving.len()), allowed));
        }
        self.moving.iter().enumerate().try_for_each(|(i, disc)| disc.check(&format!("moving[{i}]")))?;
        Ok(())
    }

    fn check_robot(&self) -> Result<(), Error> {
        let Some(robot) = self.robot else {
            return Ok(());
        };
        for (name, value) in robot.fields().into_iter().filter_map(|(name, value)| value.map(|value| (name, value))) {
            let field = format!("robot.{name}");
            let in_cells = |range: [f64; 2]| range.map(|end| end * self.cell);
            let [least, most] = match name {
                "length" | "width" => {
                    positive(&field, value)?;
                    continue;
                }
                "turn_time" | "look_ahead" => Robot::TIMES,
                "speed" => in_cells(Robot::SPEEDS),
                _ => in_cells(Robot::LENGTHS),
            };
            finite(&field, value)?;
            if !(least..=most).contains(&value) {
                return Err(Error::refused(field, value, from_to(least, most)));
            }
        }
        match (robot.length, robot.width) {
            (Some(_), None) => {
                Err(Error::refused("robot.width", nothing(), message!("scene-robot-width", "a width, as there is a length")))
            }
            (None, Some(_)) => {
                Err(Error::refused("robot.length", nothing(), message!("scene-robot-length", "a length, as there is a width")))
            }
            _ => Ok(()),
        }
    }

    /// A point of the path must lie in the grid, and the robot must fit there; it may touch.
    fn check_point(&self, field: &str, point: [f64; 2]) -> Result<(), Error> {
        (0..2).try_for_each(|axis| coordinate(field, point, axis))?;
        let shown = || coordinates(&point);
        let max = self.bounds().max;
        if (0..2).any(|axis| !(0.0..=max[axis]).contains(&point[axis])) {
            let allowed = message!("scene-inside-grid", "inside the grid, (0, 0) to ({right}, {top})", right = max[0], top = max[1]);
            return Err(Error::refused(field, shown(), allowed));
        }
        if self.field().is_free(point, point) {
            return Ok(());
        }
        let allowed = match self.radius() {
            0.0 => message!("scene-outside-cells", "outside every blocked cell"),
            radius => message!("scene-robot-fits", "where the robot fits: at least its radius, {radius}, from every blocked cell", radius),
        };
        Err(Error::refused(field, shown(), allowed))
    }

    pub(super) fn shortest(&self) -> Option<Exact> {
        let ends = [self.start?, self.goal?];
        if self.blocked.len() > MAX_EXACT_CELLS {
            return None;
        }
        shortest_on_grid(ends, self.cell, self.columns, &self.blocked, self.field(), self.corner_cutting)
    }

    /// The shortest way from cell to cell.
    pub(super) fn shortest_over_cells(&self) -> Option<Exact> {
        shortest_over_cells(self.cells(), &self.endpoints().ok()?)
    }

    /// The shortest tour through the stops, by the shortest way for each pair.
    pub(super) fn shortest_tour(&self, reference: ReferenceOptimum, ends: TourEnds) -> Option<Exact> {
        let n = self.stops.len();
        if !(2..=MAX_EXACT_STOPS).contains(&n) {
            return None;
        }
        let way = |i: usize, j: usize| {
            let ends = [self.stops[i], self.stops[j]];
            match reference {
                ReferenceOptimum::Cells => shortest_over_cells(self.cells(), &self.endpoints_between(["stops", "stops"], ends).ok()?),
                _ => self.with_ends(ends).shortest(),
            }
        };
        let pairs = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        let ways: Vec<_> = pairs.map(|(i, j)| way(i, j)).collect::<Option<_>>()?;
        // The pairs of the stops before i come first: n − 1, n − 2, … of them.
        let of = |i: usize, j: usize| &ways[i * (2 * n - i - 1) / 2 + j - i - 1];
        let distances = Distances::of(n, |i, j| of(i, j).length);
        let (order, length) = shortest_tour(&distances, ends)?;
        let mut path = vec![self.stops[order[0]]];
        let back = ends.closes().then_some(order[0]);
        for (i, j) in order.iter().copied().zip(order[1..].iter().copied().chain(back)) {
            let way = &of(i.min(j), i.max(j)).path;
            if i < j { path.extend(&way[1..]) } else { path.extend(way[..way.len() - 1].iter().rev()) }
        }
        Some(Exact { length, path, order, tip_path: Vec::new(), stored: false })
    }

    pub(super) fn judge_path(&self, path: &[[f64; 2]]) -> Verdict {
        self.judge_way(path, path.first().copied() == self.start && path.last().copied() == self.goal)
    }

    /// A tour must call at each stop in its order.
    pub(super) fn judge_tour(&self, order: &[usize], ends: TourEnds, path: &[[f64; 2]]) -> Verdict {
        let allowed = ends.allows(order, self.stops.len());
        let calls: Vec<_> = order.iter().chain(order.first().filter(|_| ends.closes())).filter_map(|&i| self.stops.get(i)).collect();
        let ends = path.first() == calls.first().copied() && path.last() == calls.last().copied();
        let mut corners = path.iter();
        // Two stops at the same place are one corner.
        let mut at = None;
        let in_order = calls.iter().all(|&call| {
            at == Some(call) || {
                at = corners.find(|&corner| corner == call);
                at.is_some()
            }
        });
        self.judge_way(path, allowed && ends && in_order)
    }

    /// A drive must arrive, cross nothing, and never touch a moving obstacle. Its path must be the one through its moments.
    pub(super) fn judge_drive(&self, track: &Track) -> Verdict {
        let verdict = self.judge_path(&track.path);
        let mut places: Vec<_> = track.moments.iter().map(|&[_, x, y]| [x, y]).collect();
        places.dedup();
        let gap = self.gap(track).unwrap_or(f64::INFINITY);
        let clearance = verdict.clearance.into_iter().chain(gap.is_finite().then_some(gap)).reduce(f64::min);
        Verdict { feasible: verdict.feasible && places == track.path && gap >= -CONTACT * self.cell, clearance, ..verdict }
    }

    /// The smallest distance between the robot of a track and a moving obstacle, negative if they overlap; `None` without one.
    pub fn gap(&self, track: &Track) -> Option<f64> {
        // A drive that ends where it begins has one moment.
        let one = track.moments.first().filter(|_| track.moments.len() == 1).map(|&moment| [moment; 2]);
        let legs = track
            .moments
            .windows(2)
            .chain(one.as_ref().map(|pair| &pair[..]))
            .flat_map(|leg| self.moving.iter().map(move |disc| (leg, disc)));
        legs.map(|(leg, disc)| {
            let ([from, x, y], [until, to_x, to_y]) = (leg[0], leg[1]);
            let seconds = until - from;
            let velocity = if seconds > 0.0 { [(to_x - x) / seconds, (to_y - y) / seconds] } else { [0.0; 2] };
            disc.least_distance([x, y], velocity, [from, until], track.border, self.bounds()) - disc.radius - track.radius
        })
        .reduce(f64::min)
    }

    fn judge_way(&self, path: &[[f64; 2]], joins: bool) -> Verdict {
        let max = self.bounds().max;
        let inside = path.iter().all(|p| (0..2).all(|axis| (0.0..=max[axis]).contains(&p[axis])));
        let field = self.field();
        let free = path.windows(2).all(|w| field.is_free(w[0], w[1]));
        let clearance = path.windows(2).filter_map(|w| field.clearance(w[0], w[1])).reduce(f64::min);
        Verdict { length: Some(geometry::length(path)), feasible: joins && inside && free, clearance }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> GridScene {
        let blocked = [".....", "..#..", "....."].iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        GridScene { start: Some([0.5, 0.5]), goal: Some([4.5, 2.5]), ..GridScene::new(1.0, 5, blocked) }
    }

    #[test]
    fn a_path_is_judged_with_the_robot_s_size() {
        let path = [[0.5, 0.5], [4.5, 0.5], [4.5, 2.5]];
        let point = scene().judge_path(&path);
        assert_eq!((point.length, point.feasible, point.clearance), (Some(6.0), true, Some(0.5)));
        let robot = |length| Some(Robot { length: Some(length), width: Some(0.0), ..Robot::default() });
        let wide = GridScene { robot: robot(1.0), ..scene() }.judge_path(&path);
        assert_eq!((wide.feasible, wide.clearance), (true, Some(0.0)), "it touches");
        let wider = GridScene { robot: robot(1.25), ..scene() }.judge_path(&path);
        assert_eq!((wider.feasible, wider.clearance), (false, Some(-0.125)));
        assert!(!scene().judge_path(&[[0.5, 0.5], [4.5, 2.5]]).feasible, "through the blocked cell");
        assert!(!scene().judge_path(&[[0.5, 0.5], [4.5, -0.5], [4.5, 2.5]]).feasible, "out of the grid");
        assert!(!scene().judge_path(&path[..2]).feasible, "it must end at the goal");
    }

    #[test]
    fn each_wrong_field_is_named() {
        let field = |change: fn(&mut GridScene)| {
            let mut scene = scene();
            change(&mut scene);
            scene.check_fields().unwrap_err().field().to_owned()
        };
        assert_eq!(field(|s| s.cell = 0.0), "cell");
        assert_eq!(field(|s| s.blocked = Vec::new()), "rows");
        assert_eq!(field(|s| s.start = Some([2.5, 1.5])), "start");
        assert_eq!(field(|s| s.goal = Some([5.5, 1.5])), "goal");
        assert_eq!(field(|s| s.goal = None), "goal");
        assert_eq!(field(|s| (s.start, s.goal) = (None, None)), "start");
        assert_eq!(field(|s| s.stops = vec![[0.5, 0.5], [2.5, 1.5]]), "stops[1]");
        assert_eq!(field(|s| s.robot = Some(Robot { length: Some(1.0), ..Robot::default() })), "robot.width");
        assert_eq!(field(|s| s.robot = Some(Robot { speed: Some(-1.0), ..Robot::default() })), "robot.speed");
        assert_eq!(field(|s| s.moving = vec![Moving::straight([1.0, 1.0], 0.0, [0.0, 1.0])]), "moving[0].radius");
        let tight = GridScene { robot: Some(Robot { length: Some(3.0), width: Some(2.0), ..Robot::default() }), ..scene() };
        assert!(tight.check_fields().unwrap_err().allowed().contains("robot fits"));
        assert!(scene().check_fields().is_ok());
    }
}
