//! The claims of [ANTBAT](forage#papers).

use super::{
    claim::{Arm, Claim, Part, Question, Until},
    measure::{EVALUATIONS, LENGTH, Measure},
    paper::PaperClaims,
};

/// See the module.
pub(super) const CLAIMS: PaperClaims = PaperClaims { claims: |_| claims(), first: Vec::new, files: ["", "antbat-claims-runs.csv"] };

const SCENE: &str = "ant-bat-30";
const GRID: &str = "columns=20 rows=20";
const TURNS: Measure = Measure::new("turns", "number of turns", 4);
const TURNING: Measure = Measure::new("turning", "sum of turns in rad", 4);
const CONVERGED: Measure = Measure::new("converged", "iterations until the final path is found", 4);
const SETTLED: Measure = Measure::new("settled", "iterations until the colony settles", 4);
const ITERATIONS: Measure = Measure::new("iterations", "iterations", 4).of_any_run();
const REACHED: Measure = Measure::new("reached", "evaluations until it is within 1 % of the optimum", 4);
/// The traditional ants and those of reference 14, with the printed α and β.
const RIVALS: [(&str, &str); 2] = [("aco", "alpha=1.5 beta=8"), ("aco-dijkstra", "")];
/// The colony with direction: our default, ψ in its linear form, and Q as small as our first reading.
const READINGS: [&str; 3] = ["", "direction=linear", "q=1 q_unit=absolute"];

/// The colony with direction and a rival.
fn against(rival: usize, reading: &str) -> [Arm; 2] {
    let (planner, params) = RIVALS[rival];
    [Arm::new("aco-direction", reading), Arm::new(planner, params)]
}

fn each_reading(rival: usize, question: Question) -> impl Iterator<Item = Part> {
    READINGS.into_iter().map(move |reading| Part::on(SCENE, against(rival, reading), question))
}

/// Bats against the planners of Table 2 with equal numbers of tours, under both readings of step 2.
fn tours(question: Question) -> Vec<Part> {
    let mut parts = Vec::new();
    for (scene, budget) in [("random-52", 50_000), ("clustered-100", 100_000), ("random-280", 200_000)] {
        for replace in ["always", "better"] {
            for (rival, params) in [("hybrid-bat", ""), ("ga", ""), ("tour-pso", "local_search=none"), ("sa", "")] {
                let arms = [
                    Arm::new("bat", &format!("local_search=none replace={replace} iterations=1000000")),
                    Arm::new(rival, &format!("{params} iterations=1000000")),
                ];
                parts.push(Part::on(scene, arms, question).until(Until::Evaluations(budget)).seeds([51, 70]));
            }
        }
    }
    parts
}

/// The same on the paper's twelve stops with the shortest paths between them.
fn twelve(question: Question) -> impl Iterator<Item = Part> {
    let roads = "roads=dijkstra smooth=false";
    [("hybrid-bat", ""), ("ga", ""), ("tour-pso", "local_search=none"), ("sa", "")].into_iter().map(move |(rival, params)| {
        Part::on(SCENE, [Arm::new("bat", &format!("local_search=none {roads}")), Arm::new(rival, &format!("{params} {roads}"))], question)
    })
}

fn claims() -> Vec<Claim> {
    [lengths(), convergence(), bats()].concat()
}

/// How long the colonies' paths are, and how much they turn.
fn lengths() -> Vec<Claim> {
    let shorter = "路径长度分别缩短7.62%和3.75%";
    let table = "§3.1, table, fig. 4";
    let colonies: &[&str] = &["§3.1"];
    vec![
        Claim {
            id: "A1a",
            quotation: shorter,
            says: "The improved ants’ paths are shorter than those of traditional ants",
            place: table,
            universal: false,
            tables: colonies,
            reading: "The layout is a reconstruction. Three readings: ψ with squares (our default), ψ linear, Q = 1 absolute.",
            parts: each_reading(0, Question::Less(LENGTH))
                .chain([Part::across(GRID, against(0, ""), Question::LessAcross(LENGTH))])
                .collect(),
        },
        Claim {
            id: "A1b",
            quotation: shorter,
            says: "The improved ants’ paths are shorter than those of the ants of [14]",
            place: table,
            universal: false,
            tables: colonies,
            reading: "[14] as this paper describes it: its pheromone begins with an exact path, so on most maps it cannot be beaten.",
            parts: each_reading(1, Question::Less(LENGTH))
                .chain([Part::across(GRID, against(1, ""), Question::LessAcross(LENGTH))])
                .collect(),
        },
        Claim {
            id: "A1c",
            quotation: "转向次数分别减少5次和3次,转向角度分别缩小了47.15%和35.84%",
            says: "The improved ants’ paths have fewer turns and turn less than both others",
            place: table,
            universal: true,
            tables: colonies,
            reading: "",
            parts: [0, 1]
                .into_iter()
                .flat_map(|rival| {
                    [TURNS, TURNING].into_iter().flat_map(move |measure| {
                        [
                            Part::on(SCENE, against(rival, ""), Question::Less(measure)),
                            Part::across(GRID, against(rival, ""), Question::LessAcross(measure)),
                        ]
                    })
                })
                .collect(),
        },
    ]
}

