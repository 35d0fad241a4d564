//! The claims of [LTQPSO](forage#papers).

use super::{
    claim::{Arm, Claim, Event, Part, Question, Until},
    measure::{EVALUATIONS, LENGTH, Measure, value_on},
    paper::PaperClaims,
};

/// See the module.
pub(super) const CLAIMS: PaperClaims = PaperClaims { claims: |_| claims(), first: Vec::new, files: ["", "ltqpso-claims-runs.csv"] };

const PAIR: [&str; 2] = ["ltqpso", "qpso"];
const COST: Measure = Measure::new("cost", "cost", 6).of_any_run().or_trivial();
const SPREAD: Measure = Measure::new("spread", "spread of the particles", 4).of_any_run();
const REACHED: Measure = Measure::new("reached", "evaluations until it is within 0.01 of the minimum", 4);
/// Table 3's and Table 4's settings.
const EIGHT: &str = "segments=8 population=30 iterations=50";
const SIXTEEN: &str = "segments=16 initial=normal population=52 iterations=99";
const REDRAWS: [&str; 2] = ["redraws=100", "redraws=0"];
/// Fig. 1's functions, with its c1.
const FIG_1: [&str; 2] = ["sphere-4", "rastrigin"];
const FUNCTIONS: [&str; 3] = ["sphere", "rosenbrock", "ackley"];
const LONG: &str = "population=60 iterations=1000";
const NEAR: Event = Event { name: "within 1 % of the exact optimum", of: |run| run.gap.is_some_and(|gap| gap <= 0.01) };
const ESCAPES: Event = Event { name: "better after 50 or more iterations without improvement", of: |run| run.longest_wait >= 50 };
const GS_NEAR_1: Event =
    Event { name: "with a dispersion gs from 0.9 to 1.1 at the end", of: |run| run.other("gs").is_some_and(|gs| (gs - 1.0).abs() <= 0.1) };

fn both(params: &str) -> [Arm; 2] {
    PAIR.map(|planner| Arm::new(planner, params))
}

/// Tables 3 and 4, with and without redraws.
fn on_paths(more: &str, question: Question) -> Vec<Part> {
    let settings = [EIGHT, SIXTEEN].into_iter().flat_map(|sizes| REDRAWS.map(|redraws| format!("{sizes} {redraws} {more}")));
    settings.map(|params| Part::on("qpso-10m", both(&params), question)).collect()
}

fn claims() -> Vec<Claim> {
    [table_3_and_4(), search(), parameters(), optima()].concat()
}

/// Mean, deviation and time on the grid.
fn table_3_and_4() -> Vec<Claim> {
    let mean = "平均代价值、标准差和平均计算时间均小于QPSO算法";
    let place = "§5.1, Tables 3 and 4";
    vec![
        Claim {
            id: "L1a",
            quotation: mean,
            says: "LTQPSO’s mean cost is smaller than QPSO’s",
            place,
            universal: false,
            tables: &["Table 3", "Table 4"],
            reading: "Cost is what the planner minimises; length is that of the path which is handed over. Tables 3 and 4, with redraws of colliding angles and without.",
            parts: on_paths("", Question::Less(COST))
                .into_iter()
                .chain(on_paths("", Question::Less(LENGTH)))
                .chain([Part::across("columns=20 rows=20", both(""), Question::LessAcross(LENGTH))])
                .collect(),
        },
        Claim {
            id: "L1b",
            quotation: mean,
            says: "The standard deviation of LTQPSO’s cost is smaller than QPSO’s",
            place,
            universal: false,
            tables: &["Table 3", "Table 4"],
            reading: "",
            parts: on_paths("", Question::SpreadsLess(COST)).into_iter().chain(on_paths("", Question::SpreadsLess(LENGTH))).collect(),
        },
        Claim {
            id: "L1c",
            quotation: mean,
            says: "LTQPSO takes less time than QPSO",
            place,
            universal: false,
            tables: &["Table 3", "Table 4"],
            reading: "Time depends on the machine, so evaluations until the early stop of §4 (9) are compared; the paper does not say after how many iterations without improvement it stops.",
            parts: [10, 20, 30, 50]
                .into_iter()
                .flat_map(|stop| on_paths(&format!("early_stop={stop}"), Question::Less(EVALUATIONS)))
                .collect(),
        },
    ]
}

/// How it searches functions.
fn search() -> Vec<Claim> {
    vec![
        Claim {
            id: "L2a",
            quotation: "加强LTQPSO算法的全局搜索能力,加快算法的收敛速度",
            says: "LTQPSO searches globally better than QPSO",
            place: "Abstract",
            universal: false,
            tables: &[],
            reading: "Final values on the functions of fig. 1 (20 particles, 100 iterations, c1 = 1 as printed there) and on three others with 60 particles and 1000 iterations.",
            parts: FIG_1
                .into_iter()
                .map(|scene| Part::on(scene, both("c1=1"), Question::Less(value_on(scene))))
                .chain(FUNCTIONS.into_iter().map(|scene| Part::on(scene, both(LONG), Question::Less(value_on(scene)))))
                .collect(),
        },
        Claim {
            id: "L2b",
            quotation: "加强LTQPSO算法的全局搜索能力,加快算法的收敛速度",
            says: "LTQPSO converges faster than QPSO",
            place: "Abstract",
            universal: false,
            tables: &[],
            reading: "",
            parts: FIG_1
                .into_iter()
                .map(|scene| (scene, "c1=1"))
                .chain(FUNCTIONS.into_iter().map(|scene| (scene, LONG)))
                .map(|(scene, params)| Part::on(scene, both(params), Question::Sooner { at: REACHED, end: EVALUATIONS }))
                .collect(),
        },
    ]
}

