//! The suite `centre-bias`: whether a planner searches near the centre of the search box, where most test functions have their minimum.
//!
//! The same functions are minimised with the minimum in the middle, somewhere else, and in the middle with other axes, with equal
//! evaluations and the same seeds. A rotation-invariant planner has the same gap on centred and rotated functions; on shifted ones even
//! an unbiased search may have a larger gap, so it is compared with that of random search (Kudela, Nature Machine Intelligence 4 (2022)).

mod form;
mod measure;
mod report;
mod row;

use std::{
    path::{Path, PathBuf},
    sync::{Arc, atomic::AtomicBool},
};

use forage::{
    Error, Registry, math,
    scene::{FUNCTION, Function},
};

use self::row::key;
use super::{
    super::{failure::Failure, runner::Job, table::Table},
    minimise::{Convergence, Minimisation},
    suite::{Contender, Suite, SuiteJob, check_count},
    targets,
};

pub use form::Form;
pub use row::Row;

/// How many variables, unless it is said otherwise.
pub const DIMENSION: usize = 10;
/// How many instances of each form, unless it is said otherwise.
pub const INSTANCES: u64 = 50;
/// Evaluations for each variable, unless it is said otherwise.
pub const BUDGET: u64 = 1_000;
/// At how many equally spaced points of a run the gap is sampled.
const SAMPLES: u64 = 100;

/// What is run.
#[derive(Debug, Clone)]
pub struct Plan {
    /// The number of variables.
    pub dimension: usize,
    /// How many instances.
    pub instances: u64,
    /// Evaluations for each variable.
    pub budget: u64,
}

/// A run of a planner on a form of a function.
#[derive(Debug, Clone)]
pub struct Task {
    registry: Arc<Registry>,
    contender: Arc<Contender>,
    function: Function,
    form: Form,
    dimension: usize,
    instance: u64,
    budget: u64,
}

/// The functions that are defined in so many dimensions.
fn functions(dimension: usize) -> impl Iterator<Item = Function> {
    Function::ALL.into_iter().filter(move |function| (function.dimensions().0..=function.dimensions().1).contains(&dimension))
}

impl Suite for Plan {
    type Task = Task;

    const NAME: &'static str = "centre-bias";

    fn all_planners(registry: &Registry) -> Vec<Contender> {
        let planners = registry.planners().iter().filter(|entry| entry.kinds.contains(&FUNCTION));
        planners.map(|entry| Contender::new(entry.name)).collect()
    }

    fn jobs(&self, registry: &Arc<Registry>, contenders: &[Contender]) -> Result<Vec<Task>, Error> {
        let of_each = functions(self.dimension).count() * Form::ALL.len() * self.instances as usize;
        check_count(of_each.saturating_mul(contenders.len()))?;
        let mut tasks = Vec::new();
        for contender in contenders {
            let contender = Arc::new(contender.clone());
            for function in functions(self.dimension) {
                for form in Form::ALL {
                    tasks.extend((1..=self.instances).map(|instance| Task {
                        registry: Arc::clone(registry),
                        contender: Arc::clone(&contender),
                        function,
                        form,
                        dimension: self.dimension,
                        instance,
                        budget: self.budget * self.dimension as u64,
                    }));
                }
            }
        }
        // One run says it for all of a planner.
        for task in tasks.iter().step_by(of_each.max(1)) {
            let known = task.form.of(task.function, task.dimension, task.instance)?;
            let setup = task.minimisation(&task.name()).setup(known)?;
            setup.check(registry).map_err(|error| error.within(&task.contender.planner))?;
        }
        Ok(tasks)
    }

    fn write(&self, rows: &[Row], folder: &Path) -> Result<Vec<PathBuf>, Failure> {
        report::write(rows, folder)
    }

    fn table(&self, rows: &[Row]) -> Table {
        report::table(rows)
    }
}

impl Task {
    fn name(&self) -> String {
        format!("{}-{}-{}-{}", self.function.name(), self.form, self.dimension, self.instance)
    }

    fn minimisation<'a>(&'a self, name: &'a str) -> Minimisation<'a> {
        Minimisation { registry: &self.registry, contender: &self.contender, name, seed: self.instance, budget: self.budget }
    }
}

/// The common logarithm of how far above the minimum the best was, averaged over the budget's evaluations.
fn level(convergence: &Convergence, budget: u64) -> f64 {
    let mut improvements = convergence.improvements.iter().peekable();
    let mut gap = f64::INFINITY;
    let mut sum = 0.0;
    let mut counted = 0;
    for sample in 1..=SAMPLES {
        while let Some((_, lower)) = improvements.next_if(|(at, _)| at * SAMPLES <= budget * sample) {
            gap = *lower;
        }
        if gap.is_finite() {
            sum += math::ln(gap.max(targets::FINAL)) / std::f64::consts::LN_10;
            counted += 1;
        }
    }
    // Without a result there is none: 0 by 0.
    sum / f64::from(counted)
}

impl Job for Task {
    type Row = Row;

    fn key(&self) -> String {
        key(&self.contender.name(), self.function.name(), self.dimension, self.form, self.instance, self.budget)
    }

    fn weight(&self) -> u64 {
        self.budget
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Row>, Error> {
        let known = self.form.of(self.function, self.dimension, self.instance)?;
        let convergence = self.minimisation(&self.name()).run(known, stop)?;
        Ok(convergence.map(|convergence| Row {
            planner: self.contender.planner.clone(),
            params: self.contender.overrides_text(),
            function: self.function.name().to_owned(),
            dimension: self.dimension,
            form: self.form,
            instance: self.instance,
            budget: self.budget,
            evaluations: convergence.evaluations,
            gap: convergence.gap(),
            level: level(&convergence, self.budget),
        }))
    }
}

impl SuiteJob for Task {
    fn contender(&self) -> &Contender {
        &self.contender
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_level_is_the_mean_of_logarithms() {
        // 100 until half of the evaluations, then solved.
        let convergence = Convergence { evaluations: 500, improvements: vec![(1, 100.0), (501, 1e-12)] };
        // At 1 % to 50 % the logarithm is 2, at 51 % to 100 % it is −8.
        assert!((level(&convergence, 1000) - (50.0 * 2.0 - 50.0 * 8.0) / 100.0).abs() < 1e-12);
    }
}
