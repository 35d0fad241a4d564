//! From runs to answers, and from answers to marks.

use std::collections::BTreeMap;

use forage::statistics::{LAST, Summary, comparable, holm, proportion, rank_sum};

use super::{
    super::{
        inference::{brown_forsythe, fisher, log_rank, mcnemar, mean_difference, mean_of, page, signed_rank, std_of},
        marking::LEVEL,
        runner::Job,
        table::significant,
    },
    claim::{Claim, Event, On, Part, Question},
    judged::{Answer, Answered, Judged, Mark, ShownArm},
    measure::Measure,
    run::Run,
};

/// The least share of pairs in which the first is better (Vargha and Delaney's A) that upholds a claim.
pub const LEAST_EFFECT: f64 = 0.60;
/// Differences of lengths and costs within this many per cent are trivial.
pub const TRIVIAL: f64 = 0.5;
/// Of so many of the runs a mean or a deviation must be known.
const KNOWN: f64 = 0.9;

/// What a test says before it is corrected for the others.
struct Found {
    n: usize,
    numbers: String,
    test: &'static str,
    p: Option<f64>,
    /// Whether the difference is as claimed.
    toward: bool,
    /// Whether it is large enough to uphold a claim.
    large: bool,
    /// Whether it is too small to matter.
    trivial: bool,
    effect: String,
    /// Where no p-value decides.
    answer: Option<Answer>,
}

impl Default for Found {
    fn default() -> Self {
        Self {
            n: 0,
            numbers: String::new(),
            test: "",
            p: None,
            toward: false,
            large: true,
            trivial: false,
            effect: String::new(),
            answer: None,
        }
    }
}

/// Answers a claim's parts and marks it.
pub fn judge(claim: &Claim, rows: &BTreeMap<String, Run>) -> Judged {
    let found: Vec<Found> = claim.parts.iter().map(|part| ask(part, rows)).collect();
    let tested: Vec<f64> = found.iter().filter_map(|found| found.p).collect();
    let mut corrected = holm(&tested).into_iter();
    let parts: Vec<Answered> = claim.parts.iter().zip(found).map(|(part, found)| answered(part, found, &mut corrected)).collect();
    let answers: Vec<Answer> = parts.iter().map(|part| part.answer).collect();
    let count = |answer: Answer| answers.iter().filter(|&&other| other == answer).count();
    let counts = Answer::ALL.map(|answer| (count(answer), answer.name())).into_iter().filter(|(count, _)| *count > 0);
    let counted: Vec<String> = counts.map(|(count, name)| format!("{count} {name}")).collect();
    let of = if answers.len() == 1 { "One question".to_owned() } else { format!("{} questions", answers.len()) };
    let enough = if claim.universal && count(Answer::Contrary) > 0 { "; one contrary case refutes a claim about all cases" } else { "" };
    let &Claim { id, quotation, says, place, universal, tables, reading, .. } = claim;
    let (mark, because) = (Mark::of(&answers, universal), format!("{of}: {}{enough}", counted.join(", ")));
    Judged { id, quotation, says, place, universal, tables, reading, mark, because, parts }
}

fn answered(part: &Part, found: Found, corrected: &mut impl Iterator<Item = f64>) -> Answered {
    let corrected = found.p.and_then(|_| corrected.next());
    let answer = found.answer.unwrap_or(match corrected {
        _ if found.trivial => Answer::Trivial,
        Some(p) if p < LEVEL && found.toward && found.large => Answer::AsClaimed,
        Some(p) if p < LEVEL && !found.toward => Answer::Contrary,
        _ => Answer::Undecided,
    });
    let arms = part.arms.iter().map(|arm| ShownArm {
        planner: arm.planner,
        parameters: arm.params.clone(),
        motion: arm.motion.clone(),
        command: part.command(arm),
    });
    Answered {
        question: part.question.text(),
        on: part.place(),
        scene: match part.on.as_slice() {
            [On::Scene(name)] => Some(name),
            _ => None,
        },
        arms: arms.collect(),
        seeds: part.seeds,
        n: found.n,
        numbers: found.numbers,
        test: found.test,
        p: found.p,
        corrected,
        effect: found.effect,
        answer,
    }
}

