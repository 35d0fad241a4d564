//! What follows the options in each command's help. A test runs every example.

use forage::{describe::Generator, message};
use forage_study::{
    registry::{REPRODUCTIONS, STUDIES},
    study::Study,
};

use super::{
    language::{say, say_numbered},
    registry::registry,
};

pub(super) const QUICK_START: &str = "Quick start:
  forage list                                   # planners, generators and scenes
  forage list wcpso                             # one planner: its parameters and metrics
  forage run wcpso --scene wcpso-discs          # run it on a scene
  forage run wcpso --scene wcpso-discs --seed 2 --json
  forage exact --scene wcpso-discs              # the exact optimum, to compare with
  forage generate maze --seed 7 --out maze.json # a random scene
  forage run a-star --scene maze.json --svg maze.svg

`forage COMMAND --help` shows a command’s options and more examples.";

pub(super) const LIST: &str = "Examples:
  forage list
  forage list wcpso
  forage list qpso-10m
  forage list maze
  forage list drive
  forage list wcpso --json";

pub(super) const RUN: &str = "Examples:
  forage run wcpso --scene wcpso-discs
  forage run pso --scene ackley --seed 7 --set population=40 --set w=0.6 --json
  forage run wcpso --scene wcpso-discs --svg run.svg --trace run.csv
  forage run ltqpso --scene qpso-10m --drive drive.csv --drive-set look_ahead=0.5
  forage run bat --scene random-52 --tour best.tour
  forage run '#v=1&planner=wcpso&scene=wcpso-discs&seed=7&at=120'

`forage list` shows all planners and shipped scenes.";

pub(super) const SUGGEST: &str = "Examples:
  forage suggest ltqpso --scene qpso-10m
  forage suggest ltqpso --scene qpso-10m --set segments=16 --json
  forage run ltqpso --scene qpso-10m --suggested";

pub(super) const EXACT: &str = "Examples:
  forage exact --scene wcpso-discs
  forage exact --scene wolf-ant-20 --json";

pub(super) const GRADE: &str = r#"Examples:
  forage grade links.txt --task task.json
  forage grade links.txt --task task.json > marks.csv

A task: {"goal": {"gap": 0.01}, "budget": {"evaluations": 5000}, "scene": "wcpso-discs"}
The goal is at most so much of gap, length or cost; budget, planner, scene and params may be left out."#;

pub(super) const CONVERT: &str = "Examples:
  forage convert wolf-ant-20 wolf.scen
  forage convert wolf.scen --problem 0 wolf.json
  forage convert wolf.json wolf.yaml
  forage convert random-52 random.tsp
  forage convert random.tsp random.opt.tour random.json
  forage convert random.json random.csv";

pub(super) const COMPLETIONS: &str = "Examples:
  forage completions bash > forage.bash
  forage completions zsh > _forage
  forage completions fish > forage.fish

Read the script from your shell’s start-up file, or put it where your shell looks for completions.";

pub(super) const MAN: &str = "Examples:
  forage man > forage.1
  forage man --out man";

pub(super) const LICENSES: &str = "Example:
  forage licenses";

pub(super) const BENCH: &str = "Examples:
  forage bench bbob --planners pso,wcpso --dimensions 2,10
  forage bench barn the-barn-challenge
  forage bench centre-bias
  forage bench movingai maps/dao
  forage bench trees
  forage bench tsplib tsplib95 --largest 1000
  forage bench movingai --help

`forage bench SUITE --help` shows a suite’s options and more examples.";

pub(super) const BENCH_BARN: &str = "Examples:
  forage bench barn the-barn-challenge --every 10
  forage bench barn the-barn-challenge --planners a-star-drive --out robots";

pub(super) const BENCH_BBOB: &str = "Examples:
  forage bench bbob
  forage bench bbob --planners pso,wcpso --dimensions 2,10 --budget 10000 --out swarms
  forage bench bbob --set pso.w=0.7 --functions 1-5 --instances 1-5
  python3 -m cocopp swarms/coco/pso swarms/coco/wcpso";

pub(super) const BENCH_CENTRE_BIAS: &str = "Examples:
  forage bench centre-bias
  forage bench centre-bias --planners pso,wcpso --dimension 2 --budget 100 --out bias
  forage bench centre-bias --code my-planner.js --planners pso";

