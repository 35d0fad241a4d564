//! The result, honestly: what was found, whether it is any good, and what it cost.

use serde::Serialize;

use crate::{
    arm::{self, MotionOutcome},
    drive::{self, DriveOutcome},
    geometry,
    kernel::{Event, Recommend, Recommendation, ReferenceOptimum, Solution, Status, Track},
    params::{Overrides, Value, as_object},
    scene::TOUR,
};

use super::run::Session;

/// Where a run stands. Serialises to the object that `forage run --json` prints and `outcome()` returns.
#[derive(Debug, Clone, Serialize)]
pub struct Outcome {
    /// The planner's name.
    pub planner: &'static str,
    /// The scene's name.
    pub scene: String,
    /// The seed.
    pub seed: u64,
    /// Iterations taken.
    pub iterations: u64,
    /// Candidate solutions evaluated.
    pub evaluations: u64,
    /// Running, or why it stopped.
    pub status: Status,
    /// What the planner minimised; `None` before anything was found.
    pub cost: Option<f64>,
    /// The path's length, in the scene's unit.
    pub length: Option<f64>,
    /// True only if the result itself was checked and breaks nothing, whatever the penalty was.
    pub feasible: bool,
    /// The smallest distance to an obstacle; negative: how deep the path cuts.
    pub clearance: Option<f64>,
    /// The exact optimum by the rule that the planner keeps to.
    pub exact: Option<f64>,
    /// Which optimum that is: over the cells of a grid, at any angle, by the scene's distances, or as its file says.
    pub exact_by: ReferenceOptimum,
    /// (length − exact) / exact; `None` where the optimum is 0 or there is no length.
    pub gap: Option<f64>,
    /// At how many corners the path turns.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turns: Option<usize>,
    /// How much the path turns in all, in radians.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turning: Option<f64>,
    /// How the scene's robot drives along the path, with the default parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub drive: Option<DriveOutcome>,
    /// The path's corners.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub path: Option<Vec<[f64; 2]>>,
    /// The corners of the tip's path, in metres. Arms only.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tip_path: Option<Vec<[f64; 3]>>,
    /// The postures that were planned, in degrees, where the planner plans postures.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub joints: Vec<[f64; 6]>,
    /// How the arm follows the path, with the default parameters.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub motion: Option<MotionOutcome>,
    /// The stops' numbers in the tour's order.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub order: Option<Vec<usize>>,
    /// The point in a function's box.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub position: Option<Vec<f64>>,
    /// The numbers of this iteration.
    #[serde(serialize_with = "as_object")]
    pub readings: Vec<(&'static str, f64)>,
    /// What keeps the planner from a result, if something does.
    #[serde(rename = "trouble", skip_serializing_if = "Option::is_none")]
    pub failure: Option<String>,
    /// What happened in simulated time, and what was decided and why.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub events: Vec<Event>,
    /// What a planner of planners recommends.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tuned: Option<Recommendation>,
    /// No random number has a part in it: other seeds give the same result.
    pub deterministic: bool,
    /// The hash of setup, iteration, best and state.
    pub hash: String,
    /// Every parameter's value.
    #[serde(serialize_with = "as_object")]
    pub parameters: Vec<(&'static str, Value)>,
}

impl Session {
    /// The run's current result, judged, with all its numbers.
    pub fn outcome(&mut self) -> Outcome {
        Outcome::of(self)
    }

    /// How the arm follows the best path with the usual parameters.
    fn usual_motion(&mut self, best: &Solution) -> Option<MotionOutcome> {
        if self.followed.as_ref().is_none_or(|(solution, _)| solution != best) {
            // The defaults are never refused.
            let motion = arm::along(&self.scene, Some(best), &Overrides::new()).ok().flatten();
            self.followed = motion.map(|motion| (best.clone(), motion.outcome));
        }
        self.followed.as_ref().map(|(_, outcome)| outcome.clone())
    }

    /// What keeps the run from a result, if something does.
    fn failure(&self) -> Option<String> {
        self.at.planner.facets().failure?.failure(self.status())
    }
}

impl Outcome {
    pub(super) fn of(session: &mut Session) -> Self {
        let readings = session.readings().iter().collect();
        let digest = session.digest();
        let best = session.best();
        let verdict = best.as_ref().map(|best| session.scene.judge(&best.solution));
        let length = verdict.and_then(|v| v.length);
        let (exact, exact_by) = match session.exact() {
            Some(exact) if exact.stored && length.is_some_and(|length| length < exact.length) => (None, ReferenceOptimum::Refuted),
            Some(exact) => (Some(exact.length), if exact.stored { ReferenceOptimum::Stored } else { session.reference }),
            None => (session.scene.minimum(), session.reference),
        };
        let nodes = best.as_ref().map_or(0, |best| best.solution.corners());
        let gap = exact.zip(length).filter(|(exact, _)| *exact > 0.0).map(|(exact, length)| gap(length, exact, nodes));
        let cost = best.as_ref().map(|best| best.cost);
        let motion = best.as_ref().and_then(|best| session.usual_motion(&best.solution));
        let (tip_path, joints) = match best.as_ref().map(|best| &best.solution) {
            Some(Solution::Reach { path, postures }) => (Some(path.clone()), postures.iter().map(arm::degrees).collect()),
            _ => (None, Vec::new()),
        };
        let (path, order, position) = match best.map(|best| best.solution) {
            Some(Solution::Path(path) | Solution::Drive(Track { path, .. })) => (Some(path), None, None),
            Some(Solution::Tour { path, order, .. }) => (Some(path), Some(order), None),
            Some(Solution::Position(position)) => (None, None, Some(position)),
            Some(Solution::Reach { .. }) | None => (None, None, None),
        };
        // Between stops of a tour there are no corners to count.
        let turned = path.as_deref().filter(|_| session.scene.kind() != TOUR);
        // The defaults are never refused.
        let drive = drive::along(&session.scene, path.as_deref(), &Overrides::new()).ok().flatten().map(|drive| drive.outcome);
        Self {
            planner: session.entry.name,
            scene: session.scene.name().to_owned(),
            seed: session.seed,
            iterations: session.iteration(),
            evaluations: session.evaluations(),
            status: session.status(),
            cost,
            length,
            feasible: verdict.is_some_and(|v| v.feasible),
            clearance: verdict.and_then(|v| v.clearance),
            exact,
            exact_by,
            gap,
            turns: turned.map(geometry::turns),
            turning: turned.map(geometry::turning),
            drive,
            path,
            tip_path,
            joints,
            motion,
            order,
            position,
            readings,
            failure: session.failure(),
            events: session.events().to_vec(),
            tuned: session.at.planner.facets().recommend.and_then(Recommend::recommendation),
            deterministic: !digest.is_random(),
            hash: digest.hex(),
            parameters: session.settings.all().to_vec(),
        }
    }
}

/// (length − exact) / exact. The same steps added in another order differ in the last digits: that is no gap.
/// Each of the `nodes` that are added may be off by one.
fn gap(length: f64, exact: f64, nodes: usize) -> f64 {
    let gap = (length - exact) / exact;
    if gap.abs() <= (nodes + 2) as f64 * f64::EPSILON { 0.0 } else { gap }
}
