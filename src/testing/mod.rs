//! The conformance suite: what every planner must keep to, checked for yours as for ours. Not part of the wasm.
//!
//! ```
//! use forage::{standard, testing};
//!
//! testing::assert_conforms(standard(), "a-star");
//! ```
//!
//! A planner from outside is checked the same way, in a `#[test]`, with a registry that lists it. The suite runs it on the
//! shipped scenes and on generated ones, with default, random and extreme parameters. All that is random follows from
//! fixed seeds: a suite finds the same every time. Build it with debug assertions, as tests usually are: only so does it see
//! that a parameter is read which the entry does not list.
//!
//! - `entry`: what can be seen without running it. `cases`: what it is shown with. `parameters`: every value that the entry allows.
//! - `repeat`: determinism, the way back, links, hashes. `results`: costs, solutions, limits.
//! - `shown`: readings, layers, members and events. `explain`: explanations.
//! - `subject` draws the runs; a `fault` in one becomes one of the `findings`, which make the `report`.
//!
//! The suite cannot see everything. It sees that a skipped field matters (`#[state(skip)]`) only where nothing else of the
//! state changes with it; it does not measure memory, nor time.

mod cases;
mod entry;
mod explain;
mod fault;
mod findings;
mod parameters;
mod repeat;
mod report;
mod results;
mod shown;
mod subject;

use std::sync::Arc;

use crate::{
    describe::Registry,
    kernel::Scene,
    params::{Overrides, Value},
};

use findings::Findings;
use subject::Subject;

pub use report::{Finding, Report};

/// A check of one planner.
#[derive(Debug, Clone, Copy)]
pub struct Check {
    /// Its name: what holds for a planner that keeps to it.
    pub name: &'static str,
    run: fn(&Subject, &mut Findings),
}

/// All checks, in the order in which they are made.
pub const CHECKS: &[Check] = &[
    Check { name: "its_entry_is_complete", run: entry::is_complete },
    Check { name: "its_presets_run_and_change_something", run: entry::presets_run },
    Check { name: "its_cases_show_something", run: cases::show_something },
    Check { name: "parameters_run_at_both_ends", run: parameters::both_ends_run },
    Check { name: "values_that_are_not_allowed_are_refused_by_name", run: parameters::others_are_refused },
    Check { name: "the_same_setup_gives_the_same_bits", run: repeat::same_bits },
    Check { name: "rewinding_is_exact", run: repeat::rewinding },
    Check { name: "a_link_reproduces_the_hash", run: repeat::links },
    Check { name: "only_random_runs_depend_on_their_seed", run: repeat::seeds },
    Check { name: "the_hash_sees_the_state", run: repeat::hashes },
    Check { name: "results_only_get_better", run: results::only_better },
    Check { name: "results_are_what_they_are_said_to_be", run: results::honest },
    Check { name: "runs_end_as_they_say", run: results::ends },
    Check { name: "readings_are_those_of_the_entry", run: shown::readings },
    Check { name: "layers_are_those_of_the_entry", run: shown::layers },
    Check { name: "members_and_events_are_those_of_the_entry", run: shown::members_and_events },
    Check { name: "what_can_be_picked_is_explained", run: explain::explained },
    Check { name: "what_is_said_to_be_exact_is_optimal", run: results::exact },
];

/// Checks of one planner. [`assert_conforms`] is the short form.
#[derive(Debug, Clone)]
pub struct Suite {
    registry: Arc<Registry>,
    planner: String,
    random_runs: u32,
    fixed: Overrides,
    scenes: Vec<Arc<Scene>>,
}

impl Suite {
    /// All checks of a planner that the registry lists, with [`Suite::RANDOM_RUNS`].
    pub fn new(registry: &Arc<Registry>, planner: &str) -> Self {
        Self {
            registry: Arc::clone(registry),
            planner: planner.to_owned(),
            random_runs: Self::RANDOM_RUNS,
            fixed: Overrides::new(),
            scenes: Vec::new(),
        }
    }

    /// The number of random runs of a check if nothing else is asked for: seconds in all.
    pub const RANDOM_RUNS: u32 = 4;

    /// Sets the number of runs of each check with random scenes, parameters and seeds.
    #[must_use]
    pub fn random_runs(self, random_runs: u32) -> Self {
        Self { random_runs, ..self }
    }

    /// Keeps a parameter at a value, where it applies: for a planner whose steps take long with the default.
    #[must_use]
    pub fn set(mut self, parameter: &str, value: impl Into<Value>) -> Self {
        self.fixed.insert(parameter, value.into());
        self
    }

    /// Adds a scene to those that ship and those that are generated.
    #[must_use]
    pub fn with_scene(mut self, scene: Arc<Scene>) -> Self {
        self.scenes.push(scene);
        self
    }

    /// Makes all checks.
    pub fn run(&self) -> Report {
        self.run_checks(CHECKS)
    }

    /// Makes some checks.
    pub fn run_checks(&self, checks: &[Check]) -> Report {
        let mut findings = Findings::new(&self.registry, &self.planner);
        match self.registry.planner(&self.planner) {
            Ok(entry) => {
                let subject = Subject::new(&self.registry, entry, self.random_runs, &self.fixed, &self.scenes);
                for check in checks {
                    findings.check = check.name;
                    // Its random runs are the same whichever other checks are made.
                    findings.number = CHECKS.iter().position(|known| known.name == check.name).unwrap_or(0) as u64;
                    (check.run)(&subject, &mut findings);
                }
            }
            Err(error) => findings.unlisted(&error),
        }
        Report { planner: self.planner.clone(), checks: checks.len(), findings: findings.list }
    }
}

/// Makes all checks of a planner that the registry lists, with a few random runs each.
pub fn check(registry: &Arc<Registry>, planner: &str) -> Report {
    Suite::new(registry, planner).run()
}

/// Panics with a readable report unless a planner that the registry lists keeps to all that a planner promises.
///
/// # Panics
/// If it breaks a promise.
#[track_caller]
pub fn assert_conforms(registry: &Arc<Registry>, planner: &str) {
    check(registry, planner).assert();
}