fn ask(part: &Part, rows: &BTreeMap<String, Run>) -> Found {
    let runs: Vec<Vec<&Run>> = (0..part.arms.len()).map(|arm| part.tasks(arm).filter_map(|task| rows.get(&task.key())).collect()).collect();
    let of = |measure: &Measure| -> Vec<Vec<Option<f64>>> {
        runs.iter().map(|runs| runs.iter().map(|run| run.number(measure)).collect()).collect()
    };
    match &part.question {
        Question::Less(measure) => differ(&of(measure), measure, true),
        Question::More(measure) => differ(&of(measure), measure, false),
        Question::LessAcross(measure) => across(&of(measure), part.on.len(), measure),
        Question::SpreadsLess(measure) => spreads(&of(measure), measure),
        Question::Sooner { at, end } => sooner(&of(at), &of(end), at),
        Question::MoreOften(event) => more_often(&runs, event),
        Question::MoreOftenInPairs(event) => in_pairs(&runs, event),
        Question::AtLeast(event, share) => at_least(&runs[0], event, *share),
        Question::Never(event) => never(&runs[0], event),
        Question::AtMost(measure, limit) => at_most(&of(measure)[0], measure, *limit, "mean", |known| {
            (Summary::of(known.iter().copied()).map_or(f64::NAN, |summary| summary.mean), mean_of(known, known.len(), 0))
        }),
        Question::SpreadsAtMost(measure, limit) => at_most(&of(measure)[0], measure, *limit, "standard deviation", |known| {
            (Summary::of(known.iter().copied()).and_then(|summary| summary.std).unwrap_or(f64::NAN), std_of(known, 0))
        }),
        Question::Grows(measure) => grows(&of(measure)),
        Question::Open(reason) => Found { numbers: (*reason).to_owned(), answer: Some(Answer::Undecided), ..Found::default() },
    }
}

fn median(numbers: &[f64]) -> f64 {
    Summary::of(numbers.iter().copied()).map_or(LAST, |summary| summary.median)
}

fn shown(number: f64, digits: usize) -> String {
    if number < LAST { significant(number, digits) } else { "none".to_owned() }
}

fn effect(smaller: f64) -> String {
    format!("A = {smaller:.2}")
}

/// Whether two samples are one number: at the floor or at the optimum no difference can show.
fn same_number(first: &[f64], second: &[f64]) -> bool {
    first.iter().chain(second).all(|number| *number == first[0])
}

/// By how many per cent the means differ; `None` if a run has no number.
fn percent(first: &[f64], second: &[f64]) -> Option<[f64; 3]> {
    let known = first.iter().chain(second).all(|number| *number < LAST);
    let interval = mean_difference(first, second, 0).filter(|_| known)?;
    Some([interval.value, interval.low, interval.high])
}

fn differ(numbers: &[Vec<Option<f64>>], measure: &Measure, less: bool) -> Found {
    let ranked = comparable(numbers.iter().map(Vec::as_slice));
    let [first, second] = [&ranked[0], &ranked[1]];
    let Some(test) = rank_sum(first, second) else { return Found::default() };
    let better = if less { test.smaller } else { 1.0 - test.smaller };
    let difference = percent(first, second).filter(|_| measure.trivial);
    let ceiling = same_number(first, second);
    Found {
        n: first.len(),
        numbers: format!("medians {} and {}", shown(median(first), measure.digits), shown(median(second), measure.digits)),
        test: "rank-sum test",
        p: Some(test.p),
        toward: better > 0.5,
        large: better >= LEAST_EFFECT,
        trivial: !ceiling && difference.is_some_and(|[_, low, high]| low > -TRIVIAL && high < TRIVIAL),
        effect: difference.map_or_else(
            || effect(better),
            |[value, low, high]| format!("{}, means differ by {value:+.2} % ({low:+.2} to {high:+.2})", effect(better)),
        ),
        answer: None,
    }
}