/// What its weight does, and how large it has to be.
fn parameters() -> Vec<Claim> {
    vec![
        Claim {
            id: "L3",
            quotation: "惯性权重可以维持种群的稳定性与多样性",
            says: "The adaptive weight keeps the swarm stable and diverse",
            place: "§2.2, fig. 1",
            universal: false,
            tables: &[],
            reading: "Stable: the dispersion gs, without the cap of our default, is near 1 at the end. Diverse: the particles’ spread is larger than QPSO’s; ip and gs with selection, and alone.",
            parts: FIG_1
                .into_iter()
                .flat_map(|scene| {
                    let gs = Part::on(scene, [Arm::new("ltqpso", "c1=1 dispersion=uncapped")], Question::AtLeast(GS_NEAR_1, 0.9));
                    let spreads = [25, 50, 100].into_iter().flat_map(move |k| {
                        ["", "selection=false"].map(|own| {
                            let arms = [Arm::new("ltqpso", &format!("c1=1 dispersion=uncapped {own}")), Arm::new("qpso", "c1=1")];
                            Part::on(scene, arms, Question::More(SPREAD)).until(Until::Iteration(k))
                        })
                    });
                    [gs].into_iter().chain(spreads)
                })
                .collect(),
        },
        Claim {
            id: "L4",
            quotation: "LTQPSO算法可使用式(10)和式(11)来确定基本参数",
            says: "(10) and (11) give the population N and the iterations M",
            place: "§3, Tables 1 and 2, figs 3 and 4",
            universal: false,
            tables: &["Table 1", "Table 2"],
            reading: "The paper’s criterion: with N and M the standard deviation of the lengths without obstacles is below 0.05. How N and M were increased is not printed; the exponents, fitted by our rule, are in the figures below.",
            parts: [(5, 7, 10, 6, 7), (8, 16, 29, 14, 20), (12, 32, 71, 30, 51), (16, 52, 134, 52, 99), (20, 77, 219, 78, 167)]
                .into_iter()
                .flat_map(|(d, n10, m10, n11, m11)| {
                    [("uniform", "", n10, m10), ("normal", "initial_mean=30 initial_std=45", n11, m11)].map(|(initial, more, n, m)| {
                        let params = format!("segments={d} initial={initial} {more} population={n} iterations={m} smooth=false redraws=0");
                        Part::on("qpso-10m-empty", [Arm::new("ltqpso", &params)], Question::SpreadsAtMost(LENGTH, 0.05))
                    })
                })
                .collect(),
        },
    ]
}

/// Optima, and other swarms.
fn optima() -> Vec<Claim> {
    vec![
        Claim {
            id: "L5a",
            quotation: "QPSO算法不能求得最优路径解",
            says: "QPSO cannot reach the optimal path",
            place: "§5.1, fig. 7",
            universal: true,
            tables: &[],
            reading: "A path within 1 % of the exact optimum counts as optimal.",
            parts: REDRAWS
                .into_iter()
                .map(|redraws| Part::on("qpso-10m", [Arm::new("qpso", &format!("{SIXTEEN} {redraws}"))], Question::Never(NEAR)))
                .collect(),
        },
        Claim {
            id: "L5b",
            quotation: "跳出局部最优解的能力强于PQSO算法",
            says: "LTQPSO escapes local optima better than QPSO",
            place: "§5.2, figs 9 to 11",
            universal: false,
            tables: &[],
            reading: "Fig. 9’s layout, start and goal are not printed. Runs of 500 iterations: how often they come within 1 % of the optimum, and how often the best improves after 50 iterations without improvement.",
            parts: REDRAWS
                .into_iter()
                .flat_map(|redraws| {
                    let params = format!("segments=16 initial=normal population=52 iterations=500 {redraws}");
                    [NEAR, ESCAPES].map(|event| Part::on("qpso-10m", both(&params), Question::MoreOften(event)))
                })
                .collect(),
        },
        Claim {
            id: "L6",
            quotation: "QPSO算法在搜索能力上优于所有开发的PSO算法",
            says: "QPSO searches better than every PSO",
            place: "§2.1, cited",
            universal: true,
            tables: &[],
            reading: "The four swarms of [WCPSO]; 60 particles and 1000 iterations each.",
            parts: ["sphere", "rosenbrock", "ackley", "rastrigin"]
                .into_iter()
                .flat_map(|scene| {
                    ["pso", "wpso", "cpso", "wcpso"].map(|rival| {
                        Part::on(scene, ["qpso", rival].map(|planner| Arm::new(planner, LONG)), Question::Less(value_on(scene)))
                    })
                })
                .collect(),
        },
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use forage::{Setup, shipped, standard};

    /// The sizes of L4 are those that (10) and (11) give.
    #[test]
    fn sizes_are_those_that_the_planner_suggests() {
        let claims = claims();
        let parts = &claims.iter().find(|claim| claim.id == "L4").unwrap().parts;
        for arm in parts.iter().flat_map(|part| &part.arms) {
            let setup =
                Setup { planner: arm.planner.to_owned(), scene: shipped("qpso-10m-empty").unwrap(), params: arm.params.clone(), seed: 1 };
            let suggested = setup.suggest(standard()).unwrap().unwrap();
            let given = ["population", "iterations"].map(|name| arm.params.get(name).unwrap().to_string());
            assert_eq!(given, [suggested.population, suggested.iterations].map(|number| number.to_string()), "{:?}", arm.params);
        }
    }
}
