//! Commands and options.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, Parser, Subcommand, ValueHint};

use forage::scene::function::MAX_DIMENSION;
use forage_study::bench::{barn, centre_bias, trees};

use super::{examples, names, names::Offered};

/// A laboratory for path planners: swarms, ants, bats and trees, with the same results as in the web page.
#[derive(Parser)]
#[command(name = "forage", version, propagate_version = true, after_help = examples::QUICK_START)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// List planners, generators and scenes, or describe one of them.
    #[command(after_help = examples::LIST)]
    List(ListArgs),
    /// Run a planner on a scene and check whether the result is feasible.
    ///
    /// Exit code 0: a feasible result; 1: none was found.
    #[command(after_help = examples::RUN)]
    Run(Box<RunArgs>),
    /// Print the population and the iterations that a planner's paper recommends for a scene.
    #[command(after_help = examples::SUGGEST)]
    Suggest(SuggestArgs),
    /// Compute the exact optimum of a scene.
    #[command(after_help = examples::EXACT)]
    Exact(ExactArgs),
    /// Convert scenes from and to the formats of other programs.
    ///
    /// Reads and writes MovingAI (.map, .scen), ROS map_server (.yaml, .pgm), TSPLIB (.tsp, .tour), points (.csv) and scene
    /// files (.json). A .scen file needs its .map file, a .yaml file its .pgm file, a .tour file its .tsp file: each is looked
    /// for in the same folder. A tour is measured; that of a .opt.tour file becomes the optimum stated in the scene file.
    #[command(after_help = examples::CONVERT, override_usage = "forage convert [OPTIONS] <IN>... <OUT>")]
    Convert(ConvertArgs),
    /// Generate a random scene; the same parameters and seed give the same scene.
    #[command(after_help = examples::generate())]
    Generate(GenerateArgs),
    /// Replay the runs that were handed in as links, and say which of them reach a task's goal.
    ///
    /// Prints a CSV row for each link. Exit code 0: all reached the goal, and their hashes came out again; 1: some did not.
    #[command(after_help = examples::GRADE)]
    Grade(GradeArgs),
    /// Repeat a published experiment and compare the results with the published values.
    ///
    /// Finished runs are kept: after an interruption the same command continues.
    #[command(after_help = examples::reproduce())]
    Reproduce(ReproduceArgs),
    /// Measure the planners beyond the papers, and print tables.
    ///
    /// Finished runs are kept: after an interruption the same command continues.
    #[command(after_help = examples::study())]
    Study(StudyArgs),
    /// Run planners × scenes × parameter values × seeds and test whether the results differ.
    ///
    /// Writes one row per run and prints statistics. Finished runs are kept: after an interruption the same command
    /// continues. The complete file has the same bytes whatever the number of threads, interruptions or parts.
    #[command(after_help = examples::EXPERIMENT)]
    Experiment(ExperimentArgs),
    /// Run planners on a standard benchmark suite, and write files for the field's tools.
    ///
    /// Finished runs are kept: after an interruption the same command continues.
    #[command(after_help = examples::BENCH, subcommand_value_name = "SUITE", subcommand_help_heading = "Suites")]
    Bench(BenchArgs),
    /// Print a completion script for a shell.
    #[command(after_help = examples::COMPLETIONS)]
    Completions {
        /// The shell.
        shell: clap_complete::Shell,
    },
    /// Print the manual page, or write one page per subcommand.
    #[command(after_help = examples::MAN)]
    Man {
        /// Write the pages forage.1, forage-run.1, … into this folder.
        #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
        out: Option<PathBuf>,
    },
    /// Print Forage's licence and the notices of third-party software.
    #[command(after_help = examples::LICENSES)]
    Licenses,
}

#[derive(Args)]
pub(super) struct ListArgs {
    /// A planner, a generator, a shipped scene, `drive` or `motion`: show its page.
    #[arg(value_parser = Offered(names::pages), hide_possible_values = true)]
    pub(super) name: Option<String>,
    /// Print JSON with all fields.
    #[arg(long)]
    pub(super) json: bool,
    /// Print as JSON all messages that runs, explanations and errors can give, for pages and translators.
    #[arg(long, conflicts_with_all = ["name", "json"])]
    pub(super) messages: bool,
    /// Print the TypeScript types of all that crosses to JavaScript, for packages.
    #[arg(long, conflicts_with_all = ["name", "json", "messages"])]
    pub(super) types: bool,
}

