//! The claims of [ARM-RRT](forage#papers).

use super::{
    claim::{Arm, Claim, Event, Part, Question},
    measure::{GAP, LENGTH, Measure},
    paper::PaperClaims,
};

/// See the module.
pub(super) const CLAIMS: PaperClaims = PaperClaims { claims: |_| claims(), first: Vec::new, files: ["", "arm-rrt-claims-runs.csv"] };

const NODES: Measure = Measure::new("nodes", "number of nodes", 4);
const TESTED: Measure = Measure::new("tested", "number of collision tests", 4);
const ASIDE: Measure = Measure::new("aside", "largest sideways deviation in m", 4);
const LARGEST_JUMP: Measure = Measure::new("largest_jump", "largest jump of a joint’s velocity in °/s", 4);
const MEAN_JUMP: Measure = Measure::new("mean_jump", "mean jump of joint velocities in °/s", 4);
/// 5 % of the 1.3161 m from start to goal, and 5 % more than them.
const STRAIGHT: [f64; 2] = [0.0658, 1.3819];
/// Without what the paper does not have.
const RAW: &str = "shorten=false polyline=false smooth=false";
const FINISHED: &str = "shorten=false";
const STEPS: [&str; 2] = ["step_size=0.03", "step_size=0.05"];
const FEASIBLE: Event = Event { name: "end with a feasible path", of: |run| run.feasible };
const ARM_FREE: Event = Event { name: "let the whole arm pass without contact", of: |run| run.other("motion_free") == Some(1.0) };
const FOLLOWED: Event = Event { name: "followed by the arm to the goal", of: |run| run.other("motion_arrived") == Some(1.0) };

