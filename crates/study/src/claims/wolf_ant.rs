//! The claims of [WOLF-ANT](forage#papers).

use super::{
    super::runner::Job,
    claim::{Arm, Claim, Event, On, Part, Question, Until},
    measure::{LENGTH, Measure},
    paper::{PaperClaims, Rows},
    task::Task,
};

/// See the module.
pub(super) const CLAIMS: PaperClaims =
    PaperClaims { claims, first: tunings, files: ["wolf-ant-claims-tunings.csv", "wolf-ant-claims-runs.csv"] };

const SCENE: &str = "wolf-ant-20";
const GRID: &str = "columns=20 rows=20";
/// The published parameters of the improved ants.
const PAPER: &str = "beta=7 rho=0.367";
/// The traditional ants with as many ants; their α, β and ρ are not printed.
const RIVALS: [&str; 2] = ["ants=30 alpha=1 beta=7", "ants=30 alpha=1.5 beta=8"];
const SECONDS: Measure = Measure::new("seconds", "driving time in s", 6).or_trivial();
const CONVERGED: Measure = Measure::new("converged", "iterations until the final path is found", 4);
const SETTLED: Measure = Measure::new("settled", "iterations until the colony settles", 4);
const ITERATIONS: Measure = Measure::new("iterations", "iterations", 4).of_any_run();
const OPTIMAL: Event = Event { name: "end at the exact optimum", of: |run| run.gap.is_some_and(|gap| gap.abs() < 1e-9) };
const ARRIVES: Event =
    Event { name: "at the goal without a collision", of: |run| run.solved && run.other("collisions").is_none_or(|count| count == 0.0) };
/// Tunings by the swarm, and by random search with as many sets of parameters.
const TUNERS: [(&str, Until); 2] = [("", Until::End), ("population=620", Until::Iteration(0))];
const TUNING_SEEDS: [u64; 2] = [51, 55];
const TUNED: [&str; 5] = ["alpha", "beta", "rho", "q", "epsilon"];

/// All tunings.
fn tunings() -> Vec<Task> {
    TUNERS.into_iter().flat_map(|tuner| (TUNING_SEEDS[0]..=TUNING_SEEDS[1]).map(move |seed| tuning(tuner, seed))).collect()
}

fn tuning((params, until): (&str, Until), seed: u64) -> Task {
    Task { on: On::Scene(SCENE), arm: Arm::new("pso-tuning", params), until, seed }
}

/// The colony with the parameters that a tuning found.
fn tuned(rows: &Rows, tuner: (&str, Until), seed: u64) -> Option<Arm> {
    let run = rows.get(&tuning(tuner, seed).key())?;
    let found: Option<Vec<String>> = TUNED.iter().map(|name| Some(format!("{name}={}", run.other(name)?))).collect();
    Some(Arm::new("aco-wolf", &found?.join(" ")))
}

/// Against traditional ants on the paper's scene, and on maps.
fn against_ants(question: Question, across: Question) -> Vec<Part> {
    let mut parts = Vec::new();
    for rival in RIVALS {
        let arms = [Arm::new("aco-wolf", PAPER), Arm::new("aco", rival)];
        parts.push(Part::on(SCENE, arms.clone(), question));
        parts.push(Part::across(GRID, arms, across));
    }
    parts
}

fn claims(rows: &Rows) -> Vec<Claim> {
    [paths(), convergence(), tuned_claims(rows), drives()].concat()
}

/// How long the paths are.
fn paths() -> Vec<Claim> {
    let avoids = "避免搜索陷入局部最优,减少机器人的行走时间";
    vec![
        Claim {
            id: "O1a",
            quotation: "改进的蚁群算法能寻找到全局最优路径",
            says: "The improved ants find the globally optimal path of the paper’s map",
            place: "§6, figs 2 and 3",
            universal: false,
            tables: &["Table 2", "§6"],
            reading: "At least 90 % of all runs. The map is a reconstruction on which the printed path is optimal.",
            parts: vec![Part::on(SCENE, [Arm::new("aco-wolf", PAPER)], Question::AtLeast(OPTIMAL, 0.9)).seeds([51, 150])],
        },
        Claim {
            id: "O1b",
            quotation: "改进的蚁群算法能寻找到全局最优路径",
            says: "The improved ants find the globally optimal path of other maps",
            place: "§6, figs 2 and 3",
            universal: false,
            tables: &[],
            reading: "At least 90 % of all runs on generated maps.",
            parts: vec![Part::across(GRID, [Arm::new("aco-wolf", PAPER)], Question::AtLeast(OPTIMAL, 0.9))],
        },
        Claim {
            id: "O2a",
            quotation: avoids,
            says: "The improved ants avoid local optima and drive a shorter time than traditional ants",
            place: "§6, Table 2",
            universal: false,
            tables: &["Table 2"],
            reading: "The paper does not print the rival’s parameters: two sets.",
            parts: against_ants(Question::Less(LENGTH), Question::LessAcross(LENGTH))
                .into_iter()
                .chain(RIVALS.map(|rival| Part::on(SCENE, [Arm::new("aco-wolf", PAPER), Arm::new("aco", rival)], Question::Less(SECONDS))))
                .collect(),
        },
        Claim {
            id: "O2b",
            quotation: avoids,
            says: "The improved ants’ paths are shorter than those of A*",
            place: "§6, Table 2",
            universal: false,
            tables: &["Table 2"],
            reading: "A* is exact, so nothing can be shorter.",
            parts: vec![
                Part::on(SCENE, [Arm::new("aco-wolf", PAPER), Arm::new("a-star", "")], Question::Less(LENGTH)),
                Part::across(GRID, [Arm::new("aco-wolf", PAPER), Arm::new("a-star", "")], Question::LessAcross(LENGTH)),
            ],
        },
    ]
}