#[derive(Args)]
pub(super) struct SuggestArgs {
    /// The planner.
    #[arg(value_parser = Offered(names::planners), hide_possible_values = true)]
    pub(super) planner: String,
    /// A scene file (.json, .map, .scen, .yaml, .tsp, .csv), a shipped scene's name, or a link.
    #[arg(long, value_name = "FILE|NAME|LINK", value_hint = ValueHint::FilePath)]
    pub(super) scene: String,
    /// Set a parameter that the recommendation depends on; repeat for several.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// Print JSON: population, iterations and source.
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct ExactArgs {
    /// A scene file (.json, .map, .scen, .yaml, .tsp, .csv), a shipped scene's name, or a link.
    #[arg(long, value_name = "FILE|NAME|LINK", value_hint = ValueHint::FilePath)]
    pub(super) scene: String,
    /// Print JSON: length and path.
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct GradeArgs {
    /// A text file with a link in each line; whose it is may stand before it. Lines that begin with `# ` are skipped.
    #[arg(value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) links: PathBuf,
    /// The task: a JSON file with goal and budget, and what is given of planner, scene and parameters.
    #[arg(long, value_name = "FILE.json", value_hint = ValueHint::FilePath)]
    pub(super) task: PathBuf,
    /// How many threads to use; default: all cores. The rows do not depend on it.
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub(super) jobs: Option<NonZeroUsize>,
    /// Grade one link that comes by standard input: code that does not end ends only with its program.
    #[arg(long, hide = true)]
    pub(super) alone: bool,
}

#[derive(Args)]
pub(super) struct BenchArgs {
    /// The suite.
    #[command(subcommand)]
    pub(super) suite: Suite,
}

/// Suites of benchmarks.
#[derive(Subcommand)]
pub(super) enum Suite {
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
pub(super) struct BarnArgs {
    /// A copy of the repository Daffan/the-barn-challenge.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(super) folder: PathBuf,
    /// Take only every N-th world.
    #[arg(long, value_name = "N", default_value = "1", value_parser = many, allow_negative_numbers = true)]
    pub(super) every: NonZeroUsize,
    /// The robot's radius, in metres; default: half the width of a Jackal.
    #[arg(long, value_name = "R", default_value_t = barn::RADIUS, value_parser = radius, allow_negative_numbers = true)]
    pub(super) radius: f64,
    #[command(flatten)]
    pub(super) common: SuiteArgs,
}

#[derive(Args)]
pub(super) struct BbobArgs {
    /// Numbers of functions: `1-5,8`; default: all.
    #[arg(long, value_name = "LIST")]
    pub(super) functions: Option<String>,
    /// Numbers of variables: `2,10`; default: 2, 3, 5, 10, 20, 40.
    #[arg(long, value_name = "LIST")]
    pub(super) dimensions: Option<String>,
    /// Instances: `1-5`; default: 1-15.
    #[arg(long, value_name = "LIST")]
    pub(super) instances: Option<String>,
    /// Evaluations for each variable.
    #[arg(long, value_name = "N", default_value_t = forage_study::bench::bbob::BUDGET, value_parser = whole::<1, 1_000_000_000>, allow_negative_numbers = true)]
    pub(super) budget: u64,
    #[command(flatten)]
    pub(super) common: SuiteArgs,
}

#[derive(Args)]
pub(super) struct CentreBiasArgs {
    /// The number of variables.
    #[arg(long, value_name = "N", default_value_t = centre_bias::DIMENSION, value_parser = variables, allow_negative_numbers = true)]
    pub(super) dimension: usize,
    /// How many instances of each form; their numbers, from 1, are the seeds.
    #[arg(long, value_name = "N", default_value_t = centre_bias::INSTANCES, value_parser = whole::<2, 1_000>, allow_negative_numbers = true)]
    pub(super) instances: u64,
    /// Evaluations for each variable.
    #[arg(long, value_name = "N", default_value_t = centre_bias::BUDGET, value_parser = whole::<1, 1_000_000_000>, allow_negative_numbers = true)]
    pub(super) budget: u64,
    #[command(flatten)]
    pub(super) common: SuiteArgs,
}

#[derive(Args)]
pub(super) struct MovingaiArgs {
    /// The folder with .scen files and their maps, with all folders in it.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(super) folder: PathBuf,
    /// Take only the first N problems of each bucket of a file.
    #[arg(long, value_name = "N", value_parser = many, allow_negative_numbers = true)]
    pub(super) per_bucket: Option<NonZeroUsize>,
    #[command(flatten)]
    pub(super) common: SuiteArgs,
}

#[derive(Args)]
pub(super) struct TreesArgs {
    /// Scenes: files, shipped names or links; default: all that ship and have paths.
    #[arg(value_name = "SCENE", value_hint = ValueHint::FilePath)]
    pub(super) scenes: Vec<String>,
    /// How many runs on each scene; their numbers, from 1, are the seeds.
    #[arg(long, value_name = "N", default_value_t = trees::RUNS, value_parser = whole::<1, 100_000>, allow_negative_numbers = true)]
    pub(super) runs: u64,
    /// Evaluations of a run: straight segments that are checked for collisions.
    #[arg(long, value_name = "N", default_value_t = trees::BUDGET, value_parser = whole::<1, 1_000_000_000>, allow_negative_numbers = true)]
    pub(super) budget: u64,
    #[command(flatten)]
    pub(super) common: SuiteArgs,
}

#[derive(Args)]
pub(super) struct TsplibArgs {
    /// The folder with .tsp files, with all folders in it.
    #[arg(value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(super) folder: PathBuf,
    /// Take only instances with at most N stops.
    #[arg(long, value_name = "N", value_parser = many, allow_negative_numbers = true)]
    pub(super) largest: Option<NonZeroUsize>,
    /// Evaluations for each stop: tours, or moves of one, that are measured.
    #[arg(long, value_name = "N", default_value_t = forage_study::bench::tsplib::BUDGET, value_parser = whole::<1, 1_000_000>, allow_negative_numbers = true)]
    pub(super) budget: u64,
    /// Runs per instance; the seeds are 1 to N.
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = whole::<1, 1_000>, allow_negative_numbers = true)]
    pub(super) runs: u64,
    #[command(flatten)]
    pub(super) common: SuiteArgs,
}

/// The options of all suites.
#[derive(Args)]
pub(super) struct SuiteArgs {
    /// The planners, separated by commas; default: all that can run; movingai: the graph searches; tsplib: planners without a population. On functions `random-search` is a baseline.
    #[arg(long, value_name = "PLANNERS", value_delimiter = ',')]
    pub(super) planners: Vec<String>,
    /// A planner of your own, in JavaScript: with those of `--planners`, or alone. Can be given several times.
    #[arg(long, value_name = "FILE.js", value_hint = ValueHint::FilePath)]
    pub(super) code: Vec<PathBuf>,
    /// A parameter of all planners, or with `PLANNER.` before it of one of them. Can be given several times.
    #[arg(long, value_name = "[PLANNER.]NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// The folder for rows, report and files of the suite's tools; default: the suite's name.
    #[arg(long, value_name = "DIR", value_hint = ValueHint::DirPath)]
    pub(super) out: Option<PathBuf>,
    /// How many threads to use; default: all cores. The results do not depend on it, only times that are measured.
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub(super) jobs: Option<NonZeroUsize>,
    /// Run only part I of N, into a file of rows of its own; without it, the parts in the folder are merged.
    #[arg(long, value_name = "I/N", allow_hyphen_values = true)]
    pub(super) shard: Option<String>,
    /// Delete existing rows and start again.
    #[arg(long)]
    pub(super) fresh: bool,
}

#[derive(Args)]
pub(super) struct ExperimentArgs {
    /// The experiment's file; `--example` prints one.
    #[arg(value_name = "FILE.toml", required_unless_present = "example", value_hint = ValueHint::FilePath)]
    pub(super) file: Option<PathBuf>,
    /// Print an example of FILE.toml.
    #[arg(long, exclusive = true)]
    pub(super) example: bool,
    /// How many threads to use; default: all cores. The rows do not depend on it.
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub(super) jobs: Option<NonZeroUsize>,
    /// Run only part I of N, into a file of its own with .I-of-N before its ending.
    #[arg(long, value_name = "I/N", conflicts_with = "merge", allow_hyphen_values = true)]
    pub(super) shard: Option<String>,
    /// Where to write the rows: .csv, or .jsonl or .ndjson for JSON Lines. Default: as FILE.toml says, or FILE.csv.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) out: Option<PathBuf>,
    /// Delete existing rows and start again.
    #[arg(long, conflicts_with = "merge")]
    pub(super) fresh: bool,
    /// Run nothing; merge these parts, in any order, into the file of a single run.
    #[arg(long, value_name = "PART", num_args = 1.., conflicts_with = "jobs", value_hint = ValueHint::FilePath)]
    pub(super) merge: Vec<PathBuf>,
    /// Write convergence curves, the best value of each run over its evaluations: .csv, or .parquet. What is kept of each run is in files with .runs.csv
    /// behind its name; of parts only those are written, and `--merge` takes them together.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) curves: Option<PathBuf>,
    /// Write the statistics as Markdown, and pictures next to it: runs near the optimum over evaluations, performance profile, mean ranks.
    #[arg(long, value_name = "FILE", conflicts_with = "shard", value_hint = ValueHint::FilePath)]
    pub(super) report: Option<PathBuf>,
    /// Print the statistics as JSON.
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct ConvertArgs {
    /// The files of one scene (.map, .scen, .yaml, .pgm, .tsp, .tour, .csv, .json), a shipped scene's name, or a link; last,
    /// the file to write.
    ///
    /// A .map is written with its .scen, a .yaml with its .pgm, and a .tsp with its .opt.tour if the shortest tour is known.
    #[arg(required = true, value_name = "IN... OUT", value_hint = ValueHint::FilePath)]
    pub(super) paths: Vec<String>,
    /// Which problem of a .scen file to use, counted from 0; default: the last one.
    #[arg(long, value_name = "N", value_parser = problem, allow_negative_numbers = true)]
    pub(super) problem: Option<usize>,
}

#[derive(Args)]
pub(super) struct GenerateArgs {
    /// The generator.
    #[arg(value_parser = Offered(names::generators), hide_possible_values = true)]
    pub(super) generator: String,
    /// Set a parameter; repeat for several. `forage list GENERATOR` shows them.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// 0 to 9007199254740991, or `random` for a new one.
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value = "1")]
    pub(super) seed: String,
    /// The file to write: .json or another format of `forage convert`. Default: standard output, as JSON.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) out: Option<String>,
}

