//! What the papers claim, as questions that runs can answer: upheld, refuted or undecided.
//!
//! A [`Claim`] quotes the paper and has [`Part`]s. A part names scenes, planners with their parameters ([`Arm`]) and a [`Question`]
//! that a test answers with seeds which no parameter was chosen by. The mark follows from the parts' answers by one rule ([`Mark`]).
//! Each paper has a file with its claims, as data, and a [`Study`] that carries their runs out.

mod antbat;
mod arm_rrt;
mod judge;
mod ltqpso;
mod run;
mod show;
mod wcpso;
mod wolf_ant;

#[cfg(test)]
mod tests;

use std::{
    collections::{BTreeMap, BTreeSet},
    path::Path,
    sync::Arc,
};

use forage::{
    Given, Value,
    kernel::Error,
    scene::{
        Scene,
        generate::{self, GENERATORS},
        shipped,
    },
};

use super::{
    Failure, Options, Study,
    fingerprints::JobList,
    report::Report,
    runner::{self, Control, Job},
};

pub use judge::{Answer, Answered, Judged, Mark};
pub use show::{RULES, counted, json, markdown, text};

use run::{Run, Task};

/// A study of one paper's claims.
macro_rules! study {
    ($name:literal, $source:literal, $claims:ident) => {
        Study {
            name: $name,
            title: "what the paper claims",
            source: $source,
            repeatable: true,
            jobs: |options| $claims::CLAIMS.jobs(options),
            run: |options, control| $claims::CLAIMS.carry_out($name, options, control),
        }
    };
}

/// The claims' studies, in the order of the papers.
pub const STUDIES: [Study; 5] = [
    study!("wcpso-claims", "[WCPSO]", wcpso),
    study!("ltqpso-claims", "[LTQPSO]", ltqpso),
    study!("antbat-claims", "[ANTBAT]", antbat),
    study!("arm-rrt-claims", "[ARM-RRT]", arm_rrt),
    study!("wolf-ant-claims", "[WOLF-ANT]", wolf_ant),
];

/// Seeds of a part on one scene: 51 to 100. No parameter of ours was chosen by them.
pub const SEEDS: [u64; 2] = [51, 100];
/// Seeds on each map of a part across maps.
pub const SEEDS_ON_MAPS: [u64; 2] = [51, 55];
/// Maps of each generator for parts across maps: the numbers of maps that no parameter was chosen by.
const MAPS: [u64; 2] = [101, 106];

/// A statement of a paper.
#[derive(Debug, Clone)]
pub struct Claim {
    /// `W1`; parts of one sentence that are judged apart have a letter: `L1a`.
    pub id: &'static str,
    /// The paper's words.
    pub quotation: &'static str,
    /// What they say, in English.
    pub says: &'static str,
    /// Where they are.
    pub place: &'static str,
    /// Whether it says "all", "best", "never" or "cannot", so that one contrary case refutes it.
    pub universal: bool,
    /// The tables of figures that belong to it, by the beginnings of their names.
    pub tables: &'static [&'static str],
    /// How it was read, and what limits the answer.
    pub reading: &'static str,
    /// What has to hold.
    pub parts: Vec<Part>,
}

/// A question to runs.
#[derive(Debug, Clone)]
pub struct Part {
    /// What is asked.
    pub question: Question,
    /// Where: one scene, or maps of which each is a pair of the test.
    pub on: Vec<On>,
    /// Who: the planner that the claim speaks for, and its rivals.
    pub arms: Vec<Arm>,
    /// How long.
    pub until: Until,
    /// The first and the last seed.
    pub seeds: [u64; 2],
}

/// A scene of a part.
#[derive(Debug, Clone, PartialEq)]
pub enum On {
    /// One that ships.
    Scene(&'static str),
    /// A scene of a generator.
    Map {
        /// The generator's name.
        generator: &'static str,
        /// The generator's settings, as they are typed.
        settings: &'static str,
        /// The map's number: the generator's seed.
        map: u64,
    },
}

/// A planner and the parameters that are not its defaults.
#[derive(Debug, Clone, PartialEq)]
pub struct Arm {
    /// The planner's name.
    pub planner: &'static str,
    /// Its parameters.
    pub params: Given,
    /// Parameters of the arm's motion along the path, where they are not the defaults.
    pub motion: Given,
}

/// When a run is looked at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Until {
    /// When it has ended.
    End,
    /// After this iteration.
    Iteration(u64),
    /// After so many evaluations, or an iteration more than that.
    Evaluations(u64),
}

