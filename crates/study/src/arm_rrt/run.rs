//! One run of a tree and of the arm behind it, as a row.

use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};

use forage::{
    Setup, Status, Value,
    arm::ArmScene,
    describe::Start,
    follow::motion::MotionOutcome,
    geometry::length_in_space,
    kernel::{Error, Readings, Solution, Stepper},
    standard,
};

use super::super::{rows::KeyedRow, runner::Job};

/// A run. What begins with `measured` is no result: it differs each time.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(super) struct Run {
    pub scene: String,
    pub planner: String,
    /// In metres; of the joints' tree, whose step is no length, nothing.
    pub step: Option<f64>,
    pub seed: u64,
    /// There is a path for the tip that touches nothing.
    pub found: bool,
    /// After how many extensions the path was found; of `rrt-star` the one that it ends with.
    pub found_after: Option<f64>,
    pub extensions: u64,
    pub nodes: u64,
    /// The tip's way along the tree.
    pub raw_length: Option<f64>,
    /// How far that is from the straight line at most.
    pub raw_aside: Option<f64>,
    /// The length of what is handed over: shortened, fitted, smoothed.
    pub length: Option<f64>,
    /// The arm can follow it to the goal.
    pub followed: Option<bool>,
    /// And touches nothing with any link.
    pub free: Option<bool>,
    /// From one posture to the next, in degrees.
    pub largest_step: Option<f64>,
    pub seconds: Option<f64>,
    pub mirrored: Option<u64>,
    pub drawn: Option<u64>,
    #[serde(rename = "trouble")]
    pub failure: Option<String>,
    /// The time of the tree alone.
    pub measured_ms: f64,
}

impl KeyedRow for Run {
    fn key(&self) -> String {
        key(&self.scene, &self.planner, self.step, self.seed)
    }

    fn computed(&self) -> Self {
        Self { measured_ms: 0.0, ..self.clone() }
    }
}

fn key(scene: &str, planner: &str, step: Option<f64>, seed: u64) -> String {
    let step = step.map_or(String::new(), |step| format!(" step {step}"));
    format!("{scene}, {planner}{step}, seed {seed}")
}

/// A setup whose run is a row.
pub(super) struct Task(pub Setup);

/// The step of a setup's tree.
pub(super) fn step(setup: &Setup) -> Option<f64> {
    match setup.params.get("step_size") {
        Some(Value::Number(step)) => Some(*step),
        _ => None,
    }
}

/// A tree and its path as it has grown.
struct Tree {
    path: Option<Vec<[f64; 3]>>,
    readings: Readings,
    extensions: u64,
    ms: f64,
}

/// Grows a tree, nothing else: no keyframes, no finishing, no arm. `None` if it was stopped.
#[expect(clippy::disallowed_types, reason = "how long it takes is printed with the results; no planner sees it")]
fn grow(setup: &Setup, stop: &AtomicBool) -> Result<Option<Tree>, Error> {
    let mut raw = setup.clone();
    for part in ["shorten", "polyline", "smooth"] {
        raw.params.insert(part, Value::Flag(false));
    }
    let (entry, parameters) = raw.check(standard())?;
    let begun = std::time::Instant::now();
    let mut run =
        Stepper::from((entry.start)(&Start { entry, scene: &raw.scene, parameters: &parameters, seed: raw.seed, entries: &**standard() })?);
    while run.step(|_| Vec::new()) {
        if run.iteration.is_multiple_of(1000) && stop.load(Ordering::Relaxed) {
            return Ok(None);
        }
    }
    let ms = begun.elapsed().as_secs_f64() * 1e3;
    let mut readings = Readings::default();
    run.planner.read(&mut readings);
    let path = run.planner.best().and_then(|best| match best.solution {
        Solution::Reach { path, .. } => Some(path),
        _ => None,
    });
    Ok(Some(Tree { path, readings, extensions: run.iteration, ms }))
}

impl Job for Task {
    type Row = Run;

