//! Options of `forage bench`.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, Subcommand, ValueHint};

use forage::{message, scene::function::MAX_DIMENSION};
use forage_study::bench::{barn, bbob, centre_bias, trees, tsplib};

use super::{
    super::examples,
    numbers::{many, must_be, threads, whole, whole_number},
};

#[derive(Args)]
pub(crate) struct BenchArgs {
    /// The suite.
    #[command(subcommand)]
    pub(crate) suite: Suite,
}

/// Suites of benchmarks.
#[derive(Subcommand)]
pub(crate) enum Suite {
    /// A robot through the worlds of the BARN challenge
    #[command(after_help = examples::BENCH_BARN)]
    Barn(BarnArgs),
    /// The 24 noiseless functions of COCO
    #[command(after_help = examples::BENCH_BBOB)]
    Bbob(BbobArgs),
    /// Whether planners search near the centre of the search box, where most test functions have their minimum
    #[command(after_help = examples::BENCH_CENTRE_BIAS)]
    CentreBias(CentreBiasArgs),
    /// The problems of MovingAI's .scen files in a folder, against the optima that the files give
    #[command(after_help = examples::BENCH_MOVINGAI)]
    Movingai(MovingaiArgs),
    /// Trees on scenes, with the logs that OMPL's tools read
    #[command(after_help = examples::BENCH_TREES)]
    Trees(TreesArgs),
    /// Tours through the instances of TSPLIB in a folder, against the published optima
    #[command(after_help = examples::BENCH_TSPLIB)]
    Tsplib(TsplibArgs),
}

#[derive(Args)]
pub(crate) struct BarnArgs {
    /// A copy of the repository Daffan/the-barn-challenge.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) folder: PathBuf,
    /// Take only every N-th world.
    #[arg(long, value_name = "N", default_value = "1", value_parser = many, allow_negative_numbers = true)]
    pub(crate) every: NonZeroUsize,
    /// The robot's radius, in metres; default: half the width of a Jackal.
    #[arg(long, value_name = "R", default_value_t = barn::RADIUS, value_parser = radius, allow_negative_numbers = true)]
    pub(crate) radius: f64,
    #[command(flatten)]
    pub(crate) common: SuiteArgs,
}

#[derive(Args)]
pub(crate) struct BbobArgs {
    /// Numbers of functions: `1-5,8`; default: all.
    #[arg(long, value_name = "LIST")]
    pub(crate) functions: Option<String>,
    /// Numbers of variables: `2,10`; default: 2, 3, 5, 10, 20, 40.
    #[arg(long, value_name = "LIST")]
    pub(crate) dimensions: Option<String>,
    /// Instances: `1-5`; default: 1-15.
    #[arg(long, value_name = "LIST")]
    pub(crate) instances: Option<String>,
    /// Evaluations for each variable.
    #[arg(long, value_name = "N", default_value_t = bbob::BUDGET, value_parser = whole::<1, 1_000_000_000>, allow_negative_numbers = true)]
    pub(crate) budget: u64,
    #[command(flatten)]
    pub(crate) common: SuiteArgs,
}

#[derive(Args)]
pub(crate) struct CentreBiasArgs {
    /// The number of variables.
    #[arg(long, value_name = "N", default_value_t = centre_bias::DIMENSION, value_parser = variables, allow_negative_numbers = true)]
    pub(crate) dimension: usize,
    /// How many instances of each form; their numbers, from 1, are the seeds.
    #[arg(long, value_name = "N", default_value_t = centre_bias::INSTANCES, value_parser = whole::<2, 1_000>, allow_negative_numbers = true)]
    pub(crate) instances: u64,
    /// Evaluations for each variable.
    #[arg(long, value_name = "N", default_value_t = centre_bias::BUDGET, value_parser = whole::<1, 1_000_000_000>, allow_negative_numbers = true)]
    pub(crate) budget: u64,
    #[command(flatten)]
    pub(crate) common: SuiteArgs,
}

