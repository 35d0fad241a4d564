//! One run of many: carried out step by step, and summed up in a [`Record`].
//!
//! Sweeps natively and batches in the page are made of these, so that both have the same rows. A record says what came out
//! and what it cost in evaluations, but no times: those are no property of the run.

use std::sync::Arc;

use serde::Serialize;

use crate::{
    describe::Registry,
    kernel::{Error, ReferenceOptimum, Status, Stepped},
    message,
    params::Overrides,
    settled::SETTLED,
};

use super::{curve::Improvement, setup::Setup, stepping::Run};

/// How near to the exact optimum counts as reached by default: 1 % of it, on functions a difference of 0.01.
pub const WITHIN: f64 = 0.01;

/// What a run came to.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "TrialRecord"))]
pub struct Record {
    /// The planner's name.
    #[cfg_attr(feature = "types", ts(type = "PlannerName"))]
    pub planner: &'static str,
    /// The scene's name.
    pub scene: String,
    /// The seed.
    pub seed: u64,
    /// The parameters that differ from the defaults.
    #[cfg_attr(feature = "types", ts(type = "Record<string, ParameterValue>"))]
    pub parameters: Overrides,
    /// Running, or why it stopped.
    pub status: Status,
    /// The iteration at which it ends at the latest.
    pub limit: u64,
    /// Iterations taken.
    pub iterations: u64,
    /// Candidate solutions evaluated.
    pub evaluations: u64,
    /// What the planner minimised; `None` before anything was found.
    pub cost: Option<f64>,
    /// The path's length, in the scene's unit.
    pub length: Option<f64>,
    /// What runs are compared by: a feasible result's length, or where there is no path its cost. `None` if there is none.
    pub value: Option<f64>,
    /// True only if the result itself was checked and breaks nothing.
    pub feasible: bool,
    /// The smallest distance to an obstacle.
    pub clearance: Option<f64>,
    /// The exact optimum by the rule that the planner keeps to.
    pub exact: Option<f64>,
    /// Which optimum that is.
    pub exact_by: ReferenceOptimum,
    /// (length − exact) / exact.
    pub gap: Option<f64>,
    /// Evaluations when the best was first feasible and near enough to the optimum; `None` if it never was, or there is none.
    pub reached: Option<u64>,
    /// The same in iterations.
    pub reached_iteration: Option<u64>,
    /// The iteration from which the population's mean stayed within 1 % of its best; `None` without such a reading, or if it never did.
    pub settled: Option<f64>,
    /// At how many corners the path turns.
    pub turns: Option<usize>,
    /// No random number has a part in it: other seeds give the same result.
    pub deterministic: bool,
    /// The state's hash.
    pub hash: String,
}

/// A run with a record.
///
/// ```
/// use forage::{Setup, Trial, run::trial::WITHIN, shipped, standard};
/// let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs")?, params: Default::default(), seed: 1 };
/// let mut trial = Trial::new(standard(), setup, WITHIN)?;
/// trial.step(u64::MAX);
/// let record = trial.record();
/// assert!(record.feasible && record.reached.unwrap() <= record.evaluations);
/// # Ok::<(), forage::Error>(())
/// ```
pub struct Trial {
    run: Run,
    /// The largest value that is near enough to the optimum, if there is one.
    near: Option<f64>,
}

impl Trial {
    /// Starts a run. Near enough to the optimum is what is longer by up to the share `within` of it; on functions, whose values have no
    /// natural zero, and where the optimum is 0, what is larger by up to `within`.
    ///
    /// # Errors
    /// As [`Run::new`], and a `within` that is no number from 0 to 1,000,000.
    pub fn new(registry: &Arc<Registry>, setup: Setup, within: f64) -> Result<Self, Error> {
        if !(0.0..=1e6).contains(&within) {
            return Err(Error::refused(
                "within",
                within,
                message!("run-within", "from 0 to 1000000, a share of the exact optimum, or on functions a difference"),
            ));
        }
        let mut run = Run::with_keyframes(registry, setup, 0)?;
        let length = run.exact().map(|exact| if exact.length > 0.0 { exact.length * (1.0 + within) } else { within });
        let near = length.or_else(|| run.scene().minimum().map(|minimum| minimum.value + within));
        run.curve();
        Ok(Self { run, near })
    }

    /// Takes up to `steps` steps; stops where the planner does.
    pub fn step(&mut self, steps: u64) -> Status {
        self.run.step(steps)
    }

