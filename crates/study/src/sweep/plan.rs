//! What is run: every run has a number, and there is no list of them.

use std::{collections::BTreeMap, fmt, str::FromStr, sync::Arc};

use forage::{
    Overrides, Registry, Scene, Setup, Value,
    kernel::{Digest, Error},
    message,
    params::Parameters,
    run::Spending,
};

use super::text::value_text;

/// So many runs fit in the memory of a usual machine, and in years of its time.
pub const MOST: usize = 100_000_000;

/// Each combination is checked before anything is run: more than these take too long for that.
pub const MOST_CELLS: usize = 1_000_000;

/// Parameters with their values.
pub(super) type Pairs<'a> = Vec<(&'a str, &'a Value)>;

/// A parameter of a planner, and the values that it takes.
#[derive(Debug, Clone)]
pub(super) struct Setting {
    /// Which of the file's parameters.
    pub(super) column: usize,
    pub(super) values: Vec<Value>,
    /// Which value is written how.
    pub(super) texts: BTreeMap<String, usize>,
}

impl Setting {
    pub(super) fn new(column: usize, values: Vec<Value>) -> Self {
        let texts = values.iter().map(value_text).zip(0..).collect();
        Self { column, values, texts }
    }
}

/// A planner with all combinations of its parameters' values; the last parameter changes first.
#[derive(Debug, Clone)]
pub(super) struct Variants {
    pub(super) planner: String,
    pub(super) settings: Vec<Setting>,
    /// How many combinations.
    pub(super) count: usize,
}

/// The seeds of every combination.
#[derive(Debug, Clone)]
pub(super) enum Seeds {
    /// The first, and how many.
    From(u64, usize),
    /// These, and the place of each.
    List(Vec<u64>, BTreeMap<u64, usize>),
}

impl Seeds {
    pub(super) fn len(&self) -> usize {
        match self {
            Self::From(_, count) => *count,
            Self::List(seeds, _) => seeds.len(),
        }
    }

    fn seed(&self, k: usize) -> u64 {
        match self {
            Self::From(first, _) => first + k as u64,
            Self::List(seeds, _) => seeds[k],
        }
    }

    fn find(&self, seed: u64) -> Option<usize> {
        match self {
            Self::From(first, count) => seed.checked_sub(*first).map(|k| k as usize).filter(|k| k < count),
            Self::List(_, places) => places.get(&seed).copied(),
        }
    }
}

/// When runs are stopped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Budget {
    /// After as many evaluations as the first planner of the sweep takes with its own iterations on the same scene.
    First,
    /// After so many evaluations.
    Evaluations(u64),
    /// After their own iterations.
    Own,
}

/// Planners × scenes × parameter values × seeds.
#[derive(Debug)]
pub struct Sweep {
    /// What there is to run.
    pub registry: Arc<Registry>,
    /// What it is called.
    pub name: String,
    /// What is planned in; no two have one name.
    pub scenes: Vec<Arc<Scene>>,
    /// What the rows of each scene come from: see [`digest`](crate::digest).
    pub(super) origins: Vec<Digest>,
    /// How near to the exact optimum counts as reached: a share of it, on functions a difference.
    pub within: f64,
    /// When runs are stopped.
    pub budget: Budget,
    /// After how many evaluations runs are stopped on each scene, if they are.
    pub allowances: Vec<Option<u64>>,
    /// The parameters that any planner sets, in the order of the file.
    pub parameters: Vec<String>,
    pub(super) planners: Vec<Variants>,
    pub(super) seeds: Seeds,
    /// How many combinations are in front of each planner's.
    pub(super) in_front: Vec<usize>,
    /// About how much work a run of a cell is.
    pub(super) weights: Vec<u64>,
}

/// What a cell is: all runs of it differ by their seed only.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// Which of the scenes.
    pub scene: usize,
    /// Which of the combinations of planner and parameters.
    pub group: usize,
    planner: usize,
    variant: usize,
}

impl Sweep {
    /// How many runs.
    pub fn len(&self) -> usize {
        self.cells() * self.seeds.len()
    }

    /// Whether there is nothing to run; there always is.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many runs differ by more than their seed.
    pub fn cells(&self) -> usize {
        self.groups() * self.scenes.len()
    }

    /// How many combinations there are of planner and parameters.
    pub fn groups(&self) -> usize {
        self.planners.iter().map(|planner| planner.count).sum()
    }

    /// How many seeds.
    pub fn seeds(&self) -> usize {
        self.seeds.len()
    }

    /// Which cell a run is in.
    pub fn cell(&self, job: usize) -> usize {
        job / self.seeds.len()
    }