fn across(numbers: &[Vec<Option<f64>>], maps: usize, measure: &Measure) -> Found {
    let ranked = comparable(numbers.iter().map(Vec::as_slice));
    let medians = |k: usize| -> Vec<f64> { ranked[k].chunks(ranked[k].len() / maps).map(median).collect() };
    let [first, second] = [medians(0), medians(1)];
    let pairs = || first.iter().zip(&second);
    // A map that one of them does not solve is the largest difference, whatever the other's length is.
    let relative = |(a, b): (&f64, &f64)| if a == b { 0.0 } else { (100.0 * (a - b) / b.min(*a)).clamp(-100.0, 100.0) };
    let differences: Vec<f64> = pairs().map(relative).collect();
    let (less, more) = (pairs().filter(|(a, b)| a < b).count(), pairs().filter(|(a, b)| a > b).count());
    let Some(test) = signed_rank(&differences) else { return Found::default() };
    let mean = Summary::of(differences.iter().copied()).map_or(f64::NAN, |summary| summary.mean);
    let [low, high] = mean_of(&differences, differences.len(), 0);
    let better = if less + more == 0 { 0.5 } else { less as f64 / (less + more) as f64 };
    Found {
        n: maps,
        numbers: format!("smaller on {less} maps, larger on {more}"),
        test: "signed-rank test of the maps’ medians",
        p: Some(test.p),
        toward: mean < 0.0,
        large: better >= LEAST_EFFECT,
        trivial: measure.trivial && less + more > 0 && low > -TRIVIAL && high < TRIVIAL,
        effect: format!("{mean:+.2} % in the mean ({low:+.2} to {high:+.2})"),
        answer: None,
    }
}

fn spreads(numbers: &[Vec<Option<f64>>], measure: &Measure) -> Found {
    let known: Vec<Vec<f64>> = numbers.iter().map(|numbers| numbers.iter().copied().flatten().collect()).collect();
    let deviation = |k: usize| Summary::of(known[k].iter().copied()).and_then(|summary| summary.std);
    let (Some(test), Some((first, second))) = (brown_forsythe(&known[0], &known[1]), deviation(0).zip(deviation(1))) else {
        return Found { numbers: "too few feasible runs".to_owned(), answer: Some(Answer::Undecided), ..Found::default() };
    };
    Found {
        n: known[0].len().min(known[1].len()),
        numbers: format!("standard deviations {} and {}", shown(first, measure.digits), shown(second, measure.digits)),
        test: "Brown–Forsythe test",
        p: Some(test.p),
        toward: first < second,
        effect: if second > 0.0 { format!("ratio {:.2}", first / second) } else { String::new() },
        ..Found::default()
    }
}

fn sooner(at: &[Vec<Option<f64>>], end: &[Vec<Option<f64>>], measure: &Measure) -> Found {
    let times = |k: usize| -> Vec<(f64, bool)> {
        at[k].iter().zip(&end[k]).map(|(at, end)| at.map_or((end.unwrap_or(LAST), false), |at| (at, true))).collect()
    };
    let ranked = comparable(at.iter().map(Vec::as_slice));
    let (Some(test), Some(order)) = (log_rank(&times(0), &times(1)), rank_sum(&ranked[0], &ranked[1])) else { return Found::default() };
    let reached = |k: usize| at[k].iter().flatten().count();
    Found {
        n: ranked[0].len(),
        numbers: format!(
            "medians {} and {}, {} and {} runs come there",
            shown(median(&ranked[0]), measure.digits),
            shown(median(&ranked[1]), measure.digits),
            reached(0),
            reached(1)
        ),
        test: "log-rank test",
        p: Some(test.p),
        toward: order.smaller > 0.5,
        large: order.smaller >= LEAST_EFFECT,
        effect: effect(order.smaller),
        ..Found::default()
    }
}

fn counts(runs: &[&Run], event: &Event) -> [u64; 2] {
    let yes = runs.iter().filter(|run| (event.of)(run)).count() as u64;
    [yes, runs.len() as u64 - yes]
}

/// In per cent.
fn share([yes, no]: [u64; 2]) -> f64 {
    100.0 * yes as f64 / (yes + no) as f64
}