/// A number of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Measure {
    /// In the run's row: a column, a reading or a number of its motion.
    pub key: &'static str,
    /// In words.
    pub name: &'static str,
    /// Digits that are shown, from the first that is not 0.
    pub digits: usize,
    /// Whether differences of less than half a per cent are trivial: so of lengths and costs.
    pub trivial: bool,
    /// Whether a run without a feasible result has none.
    pub of_feasible: bool,
    /// What is smaller is rounding and counts as 0.
    pub floor: f64,
}

impl Measure {
    /// A number that only a feasible result has.
    pub const fn new(key: &'static str, name: &'static str, digits: usize) -> Self {
        Self { key, name, digits, trivial: false, of_feasible: true, floor: 0.0 }
    }

    pub(crate) const fn or_trivial(self) -> Self {
        Self { trivial: true, ..self }
    }

    pub(crate) const fn of_any_run(self) -> Self {
        Self { of_feasible: false, ..self }
    }
}

/// The value of a function.
pub const VALUE: Measure = Measure::new("value", "value", 4);

/// The value of a shipped function. What is left of Ackley's below 1e-14 is rounding: numbers of the order of 1 are added and subtracted.
fn value_on(scene: &str) -> Measure {
    Measure { floor: if scene.starts_with("ackley") { 1e-14 } else { 0.0 }, ..VALUE }
}

/// The length of a path or a tour.
pub const LENGTH: Measure = Measure::new("value", "length", 6).or_trivial();
/// How far it is from the exact optimum.
pub const GAP: Measure = Measure::new("gap", "gap to the exact optimum", 3);
/// What it cost.
pub const EVALUATIONS: Measure = Measure::new("evaluations", "evaluations", 4);

/// Something that a run does or does not do.
#[derive(Debug, Clone, Copy)]
pub struct Event {
    /// In words, after "how often": `the result is feasible`.
    pub name: &'static str,
    /// Whether it does.
    pub of: fn(&Run) -> bool,
}

/// What is asked of a part's runs. The first arm is the one that the claim speaks for.
#[derive(Debug, Clone, Copy)]
pub enum Question {
    /// Its numbers are smaller than the second's: rank-sum test.
    Less(Measure),
    /// The same of the medians over many maps: signed-rank test of the pairs.
    LessAcross(Measure),
    /// Its numbers are larger than the second's: rank-sum test.
    More(Measure),
    /// Its numbers vary less: Brown–Forsythe test.
    SpreadsLess(Measure),
    /// It comes there sooner (the measure is missing where it never does): log-rank test, censored at the end of the run.
    Sooner {
        /// When.
        at: Measure,
        /// How long the run was, in the same unit.
        end: Measure,
    },
    /// The event happens more often than with the second: Fisher's test.
    MoreOften(Event),
    /// The same run by run, on the same scene with the same seed: McNemar's test.
    MoreOftenInPairs(Event),
    /// The event happens at least in this share of the runs: Wilson's interval.
    AtLeast(Event, f64),
    /// It never happens.
    Never(Event),
    /// The mean is at most this: its bootstrap interval.
    AtMost(Measure, f64),
    /// The standard deviation is at most this: its bootstrap interval.
    SpreadsAtMost(Measure, f64),
    /// The numbers grow from arm to arm: Page's test over the seeds.
    Grows(Measure),
    /// No run can say, for this reason.
    Open(&'static str),
}

impl Arm {
    /// A planner with parameters as they are typed: `random=particle v_max=1`.
    pub fn new(planner: &'static str, params: &str) -> Self {
        Self { planner, params: given(params), motion: Given::new() }
    }

    /// With parameters of the arm's motion.
    #[must_use]
    pub fn moving(self, motion: &str) -> Self {
        Self { motion: given(motion), ..self }
    }
}

fn given(text: &str) -> Given {
    text.split_whitespace().filter_map(|pair| pair.split_once('=')).map(|(name, value)| (name, Value::from(value))).collect()
}

impl Part {
    /// On a scene that ships.
    pub fn on(scene: &'static str, arms: impl Into<Vec<Arm>>, question: Question) -> Self {
        Self { question, on: vec![On::Scene(scene)], arms: arms.into(), until: Until::End, seeds: SEEDS }
    }

    /// On one scene of a generator.
    pub fn on_map(generator: &'static str, map: u64, settings: &'static str, arms: impl Into<Vec<Arm>>, question: Question) -> Self {
        Self { on: vec![On::Map { generator, settings, map }], ..Self::on("", arms, question) }
    }

    /// Over maps of all generators of grids, with these settings.
    pub fn across(settings: &'static str, arms: impl Into<Vec<Arm>>, question: Question) -> Self {
        Self::on_maps(GENERATORS.iter().map(|generator| generator.name), MAPS, settings, arms, question)
    }