/// The guided tree and rivals in the arm's workspace.
fn in_workspace(rivals: &[(&'static str, &str)], question: Question) -> Vec<Part> {
    let mut parts = Vec::new();
    for scene in ["arm-cuboid", "arm-free"] {
        for step in STEPS {
            parts.extend(rivals.iter().map(|(rival, params)| {
                Part::on(scene, [Arm::new("rrt-guided", step), Arm::new(rival, &format!("{step} {params}"))], question)
            }));
        }
    }
    parts
}

fn claims() -> Vec<Claim> {
    let mut claims = [cost(), paths(), motion(), guarantees()].concat();
    // The paper's trees ask the tip alone.
    for part in claims.iter_mut().flat_map(|claim| &mut claim.parts).filter(|part| part.is_on("arm-")) {
        part.arms = part.arms.iter().map(|arm| arm.clone().with("reachable", "false")).collect();
    }
    claims
}

/// What a tree costs.
fn cost() -> Vec<Claim> {
    let nodes = "能够有效地缩短规划时间,并且能够减少随机数的节点数";
    vec![
        Claim {
            id: "R1a",
            quotation: nodes,
            says: "Guided RRT needs fewer nodes and less time than basic RRT in the arm’s workspace",
            place: "§3.2.1, §5",
            universal: false,
            tables: &["Nodes"],
            reading: "Time depends on the machine, so collision tests are compared instead. The paper prints no numbers.",
            parts: [NODES, TESTED].into_iter().flat_map(|measure| in_workspace(&[("rrt", "")], Question::Less(measure))).collect(),
        },
        Claim {
            id: "R1b",
            quotation: nodes,
            says: "Guided RRT needs fewer nodes and less time than RRT with goal bias and RRT-Connect",
            place: "§3.2.1, §5",
            universal: false,
            tables: &["Nodes"],
            reading: "The paper compares with basic RRT alone; these two are common today.",
            parts: [NODES, TESTED]
                .into_iter()
                .flat_map(|measure| in_workspace(&[("rrt", "goal_bias=0.05"), ("rrt-connect", "")], Question::Less(measure)))
                .collect(),
        },
        Claim {
            id: "R1c",
            quotation: nodes,
            says: "Guided RRT needs fewer nodes and less time in clutter",
            place: "§3.2.1, §5",
            universal: false,
            tables: &[],
            reading: "Generated maps; a tree that finds no path counts as the largest.",
            parts: [NODES, TESTED]
                .into_iter()
                .flat_map(|measure| {
                    ["", "goal_bias=0.05"].map(|bias| {
                        Part::across(
                            "columns=30 rows=30",
                            [Arm::new("rrt-guided", ""), Arm::new("rrt", bias)],
                            Question::LessAcross(measure),
                        )
                    })
                })
                .collect(),
        },
    ]
}

/// What its paths are like.
fn paths() -> Vec<Claim> {
    vec![
        Claim {
            id: "R2",
            quotation: "在无障碍物基本上是沿着直线",
            says: "Without an obstacle the path is nearly straight",
            place: "§4, §5, fig. 6",
            universal: false,
            tables: &["Straightness"],
            reading: "The paper shows a picture. Nearly straight means here: at most 5 % longer than the straight line, and at most 5 % of its length to the side. The tree’s own path, and after the paper’s polyline and Hermite curve; shortening, which the paper does not have, makes it exactly straight.",
            parts: [RAW, FINISHED]
                .into_iter()
                .flat_map(|steps| {
                    ["choice=angle", "choice=distance"].into_iter().flat_map(move |choice| {
                        let arm = Arm::new("rrt-guided", &format!("{steps} {choice}"));
                        [
                            Part::on("arm-free", [arm.clone()], Question::AtMost(ASIDE, STRAIGHT[0])),
                            Part::on("arm-free", [arm], Question::AtMost(LENGTH, STRAIGHT[1])),
                        ]
                    })
                })
                .collect(),
        },
        Claim {
            id: "R3a",
            quotation: "能够顺利避开障碍物",
            says: "The arm avoids the cuboid",
            place: "§5, figs 7 and 8",
            universal: false,
            tables: &["Success"],
            reading: "At least 95 % of all runs: the tip’s path, and the whole arm along it. The cuboid is a reconstruction.",
            parts: STEPS
                .into_iter()
                .flat_map(|step| {
                    [FEASIBLE, ARM_FREE].map(|event| Part::on("arm-cuboid", [Arm::new("rrt-guided", step)], Question::AtLeast(event, 0.95)))
                })
                .map(|part| part.seeds([51, 150]))
                .collect(),
        },
        Claim {
            id: "R3b",
            quotation: "以较近的路径到达目标位置",
            says: "The path past the cuboid is short",
            place: "§5, figs 7 and 8",
            universal: false,
            tables: &["Success"],
            reading: "Short means here: at most 5 % longer than the exact optimum of the tip. With the paper’s own steps, and with shortening.",
            parts: [FINISHED, ""]
                .into_iter()
                .map(|steps| Part::on("arm-cuboid", [Arm::new("rrt-guided", steps)], Question::AtMost(GAP, 0.05)))
                .collect(),
        },
    ]
}

/// How the arm follows them.
fn motion() -> Vec<Claim> {
    vec![
        Claim {
            id: "R4",
            quotation: "降低了机器人工作过程中的抖动",
            says: "Smoothing reduces the arm’s shaking",
            place: "Abstract; §3.2.2",
            universal: false,
            tables: &[],
            reading: "Jumps of the joints’ velocities from one leg of the motion to the next, with the Hermite curve and without it, under the same time law.",
            parts: ["arm-free", "arm-cuboid"]
                .into_iter()
                .flat_map(|scene| {
                    [LARGEST_JUMP, MEAN_JUMP].map(|measure| {
                        let arms = [Arm::new("rrt-guided", "shorten=false"), Arm::new("rrt-guided", "shorten=false smooth=false")];
                        Part::on(scene, arms, Question::Less(measure))
                    })
                })
                .collect(),
        },
        Claim {
            id: "R5",
            quotation: "对于反解失败的点,做了规划替代",
            says: "Points without an inverse solution are replaced, so that the arm can go on",
            place: "Abstract; steps 4 and 6",
            universal: false,
            tables: &[],
            reading: "The arm’s motion with and without replacement, on another arm whose inverse often fails: with a fixed tool, and with links 5 cm thick. On the paper’s arm no point fails with a free tool, and with a fixed one the first does, which nothing can replace.",
            parts: ["orientation=home", "radius=0.05"]
                .into_iter()
                .map(|motion| {
                    let arm =
                        |replacement: bool| Arm::new("rrt-guided", "shorten=false").moving(&format!("{motion} replacement={replacement}"));
                    Part::on("arm-puma", [arm(true), arm(false)], Question::MoreOften(FOLLOWED))
                })
                .collect(),
        },
    ]
}

/// What the method guarantees.
fn guarantees() -> Vec<Claim> {
    vec![
        Claim {
            id: "R6a",
            quotation: "快速规划出一条全局优化路径",
            says: "The path is globally optimal",
            place: "Abstract",
            universal: false,
            tables: &["Success"],
            reading: "Optimal means here: at most 1 % longer than the exact optimum of the tip, by the paper’s own steps.",
            parts: STEPS
                .into_iter()
                .map(|step| Part::on("arm-cuboid", [Arm::new("rrt-guided", &format!("{FINISHED} {step}"))], Question::AtMost(GAP, 0.01)))
                .collect(),
        },
        Claim {
            id: "R6b",
            quotation: "确保事件的概率完备性",
            says: "The method is probabilistically complete",
            place: "§1",
            universal: false,
            tables: &[],
            reading: "In scenes that trap a guided tree it should still find a path when it goes on: at least 95 % of all runs, with 20,000 extensions, with and without the step of plain RRT when all kept directions collide.",
            parts: ["discs-gate", "rooms-20"]
                .into_iter()
                .flat_map(|scene| {
                    [true, false].map(|fallback| {
                        Part::on(scene, [Arm::new("rrt-guided", &format!("fallback={fallback}"))], Question::AtLeast(FEASIBLE, 0.95))
                    })
                })
                .map(|part| part.seeds([51, 150]))
                .collect(),
        },
    ]
}