#[derive(Args)]
pub(super) struct StudyOptions {
    /// The folder for rows, tables (CSV and Markdown) and pictures.
    #[arg(long, value_name = "DIR", default_value = "reproduce", value_hint = ValueHint::DirPath)]
    pub(super) out: PathBuf,
    /// How many threads to use; default: all cores. The rows do not depend on it.
    #[arg(long, value_name = "N", value_parser = threads, allow_negative_numbers = true)]
    pub(super) jobs: Option<NonZeroUsize>,
    /// Runs per cell of a table; default: as many as published. Fewer are quicker.
    #[arg(long, value_name = "N", value_parser = runs, allow_negative_numbers = true)]
    pub(super) runs: Option<u64>,
    /// Delete existing rows and start again.
    #[arg(long)]
    pub(super) fresh: bool,
    /// Print the reports as JSON.
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct StudyArgs {
    /// Which study.
    #[arg(value_parser = Offered(names::studies), hide_possible_values = true)]
    pub(super) study: String,
    #[command(flatten)]
    pub(super) options: StudyOptions,
}

#[derive(Args)]
pub(super) struct ReproduceArgs {
    /// Which experiment; default: all of them and all studies, which takes long.
    #[arg(value_parser = Offered(names::reproductions), hide_possible_values = true)]
    pub(super) name: Option<String>,
    #[command(flatten)]
    pub(super) options: StudyOptions,
    /// Afterwards compare REPRODUCTION.md and REPRODUCTION.csv with those in this folder; exit code 1 if they differ.
    #[arg(long, value_name = "DIR", conflicts_with = "name", value_hint = ValueHint::DirPath)]
    pub(super) check: Option<PathBuf>,
    /// With --check: run only some of the jobs, in an order that SEED chooses, and compare their rows with the fingerprints in
    /// REPRODUCTION.rows.json; exit code 1 if they differ.
    #[arg(long, value_name = "SEED", requires = "check", conflicts_with_all = ["runs", "fresh"])]
    pub(super) sample: Option<String>,
    /// How long the sample takes, in seconds.
    #[arg(long, value_name = "N", default_value_t = 90, value_parser = seconds, allow_negative_numbers = true)]
    pub(super) seconds: u64,
}

#[derive(Args)]
pub(super) struct RunArgs {
    /// The planner, or a link, which names planner and scene. Not needed if --scene is a link.
    #[arg(value_name = "PLANNER|LINK", value_parser = Offered(names::planners), hide_possible_values = true)]
    pub(super) planner: Option<String>,
    /// A scene file (.json, .map, .scen, .yaml, .tsp, .csv), a shipped scene's name, or a link from the page.
    #[arg(long, value_name = "FILE|NAME|LINK", value_hint = ValueHint::FilePath)]
    pub(super) scene: Option<String>,
    /// A planner in JavaScript: a script that calls `register({ … })` once. It runs in an interpreter without network, clock and files.
    #[arg(long, value_name = "FILE.js", value_hint = ValueHint::FilePath)]
    pub(super) code: Option<PathBuf>,
    /// 0 to 9007199254740991, or `random` for a new one. Default: 1, or the link's.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(super) seed: Option<String>,
    /// The iteration limit; the same as --set iterations=N.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(super) iterations: Option<String>,
    /// Use a preset of the planner, such as `paper` or `fitted`; --set overrides it. `forage list PLANNER` shows them.
    #[arg(long, value_name = "NAME")]
    pub(super) preset: Option<String>,
    /// Set a parameter; repeat for several. `forage list PLANNER` shows them.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// Use the population and the iterations that the planner's paper recommends; --set overrides them.
    #[arg(long)]
    pub(super) suggested: bool,
    /// Accept a link whose hash does not come out again, such as one of an older version. Otherwise that is exit code 1.
    #[arg(long)]
    pub(super) ignore_hash: bool,
    /// Print one JSON object with full precision.
    #[arg(long)]
    pub(super) json: bool,
    /// Write a picture of the result.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) svg: Option<PathBuf>,
    /// Write the metrics of every iteration as CSV.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) trace: Option<PathBuf>,
    /// Write how the scene's robot drives along the path as CSV, one row per control period.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) drive: Option<PathBuf>,
    /// Write the tour as a TSPLIB .tour file.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) tour: Option<PathBuf>,
    /// Set a parameter of the drive; repeat for several. `forage list drive` shows them.
    #[arg(long = "drive-set", value_name = "NAME=VALUE")]
    pub(super) drive_set: Vec<String>,
    /// Write how the scene's arm follows the path as CSV, one row per configuration.
    #[arg(long, value_name = "FILE", value_hint = ValueHint::FilePath)]
    pub(super) motion: Option<PathBuf>,
    /// Set a parameter of the arm's motion; repeat for several. `forage list motion` shows them.
    #[arg(long = "motion-set", value_name = "NAME=VALUE")]
    pub(super) motion_set: Vec<String>,
}

fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let threads = whole_number(text, 1, 1024)?;
    // It is at least 1.
    Ok(usize::try_from(threads).ok().and_then(NonZeroUsize::new).unwrap_or(NonZeroUsize::MIN))
}

