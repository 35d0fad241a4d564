//! Numbers of the papers' texts, and what in the papers contradicts something else in them.

use forage::{
    Overrides, Setup, Value, geometry,
    kernel::{Error, SceneKindId},
    scene::{FUNCTION, GridScene},
    shipped, standard,
};

use super::{
    finding::Finding,
    samples::{ackley_minima, fall, samples},
};
use crate::{
    compared::Printed,
    figure::Figure,
    marks::Source,
    published::{
        ANTBAT, TABLE_1, TABLE_2, TABLE_3, TABLE_4, WOLF_ANT, WOLF_ANT_TURNS,
        wcpso::{self, PLANNERS},
        wolf_ant_path,
    },
    table::significant,
};

/// What arithmetic says of texts, paper by paper.
pub(super) fn findings() -> Result<Vec<Finding>, Error> {
    Ok([wcpso()?, ltqpso()?, antbat(), arm_rrt(), wolf_ant()?].concat())
}

/// Consistent if it holds, otherwise the other.
fn if_so(holds: bool, otherwise: Source) -> Source {
    if holds { Source::Consistent } else { otherwise }
}

/// A planner's default.
fn default(planner: &str, name: &str, kind: SceneKindId) -> Result<f64, Error> {
    let entry = standard().planner(planner)?;
    Ok(match entry.parameter(name).map(|parameter| parameter.default_on(kind)) {
        Some(Value::Number(number)) => number,
        _ => f64::NAN,
    })
}

/// A printed mean of Table 2 of [WCPSO](forage#papers); `which`: best, mean or standard deviation.
fn of_table_2(row: &wcpso::Row, planner: &str, which: usize) -> Result<f64, Error> {
    let k = PLANNERS.iter().position(|name| *name == planner).unwrap_or(0);
    Ok(Printed::read(row.results[k][which])?.value)
}

