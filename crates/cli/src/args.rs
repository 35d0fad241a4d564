//! What can be typed.

use std::{num::NonZeroUsize, path::PathBuf};

use clap::{Args, Parser, Subcommand};

/// A laboratory for path planners: the same runs as in the page, bit for bit.
#[derive(Parser)]
#[command(name = "forage", version, propagate_version = true)]
pub(super) struct Cli {
    #[command(subcommand)]
    pub(super) command: Command,
}

#[derive(Subcommand)]
pub(super) enum Command {
    /// List planners with their parameters, and the scenes that ship.
    List {
        /// The whole catalogue as JSON.
        #[arg(long)]
        json: bool,
    },
    /// Run a planner on a scene and judge what it found.
    #[command(after_help = super::list::after_help())]
    Run(RunArgs),
    /// The population and iterations that a planner's paper recommends for a scene and parameters.
    Suggest {
        /// The planner's name.
        planner: String,
        /// A scene file (.json, .map, .scen, .yaml, .tsp, .csv), a shipped scene's name, or a link.
        #[arg(long, value_name = "FILE|NAME|LINK")]
        scene: String,
        /// A parameter that the recommendation depends on; may be given many times.
        #[arg(long = "set", value_name = "NAME=VALUE")]
        set: Vec<String>,
        /// As JSON: population, iterations and source.
        #[arg(long)]
        json: bool,
    },
    /// The exact optimum of a scene.
    Exact {
        /// A scene file (.json, .map, .scen, .yaml, .tsp, .csv), a shipped scene's name, or a link.
        #[arg(long, value_name = "FILE|NAME|LINK")]
        scene: String,
        /// As JSON: length and path.
        #[arg(long)]
        json: bool,
    },
    /// Turn other programs’ files into scenes, and scenes into such files.
    ///
    /// A .scen needs its .map, a .yaml its .pgm, a .tour its .tsp; they are looked for beside it. A tour is measured; a
    /// .opt.tour becomes the scene’s stored optimum. What is read or written in some way that
    /// should be known is told on standard error.
    #[command(after_help = super::convert::AFTER_HELP, override_usage = "forage convert [OPTIONS] <IN>... <OUT>")]
    Convert(ConvertArgs),
    /// Make a random scene: the same for the same parameters and seed.
    #[command(after_help = super::generate::after_help())]
    Generate(GenerateArgs),
    /// Carry out a published experiment anew and print the result beside the published one.
    ///
    /// Rows are kept as they are finished: after an interruption the same command goes on from there.
    #[command(after_help = super::reproduce::after_help())]
    Reproduce(ReproduceArgs),
    /// Run planners × scenes × parameter values × seeds, one row a run, and say whether they differ.
    ///
    /// Rows are kept as they are finished: after an interruption the same command goes on from there. When all are there
    /// they are in the order of the file, the same bytes whatever the threads, interruptions or shards; the same command
    /// then prints the statistics again.
    #[command(after_help = EXPERIMENT)]
    Experiment(ExperimentArgs),
}