fn more_often(runs: &[Vec<&Run>], event: &Event) -> Found {
    let [first, second] = [counts(&runs[0], event), counts(&runs[1], event)];
    Found {
        n: runs[0].len(),
        numbers: format!("{} and {} runs", first[0], second[0]),
        test: "Fisher’s exact test",
        p: Some(fisher(first, second).p),
        toward: first[0] * (second[0] + second[1]) > second[0] * (first[0] + first[1]),
        effect: format!("{:.0} and {:.0} %", share(first), share(second)),
        ..Found::default()
    }
}

fn in_pairs(runs: &[Vec<&Run>], event: &Event) -> Found {
    let only = |yes: usize, no: usize| runs[yes].iter().zip(&runs[no]).filter(|(a, b)| (event.of)(a) && !(event.of)(b)).count() as u64;
    let [first, second] = [only(0, 1), only(1, 0)];
    Found {
        n: runs[0].len(),
        numbers: format!("only the first in {first} pairs of runs, only the second in {second}"),
        test: "McNemar’s test",
        p: Some(mcnemar(first, second).p),
        toward: first > second,
        ..Found::default()
    }
}

fn at_least(runs: &[&Run], event: &Event, share: f64) -> Found {
    let [yes, _] = counts(runs, event);
    let [low, high] = proportion(yes as usize, runs.len()).unwrap_or([0.0, 1.0]);
    let answer = match () {
        () if low >= share => Answer::AsClaimed,
        () if high < share => Answer::Contrary,
        () => Answer::Undecided,
    };
    Found {
        n: runs.len(),
        numbers: format!("{yes} of {}", runs.len()),
        test: "Wilson’s interval",
        effect: format!("{:.1} to {:.1} %", 100.0 * low, 100.0 * high),
        answer: Some(answer),
        ..Found::default()
    }
}

fn never(runs: &[&Run], event: &Event) -> Found {
    let [yes, _] = counts(runs, event);
    let answer = if yes > 0 { Answer::Contrary } else { Answer::AsClaimed };
    Found { answer: Some(answer), ..at_least(runs, event, 0.0) }
}

fn at_most(numbers: &[Option<f64>], measure: &Measure, limit: f64, what: &str, of: impl Fn(&[f64]) -> (f64, [f64; 2])) -> Found {
    let known: Vec<f64> = numbers.iter().copied().flatten().collect();
    let (value, [low, high]) = of(&known);
    let answer = match () {
        () if (known.len() as f64) < KNOWN * numbers.len() as f64 => Answer::Undecided,
        () if high <= limit => Answer::AsClaimed,
        () if low > limit => Answer::Contrary,
        () => Answer::Undecided,
    };
    Found {
        n: known.len(),
        numbers: format!("{what} {}", shown(value, measure.digits)),
        test: "bootstrap interval",
        effect: format!("{} to {}", shown(low, measure.digits), shown(high, measure.digits)),
        answer: Some(answer),
        ..Found::default()
    }
}

fn grows(numbers: &[Vec<Option<f64>>]) -> Found {
    let ranked = comparable(numbers.iter().map(Vec::as_slice));
    let blocks = |order: &[usize]| -> Vec<Vec<f64>> {
        (0..ranked[0].len()).map(|seed| order.iter().map(|&arm| ranked[arm][seed]).collect()).collect()
    };
    let forward: Vec<usize> = (0..ranked.len()).collect();
    let backward: Vec<usize> = forward.iter().rev().copied().collect();
    let (Some(up), Some(down)) = (page(&blocks(&forward)), page(&blocks(&backward))) else { return Found::default() };
    let medians: Vec<String> = ranked.iter().map(|numbers| shown(median(numbers), 4)).collect();
    Found {
        n: ranked[0].len(),
        numbers: format!("medians {}", medians.join(", ")),
        test: "Page’s trend test",
        // One-sided both ways.
        p: Some((2.0 * up.p.min(down.p)).min(1.0)),
        toward: up.p < down.p,
        ..Found::default()
    }
}