fn wcpso() -> Result<Vec<Finding>, Error> {
    let place = "[WCPSO] text";
    let mut findings = Vec::new();
    // Separable: the mixed difference over the corners of any box is 0.
    let f = |x: f64, y: f64| 100.0 * (y - x * x) * (y - x * x) + (1.0 - x) * (1.0 - x);
    let mixed = f(1.0, 1.0) - f(1.0, 0.0) - f(0.0, 1.0) + f(0.0, 0.0);
    findings.push(Finding::new(
        "[WCPSO] Table 1",
        "Rosenbrock’s function: separable (US)",
        if_so(mixed == 0.0, Source::Impossible),
        format!("f(1, 1) − f(1, 0) − f(0, 1) + f(0, 0) is {mixed}; of a separable function it is 0"),
    ));
    let best = |planner: &str, name: &str, dimension: usize| -> Result<f64, Error> {
        let row = wcpso::TABLE_2.iter().find(|row| row.name == name && row.dimension == dimension);
        row.map_or(Ok(f64::NAN), |row| of_table_2(row, planner, 0))
    };
    let (pso, own) = (best("pso", "f4", 10)?, best("wcpso", "f4", 10)?);
    findings.push(Finding::new(
        place,
        "f4 and f5: the four swarms find similar optima",
        if_so(pso / own < 10.0, Source::Impossible),
        format!("on f4 with 10 variables the best of PSO is {pso}, that of WCPSO {own}: {:.0} times", pso / own),
    ));
    for (row, claimed) in wcpso::TABLE_2.iter().zip(std::iter::repeat("WPSO is second")) {
        let [wpso, cpso] = [of_table_2(row, "wpso", 1)?, of_table_2(row, "cpso", 1)?];
        if cpso < wpso {
            findings.push(Finding::new(
                place,
                format!("{claimed}: {}, {} variables", row.name, row.dimension),
                Source::Impossible,
                format!("Table 2 has the mean {} for CPSO and {} for WPSO", significant(cpso, 7), significant(wpso, 7)),
            ));
        }
        let [own_best, other] = [of_table_2(row, "wcpso", 0)?, of_table_2(row, "wpso", 0)?];
        if other <= own_best {
            findings.push(Finding::new(
                place,
                format!("WCPSO is better than the others: {}, {} variables", row.name, row.dimension),
                if other < own_best { Source::Impossible } else { Source::Doubtful },
                format!("Table 2 has the best {} for WCPSO and {} for WPSO", significant(own_best, 7), significant(other, 7)),
            ));
        }
    }
    // Variances would be other standard deviations.
    let ackley = wcpso::TABLE_2.iter().find(|row| row.name == "f5" && row.dimension == 10);
    if let Some(row) = ackley {
        let k = PLANNERS.iter().position(|name| *name == "wpso").unwrap_or(0);
        let [mean, std] = [Printed::read(row.results[k][1])?, Printed::read(row.results[k][2])?];
        let root = Printed { value: std.value.sqrt(), unit: std.unit };
        let [as_std, as_variance] = [std, root].map(|std| samples(mean, std, &ackley_minima(10, 3)).len());
        findings.push(Finding::new(
            "[WCPSO] Table 2",
            "the text says variance (方差), the table Std",
            if_so(as_variance > 0, Source::Impossible),
            format!("as a standard deviation f5’s of WPSO fits {as_std} sample of stuck runs, as a variance {as_variance}: the table has standard deviations"),
        ));
    }
    let c = ["c_b", "c_a"].map(|name| default("wcpso", name, FUNCTION));
    let [middle, swing] = [c[0].clone()?, c[1].clone()?];
    findings.push(Finding::new(
        place,
        "c1 and c2 in [0.5, 2.5]",
        if_so((middle - swing, middle + swing) == (0.5, 2.5), Source::Impossible),
        format!("(4) with its printed coefficients goes from {} to {}", middle + swing, middle - swing),
    ));
    let f_l = default("wcpso", "f_l", FUNCTION)?;
    findings.push(Finding::new(
        place,
        "F_L in [1, 2]",
        Source::Consistent,
        format!("the default here is {f_l}, a parameter; 1 is a jump onto the best, 2 one to its mirror image"),
    ));
    let epsilon = format!("{:.4e}", f64::MIN_POSITIVE);
    findings.push(Finding::new(
        place,
        "ε = 2.2251e−308",
        if_so(epsilon == "2.2251e-308", Source::Impossible),
        format!("the smallest normal number of 64 bits is {epsilon}: it only avoids a division by 0"),
    ));
    Ok(findings)
}

/// What (10) and (11) suggest for D segments.
fn suggested(d: u64, initial: &str) -> Result<[u64; 2], Error> {
    let params: Overrides = [("segments", Value::from(d as f64)), ("initial", Value::from(initial))].into_iter().collect();
    let setup = Setup { planner: "ltqpso".to_owned(), scene: shipped("qpso-10m")?, params, seed: 1 };
    Ok(setup.suggest(standard())?.map_or([0, 0], |suggestion| [suggestion.population, suggestion.iterations]))
}