    /// What a cell is.
    pub fn place(&self, cell: usize) -> Place {
        // Each planner's cells are behind those of the planners in front of it.
        let planner = self.in_front.partition_point(|&groups| groups * self.scenes.len() <= cell) - 1;
        let rest = cell - self.in_front[planner] * self.scenes.len();
        let count = self.planners[planner].count;
        let (scene, variant) = (rest / count, rest % count);
        Place { scene, group: self.in_front[planner] + variant, planner, variant }
    }

    /// The cell of a scene and a group.
    pub fn cell_of(&self, scene: usize, group: usize) -> usize {
        let planner = self.planner_of(group);
        self.in_front[planner] * self.scenes.len() + scene * self.planners[planner].count + group - self.in_front[planner]
    }

    fn planner_of(&self, group: usize) -> usize {
        self.in_front.partition_point(|&groups| groups <= group) - 1
    }

    /// A planner and its parameters, as they are set.
    pub(super) fn group(&self, group: usize) -> (&str, Pairs<'_>) {
        let planner = self.planner_of(group);
        let variants = &self.planners[planner];
        (&variants.planner, self.values(planner, group - self.in_front[planner]))
    }

    fn values(&self, planner: usize, variant: usize) -> Pairs<'_> {
        let mut rest = variant;
        let mut values: Vec<_> = (self.planners[planner].settings.iter().rev())
            .map(|setting| {
                let value = &setting.values[rest % setting.values.len()];
                rest /= setting.values.len();
                (self.parameters[setting.column].as_str(), value)
            })
            .collect();
        values.reverse();
        values
    }

    /// What a run is made of.
    pub fn setup(&self, job: usize) -> Setup {
        let cell = self.cell(job);
        let Place { planner, scene, variant, .. } = self.place(cell);
        Setup {
            planner: self.planners[planner].planner.clone(),
            scene: Arc::clone(&self.scenes[scene]),
            params: self.values(planner, variant).into_iter().map(|(name, value)| (name, value.clone())).collect::<Overrides>(),
            seed: self.seeds.seed(job % self.seeds.len()),
        }
    }

    /// What a run's row comes from.
    pub(super) fn origin(&self, job: usize) -> &Digest {
        &self.origins[self.place(self.cell(job)).scene]
    }

    /// What the rows of a scene of this name come from.
    pub(super) fn origin_of(&self, scene: &str) -> Option<&Digest> {
        self.scenes.iter().position(|known| known.name() == scene).map(|scene| &self.origins[scene])
    }

    /// The run that a row tells of by its scene, planner, seed and the texts of its parameters, in the order of `parameters`.
    pub fn find(&self, scene: &str, planner: &str, seed: &str, parameters: &[&str]) -> Option<usize> {
        let scene = self.scenes.iter().position(|known| known.name() == scene)?;
        let seed = self.seeds.find(seed.parse().ok()?)?;
        let named = self.planners.iter().enumerate().filter(|(_, variants)| variants.planner == planner);
        let (planner, variant) = named.into_iter().find_map(|(at, variants)| Some((at, variants.find(parameters)?)))?;
        Some(self.cell_of(scene, self.in_front[planner] + variant) * self.seeds.len() + seed)
    }

    /// A run in words.
    pub fn describe(&self, job: usize) -> String {
        let Setup { planner, scene, params, seed } = self.setup(job);
        let params: Vec<String> = params.iter().map(|(name, value)| format!(" {name}={},", value_text(value))).collect();
        format!("{planner} on {},{} seed {seed}", scene.name(), params.concat())
    }

    /// About how much work a run of a cell is.
    pub(super) fn weight_of(&self, cell: usize) -> u64 {
        self.weights[cell]
    }

    /// About how much work a part is.
    pub(super) fn work(&self, part: Part) -> u64 {
        part.jobs(self.len()).map(|job| self.weights[self.cell(job)]).sum()
    }

    /// An error of a cell's planner, with the place in the file of what is refused.
    pub(super) fn placed(&self, cell: usize, error: Error) -> Error {
        let Place { planner, scene, .. } = self.place(cell);
        let variants = &self.planners[planner];
        let on = message!("study-planner-on-scene", "{planner} on {scene}", planner = variants.planner, scene = self.scenes[scene].name());
        match error {
            Error::Refused { field, value, allowed } => {
                let is_parameter = self.values(planner, 0).iter().any(|(name, _)| *name == field);
                let place = if is_parameter { format!("planner[{planner}].params.{field}") } else { format!("scenes[{scene}].{field}") };
                Error::Refused { field: place, value, allowed: message!("study-allowed-on", "{allowed} ({on})", allowed, on) }
            }
            Error::Unknown { value, known, .. } => {
                Error::Unknown { field: format!("planner[{planner}].params"), value, known: format!("{known} ({on})") }
            }
            other => other.within(&format!("planner[{planner}]")),
        }
    }

    /// After how many evaluations a run is stopped, if it is.
    pub fn allowance(&self, job: usize) -> Option<u64> {
        self.allowances[self.place(self.cell(job)).scene]
    }

    /// Finds out after how many evaluations runs are stopped. A planner that evaluates nothing gives no number.
    pub(super) fn allow(&mut self) -> Result<(), Error> {
        let of_scene = |scene: usize| match self.budget {
            Budget::Own => Ok(None),
            Budget::Evaluations(number) => Ok(Some(number)),
            Budget::First => {
                let cell = self.cell_of(scene, 0);
                let spending = Spending::of(&self.registry, &self.setup(cell * self.seeds.len()));
                let spending = spending.map_err(|error| self.placed(cell, error))?;
                Ok((spending.step > 0).then(|| spending.all()))
            }
        };
        self.allowances = (0..self.scenes.len()).map(of_scene).collect::<Result<_, Error>>()?;
        Ok(())
    }

    /// Checks each combination on each scene, and weighs it.
    pub(super) fn weigh(&mut self) -> Result<(), Error> {
        let mut weights = Vec::with_capacity(self.cells());
        for cell in 0..self.cells() {
            let (_, parameters) = self.setup(cell * self.seeds.len()).check(&self.registry).map_err(|error| self.placed(cell, error))?;
            let weight = self.allowances[self.place(cell).scene].unwrap_or_else(|| weight(&parameters));
            weights.push(weight.clamp(1, HEAVIEST));
        }
        self.weights = weights;
        Ok(())
    }
}