fn many(text: &str) -> Result<NonZeroUsize, String> {
    let number = whole_number(text, 1, 1_000_000)?;
    Ok(usize::try_from(number).ok().and_then(NonZeroUsize::new).unwrap_or(NonZeroUsize::MIN))
}

fn radius(text: &str) -> Result<f64, String> {
    let found = text.parse::<f64>().ok().filter(|radius| (0.01..=1.0).contains(radius));
    found.ok_or_else(|| "it must be a number from 0.01 to 1".to_owned())
}

fn variables(text: &str) -> Result<usize, String> {
    let number = whole_number(text, 2, MAX_DIMENSION as u64)?;
    Ok(usize::try_from(number).unwrap_or(MAX_DIMENSION))
}

fn runs(text: &str) -> Result<u64, String> {
    whole_number(text, 2, 1_000_000)
}

fn seconds(text: &str) -> Result<u64, String> {
    whole_number(text, 1, 86_400)
}

fn problem(text: &str) -> Result<usize, String> {
    // No file of problems can hold more.
    whole_number(text, 0, u64::from(u32::MAX)).map(|number| number as usize)
}

fn whole<const LEAST: u64, const MOST: u64>(text: &str) -> Result<u64, String> {
    whole_number(text, LEAST, MOST)
}

fn whole_number(text: &str, least: u64, most: u64) -> Result<u64, String> {
    let number = text.parse().ok().filter(|number| (least..=most).contains(number));
    number.ok_or_else(|| format!("it must be a whole number from {least} to {most}"))
}