fn ltqpso() -> Result<Vec<Finding>, Error> {
    let mut findings = Vec::new();
    let distance = 10.0 * std::f64::consts::SQRT_2;
    let segments = [0.4, 0.3].map(|length| (distance / length).round());
    findings.push(Finding::new(
        "[LTQPSO] (12)",
        "D = 8 and 16",
        Source::Impossible,
        format!("distance / robot length is {:.2} / 0.4 m = {} or / 0.3 m = {}", distance, segments[0], segments[1]),
    ));
    for (printed, d) in [([30, 50], 8), ([83, 418], 16)] {
        let [uniform, normal] = [suggested(d, "uniform")?, suggested(d, "normal")?];
        let fits = [uniform, normal].contains(&printed);
        findings.push(Finding::new(
            "[LTQPSO] §5.1",
            format!("N = {}, M = {} for D = {d}", printed[0], printed[1]),
            if_so(fits, Source::Impossible),
            format!("(10) gives {} and {}, (11) {} and {}", uniform[0], uniform[1], normal[0], normal[1]),
        ));
    }
    let normal = suggested(16, "normal")?;
    let ratios = [83.0 / normal[0] as f64, 418.0 / normal[1] as f64];
    findings.push(Finding::new(
        "[LTQPSO] §5.1",
        "LTQPSO’s N and M are 1.0771 to 1.963 times QPSO’s",
        Source::Doubtful,
        format!(
            "83 and 418 are {:.4} and {:.4} times what (11) gives for D = 16; the text does not say what is divided",
            ratios[0], ratios[1]
        ),
    ));
    let exponent = TABLE_1[3].b[1];
    findings.push(Finding::new(
        "[LTQPSO] (10)",
        "M: exponent 2.218",
        if_so(exponent == 2.218, Source::Impossible),
        format!("Table 1 has {exponent:.4}"),
    ));
    let [minimum, maximum] = [TABLE_1[0].f, TABLE_1[1].f];
    findings.push(Finding::new(
        "[LTQPSO] §3",
        "the maxima fit better than the minima",
        if_so(maximum > minimum, Source::Impossible),
        format!("Table 1: F of N min {minimum} is larger than F of N max {maximum}"),
    ));
    for (table, lines) in [("Table 1", &TABLE_1), ("Table 2", &TABLE_2)] {
        for (name, line) in ["N min", "N max", "M min", "M max"].iter().zip(lines) {
            let Some(printed) = line.r2 else { continue };
            let follows = line.f / (line.f + 14.0);
            findings.push(Finding::new(
                &format!("[LTQPSO] {table}"),
                format!("{name}: R² {printed}"),
                if_so((printed - follows).abs() < 1e-4, Source::Impossible),
                format!("F {} and 16 points give {follows:.4}", line.f),
            ));
        }
    }
    // Bhatia and Davis: the worst of 50 runs of at least 14.14 m.
    let [mean, std, _] = TABLE_4[0];
    let worst = mean + std * std * 49.0 / 50.0 / (mean - distance);
    findings.push(Finding::new(
        "[LTQPSO] Table 4",
        format!("QPSO: mean {mean} m, standard deviation {std} m"),
        Source::Doubtful,
        format!("no path is shorter than {distance:.2} m, so the longest of 50 runs is at least {worst:.1} m: a penalised failure, a zigzag, or the smoothness term"),
    ));
    for (table, results) in [("Table 3", TABLE_3), ("Table 4", TABLE_4)] {
        findings.push(Finding::new(
            &format!("[LTQPSO] {table}"),
            format!("times {} s and {} s", results[0][2], results[1][2]),
            Source::Consistent,
            format!("{:.1} % less; times depend on the machine, claim L1c compares evaluations", fall([results[0][2], results[1][2]])),
        ));
    }
    findings.push(Finding::new(
        "[LTQPSO] §5.2, figs 10 and 11",
        "stuck about iteration 149, escape about 200, 50 more iterations; 4.0252 m and 4.3812 m",
        Source::Doubtful,
        format!("M = 50 in §5.1 ends before; the early stop (9) would have ended a run at 149 unless its patience exceeds {}. The lengths differ by {:.1} %; layout, start and goal are not printed, so they cannot be computed", 200 - 149, fall([4.3812, 4.0252])),
    ));
    findings.push(Finding::new(
        "[LTQPSO] §4",
        "(20) to (23) are the algorithm",
        Source::Doubtful,
        "they are plain QPSO, without ip, gs and selection; (21) has φ uniform, (22) has it from c1 and c2; Table 4’s start is N(45°, 30°), the text’s N(30°, 45°)",
    ));
    Ok(findings)
}

fn antbat() -> Vec<Finding> {
    let mut findings = Vec::new();
    for (k, (said, name)) in [(47.15, "traditional"), (35.84, "[14]")].into_iter().enumerate() {
        let fell = fall([ANTBAT[k].turning.value, ANTBAT[2].turning.value]);
        findings.push(Finding::new(
            "[ANTBAT] §3.1",
            format!("turning {said} % less than {name}"),
            if_so(Figure::new(said, 2).like(fell) == said, Source::Impossible),
            format!("{fell:.4} % by its table"),
        ));
    }
    for (k, (said, name)) in [(5.0, "traditional"), (3.0, "[14]")].into_iter().enumerate() {
        let fewer = ANTBAT[k].turns.value - ANTBAT[2].turns.value;
        findings.push(Finding::new(
            "[ANTBAT] §3.1",
            format!("{said} turns fewer than {name}"),
            if_so(fewer == said, Source::Impossible),
            format!("{fewer} by its table"),
        ));
    }
    findings.push(Finding::new(
        "[ANTBAT] fig. 7",
        "how four planners converge",
        Source::Doubtful,
        "the text says four (四种), the caption five (五种), as many as Table 2 has; (11) has λ where the text names γ",
    ));
    findings
}

