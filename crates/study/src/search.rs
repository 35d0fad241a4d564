//! How many particles and iterations `ltqpso` needs for a spread under 0.05, the experiment behind [LTQPSO](forage#papers)
//! (10), (11).

use std::sync::atomic::{AtomicBool, Ordering};

use serde::{Deserialize, Serialize};

use forage::{
    Overrides, Setup, Value, describe,
    kernel::{Error, Message, Stepper},
    shipped, standard,
    statistics::Moments,
};

use super::{rows::KeyedRow, runner::Job};

/// The standard deviation that the results must stay under.
pub const THRESHOLD: f64 = 0.05;
/// N and M begin here.
pub const SMALLEST: u64 = 4;
/// No search goes on beyond so many positions a run, N · M: what is not reached by then is reported as not reached.
pub const LIMIT: u64 = 20_000;

/// How the first angles are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Start {
    /// Table 1.
    Uniform,
    /// N(30°, 45°), Table 2.
    Normal,
}

impl Start {
    /// The name of the parameter's value.
    pub fn name(self) -> &'static str {
        match self {
            Self::Uniform => "uniform",
            Self::Normal => "normal",
        }
    }
}

/// What a job looks for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Aim {
    /// The first N and M, increased in turn, whose spread is small enough.
    Search,
    /// The spread at the N and M that (10) or (11) gives.
    Published,
}

/// A job: one D, one start, one block of seeds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Task {
    /// What for.
    pub aim: Aim,
    /// How the first angles are drawn.
    pub start: Start,
    /// D.
    pub segments: u64,
    /// Block b has the seeds b · runs + 1 to (b + 1) · runs.
    pub block: u64,
    /// How many seeds a block has.
    pub runs: u64,
}

/// What came out.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Found {
    /// See [`Task`].
    pub aim: Aim,
    /// See [`Task`].
    pub start: Start,
    /// See [`Task`].
    pub segments: u64,
    /// See [`Task`].
    pub block: u64,
    /// See [`Task`].
    pub runs: u64,
    /// [`LIMIT`].
    pub limit: u64,
    /// N at the end.
    pub population: u64,
    /// M at the end.
    pub iterations: u64,
    /// Whether the spread is under [`THRESHOLD`] there.
    pub reached: bool,
    /// The mean length there; of a search that was given up nothing, as not all runs were made.
    pub mean: Option<f64>,
    /// The standard deviation there.
    pub std: Option<f64>,
    /// Sizes that were tried.
    pub sizes: u64,
    /// Positions evaluated in all.
    pub evaluations: u64,
}

impl KeyedRow for Found {
    fn key(&self) -> String {
        let Self { aim, start, segments, block, runs, limit, .. } = *self;
        key(&Task { aim, start, segments, block, runs }, limit)
    }
}

fn key(Task { aim, start, segments, block, runs }: &Task, limit: u64) -> String {
    format!("{aim:?} {start:?}, D {segments}, block {block} of {runs} runs, up to {limit}")
}

/// N and M after these: the one whose turn it is grows by a fifth, at least by 1.
pub fn grow([population, iterations]: [u64; 2], turn: u64) -> [u64; 2] {
    let grown = |size: u64| size + (size / 5).max(1);
    if turn.is_multiple_of(2) { [grown(population), iterations] } else { [population, grown(iterations)] }
}

impl Task {
    /// The run with these N and M.
    ///
    /// # Errors
    /// None that is known: the scene ships.
    pub fn setup(&self, [population, iterations]: [u64; 2], seed: u64) -> Result<Setup, Error> {
        let mut params: Overrides =
            [("population", population), ("iterations", iterations), ("segments", self.segments), ("early_stop", 0)]
                .map(|(name, number)| (name, Value::Number(number as f64)))
                .into_iter()
                .collect();
        params.insert("initial", self.start.name().into());
        params.insert("smooth", Value::Flag(false));
        params.insert("redraws", Value::Number(0.0));
        if self.start == Start::Normal {
            params.insert("initial_mean", Value::Number(30.0));
            params.insert("initial_std", Value::Number(45.0));
        }
        Ok(Setup { planner: "ltqpso".to_owned(), scene: shipped("qpso-10m-empty")?, params, seed })
    }

    /// N and M by (10) or (11).
    ///
    /// # Errors
    /// A D that they do not cover.
    pub fn published(&self) -> Result<[u64; 2], Error> {
        let (entry, parameters) = self.setup([SMALLEST; 2], 1)?.check(standard())?;
        (entry.suggest)(&parameters)
            .map(|suggestion| [suggestion.population, suggestion.iterations])
            .ok_or_else(|| Error::refused("segments", self.segments, Message::verbatim("from 5 to 20")))
    }

