//! What a claim is made of: its parts, where they are asked, of whom, and what.

use std::sync::Arc;

use forage::{
    Overrides, Value,
    kernel::Error,
    scene::{GRID, Scene},
    shipped, standard,
};

use super::{measure::Measure, run::Run};

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
    pub params: Overrides,
    /// Parameters of the arm's motion along the path, where they are not the defaults.
    pub motion: Overrides,
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
        Self { planner, params: given(params), motion: Overrides::new() }
    }

    /// With another parameter.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: &str) -> Self {
        self.params.insert(name, Value::from(value));
        self
    }

    /// With parameters of the arm's motion.
    #[must_use]
    pub fn moving(self, motion: &str) -> Self {
        Self { motion: given(motion), ..self }
    }
}

fn given(text: &str) -> Overrides {
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
        Self::on_maps(standard().generators_of(GRID).map(|generator| generator.name), MAPS, settings, arms, question)
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

    /// Whether it is on scenes that ship alone, whose names begin so.
    pub fn is_on(&self, beginning: &str) -> bool {
        !self.on.is_empty() && self.on.iter().all(|on| matches!(on, On::Scene(name) if name.starts_with(beginning)))
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
}

impl On {
    pub(super) fn scene(&self) -> Result<Arc<Scene>, Error> {
        match self {
            Self::Scene(name) => shipped(name),
            Self::Map { generator, settings, map } => Ok(Arc::new(standard().generate(generator, &given(settings), *map)?)),
        }
    }
}
