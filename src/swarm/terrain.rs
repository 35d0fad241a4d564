//! What a path costs in its scene, however it is encoded: [WCPSO](crate#papers) (14) and (15) among discs,
//! [LTQPSO](crate#papers) (16)–(18) on grids.

use std::sync::Arc;

use crate::{
    describe::layers,
    geometry::{Bounds, Disc, ObstacleField, PIECES, distance_squared, shuman, subdivided},
    kernel::{Error, Frame, Plane, Readings, Shape, Solution},
    math,
    params::Parameters,
    scene::DiscsScene,
};

use super::{
    objective::{Evaluation, Scratch},
    parameters::{LENGTH, SMOOTHNESS},
    paths::{F1, F2, PASSES, PENALTY, PENALTY_WEIGHT, Penalty, REDRAWS, SMOOTH, SMOOTHING},
};

/// What a path must go round.
#[derive(Clone)]
pub(super) enum Obstacles {
    /// Discs, and where (15) looks for a path in them.
    Discs(Arc<[Disc]>, Penalty),
    /// Blocked cells, grown by the robot's radius.
    Field(Arc<dyn ObstacleField>),
}

/// How the result is smoothed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Smoothing {
    /// S of the Shuman filter.
    pub(super) strength: f64,
    /// How often it is applied.
    pub(super) passes: u64,
}

/// Where paths lead from and to, what they must go round, and what they cost.
#[derive(Clone)]
pub(super) struct Terrain {
    pub(super) start: [f64; 2],
    pub(super) goal: [f64; 2],
    pub(super) bounds: Bounds,
    pub(super) obstacles: Obstacles,
    /// f1 and f2 of (16).
    pub(super) f: [f64; 2],
    pub(super) weight: f64,
    pub(super) redraws: u64,
    pub(super) smoothing: Option<Smoothing>,
}

/// L_D of (17), L_S of (18), and how much of the path breaks the rules.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Measures {
    pub(super) length: f64,
    pub(super) squares: f64,
    pub(super) violation: f64,
}

impl Terrain {
    /// A plane with discs, with the settings `penalty`, `penalty_weight` and those of every path.
    pub(super) fn among_discs(scene: &DiscsScene, settings: &Parameters) -> Self {
        let obstacles = Obstacles::Discs(scene.discs.as_slice().into(), settings[PENALTY]);
        Self::new((scene.start, scene.goal), scene.bounds, obstacles, settings)
    }

    /// A plane with measured obstacles, with the settings `penalty_weight` and those of every path.
    ///
    /// # Errors
    /// A plane without start and goal.
    pub(super) fn among(field: Arc<dyn ObstacleField>, plane: &dyn Plane, settings: &Parameters) -> Result<Self, Error> {
        Ok(Self::new(plane.ends()?, plane.bounds(), Obstacles::Field(field), settings))
    }

    fn new((start, goal): ([f64; 2], [f64; 2]), bounds: Bounds, obstacles: Obstacles, settings: &Parameters) -> Self {
        let smoothing = Smoothing { strength: settings[SMOOTHING], passes: settings[PASSES] };
        Self {
            start,
            goal,
            bounds,
            obstacles,
            f: [settings[F1], settings[F2]],
            weight: settings[PENALTY_WEIGHT],
            redraws: settings[REDRAWS],
            smoothing: settings[SMOOTH].then_some(smoothing),
        }
    }

    /// F = f1 L_D + f2 L_S + w Σ violations, (14) and (16).
    #[inline]
    pub(super) fn evaluate(&self, points: impl Iterator<Item = [f64; 2]>, scratch: &mut Scratch) -> Evaluation {
        let Measures { length, squares, violation } = self.measure(points, scratch);
        Evaluation { cost: self.f[0] * length + self.f[1] * squares + self.weight * violation, violation }
    }

    /// What the path through these points measures.
    #[inline]
    pub(super) fn measure(&self, points: impl Iterator<Item = [f64; 2]>, scratch: &mut Scratch) -> Measures {
        let mut sum = Measures { length: 0.0, squares: 0.0, violation: 0.0 };
        // All corners are written before any is read: a load that waits for a store made just before costs a fifth of the run.
        let Scratch { path, pieces, .. } = scratch;
        path.clear();
        path.push(self.start);
        path.extend(points);
        path.push(self.goal);
        for (i, w) in path.windows(2).enumerate() {
            let (dx, dy) = (w[1][0] - w[0][0], w[1][1] - w[0][1]);
            // By the law of cosines this is the summand of (18).
            let squared = dx * dx + dy * dy;
            sum.length += squared.sqrt();
            sum.squares += squared;
            sum.violation += self.violation(w[0], w[1], i + 2 == path.len(), pieces);
        }
        sum
    }

    /// How much the path's piece from `a` to `b` breaks the rules: Σ_k V(k) of (15), or its length inside obstacles.
    #[inline]
    fn violation(&self, a: [f64; 2], b: [f64; 2], to_goal: bool, pieces: &mut Vec<[f64; 2]>) -> f64 {
        match &self.obstacles {
            Obstacles::Field(field) => field.length_inside(a, b, pieces),
            Obstacles::Discs(_, Penalty::Waypoints) if to_goal => 0.0,
            Obstacles::Discs(discs, penalty) => {
                let from = if *penalty == Penalty::Waypoints { b } else { a };
                let mut sum = 0.0;
                for disc in &**discs {
                    let squared = distance_squared(from, b, disc.center);
                    if squared < disc.radius * disc.radius {
                        sum += 1.0 - squared.sqrt() / disc.radius;
                    }
                }
                sum
            }
        }
    }

    pub(super) fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        match &self.obstacles {
            Obstacles::Field(field) => field.is_free(a, b),
            Obstacles::Discs(discs, _) => discs.iter().all(|disc| disc.clearance_of_segment(a, b) >= 0.0),
        }
    }

    /// The corners of the path through these points.
    pub(super) fn path(&self, points: impl Iterator<Item = [f64; 2]>) -> Vec<[f64; 2]> {
        std::iter::once(self.start).chain(points).chain([self.goal]).collect()
    }

    /// The path as it is handed over: smoothed, if that is wanted.
    pub(super) fn solution(&self, points: impl Iterator<Item = [f64; 2]>) -> Solution {
        let raw = self.path(points);
        Solution::Path(self.smoothed(&raw).unwrap_or(raw))
    }

    fn smoothed(&self, path: &[[f64; 2]]) -> Option<Vec<[f64; 2]>> {
        let Smoothing { strength, passes } = self.smoothing?;
        let free = |a, b| self.is_free(a, b);
        let mut path = subdivided(path, PIECES, free);
        // The filter's rounding must not carry a point over the border.
        let Bounds { min, max } = self.bounds;
        shuman(&mut path, strength, passes, |point| [0, 1].map(|axis| math::clamp(point[axis], min[axis], max[axis])), free);
        Some(path)
    }

    /// Tells L_D and L_S of the path through these points.
    pub(super) fn read(&self, points: impl Iterator<Item = [f64; 2]>, out: &mut Readings) {
        let Measures { length, squares, .. } = self.measure(points, &mut Scratch::default());
        out.push(LENGTH, length);
        out.push(SMOOTHNESS, squares);
    }

    /// Draws the smoothed path through these points.
    pub(super) fn draw_result(&self, points: impl Iterator<Item = [f64; 2]>, frame: &mut Frame) {
        if let Some(path) = self.smoothed(&self.path(points)) {
            frame.begin(layers::SMOOTHED.key, Shape::Polyline);
            path.into_iter().for_each(|point| frame.push(point, 0.0));
        }
    }
}