/// How fast the colony converges.
fn convergence() -> Vec<Claim> {
    vec![Claim {
        id: "O3",
        quotation: "提高算法的收敛速度",
        says: "The improved ants converge faster than traditional ants",
        place: "Abstract; §3",
        universal: false,
        tables: &[],
        reading: "Two measures of convergence; heuristic and pheromone update together and each alone.",
        parts: against_ants(Question::Less(CONVERGED), Question::LessAcross(CONVERGED))
            .into_iter()
            .chain(against_ants(Question::Sooner { at: SETTLED, end: ITERATIONS }, Question::LessAcross(SETTLED)))
            .chain(["heuristic=distance", "update=ant"].into_iter().flat_map(|without| {
                let arms = [Arm::new("aco-wolf", PAPER), Arm::new("aco-wolf", &format!("{PAPER} {without}"))];
                [
                    Part::on(SCENE, arms.clone(), Question::Less(CONVERGED)),
                    Part::on(SCENE, arms, Question::Sooner { at: SETTLED, end: ITERATIONS }),
                ]
            }))
            .collect(),
    }]
}

/// What the tuning is worth.
fn tuned_claims(rows: &Rows) -> Vec<Claim> {
    vec![Claim {
        id: "O4",
        quotation: "提出用粒子群算法对改进蚁群算法的重要参数进行优化选择",
        says: "The particle swarm chooses the colony’s parameters well",
        place: "Abstract; §4, §6",
        universal: false,
        tables: &["§5.2"],
        reading: "Five tunings by the swarm and five random searches with as many sets of parameters, judged by seeds that they have not seen. ε cancels out of (4), so no single optimum exists.",
        parts: (TUNING_SEEDS[0]..=TUNING_SEEDS[1])
            .filter_map(|seed| {
                let [swarm, random] = [tuned(rows, TUNERS[0], seed)?, tuned(rows, TUNERS[1], seed)?];
                Some([
                    Part::on(SCENE, [swarm.clone(), random], Question::Less(LENGTH)).seeds([101, 150]),
                    Part::on(SCENE, [swarm, Arm::new("aco-wolf", PAPER)], Question::Less(LENGTH)).seeds([101, 150]),
                ])
            })
            .flatten()
            .collect(),
    }]
}

/// Drives among moving obstacles.
fn drives() -> Vec<Claim> {
    let dynamic = "columns=20 rows=20 share=0.25 moving=3";
    vec![Claim {
        id: "O5",
        quotation: "能有效地解决移动机器人动态路径规划问题",
        says: "The method solves path planning among moving obstacles",
        place: "§6, figs 2 and 3",
        universal: false,
        tables: &["Table 2, driven"],
        reading: "At least 95 % of all drives arrive without a collision, and no fewer than with two rivals. In the printed case the obstacle never comes near a point robot, so that case proves nothing.",
        parts: [Part::on_maps(["random"], [101, 200], dynamic, [Arm::new("wolf-ant-drive", "")], Question::AtLeast(ARRIVES, 0.95))
            .seeds([51, 51])]
        .into_iter()
        .chain(["a-star-drive", "d-star-lite-drive"].map(|rival| {
            let arms = [Arm::new("wolf-ant-drive", ""), Arm::new(rival, "")];
            Part::on_maps(["random"], [101, 200], dynamic, arms, Question::MoreOftenInPairs(ARRIVES)).seeds([51, 51])
        }))
        .collect(),
    }]
}