const EXPERIMENT: &str = "FILE.toml:
  name = \"inertia\"                             # what it is called; the file’s name, if left out
  scenes = [\"sphere\", \"scenes/mine.json\"]    # shipped names, links, or files beside this one
  seeds = { from = 1, count = 50 }             # or a list
  within = 0.01                                # how near to the exact optimum counts as reached
  iterations = 500                             # for all planners
  out = \"inertia.csv\"                         # or .jsonl, .ndjson

  [[planner]]
  name = \"pso\"
  params = { w = [0.4, 0.6, 0.8], c1 = 2.0 }   # a list: each of its values, in all combinations

  [[planner]]
  name = \"wpso\"";

#[derive(Args)]
pub(super) struct ExperimentArgs {
    /// What to run.
    #[arg(value_name = "FILE.toml")]
    pub(super) file: PathBuf,
    /// How many threads; the rows do not depend on it. All cores, if left out.
    #[arg(long, value_name = "N")]
    pub(super) jobs: Option<NonZeroUsize>,
    /// Only the I-th of N parts, I from 1; into a file of its own, with .I-of-N before the ending.
    #[arg(long, value_name = "I/N", conflicts_with = "merge")]
    pub(super) shard: Option<String>,
    /// Where the rows go: .csv, or .jsonl or .ndjson for JSON Lines. As FILE.toml says, or called as it is with .csv.
    #[arg(long, value_name = "FILE")]
    pub(super) out: Option<PathBuf>,
    /// Throw away the rows that are there, and begin anew.
    #[arg(long, conflicts_with = "merge")]
    pub(super) fresh: bool,
    /// Run nothing, but make one file of these parts, in any order: that of a single run.
    #[arg(long, value_name = "PART", num_args = 1.., conflicts_with = "jobs")]
    pub(super) merge: Vec<PathBuf>,
    /// Write the statistics as Markdown.
    #[arg(long, value_name = "FILE", conflicts_with = "shard")]
    pub(super) report: Option<PathBuf>,
    /// Print the statistics as JSON.
    #[arg(long)]
    pub(super) json: bool,
}

#[derive(Args)]
pub(super) struct ConvertArgs {
    /// Files of one scene (.map, .scen, .yaml, .pgm, .tsp, .tour, .csv, .json), a shipped scene's name, or a link; and last
    /// what to write: a .json, a .map or .scen (both are written), a .yaml or .pgm (both are written), a .tsp or .tour (both
    /// are written, the tour if the shortest one is known), a .csv of points.
    #[arg(required = true, value_name = "IN... OUT")]
    pub(super) paths: Vec<String>,
    /// Which problem of a .scen file to take, counted from 0. The last one, if left out.
    #[arg(long, value_name = "N")]
    pub(super) problem: Option<usize>,
}

#[derive(Args)]
pub(super) struct GenerateArgs {
    /// The generator's name.
    pub(super) generator: String,
    /// A parameter; may be given many times.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// 0 to 9007199254740991, or `random` for a fresh one.
    #[arg(long, value_name = "N", allow_hyphen_values = true, default_value = "1")]
    pub(super) seed: String,
    /// The file to write: .json, or what else `forage convert` writes. Standard output, if left out.
    #[arg(long, value_name = "FILE")]
    pub(super) out: Option<String>,
}

#[derive(Args)]
pub(super) struct ReproduceArgs {
    /// Which one. All, if left out.
    pub(super) name: Option<String>,
    /// The folder for rows, tables (CSV and Markdown) and pictures.
    #[arg(long, value_name = "DIR", default_value = "reproduce")]
    pub(super) out: PathBuf,
    /// How many threads; the rows do not depend on it. All cores, if left out.
    #[arg(long, value_name = "N")]
    pub(super) jobs: Option<NonZeroUsize>,
    /// Runs a cell, fewer for a quick look. As many as published, if left out.
    #[arg(long, value_name = "N")]
    pub(super) runs: Option<u64>,
    /// Throw away the rows that are there, and begin anew.
    #[arg(long)]
    pub(super) fresh: bool,
    /// Print the reports as JSON.
    #[arg(long)]
    pub(super) json: bool,
    /// When all are carried out: compare REPRODUCTION.md and REPRODUCTION.csv with those of a folder; exit code 1 if they differ.
    #[arg(long, value_name = "DIR", conflicts_with = "name")]
    pub(super) check: Option<PathBuf>,
    /// With --check: run only some of the jobs, in an order that SEED chooses, and compare their rows with the fingerprints in
    /// REPRODUCTION.rows.json; exit code 1 if they differ.
    #[arg(long, value_name = "SEED", requires = "check", conflicts_with_all = ["runs", "fresh"])]
    pub(super) sample: Option<String>,
    /// How long the sample takes, in seconds.
    #[arg(long, value_name = "N", default_value_t = 90, value_parser = clap::value_parser!(u64).range(1..=86_400))]
    pub(super) seconds: u64,
}

#[derive(Args)]
pub(super) struct RunArgs {
    /// The planner's name (or a link, which names planner and scene). May be left out when --scene is a link.
    #[arg(value_name = "PLANNER|LINK")]
    pub(super) planner: Option<String>,
    /// A scene file (.json, .map, .scen, .yaml, .tsp, .csv), a shipped scene's name, or a link from the page.
    #[arg(long, value_name = "FILE|NAME|LINK")]
    pub(super) scene: Option<String>,
    /// 0 to 9007199254740991, or `random` for a fresh one. Default 1, or the link's.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(super) seed: Option<String>,
    /// The iteration limit: short for --set iterations=N.
    #[arg(long, value_name = "N", allow_hyphen_values = true)]
    pub(super) iterations: Option<String>,
    /// A parameter; may be given many times. `forage list` names them.
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub(super) set: Vec<String>,
    /// Population and iterations as the planner's paper recommends for the other parameters; what is set explicitly stays.
    #[arg(long)]
    pub(super) suggested: bool,
    /// Print one JSON object.
    #[arg(long)]
    pub(super) json: bool,
    /// Write a picture of the result.
    #[arg(long, value_name = "FILE")]
    pub(super) svg: Option<PathBuf>,
    /// Write the readings of every iteration as CSV.
    #[arg(long, value_name = "FILE")]
    pub(super) trace: Option<PathBuf>,
    /// Write how the scene's robot drives along the path as CSV, a line for each control period.
    #[arg(long, value_name = "FILE")]
    pub(super) drive: Option<PathBuf>,
    /// Write the tour that was found as a TSPLIB .tour.
    #[arg(long, value_name = "FILE")]
    pub(super) tour: Option<PathBuf>,
    /// A parameter of the drive; may be given many times. `forage list` names them.
    #[arg(long = "drive-set", value_name = "NAME=VALUE")]
    pub(super) drive_set: Vec<String>,
    /// Write how the scene's arm follows the path as CSV, a line for each posture.
    #[arg(long, value_name = "FILE")]
    pub(super) motion: Option<PathBuf>,
    /// A parameter of the arm's motion; may be given many times. `forage list` names them.
    #[arg(long = "motion-set", value_name = "NAME=VALUE")]
    pub(super) motion_set: Vec<String>,
}