    /// Over maps of these generators.
    pub fn on_maps(
        generators: impl IntoIterator<Item = &'static str>,
        [first, last]: [u64; 2],
        settings: &'static str,
        arms: impl Into<Vec<Arm>>,
        question: Question,
    ) -> Self {
        let maps = |generator: &'static str| (first..=last).map(move |map| On::Map { generator, settings, map });
        let on = generators.into_iter().flat_map(maps).collect();
        Self { question, on, arms: arms.into(), until: Until::End, seeds: SEEDS_ON_MAPS }
    }

    /// Without runs, for a reason.
    pub fn open(reason: &'static str) -> Self {
        Self { question: Question::Open(reason), on: Vec::new(), arms: Vec::new(), until: Until::End, seeds: SEEDS }
    }

    /// With other seeds.
    #[must_use]
    pub fn seeds(self, seeds: [u64; 2]) -> Self {
        Self { seeds, ..self }
    }

    /// Looked at earlier.
    #[must_use]
    pub fn until(self, until: Until) -> Self {
        Self { until, ..self }
    }

    /// The runs of an arm, scene by scene, seed by seed.
    fn tasks(&self, arm: usize) -> impl Iterator<Item = Task> + '_ {
        let task = move |on: &On, seed| Task { on: on.clone(), arm: self.arms[arm].clone(), until: self.until, seed };
        self.on.iter().flat_map(move |on| (self.seeds[0]..=self.seeds[1]).map(move |seed| task(on, seed)))
    }
}

impl On {
    fn scene(&self) -> Result<Arc<Scene>, Error> {
        match self {
            Self::Scene(name) => shipped(name),
            Self::Map { generator, settings, map } => Ok(Arc::new(generate::generate(generator, &given(settings), *map)?)),
        }
    }
}

/// A paper's claims.
pub(crate) struct PaperClaims {
    /// The claims; some parts may need the runs of `first`.
    claims: fn(&Rows) -> Vec<Claim>,
    /// Runs that tell which others there are: a tuning finds parameters, and a claim asks what they are worth.
    first: fn() -> Vec<Task>,
    /// The files of rows.
    files: [&'static str; 2],
}

/// Runs by their keys.
type Rows = BTreeMap<String, Run>;

impl PaperClaims {
    /// What can be run without rows.
    fn jobs(&self, options: &Options) -> Result<Vec<JobList>, Failure> {
        let [first_file, file] = self.files;
        let first = (self.first)();
        let tasks = tasks(&shortened(&(self.claims)(&Rows::new()), options)?);
        let list = (!first.is_empty()).then(|| JobList::new(first_file, first));
        Ok(list.into_iter().chain([JobList::new(file, tasks)]).collect())
    }

    fn carry_out(&self, name: &'static str, options: &Options, control: &Control) -> Result<Report, Failure> {
        let [first_file, file] = self.files.map(|file| options.out.join(file));
        let run = |tasks: &[Task], file: &Path| -> Result<Rows, Failure> {
            let rows = runner::run(tasks, file, options.fresh, options.threads, control)?;
            Ok(tasks.iter().map(Job::key).zip(rows).collect())
        };
        let runs = options.runs_or(full())?;
        let mut report = Report::new(super::find(super::REPRODUCTIONS, "NAME", name)?, runs, full());
        let first = (self.first)();
        let mut known = Rows::new();
        if !first.is_empty() {
            known = run(&first, &first_file)?;
            report.files.push(first_file);
        }
        let claims = shortened(&(self.claims)(&known), options)?;
        let rows = run(&tasks(&claims), &file)?;
        report.files.push(file);
        report.shortened = (runs < full()).then(|| format!("{runs} seeds instead of {}", full()));
        report.claims = claims.iter().map(|claim| judge::judge(claim, &rows)).collect();
        report.write(options)?;
        Ok(report)
    }
}

/// The runs that claims need, each once.
fn tasks(claims: &[Claim]) -> Vec<Task> {
    let parts = claims.iter().flat_map(|claim| &claim.parts);
    let all = parts.flat_map(|part| (0..part.arms.len()).flat_map(|arm| part.tasks(arm)));
    let mut seen = BTreeSet::new();
    all.filter(|task| seen.insert(task.key())).collect()
}

/// Claims with fewer seeds, where options say so.
fn shortened(claims: &[Claim], options: &Options) -> Result<Vec<Claim>, Error> {
    let mut claims = claims.to_vec();
    if options.runs.is_none() {
        return Ok(claims);
    }
    let runs = options.runs_or(full())?;
    for part in claims.iter_mut().flat_map(|claim| &mut claim.parts) {
        part.seeds[1] = part.seeds[1].min(part.seeds[0] + runs - 1);
    }
    Ok(claims)
}

const fn full() -> u64 {
    SEEDS[1] - SEEDS[0] + 1
}