pub(super) const BENCH_MOVINGAI: &str = "Examples:
  forage bench movingai maps/dao
  forage bench movingai maps --planners a-star,theta-star,aco --per-bucket 1 --out paths
  forage bench movingai maps --shard 1/4

The exit code is 1 if an exact planner misses the optimum of a file.";

pub(super) const BENCH_TREES: &str = "Examples:
  forage bench trees
  forage bench trees rooms.json wcpso-discs --planners rrt,rrt-star --runs 100 --out paths
  ompl_benchmark_statistics paths/ompl/*.log -d paths.db";

pub(super) const BENCH_TSPLIB: &str = "Examples:
  forage bench tsplib tsplib95
  forage bench tsplib tsplib95 --largest 1000 --planners two-opt,bat,ga --runs 5 --out tours
  forage bench tsplib tsplib95 --budget 100 --shard 1/4

The exit code is 1 if a tour is shorter than the published optimum.";

pub(super) const EXPERIMENT: &str = "Examples:
  forage experiment --example > sweep.toml
  forage experiment sweep.toml
  forage experiment sweep.toml --out rows.jsonl --report sweep.md --json
  forage experiment sweep.toml --shard 1/2
  forage experiment sweep.toml --shard 2/2
  forage experiment sweep.toml --out whole.csv --merge inertia.1-of-2.csv inertia.2-of-2.csv";

/// What `forage experiment --example` prints.
pub(super) const EXPERIMENT_FILE: &str = r#"name = "inertia"                             # default: the name of this file
scenes = ["sphere", "ackley"]                # shipped scenes, links, or files relative to this one
seeds = { from = 1, count = 10 }             # or a list
within = 0.01                                # a run counts as successful within this share of the exact optimum; on functions a difference
budget = 4000                                # evaluations of each run; default: what the first planner takes; or "own"
out = "inertia.csv"                          # or .jsonl, .ndjson

[[planner]]
name = "pso"
params = { w = [0.4, 0.6, 0.8], c1 = 2.0 }   # a list: each value, in all combinations

[[planner]]
name = "wpso"
"#;

/// Generators and examples.
pub(super) fn generate() -> String {
    let width = registry().generators().iter().map(|generator| generator.name.len()).max().unwrap_or(0);
    let lines: Vec<_> =
        registry().generators().iter().map(|generator| format!("  {:width$}  {}", generator.name, title(generator))).collect();
    format!(
        "Generators (`forage list NAME` shows the parameters):\n{}\n
Examples:
  forage generate maze --set columns=61 --set rows=41 --seed 7 --out maze.json
  forage generate random --set share=0.35 --out random.map
  forage generate random --set moving=5 --out traffic.json
  forage generate rooms --set stops=20 --out delivery.json
  forage generate stops --set stops=100 --out stops.tsp",
        lines.join("\n")
    )
}

fn title(generator: &Generator) -> &'static str {
    say(generator.title, &format!("generators.{}.title", generator.name))
}

/// Reproductions and examples.
pub(super) fn reproduce() -> String {
    format!(
        "Names:\n{}\n
Examples:
  forage reproduce wcpso-paths --runs 2
  forage reproduce wcpso-paths --runs 2 --out quick --json

A full run takes minutes to hours. `forage reproduce --check DIR` repeats all experiments and compares them with DIR.",
        studies(REPRODUCTIONS, |study| {
            let (title, source) = (say(study.title, ""), say_numbered(study.source));
            message!("shell-title-and-source", "{title}, {source}", title, source).to_string()
        })
    )
}

/// Studies of our own and examples.
pub(super) fn study() -> String {
    format!(
        "Names:\n{}\n
Examples:
  forage study forensics
  forage study forensics --out quick --json

`robustness` takes half an hour; with `--runs 2` it compares on two maps of each kind.",
        studies(STUDIES, |study| say(study.title, "").to_owned())
    )
}

/// A line for each study.
fn studies(studies: &[Study], line: fn(&Study) -> String) -> String {
    let width = studies.iter().map(|study| study.name.len()).max().unwrap_or(0);
    studies.iter().map(|study| format!("  {:width$}  {}", study.name, line(study))).collect::<Vec<_>>().join("\n")
}