impl Variants {
    fn find(&self, parameters: &[&str]) -> Option<usize> {
        let set = parameters.iter().filter(|text| !text.is_empty()).count();
        let mut variant = 0;
        for setting in &self.settings {
            variant = variant * setting.values.len() + setting.texts.get(parameters[setting.column])?;
        }
        (set == self.settings.len()).then_some(variant)
    }

    /// Whether some run of these is one of those, too.
    pub(super) fn meets(&self, other: &Self) -> bool {
        let meets = |one: &Setting| {
            let same = other.settings.iter().find(|setting| setting.column == one.column);
            same.is_some_and(|setting| one.texts.keys().any(|text| setting.texts.contains_key(text)))
        };
        self.planner == other.planner && self.settings.len() == other.settings.len() && self.settings.iter().all(meets)
    }
}

/// A hundred million of them still add up.
const HEAVIEST: u64 = 1 << 36;

/// Iterations times those that take part in each, as far as the planner says.
fn weight(parameters: &Parameters) -> u64 {
    let number = |name: &str| {
        let value = parameters.all().iter().find(|(known, _)| *known == name);
        value.and_then(|(_, value)| if let Value::Number(number) = value { Some(*number as u64) } else { None })
    };
    let iterations = number("iterations").unwrap_or(1);
    let each = number("population").or_else(|| number("ants")).unwrap_or(1);
    iterations.saturating_mul(each)
}

/// Every so many-th run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Part {
    /// Which part, from 1.
    pub index: usize,
    /// Of how many.
    pub of: usize,
}

impl Part {
    /// All runs.
    pub const WHOLE: Self = Self { index: 1, of: 1 };

    /// How many of `all` runs.
    pub fn len(self, all: usize) -> usize {
        (all + self.of - self.index) / self.of
    }

    /// The runs' numbers.
    pub fn jobs(self, all: usize) -> impl Iterator<Item = usize> {
        (self.index - 1..all).step_by(self.of)
    }

    /// Which one of the part a run is; `None` if it is another part's.
    pub fn find(self, job: usize) -> Option<usize> {
        (job % self.of == self.index - 1).then_some(job / self.of)
    }

    /// The run that is the part's `k`-th.
    pub fn job(self, k: usize) -> usize {
        k * self.of + self.index - 1
    }
}

impl FromStr for Part {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let numbers = text.split_once('/').and_then(|(index, of)| Some((index.parse().ok()?, of.parse().ok()?)));
        match numbers {
            Some((index, of)) if (1..=of).contains(&index) && of <= MOST => Ok(Self { index, of }),
            _ => Err(Error::refused("--shard", text, message!("study-part", "I/N, the I-th of N parts, I from 1 to N"))),
        }
    }
}

impl fmt::Display for Part {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.index, self.of)
    }
}