    fn key(&self) -> String {
        key(self.0.scene.name(), &self.0.planner, step(&self.0), self.0.seed)
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Run>, Error> {
        let Some(tree) = grow(&self.0, stop)? else { return Ok(None) };
        let mut run = forage::Run::with_keyframes(standard(), self.0.clone(), 0)?;
        while run.step(1000) == Status::Running {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
        }
        let outcome = run.outcome();
        let arm = self.0.scene.get::<ArmScene>()?;
        let motion = outcome.followed.get::<MotionOutcome>();
        let number = |name: &str| tree.readings.get(name).filter(|value| value.is_finite());
        Ok(Some(Run {
            scene: self.0.scene.name().to_owned(),
            planner: self.0.planner.clone(),
            step: step(&self.0),
            seed: self.0.seed,
            found: outcome.feasible,
            found_after: number("converged"),
            extensions: tree.extensions,
            nodes: number("nodes").unwrap_or(0.0) as u64,
            raw_length: tree.path.as_deref().map(length_in_space),
            raw_aside: tree.path.as_deref().map(|path| aside(arm, path)),
            length: outcome.length.filter(|_| outcome.feasible),
            followed: motion.map(|motion| motion.arrived),
            free: motion.map(|motion| motion.arrived && motion.free),
            largest_step: motion.map(|motion| motion.largest_step),
            seconds: motion.map(|motion| motion.time),
            mirrored: motion.map(|motion| motion.mirrored),
            drawn: motion.map(|motion| motion.drawn),
            failure: motion.and_then(|motion| motion.failure.as_ref().map(ToString::to_string)),
            measured_ms: tree.ms,
        }))
    }
}

/// How far a path is from the straight line between its scene's start and goal, at most.
pub(crate) fn aside(arm: &ArmScene, path: &[[f64; 3]]) -> f64 {
    let minus = |a: [f64; 3], b: [f64; 3]| [0, 1, 2].map(|i| a[i] - b[i]);
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let line = minus(arm.goal, arm.start);
    let distance = |&point: &[f64; 3]| {
        let from = minus(point, arm.start);
        let along = if dot(line, line) > 0.0 { (dot(from, line) / dot(line, line)).clamp(0.0, 1.0) } else { 0.0 };
        let off = minus(from, line.map(|c| c * along));
        dot(off, off).sqrt()
    };
    // Farthest at a corner: the distance from a segment is convex.
    path.iter().map(distance).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::{
        super::{PLANNERS, setups, straight_line},
        *,
    };
    use forage::shipped;

    #[test]
    fn a_path_is_as_far_aside_as_its_farthest_corner() {
        let scene = shipped("arm-free").unwrap();
        let arm = scene.get::<ArmScene>().unwrap();
        assert_eq!(aside(arm, &[arm.start, arm.goal]), 0.0);
        let middle = [0, 1, 2].map(|i| f64::midpoint(arm.start[i], arm.goal[i]));
        // At right angles to the line, in the plane: (−dy, dx).
        let [dx, dy] = [0, 1].map(|i| arm.goal[i] - arm.start[i]);
        let off = [middle[0] - 0.1 * dy, middle[1] + 0.1 * dx, middle[2]];
        assert!((aside(arm, &[arm.start, off, arm.goal]) - 0.1 * (dx * dx + dy * dy).sqrt()).abs() < 1e-12);
        // Behind the goal it is the distance from the goal.
        let behind = [0, 1, 2].map(|i| arm.goal[i] + (arm.goal[i] - arm.start[i]));
        assert!((aside(arm, &[arm.start, behind]) - straight_line(arm)).abs() < 1e-12);
    }

    #[test]
    fn a_row_agrees_with_itself_however_long_it_took() {
        let stop = AtomicBool::new(false);
        let setup = setups().unwrap().swap_remove(2);
        assert_eq!(setup.planner, PLANNERS[1]);
        let row = || Task(setup.clone()).run(&stop).unwrap().unwrap();
        let (a, b) = (row(), row());
        assert!(a.computed() == b.computed() && a.found && a.raw_length >= a.length);
        assert_ne!(a.computed(), Run { nodes: a.nodes + 1, ..b }.computed());
    }
}
