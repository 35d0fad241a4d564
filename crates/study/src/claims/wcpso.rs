//! The claims of [WCPSO](forage#papers).

use super::{
    claim::{Arm, Claim, Event, Part, Question, Until},
    measure::{LENGTH, Measure, VALUE, value_on},
    paper::PaperClaims,
};

/// See the module.
pub(super) const CLAIMS: PaperClaims = PaperClaims { claims: |_| claims(), first: Vec::new, files: ["", "wcpso-claims-runs.csv"] };

/// Table 2's functions.
const TABLE_2: [&str; 8] = ["matyas", "egg-crate", "sphere-2", "sphere", "rosenbrock-2", "rosenbrock", "ackley-2", "ackley"];
/// One of another kind.
const FURTHER: &str = "rastrigin";
/// One pair r1, r2 per coordinate or per particle: the paper does not say.
const READINGS: [&str; 2] = ["random=coordinate", "random=particle"];
const SPREAD: Measure = Measure::new("spread", "spread of the particles", 4).of_any_run();
const NEAR: Event = Event { name: "within 0.5 % of the exact optimum", of: |run| run.gap.is_some_and(|gap| gap <= 0.005) };
/// Scenes of discs, with the settings that the paper leaves open.
const DISCS: [(&str, &str); 7] = [
    ("wcpso-discs", ""),
    ("wcpso-discs", "waypoints=2"),
    ("wcpso-discs", "waypoints=4"),
    ("wcpso-discs", "waypoints=5"),
    ("wcpso-discs", "penalty=waypoints"),
    ("discs-gate", ""),
    ("discs-slalom", ""),
];

/// The functions with their minimum somewhere else, as a generator moves it.
const SHIFTED: [&str; 4] =
    ["function=sphere dimension=10", "function=rosenbrock dimension=10", "function=ackley dimension=10", "function=rastrigin dimension=10"];
/// Generated scenes of discs.
const GENERATED: [u64; 2] = [101, 124];
/// As many of them have runs enough to compare how these vary.
const VARIED: [u64; 2] = [101, 106];

