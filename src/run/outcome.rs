//! The result, honestly: what was found, whether it is any good, and what it cost.

use serde::{Serialize, Serializer, ser::SerializeStruct};

use crate::{
    describe::FollowOutcomes,
    geometry,
    kernel::{Event, Message, Recommend, Recommendation, ReferenceOptimum, Solution, Status, Track},
    params::{Object, Overrides, Value},
};

use super::stepping::Run;

/// The result of a run so far, judged. Serialises to the object that `forage run --json` prints and `outcome()` returns.
#[derive(Debug, Clone)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Outcome {
    /// The planner's name.
    #[cfg_attr(feature = "types", ts(type = "PlannerName"))]
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
    #[cfg_attr(feature = "types", ts(optional))]
    pub turns: Option<usize>,
    /// How much the path turns in all, in radians.
    #[cfg_attr(feature = "types", ts(optional))]
    pub turning: Option<f64>,
    /// How the robot or the arm of the scene follows the path, with the default parameters: `drive`, `motion`.
    #[cfg_attr(feature = "types", ts(skip))]
    pub followed: FollowOutcomes,
    /// The path's corners.
    #[cfg_attr(feature = "types", ts(optional))]
    pub path: Option<Vec<[f64; 2]>>,
    /// When it was where, for a path that was driven: `[t, x, y]` at every change of its motion, in seconds. Between two of them it
    /// went straight at constant speed, or stood still.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<[f64; 3]>>"))]
    pub moments: Vec<[f64; 3]>,
    /// The corners of the tip's path, in metres. Arms only.
    #[cfg_attr(feature = "types", ts(optional))]
    pub tip_path: Option<Vec<[f64; 3]>>,
    /// The postures that were planned, in degrees, where the planner plans postures.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<[f64; 6]>>"))]
    pub joints: Vec<[f64; 6]>,
    /// The stops' numbers in the tour's order.
    #[cfg_attr(feature = "types", ts(optional))]
    pub order: Option<Vec<usize>>,
    /// The point in a function's box.
    #[cfg_attr(feature = "types", ts(optional))]
    pub position: Option<Vec<f64>>,
    /// The numbers of this iteration.
    #[cfg_attr(feature = "types", ts(type = "Record<string, number>"))]
    pub readings: Vec<(&'static str, f64)>,
    /// What keeps the planner from a result, if something does.
    #[cfg_attr(feature = "types", ts(optional, rename = "trouble", as = "Option<String>"))]
    pub failure: Option<Message>,
    /// Where a cost could not be computed, if that is the reason.
    #[cfg_attr(feature = "types", ts(optional))]
    pub failed_at: Option<Vec<f64>>,
    /// What happened in simulated time, and what was decided and why.
    #[cfg_attr(feature = "types", ts(optional, as = "Option<Vec<Event>>"))]
    pub events: Vec<Event>,
    /// What a planner of planners recommends.
    #[cfg_attr(feature = "types", ts(optional))]
    pub tuned: Option<Recommendation>,
    /// No random number has a part in it: other seeds give the same result.
    pub deterministic: bool,
    /// The hash of setup, iteration, best and state. It may be made empty where it is of no iteration; then it is not serialised.
    pub hash: String,
    /// Every parameter's value.
    #[cfg_attr(feature = "types", ts(type = "Record<string, ParameterValue>"))]
    pub parameters: Vec<(&'static str, Value)>,
}

/// The object that `forage run --json` prints and `outcome()` returns. What does not apply is left out.
impl Serialize for Outcome {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Outcome", 30)?;
        out.serialize_field("planner", &self.planner)?;
        out.serialize_field("scene", &self.scene)?;
        out.serialize_field("seed", &self.seed)?;
        out.serialize_field("iterations", &self.iterations)?;
        out.serialize_field("evaluations", &self.evaluations)?;
        out.serialize_field("status", &self.status)?;
        out.serialize_field("cost", &self.cost)?;
        out.serialize_field("length", &self.length)?;
        out.serialize_field("feasible", &self.feasible)?;
        out.serialize_field("clearance", &self.clearance)?;
        out.serialize_field("exact", &self.exact)?;
        out.serialize_field("exact_by", &self.exact_by)?;
        out.serialize_field("gap", &self.gap)?;
        if let Some(turns) = &self.turns {
            out.serialize_field("turns", turns)?;
        }
        if let Some(turning) = &self.turning {
            out.serialize_field("turning", turning)?;
        }
        for (follower, outcome) in self.followed.iter() {
            out.serialize_field(follower, outcome)?;
        }
        if let Some(path) = &self.path {
            out.serialize_field("path", path)?;
        }
        if !self.moments.is_empty() {
            out.serialize_field("moments", &self.moments)?;
        }
        if let Some(tip_path) = &self.tip_path {
            out.serialize_field("tip_path", tip_path)?;
        }
        if !self.joints.is_empty() {
            out.serialize_field("joints", &self.joints)?;
        }
        if let Some(order) = &self.order {
            out.serialize_field("order", order)?;
        }
        if let Some(position) = &self.position {
            out.serialize_field("position", position)?;
        }
        out.serialize_field("readings", &Object(&self.readings))?;
        if let Some(failure) = &self.failure {
            out.serialize_field("trouble", failure)?;
        }
        if let Some(position) = &self.failed_at {
            out.serialize_field("failed_at", position)?;
        }
        if !self.events.is_empty() {
            out.serialize_field("events", &self.events)?;
        }
        if let Some(tuned) = &self.tuned {
            out.serialize_field("tuned", tuned)?;
        }
        out.serialize_field("deterministic", &self.deterministic)?;
        if !self.hash.is_empty() {
            out.serialize_field("hash", &self.hash)?;
        }
        out.serialize_field("parameters", &Object(&self.parameters))?;
        out.end()
    }
}