    /// Does a part of a step: see [`Run::part`].
    pub fn part(&mut self) -> Stepped {
        self.run.part()
    }

    /// Takes a step unless `stop` becomes true: see [`Run::step_until`].
    ///
    /// # Errors
    /// As [`Run::step_until`].
    pub fn step_until(&mut self, stop: &(dyn Fn() -> bool + Sync)) -> Result<Stepped, Error> {
        self.run.step_until(stop)
    }

    /// The run.
    pub fn run(&mut self) -> &mut Run {
        &mut self.run
    }

    /// The values of the feasible best, whenever it changed.
    pub fn curve(&mut self) -> &[Improvement] {
        self.run.curve()
    }

    /// Iterations and evaluations when the best was near enough.
    fn reached(&mut self) -> Option<[u64; 2]> {
        let near = self.near?;
        self.run.curve().iter().find(|best| best.value <= near).map(|best| [best.iteration, best.evaluations])
    }

    /// What the run came to so far.
    pub fn record(&mut self) -> Record {
        let parameters = self.run.parameters().changed().clone();
        let outcome = self.run.outcome();
        let found = outcome.feasible && outcome.cost.is_some() && outcome.status != Status::Failed;
        let settled =
            outcome.readings.iter().find(|(name, _)| *name == SETTLED.name).map(|(_, value)| *value).filter(|value| value.is_finite());
        // A stored optimum that a result refutes was none.
        let reached = self.reached().filter(|_| outcome.exact.is_some());
        Record {
            planner: outcome.planner,
            scene: outcome.scene,
            seed: outcome.seed,
            parameters,
            status: outcome.status,
            limit: self.run.limit(),
            iterations: outcome.iterations,
            evaluations: outcome.evaluations,
            cost: outcome.cost,
            length: outcome.length,
            value: outcome.length.or(outcome.cost).filter(|_| found),
            feasible: found,
            clearance: outcome.clearance,
            exact: outcome.exact,
            exact_by: outcome.exact_by,
            gap: outcome.gap,
            reached: reached.map(|[_, evaluations]| evaluations),
            reached_iteration: reached.map(|[iteration, _]| iteration),
            settled,
            turns: outcome.turns,
            deterministic: outcome.deterministic,
            hash: outcome.hash,
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

    use super::*;
    use crate::{describe::Entry, shipped, swarm::pso};

    static STARTS: AtomicUsize = AtomicUsize::new(0);
    static COUNTED: Entry = Entry {
        name: "counted",
        start: |start| {
            STARTS.fetch_add(1, Relaxed);
            (pso::ENTRY.start)(start)
        },
        ..pso::ENTRY
    };

    /// The curve begins with the state that the run has: a start may evaluate as much as many steps.
    #[test]
    fn a_trial_starts_its_planner_once() {
        let registry = Arc::new(Registry::standard().with(&COUNTED));
        let setup =
            |planner: &str| Setup { planner: planner.into(), scene: shipped("wcpso-discs").unwrap(), params: Overrides::new(), seed: 3 };
        let mut trial = Trial::new(&registry, setup("counted"), WITHIN).unwrap();
        trial.step(u64::MAX);
        let (record, curve) = (trial.record(), trial.curve().to_vec());
        assert_eq!(STARTS.load(Relaxed), 1);
        let mut late = Run::with_keyframes(&registry, setup("pso"), 0).unwrap();
        late.step(u64::MAX);
        assert_eq!(late.curve(), curve, "a replay gives the same curve");
        assert_eq!(record.iterations, late.iteration());
    }

    /// On a function near means a difference, whatever its minimum is: here −48.22.
    #[test]
    fn near_on_a_function_is_a_difference() {
        let function = crate::scene::FunctionScene::bbob(15, 3, 2).unwrap();
        let scene = Arc::new(crate::scene::function::KIND.scene(crate::scene::Header::named("f", "F"), function).unwrap());
        let minimum = scene.minimum().unwrap().value;
        assert!((minimum + 48.22).abs() < 1e-9, "{minimum}");
        for within in [4.0, 0.5] {
            let setup = Setup { planner: "pso".into(), scene: Arc::clone(&scene), params: Overrides::new(), seed: 1 };
            let mut trial = Trial::new(&Arc::new(Registry::standard()), setup, within).unwrap();
            trial.step(u64::MAX);
            let first = trial.curve().iter().find(|best| best.value <= minimum + within).map(|best| best.evaluations);
            assert!(first.is_some());
            assert_eq!(trial.record().reached, first);
        }
    }
}
