//! Scenes of kind `discs`: a start, a goal and circular obstacles in the plane, [WCPSO](crate#papers) §3.2.

use crate::{
    exact::shortest_among_discs,
    geometry::{self, Bounds, Disc},
    kernel::{Error, Exact, SceneKindId, Verdict, digits::Digits, error::list_of},
    message,
    scene::check::{coordinate, greater_than, positive},
};

/// The id of the kind in scene files.
pub const ID: SceneKindId = SceneKindId("discs");

/// The largest number of discs in a scene: up to here the exact optimum takes a moment, not a minute.
pub const MAX_DISCS: usize = 200;

/// A plane with circular obstacles.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct DiscsScene {
    /// The region in which waypoints are searched. A path may leave it between them.
    pub bounds: Bounds,
    /// The start of the path.
    pub start: [f64; 2],
    /// The goal of the path.
    pub goal: [f64; 2],
    /// The obstacles.
    pub discs: Vec<Disc>,
}

impl DiscsScene {
    pub(super) fn check_fields(&self) -> Result<(), Error> {
        let bounds = &self.bounds;
        for axis in 0..2 {
            coordinate("bounds.min", bounds.min, axis)?;
            coordinate("bounds.max", bounds.max, axis)?;
            if bounds.max[axis] - bounds.min[axis] < 1e-6 {
                let at = format!("bounds.max[{axis}]");
                return Err(Error::refused(at, bounds.max[axis], greater_than(&format!("bounds.min[{axis}]"), bounds.min[axis])));
            }
        }
        if self.discs.len() > MAX_DISCS {
            let allowed = message!("scene-most-discs", "at most {most} discs", most = MAX_DISCS);
            return Err(Error::refused("discs", list_of(self.discs.len()), allowed));
        }
        for (i, disc) in self.discs.iter().enumerate() {
            (0..2).try_for_each(|axis| coordinate(&format!("discs[{i}].center"), disc.center, axis))?;
            positive(&format!("discs[{i}].radius"), disc.radius)?;
        }
        self.check_end("start", self.start)?;
        self.check_end("goal", self.goal)
    }

    /// An end of the path must lie in the bounds and in no disc; the rim is free.
    fn check_end(&self, field: &str, point: [f64; 2]) -> Result<(), Error> {
        (0..2).try_for_each(|axis| coordinate(field, point, axis))?;
        let text = |point: [f64; 2]| format!("({}, {})", Digits(point[0]), Digits(point[1]));
        let Bounds { min, max } = self.bounds;
        if (0..2).any(|axis| point[axis] < min[axis] || point[axis] > max[axis]) {
            let allowed = message!(
                "scene-inside-bounds",
                "inside the bounds, ({left}, {bottom}) to ({right}, {top})",
                left = min[0],
                bottom = min[1],
                right = max[0],
                top = max[1]
            );
            return Err(Error::refused(field, text(point), allowed));
        }
        match self.discs.iter().position(|disc| disc.clearance(point) < 0.0) {
            Some(i) => {
                let allowed = message!("scene-outside-discs", "outside every disc, and it lies in discs[{i}]", i);
                Err(Error::refused(field, text(point), allowed))
            }
            None => Ok(()),
        }
    }

    pub(super) fn shortest(&self) -> Option<Exact> {
        shortest_among_discs(self.start, self.goal, &self.discs)
    }

    pub(super) fn judge_path(&self, path: &[[f64; 2]]) -> Verdict {
        let clearance =
            self.discs.iter().flat_map(|disc| path.windows(2).map(move |w| disc.clearance_of_segment(w[0], w[1]))).reduce(f64::min);
        let joins = path.first() == Some(&self.start) && path.last() == Some(&self.goal);
        Verdict { length: Some(geometry::length(path)), feasible: joins && clearance.is_none_or(|c| c >= 0.0), clearance }
    }

    pub(super) fn whole(&self) -> Bounds {
        let Bounds { mut min, mut max } = self.bounds;
        for disc in &self.discs {
            for axis in 0..2 {
                min[axis] = min[axis].min(disc.center[axis] - disc.radius);
                max[axis] = max[axis].max(disc.center[axis] + disc.radius);
            }
        }
        Bounds { min, max }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scene() -> DiscsScene {
        DiscsScene {
            bounds: Bounds { min: [0.0, 0.0], max: [10.0, 10.0] },
            start: [0.0, 0.0],
            goal: [10.0, 0.0],
            discs: vec![Disc { center: [5.0, 0.0], radius: 1.0 }],
        }
    }

    #[test]
    fn a_path_is_judged_by_its_segments_not_by_its_corners() {
        let through = scene().judge_path(&[[0.0, 0.0], [10.0, 0.0]]);
        assert_eq!((through.length, through.feasible, through.clearance), (Some(10.0), false, Some(-1.0)));
        let over = scene().judge_path(&[[0.0, 0.0], [5.0, 5.0], [10.0, 0.0]]);
        assert!(over.feasible && over.clearance.unwrap() > 2.5);
        assert!(!scene().judge_path(&[[0.0, 0.0], [5.0, 5.0]]).feasible, "it must end at the goal");
    }

    #[test]
    fn each_wrong_field_is_named() {
        let field = |change: fn(&mut DiscsScene)| {
            let mut scene = scene();
            change(&mut scene);
            scene.check_fields().unwrap_err().field().to_owned()
        };
        assert_eq!(field(|s| s.start = [5.0, 0.5]), "start");
        assert_eq!(field(|s| s.goal = [11.0, 0.5]), "goal");
        assert_eq!(field(|s| s.goal = [f64::NAN, 0.5]), "goal[0]");
        assert_eq!(field(|s| s.discs[0].radius = 0.0), "discs[0].radius");
        assert_eq!(field(|s| s.discs[0].radius = f64::INFINITY), "discs[0].radius");
        assert_eq!(field(|s| s.discs[0].center[1] = 1e7), "discs[0].center[1]");
        assert_eq!(field(|s| s.bounds.max[1] = 0.0), "bounds.max[1]");
        assert_eq!(field(|s| s.discs = vec![s.discs[0]; MAX_DISCS + 1]), "discs");
        assert!(scene().check_fields().is_ok());
    }
}
