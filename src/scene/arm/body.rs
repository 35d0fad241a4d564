//! Scenes of kind `arm`: a six-axis arm, cuboids in its workspace, start and goal of its tip.

use serde_json::Value;

use crate::{
    arm::{self, ArmScene, Posture},
    exact::{AmongCuboids, shortest_among_cuboids},
    geometry::{Cuboid, length_in_space},
    kernel::{Error, Exact, SceneKindId, Solution, Verdict, digits::coordinates, error::list_of},
    message,
    scene::check::{greater_than, limited},
};

/// The id of the kind in scene files.
pub const ID: SceneKindId = SceneKindId("arm");

/// How far from start and goal the tip may be where postures were planned, in metres.
pub(crate) const JOINED: f64 = 1e-6;
/// How far beyond the workspace's border the tip may be there, in metres: as much as the points of a curve miss of it.
const BORDER: f64 = 1e-4;
/// How far any point of a link may go between two tests of a verdict, in metres.
const RESOLUTION: f64 = 1e-3;

/// The largest number of cuboids in a scene.
pub const MAX_CUBOIDS: usize = 200;

impl ArmScene {
    pub(super) fn check_fields(&self) -> Result<(), Error> {
        check_cuboid("workspace", &self.workspace)?;
        if self.cuboids.len() > MAX_CUBOIDS {
            let allowed = message!("scene-most-cuboids", "at most {most} cuboids", most = MAX_CUBOIDS);
            return Err(Error::refused("cuboids", list_of(self.cuboids.len()), allowed));
        }
        self.cuboids.iter().enumerate().try_for_each(|(i, cuboid)| check_cuboid(&format!("cuboids[{i}]"), cuboid))?;
        self.arm.check().map_err(|error| error.within("arm"))?;
        self.check_end("start", self.start)?;
        self.check_end("goal", self.goal)
    }

    /// An end of the tip's path must lie in the workspace and touch nothing.
    fn check_end(&self, field: &str, point: [f64; 3]) -> Result<(), Error> {
        point.iter().enumerate().try_for_each(|(axis, &x)| limited(&format!("{field}[{axis}]"), x))?;
        let shown = coordinates(&point);
        if !self.workspace.contains(point) {
            let ([x0, y0, z0], [x1, y1, z1]) = (self.workspace.min, self.workspace.max);
            let allowed = message!(
                "scene-inside-workspace",
                "inside the workspace, ({x0}, {y0}, {z0}) to ({x1}, {y1}, {z1})",
                x0,
                y0,
                z0,
                x1,
                y1,
                z1
            );
            return Err(Error::refused(field, shown, allowed));
        }
        if arm::segment_meets_column(self, point, point) {
            let allowed = message!("scene-outside-column", "outside the column under the arm's base, and it touches that");
            return Err(Error::refused(field, shown, allowed));
        }
        match self.cuboids.iter().position(|cuboid| cuboid.contains(point)) {
            Some(i) => {
                let allowed = message!("scene-outside-cuboids", "outside every cuboid, and it touches cuboids[{i}]", i);
                Err(Error::refused(field, shown, allowed))
            }
            None => Ok(()),
        }
    }

    /// Whether the tip can go straight from one point to another inside the workspace, without touching a cuboid or the arm's
    /// own column.
    #[inline]
    pub fn is_free(&self, a: [f64; 3], b: [f64; 3]) -> bool {
        self.workspace.contains(a)
            && self.workspace.contains(b)
            && !self.cuboids.iter().any(|cuboid| cuboid.meets(a, b))
            && !arm::segment_meets_column(self, a, b)
    }

    /// What the tip must not touch: cuboids, and the axis of the column with its radius.
    pub(crate) fn obstacles(&self) -> impl Iterator<Item = (Cuboid, f64)> + '_ {
        let column = arm::column(self).map(|column| (column.axis, column.radius));
        self.cuboids.iter().map(|cuboid| (*cuboid, 0.0)).chain(column)
    }

    /// The tip's shortest path, as if nothing were behind it: neither the arm nor the column under its base counts, so it is
    /// a lower bound for the arm's. Where there are too many cuboids, the length that the scene's file gives.
    pub(super) fn shortest(&self, stored: Option<&Value>) -> Option<Exact> {
        match shortest_among_cuboids(&self.workspace, self.start, self.goal, &self.cuboids) {
            AmongCuboids::Found(exact) => Some(exact),
            AmongCuboids::NoWay => None,
            AmongCuboids::NotComputed => {
                // No way is shorter than the straight line.
                let straight = length_in_space(&[self.start, self.goal]);
                let length = stored?.get("tip_length")?.as_f64().filter(|length| length.is_finite() && *length >= straight)?;
                Some(Exact { stored: true, ..Exact::way(length, Vec::new()) })
            }
        }
    }

    /// What a way of the tip, or of the whole arm, is worth.
    pub(super) fn judge_solution(&self, solution: &Solution) -> Verdict {
        let Solution::Reach { path, postures } = solution else {
            return Verdict { length: None, feasible: false, clearance: None };
        };
        let gaps = self.cuboids.iter().flat_map(|cuboid| path.windows(2).map(move |w| cuboid.distance_squared(w[0], w[1])));
        let clearance = gaps.reduce(f64::min).map(f64::sqrt);
        let feasible = if postures.is_empty() {
            self.joins(path, 0.0) && path.windows(2).all(|w| self.is_free(w[0], w[1]))
        } else {
            self.is_way(path, postures)
        };
        Verdict { length: Some(length_in_space(path)), feasible, clearance }
    }

    /// Whether a path leads from start to goal.
    fn joins(&self, path: &[[f64; 3]], tolerance: f64) -> bool {
        let at = |point: Option<&[f64; 3]>, end: [f64; 3]| point.is_some_and(|&point| length_in_space(&[point, end]) <= tolerance);
        at(path.first(), self.start) && at(path.last(), self.goal)
    }

    /// Whether postures take the tip along a path from start to goal, within the limits, and no link touches anything.
    fn is_way(&self, path: &[[f64; 3]], postures: &[Posture]) -> bool {
        let within = |posture: &Posture| {
            self.arm.joints.iter().zip(arm::degrees(posture)).all(|(joint, angle)| joint.min - 1e-9 <= angle && angle <= joint.max + 1e-9)
        };
        let Cuboid { min, max } = self.workspace;
        let inside = |tip: &[f64; 3]| (0..3).all(|i| (min[i] - BORDER..=max[i] + BORDER).contains(&tip[i]));
        self.joins(path, JOINED)
            && path.iter().all(inside)
            && arm::tip_path(&self.arm, postures) == path
            && postures.iter().all(within)
            && postures.windows(2).all(|w| arm::motion_is_free(self, &w[0], &w[1], 0.0, RESOLUTION))
    }
}

fn check_cuboid(field: &str, cuboid: &Cuboid) -> Result<(), Error> {
    for axis in 0..3 {
        limited(&format!("{field}.min[{axis}]"), cuboid.min[axis])?;
        let at = format!("{field}.max[{axis}]");
        limited(&at, cuboid.max[axis])?;
        if cuboid.max[axis] - cuboid.min[axis] < 1e-6 {
            return Err(Error::refused(at, cuboid.max[axis], greater_than(&format!("{field}.min[{axis}]"), cuboid.min[axis])));
        }
    }
    Ok(())
}
