//! Commands and options.

mod numbers;
mod suites;

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, Parser, Subcommand, ValueHint};

use super::{examples, names, names::Offered};

use self::numbers::{problem, runs, seconds, share, threads};
pub(super) use self::suites::{BbobArgs, BenchArgs, Suite, SuiteArgs};

/// A laboratory for path planners: swarms, ants, bats and trees, with the same results as in the web page.
#[derive(Parser)]
#[command(name = "forage", version, propagate_version = true, after_help = examples::QUICK_START)]
pub(super) struct Cli {
    /// The language of what is printed, such as `zh-CN`. Default: that of LC_ALL, LC_MESSAGES or LANG; else English. Files and JSON stay English.
    #[arg(long, global = true, value_name = "TAG", value_parser = numbers::language)]
    pub(super) lang: Option<String>,
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
#[expect(clippy::struct_excessive_bools, reason = "each is an option")]
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
    /// Print as JSON all texts of the commands' help, for translators.
    #[arg(long, conflicts_with_all = ["name", "json", "messages"])]
    pub(super) texts: bool,
    /// Print the TypeScript types of all that crosses to JavaScript, for packages.
    #[arg(long, conflicts_with_all = ["name", "json", "messages", "texts"])]
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
    /// Run a random share of the kept rows again, from 0 to 1 (one row at least), before anything else: each must come out the same.
    #[arg(long, value_name = "SHARE", num_args = 0..=1, default_missing_value = "0.1", value_parser = share, allow_negative_numbers = true, conflicts_with = "fresh")]
    pub(super) verify: Option<f64>,
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