    /// Mean and spread over the block. Without `patience` only until it is certain that the spread is too large: the sum
    /// of squared deviations never falls, so what is given up would have failed with all runs, too.
    fn measure(&self, sizes: [u64; 2], patience: bool, stop: &AtomicBool) -> Result<Option<(Moments, u64)>, Error> {
        let most = THRESHOLD * THRESHOLD * (self.runs - 1) as f64;
        let (mut moments, mut evaluations) = (Moments::default(), 0);
        for seed in self.block * self.runs + 1..=(self.block + 1) * self.runs {
            if stop.load(Ordering::Relaxed) {
                return Ok(None);
            }
            let setup = self.setup(sizes, seed)?;
            let (entry, parameters) = setup.check(standard())?;
            // Without the run around it: nobody looks at the trace of a hundred thousand runs.
            let start = describe::Start { entry, scene: &setup.scene, parameters: &parameters, seed, entries: &**standard() };
            let mut run = Stepper::from((entry.start)(&start)?);
            while run.step(|_| Vec::new()) {}
            let length = run.planner.best().and_then(|best| setup.scene.judge(&best.solution).length);
            moments = moments.with(length.unwrap_or(f64::NAN));
            evaluations += run.planner.evaluations();
            if !patience && moments.squares >= most {
                break;
            }
        }
        Ok(Some((moments, evaluations)))
    }

    fn passes(&self, moments: &Moments) -> bool {
        moments.count == self.runs as f64 && moments.std().is_some_and(|std| std < THRESHOLD)
    }
}

impl Job for Task {
    type Row = Found;

    fn key(&self) -> String {
        key(self, LIMIT)
    }

    /// Measured: a search costs about as the fifth power of D until it meets the limit.
    fn weight(&self) -> u64 {
        let d = self.segments.min(11);
        let search = d * d * d * d * d;
        if self.aim == Aim::Search { search } else { search / 20 * self.segments / d }
    }

    fn run(&self, stop: &AtomicBool) -> Result<Option<Found>, Error> {
        let mut sizes = if self.aim == Aim::Search { [SMALLEST; 2] } else { self.published()? };
        let (mut turn, mut evaluations) = (0, 0);
        loop {
            let Some((moments, more)) = self.measure(sizes, self.aim == Aim::Published, stop)? else { return Ok(None) };
            evaluations += more;
            let reached = self.passes(&moments);
            let next = grow(sizes, turn);
            if reached || self.aim == Aim::Published || next[0] * next[1] > LIMIT {
                let whole = moments.count == self.runs as f64;
                let Self { aim, start, segments, block, runs } = *self;
                let (mean, std) = (whole.then_some(moments.mean), moments.std().filter(|_| whole));
                let [population, iterations] = sizes;
                let (sizes, limit) = (turn + 1, LIMIT);
                return Ok(Some(Found {
                    aim,
                    start,
                    segments,
                    block,
                    runs,
                    limit,
                    population,
                    iterations,
                    reached,
                    mean,
                    std,
                    sizes,
                    evaluations,
                }));
            }
            (sizes, turn) = (next, turn + 1);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    static NEVER: AtomicBool = AtomicBool::new(false);

    #[test]
    fn n_and_m_grow_in_turn() {
        assert_eq!(grow([4, 4], 0), [5, 4]);
        assert_eq!(grow([5, 4], 1), [5, 5]);
        assert_eq!(grow([100, 60], 2), [120, 60]);
        assert_eq!(grow([120, 60], 3), [120, 72]);
    }

    /// What is given up early is given up rightly, and what is found is the first that passes.
    #[test]
    fn a_search_ends_at_the_first_sizes_that_pass() {
        let task = Task { aim: Aim::Search, start: Start::Normal, segments: 5, block: 1, runs: 10 };
        let found = task.run(&NEVER).unwrap().unwrap();
        assert!(found.reached && found.std.unwrap() < THRESHOLD && found.mean.unwrap() >= 200_f64.sqrt());
        let mut sizes = [SMALLEST; 2];
        for turn in 0..found.sizes {
            let (moments, _) = task.measure(sizes, true, &NEVER).unwrap().unwrap();
            assert_eq!(moments.count, 10.0);
            assert_eq!(moments.std().unwrap() < THRESHOLD, turn + 1 == found.sizes);
            assert_eq!(sizes == [found.population, found.iterations], turn + 1 == found.sizes);
            sizes = grow(sizes, turn);
        }
        assert_eq!(task.run(&AtomicBool::new(true)).unwrap(), None);
    }

    #[test]
    fn published_sizes_are_those_of_10_and_11() {
        let task = |start| Task { aim: Aim::Published, start, segments: 16, block: 0, runs: 2 };
        // By hand: 0.4321 · 16^1.7292 = 52.2, 0.2855 · 16^2.218 = 133.8; 0.3161 · 16^1.8376 = 51.6, 0.1525 · 16^2.3358 = 99.0.
        assert_eq!(task(Start::Uniform).published().unwrap(), [52, 134]);
        assert_eq!(task(Start::Normal).published().unwrap(), [52, 99]);
    }
}