fn arm_rrt() -> Vec<Finding> {
    // The derivatives of (12) at both ends, with the factors as printed: at t = 0 that of R0, at t = 1 that of R1.
    let [start, end] = [2.0, 3.0];
    let place = "[ARM-RRT]";
    vec![
        Finding::new(
            &format!("{place} (12)"),
            "factors 2R0 and 3R1",
            if_so(start == end, Source::Impossible),
            format!(
                "a piece would begin with {start} times its tangent and end with {end} times: velocity would jump where two pieces meet, which the text excludes"
            ),
        ),
        Finding::new(
            &format!("{place} §3.2.1"),
            "which samples are kept, and by what",
            Source::Doubtful,
            "§3.2.1 keeps 4 of 20 by their angle and then draws, step 2 (2) draws by distance and takes the nearest; both are parameters here (choice)",
        ),
        Finding::new(
            place,
            "equations, figures and steps",
            Source::Doubtful,
            "(6) is named where (11) is meant, fig. 5 where fig. 6 is meant; there is no (8) and no step 5; the second conclusion belongs to another paper",
        ),
    ]
}

fn wolf_ant() -> Result<Vec<Finding>, Error> {
    let scene = shipped("wolf-ant-20")?;
    let grid = scene.get::<GridScene>()?;
    let (speed, turn) = grid.robot.and_then(|robot| robot.speed.zip(robot.turn_time)).unwrap_or((f64::NAN, f64::NAN));
    let mut findings = Vec::new();
    let path = wolf_ant_path(&scene)?;
    let (length, turns) = (geometry::length(&path), geometry::turns(&path));
    let seconds = length / speed + turns as f64 * turn;
    let [px, time] = WOLF_ANT[2];
    let same = px.like(length) == px.value && time.like(seconds) == time.value && turns as f64 == WOLF_ANT_TURNS.value;
    let free = path.windows(2).all(|two| scene.is_free(two[0], two[1]));
    findings.push(Finding::new(
        "[WOLF-ANT] §6",
        format!("the improved ants’ path, {} cells", path.len()),
        if_so(same && free, Source::Impossible),
        format!(
            "its length is {length:.6} px, it has {turns} turns and takes {seconds:.6} s: as printed; on the reconstructed map it is {}",
            if free { "free" } else { "not free" }
        ),
    ));
    let [_, a_star] = WOLF_ANT[0];
    let as_best = length / speed + 12.0 * turn;
    findings.push(Finding::new(
        "[WOLF-ANT] Table 2",
        "A* is longer than the ants",
        Source::Impossible,
        format!("A* is exact. Its printed time {} s is also that of the ants’ length with 12 turns ({as_best:.4} s), so it may have had the optimal length", a_star.value),
    ));
    let run = |epsilon: f64| -> Result<Option<f64>, Error> {
        let params: Overrides = [("epsilon", Value::from(epsilon)), ("iterations", Value::from(20.0))].into_iter().collect();
        let mut run =
            forage::Run::with_keyframes(standard(), Setup { planner: "aco-wolf".to_owned(), scene: scene.clone(), params, seed: 1 }, 0)?;
        run.step(u64::MAX);
        Ok(run.readings().get("mean"))
    };
    // A power of two scales without rounding.
    let [two, four] = [run(2.0)?, run(4.0)?];
    findings.push(Finding::new(
        "[WOLF-ANT] §5.2",
        "tuned: ε = 2",
        if_so(two != four, Source::Doubtful),
        "ε is a factor of all ranks in (6) and cancels out of (4): runs with ε = 2 and ε = 4 are the same, so it cannot be tuned",
    ));
    Ok(findings)
}