/// Two planners on functions whose minimum is not in the middle.
fn on_shifted(pairs: &[[&'static str; 2]]) -> Vec<Part> {
    let on = |settings, pair: &[&'static str; 2], reading| {
        let arms = pair.map(|planner| Arm::new(planner, reading));
        let floor = if settings == SHIFTED[2] { value_on("ackley") } else { VALUE };
        Part::on_map("shifted", 1, settings, arms, Question::Less(floor))
    };
    let each = SHIFTED.into_iter().flat_map(|settings| READINGS.map(|reading| (settings, reading)));
    each.flat_map(|(settings, reading)| pairs.iter().map(move |pair| on(settings, pair, reading))).collect()
}

/// How the lengths of `wcpso` and `wpso` vary on some generated scenes of discs.
fn varying() -> impl Iterator<Item = Part> {
    let arms = ["wcpso", "wpso"].map(|planner| Arm::new(planner, ""));
    (VARIED[0]..=VARIED[1]).map(move |map| Part::on_map("discs", map, "", arms.clone(), Question::SpreadsLess(LENGTH)))
}

/// `wcpso` and `wpso` over generated scenes of discs.
fn among_generated(question: Question) -> Part {
    Part::on_maps(["discs"], GENERATED, "", ["wcpso", "wpso"].map(|planner| Arm::new(planner, "")), question)
}

/// Each function with each reading, and two planners.
fn on_functions(scenes: &[&'static str], pairs: &[[&'static str; 2]]) -> Vec<Part> {
    let mut parts = Vec::new();
    for &scene in scenes {
        for reading in READINGS {
            parts.extend(
                pairs.iter().map(|pair| Part::on(scene, pair.map(|planner| Arm::new(planner, reading)), Question::Less(value_on(scene)))),
            );
        }
    }
    parts
}

/// `wcpso` and `wpso` among discs.
fn among_discs(question: Question) -> impl Iterator<Item = Part> {
    DISCS.into_iter().map(move |(scene, params)| Part::on(scene, ["wcpso", "wpso"].map(|planner| Arm::new(planner, params)), question))
}

/// With and without the perturbation, with either sign of s2.
fn perturbed(scene: &'static str, question: Question, until: Until) -> impl Iterator<Item = Part> {
    ["", "s2=source"]
        .into_iter()
        .map(move |sign| Part::on(scene, [Arm::new("wcpso", sign), Arm::new("wcpso", "perturb=false")], question).until(until))
}

fn claims() -> Vec<Claim> {
    [precision(), fluctuation(), parts()].concat()
}

/// How precise the swarms are on functions.
fn precision() -> Vec<Claim> {
    let functions = [TABLE_2.as_slice(), &[FURTHER]].concat();
    let trends = TABLE_2.into_iter().flat_map(|scene| {
        let ranked = ["wcpso", "wpso", "cpso", "pso"];
        READINGS.map(|reading| Part::on(scene, ranked.map(|planner| Arm::new(planner, reading)), Question::Grows(value_on(scene))))
    });
    let others = [["wcpso", "pso"], ["wcpso", "cpso"], ["wcpso", "wpso"]];
    vec![
        Claim {
            id: "W1",
            quotation: "均取得了较高的收敛精度并且优于其他算法",
            says: "On functions of all kinds WCPSO is more precise than the other swarms",
            place: "§3.1, Table 2",
            universal: true,
            tables: &["Table 2"],
            reading: "Both readings of r1 and r2. On some functions all swarms end at the floor of rounding, where no difference can show. On shifted functions the minimum is not in the middle of the search box.",
            parts: [on_functions(&functions, &others), on_shifted(&others)].concat(),
        },
        Claim {
            id: "W2",
            quotation: "其次是WPSO,传统的PSO算法收敛效果最差",
            says: "WPSO is second, and PSO converges worst",
            place: "§3.1, Table 2",
            universal: true,
            tables: &["Table 2"],
            reading: "Table 2 itself disagrees: on f4 and f5 with 10 variables its mean of CPSO is smaller than that of WPSO.",
            parts: on_functions(&TABLE_2, &[["wpso", "cpso"], ["cpso", "pso"]]).into_iter().chain(trends).collect(),
        },
    ]
}

/// How their paths vary.
fn fluctuation() -> Vec<Claim> {
    vec![
        Claim {
            id: "W3a",
            quotation: "WPSO算法虽然也能获得较优的路径,但算法波动大",
            says: "WPSO’s paths among discs vary much, WCPSO’s little",
            place: "§3.2, figs 5 to 7",
            universal: false,
            tables: &["§3.2"],
            reading: "The paper prints neither the number of waypoints nor whether segments are checked.",
            parts: among_discs(Question::SpreadsLess(LENGTH)).chain(varying()).collect(),
        },
        Claim {
            id: "W3b",
            quotation: "WPSO算法虽然也能获得较优的路径,但算法波动大",
            says: "WCPSO’s paths among discs are nearer to the optimum than WPSO’s",
            place: "§3.2, figs 5 to 7",
            universal: false,
            tables: &["§3.2"],
            reading: "",
            parts: among_discs(Question::Less(LENGTH))
                .chain(among_discs(Question::MoreOften(NEAR)))
                .chain([among_generated(Question::LessAcross(LENGTH))])
                .collect(),
        },
    ]
}

/// What the perturbation and the schedules are worth.
fn parts() -> Vec<Claim> {
    let tried = ["sphere", "rosenbrock", "ackley"];
    vec![
        Claim {
            id: "W4a",
            quotation: "增加了粒子多样性,避免了搜索停滞的问题",
            says: "The hen and chick moves increase the particles’ diversity",
            place: "§4",
            universal: false,
            tables: &[],
            reading: "The spread of the particles’ positions half-way, with the moves and without them; s2 as printed and as in the source of the moves.",
            parts: tried
                .into_iter()
                .flat_map(|scene| perturbed(scene, Question::More(SPREAD), Until::Iteration(500)))
                .chain(perturbed("wcpso-discs", Question::More(SPREAD), Until::Iteration(250)))
                .collect(),
        },
        Claim {
            id: "W4b",
            quotation: "增加了粒子多样性,避免了搜索停滞的问题",
            says: "The hen and chick moves avoid stagnation",
            place: "§4",
            universal: false,
            tables: &[],
            reading: "Stagnation costs precision, so the results at the end are compared.",
            parts: tried
                .into_iter()
                .flat_map(|scene| perturbed(scene, Question::Less(value_on(scene)), Until::End))
                .chain(["wcpso-discs", "discs-slalom"].into_iter().flat_map(|scene| perturbed(scene, Question::Less(LENGTH), Until::End)))
                .collect(),
        },
        Claim {
            id: "W5",
            quotation: "使得各参数的大小配合达到最佳",
            says: "Trigonometric schedules of ω, c1 and c2 match the parameters best",
            place: "§2.1, §4, figs 1 to 3",
            universal: true,
            tables: &[],
            reading: "Without the perturbation, against linear schedules between the same ends: all three, and one by one.",
            parts: ["sphere", "rosenbrock", "ackley", FURTHER]
                .into_iter()
                .flat_map(|scene| {
                    ["w_law=linear c1_law=linear c2_law=linear", "w_law=linear", "c1_law=linear", "c2_law=linear"].map(|laws| {
                        let linear = format!("perturb=false {laws}");
                        Part::on(scene, [Arm::new("wcpso", "perturb=false"), Arm::new("wcpso", &linear)], Question::Less(value_on(scene)))
                    })
                })
                .collect(),
        },
    ]
}