impl Run {
    /// The run's current result, judged, with all its numbers.
    pub fn outcome(&mut self) -> Outcome {
        Outcome::of(self)
    }

    /// How the followers fare on the best path with the usual parameters.
    fn followed(&mut self, best: &Solution) -> FollowOutcomes {
        if self.followed.as_ref().is_none_or(|(solution, _)| solution != best) {
            let mut outcomes = FollowOutcomes::default();
            for follower in self.registry().map_or(&[][..], |registry| registry.followers()) {
                // The defaults are never refused.
                let followed = (follower.follow)(&self.scene, Some(best), &Overrides::new()).ok().flatten();
                outcomes.set(follower.name, followed.map(|followed| followed.outcome()));
            }
            self.followed = Some((best.clone(), outcomes));
        }
        self.followed.as_ref().map(|(_, outcomes)| outcomes.clone()).unwrap_or_default()
    }

    /// What keeps the run from a result, if something does.
    fn failure(&self) -> Option<Message> {
        self.at.planner.facets().failure?.failure(self.status())
    }

    /// Where a cost could not be computed.
    fn failed_at(&self) -> Option<Vec<f64>> {
        self.at.planner.facets().failure?.failed_at().map(<[f64]>::to_vec)
    }
}

impl Outcome {
    pub(super) fn of(run: &mut Run) -> Self {
        let readings = run.readings().iter().collect();
        let digest = run.digest();
        let best = run.best();
        let verdict = best.as_ref().map(|best| run.scene.judge(&best.solution));
        let length = verdict.and_then(|v| v.length);
        let (exact, exact_by) = match run.exact() {
            Some(exact) if exact.stored && length.is_some_and(|length| length < exact.length) => (None, ReferenceOptimum::Refuted),
            Some(exact) => (Some(exact.length), if exact.stored { ReferenceOptimum::Stored } else { run.reference }),
            None => match run.scene.minimum() {
                Some(minimum) if best.as_ref().is_some_and(|best| minimum.is_refuted_by(best.cost)) => (None, ReferenceOptimum::Refuted),
                Some(minimum) => (Some(minimum.value), if minimum.stated { ReferenceOptimum::Stored } else { run.reference }),
                None => (None, run.reference),
            },
        };
        let nodes = best.as_ref().map_or(0, |best| best.solution.corners());
        let gap = exact.zip(length).filter(|(exact, _)| *exact > 0.0).map(|(exact, length)| gap(length, exact, nodes));
        let cost = best.as_ref().map(|best| best.cost);
        let followed = best.as_ref().map(|best| run.followed(&best.solution)).unwrap_or_default();
        let (tip_path, joints) = match best.as_ref().map(|best| &best.solution) {
            Some(Solution::Reach { path, postures }) => {
                (Some(path.clone()), postures.iter().map(|posture| posture.map(f64::to_degrees)).collect())
            }
            _ => (None, Vec::new()),
        };
        let moments = match best.as_ref().map(|best| &best.solution) {
            Some(Solution::Drive(track)) => track.moments.clone(),
            _ => Vec::new(),
        };
        let (path, order, position) = match best.map(|best| best.solution) {
            Some(Solution::Path(path) | Solution::Drive(Track { path, .. })) => (Some(path), None, None),
            Some(Solution::Tour { path, order, .. }) => (Some(path), Some(order), None),
            Some(Solution::Position(position)) => (None, None, Some(position)),
            Some(Solution::Reach { .. }) | None => (None, None, None),
        };
        // Between stops of a tour there are no corners to count.
        let turned = path.as_deref().filter(|_| run.scene.plane().is_some());
        Self {
            planner: run.entry.name,
            scene: run.scene.name().to_owned(),
            seed: run.seed,
            iterations: run.iteration(),
            evaluations: run.evaluations(),
            status: run.status(),
            cost,
            length,
            feasible: verdict.is_some_and(|v| v.feasible),
            clearance: verdict.and_then(|v| v.clearance),
            exact,
            exact_by,
            gap,
            turns: turned.map(geometry::turns),
            turning: turned.map(geometry::turning),
            followed,
            path,
            moments,
            tip_path,
            joints,
            order,
            position,
            readings,
            failure: run.failure(),
            failed_at: run.failed_at(),
            events: run.events().to_vec(),
            tuned: run.at.planner.facets().recommend.and_then(Recommend::recommendation),
            deterministic: !digest.is_random(),
            hash: digest.hex(),
            parameters: run.parameters.all().to_vec(),
        }
    }
}

/// (length − exact) / exact. The same steps added in another order differ in the last digits: that is no gap.
/// Each of the `nodes` that are added may be off by one.
fn gap(length: f64, exact: f64, nodes: usize) -> f64 {
    let gap = (length - exact) / exact;
    if gap.abs() <= (nodes + 2) as f64 * f64::EPSILON { 0.0 } else { gap }
}