/// How fast the colonies converge.
fn convergence() -> Vec<Claim> {
    let faster = "收敛速度分别增加24.04%和17.2%";
    let colonies: &[&str] = &["§3.1"];
    vec![
        Claim {
            id: "A2a",
            quotation: faster,
            says: "The improved ants converge faster than traditional ants",
            place: "Abstract; §3.1",
            universal: false,
            tables: colonies,
            reading: "Two measures: the iteration in which the final path is found, and the one from which the ants’ mean stays within 1 % of the best (settled).",
            parts: each_reading(0, Question::Less(CONVERGED))
                .chain(each_reading(0, Question::Sooner { at: SETTLED, end: ITERATIONS }))
                .chain([Part::across(GRID, against(0, ""), Question::LessAcross(SETTLED))])
                .collect(),
        },
        Claim {
            id: "A2b",
            quotation: faster,
            says: "The improved ants converge faster than the ants of [14]",
            place: "Abstract; §3.1",
            universal: false,
            tables: colonies,
            reading: "The printed 17.2 % follows neither from the printed times nor from the printed iterations.",
            parts: each_reading(1, Question::Less(CONVERGED))
                .chain(each_reading(1, Question::Sooner { at: SETTLED, end: ITERATIONS }))
                .chain([Part::across(GRID, against(1, ""), Question::LessAcross(SETTLED))])
                .collect(),
        },
        Claim {
            id: "A3",
            quotation: "采用奖惩机制优化信息素更新方式",
            says: "The update with reward and punishment speeds up convergence",
            place: "Abstract; §1.2",
            universal: false,
            tables: colonies,
            reading: "The colony with direction with and without reward and punishment (φ1 = φ2 = 0), and the update alone (γ = 0) against traditional ants.",
            parts: ["", "q=1 q_unit=absolute"]
                .into_iter()
                .flat_map(|q| {
                    let with = Arm::new("aco-direction", q);
                    let without = Arm::new("aco-direction", &format!("{q} phi1=0 phi2=0"));
                    let alone = Arm::new("aco-direction", &format!("{q} gamma=0"));
                    let plain = Arm::new("aco", RIVALS[0].1);
                    [
                        Part::on(SCENE, [with.clone(), without.clone()], Question::Sooner { at: SETTLED, end: ITERATIONS }),
                        Part::on(SCENE, [alone.clone(), plain.clone()], Question::Sooner { at: SETTLED, end: ITERATIONS }),
                        Part::on(SCENE, [with, without], Question::Less(LENGTH)),
                        Part::on(SCENE, [alone, plain], Question::Less(LENGTH)),
                    ]
                })
                .collect(),
        },
    ]
}

/// The bats, and the whole method.
fn bats() -> Vec<Claim> {
    let exact = "在收敛速度和解的精确度方面都有提升";
    let tour = "§3, Table 2, fig. 7";
    let stops: &[&str] = &["Table 2"];
    vec![
        Claim {
            id: "A4a",
            quotation: exact,
            says: "The bats’ tours of the paper’s twelve stops are shorter than those of the four other planners",
            place: tour,
            universal: true,
            tables: stops,
            reading: "The bats as the paper has them, without local search. Twelve stops are few: most planners find the exact tour every time. hybrid-bat is our reading of [25].",
            parts: twelve(Question::Less(LENGTH)).collect(),
        },
        Claim {
            id: "A4b",
            quotation: exact,
            says: "The bats’ tours of more stops are shorter than those of the four other planners",
            place: tour,
            universal: true,
            tables: &[],
            reading: "52, 100 and 280 stops, equal numbers of tours, 20 seeds; the bats without local search.",
            parts: tours(Question::Less(LENGTH)),
        },
        Claim {
            id: "A4c",
            quotation: exact,
            says: "The bats’ tours vary less than those of the four other planners",
            place: tour,
            universal: true,
            tables: stops,
            reading: "",
            parts: twelve(Question::SpreadsLess(LENGTH)).chain(tours(Question::SpreadsLess(LENGTH))).collect(),
        },
        Claim {
            id: "A4d",
            quotation: exact,
            says: "The bats converge faster than the four other planners",
            place: tour,
            universal: true,
            tables: stops,
            reading: "Evaluations until the tour is within 1 % of the exact optimum.",
            parts: twelve(Question::Sooner { at: REACHED, end: EVALUATIONS })
                .chain(tours(Question::Sooner { at: REACHED, end: EVALUATIONS }))
                .collect(),
        },
        Claim {
            id: "A5",
            quotation: "整体上计算复杂度更低,求解时间更短",
            says: "The whole method is of lower complexity and takes less time than [31] and [32]",
            place: "§3, fig. 8",
            universal: false,
            tables: &[],
            reading: "Fig. 8 prints no numbers. [31] is a cuckoo search for the paths, [32] a swarm with RRT; the paper prints none of their details.",
            parts: vec![
                Part::open("times depend on the machine; `forage reproduce antbat-time` measures all three for 5 to 30 stops"),
                Part::open(
                    "evaluations of the three methods are different work: an ant’s path, a candidate path of a swarm, an extension of a tree",
                ),
            ],
        },
    ]
}