#[derive(Args)]
pub(crate) struct MovingaiArgs {
    /// The folder with .scen files and their maps, with all folders in it.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) folder: PathBuf,
    /// Take only the first N problems of each bucket of a file.
    #[arg(long, value_name = "N", value_parser = many, allow_negative_numbers = true)]
    pub(crate) per_bucket: Option<NonZeroUsize>,
    #[command(flatten)]
    pub(crate) common: SuiteArgs,
}

#[derive(Args)]
pub(crate) struct TreesArgs {
    /// Scenes: files, shipped names or links; default: all that ship and have paths.
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub(crate) scenes: Vec<String>,
    /// How many runs on each scene; their numbers, from 1, are the seeds.
    #[arg(long, value_name = "N", default_value_t = trees::RUNS, value_parser = whole::<1, 100_000>, allow_negative_numbers = true)]
    pub(crate) runs: u64,
    /// Evaluations of a run: straight segments that are checked for collisions.
    #[arg(long, value_name = "N", default_value_t = trees::BUDGET, value_parser = whole::<1, 1_000_000_000>, allow_negative_numbers = true)]
    pub(crate) budget: u64,
    #[command(flatten)]
    pub(crate) common: SuiteArgs,
}

#[derive(Args)]
pub(crate) struct TsplibArgs {
    /// The folder with .tsp files, with all folders in it.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) folder: PathBuf,
    /// Take only instances with at most N stops.
    #[arg(long, value_name = "N", value_parser = many, allow_negative_numbers = true)]
    pub(crate) largest: Option<NonZeroUsize>,
    /// Evaluations for each stop: tours, or moves of one, that are measured.
    #[arg(long, value_name = "N", default_value_t = tsplib::BUDGET, value_parser = whole::<1, 1_000_000>, allow_negative_numbers = true)]
    pub(crate) budget: u64,
    /// Runs per instance; the seeds are 1 to N.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<1, 1_000>, allow_negative_numbers = true)]
    pub(crate) runs: u64,
    #[command(flatten)]
    pub(crate) common: SuiteArgs,
}

/// The options of all suites.
#[derive(Args)]
pub(crate) struct SuiteArgs {
    /// The planners, separated by commas; default: all that can run; movingai: the graph searches; tsplib: planners without a population. On functions `random-search` is a baseline.
    #[arg(long, value_name = "PLANNERS", value_delimiter = ',')]
    pub(crate) planners: Vec<String>,
    /// A planner of your own, in JavaScript: with those of `--planners`, or alone. Can be given several times.
    #[arg(long, value_name = "FILE.js", value_hint = ValueHint::FilePath)]
    pub(crate) code: Vec<PathBuf>,
    /// A parameter of all planners, or with `PLANNER.` before it of one of them. Can be given several times.
    #[arg(long, value_name = "[PLANNER.]NAME=VALUE")]
    pub(crate) set: Vec<String>,
    /// The folder for rows, report and files of the suite's tools; default: the suite's name.
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(crate) out: Option<PathBuf>,
    /// How many threads to use; default: all cores. The results do not depend on it, only times that are measured.
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub(crate) jobs: Option<NonZeroUsize>,
    /// Run only part I of N, into a file of rows of its own; without it, the parts in the folder are merged.
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub(crate) shard: Option<String>,
    /// Delete existing rows and start again.
    #[arg(long)]
    pub(crate) fresh: bool,
}

fn radius(text: &str) -> Result<f64, String> {
    let found = text.parse::<f64>().ok().filter(|radius| (0.01..=1.0).contains(radius));
    let allowed = || message!("error-number-from-to", "a number from {low} to {high}", low = 0.01, high = 1.0);
    found.ok_or_else(|| must_be(&allowed()))
}

fn variables(text: &str) -> Result<usize, String> {
    let number = whole_number(text, 2, MAX_DIMENSION as u64)?;
    Ok(usize::try_from(number).unwrap_or(MAX_DIMENSION))
}
