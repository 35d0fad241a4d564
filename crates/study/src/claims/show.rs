//! Claims in words, as Markdown and as JSON.

use std::fmt::Write;

use serde::Serialize;

use forage::{
    kernel::{Error, Message},
    message,
};

use super::{
    super::{
        failure::Failure,
        papers::PAPERS,
        report::Report,
        table::{Cell, Say, Table, probability},
    },
    judged::{Answered, Judged, Mark},
};

/// The rules, in words.
pub const RULES: &str = "Each claim is asked as one or more questions, and a test answers each: seeds 51 to 100, which no parameter was chosen by, and for questions across maps \
six maps of each generator with five seeds each. Planners have the populations and iterations that the paper gives them, which is what it compares: one may spend more evaluations than another. p-values are two-sided and corrected for the claim’s other questions (Holm). *as claimed*: p < 0.05, the first planner is the better one in at least 60 % of all pairs of runs \
(A; ties count half). *contrary*: p < 0.05 the other way. *trivial*: of lengths and costs, if the 95 % interval of the difference of the means lies within ±0.5 %. *undecided*: all else, for example because both planners always find the optimum.\n\n\
A claim is **upheld** if all answers are as claimed, **refuted** if all are contrary or trivial (of a claim that says \"all\", \"best\" or \"never\" one contrary answer is enough), otherwise **undecided**. \
Layouts that a paper does not print are reconstructions, so an answer is one about our reading of the paper.";

/// Planners as a line names them: the parameters that all have come last.
fn planners(part: &Answered) -> String {
    let mut part = part.clone();
    for arm in &mut part.arms {
        arm.motion.iter().for_each(|(name, value)| arm.parameters.insert(format!("motion {name}"), value.clone()));
    }
    let [first, rest @ ..] = part.arms.as_slice() else { return String::new() };
    let is_common = |name: &str| rest.iter().all(|arm| arm.parameters.get(name) == first.parameters.get(name));
    let listed = |of: &dyn Fn(&str) -> bool, given: &forage::Overrides| {
        given.iter().filter(|(name, _)| of(name)).map(|(name, value)| format!("{name}={value}")).collect::<Vec<_>>().join(" ")
    };
    let labels = part.arms.iter().map(|arm| {
        let own = if rest.is_empty() { String::new() } else { listed(&|name| !is_common(name), &arm.parameters) };
        if own.is_empty() { arm.planner.to_owned() } else { format!("{} ({own})", arm.planner) }
    });
    let common = listed(&|name| is_common(name), &first.parameters);
    let text = labels.collect::<Vec<_>>().join(", ");
    if common.is_empty() { text } else { format!("{text}; {common}") }
}

/// The questions of a claim.
fn table(claim: &Judged) -> Table {
    let mut table = Table::new(
        claim.id,
        message!("study-questions", "Questions of {id}", id = claim.id),
        &["question", "on", "planners", "n", "numbers", "test", "p", "effect", "answer"],
    );
    for part in &claim.parts {
        let p = part.corrected.map_or(Cell::Empty, |p| Cell::Text(probability(p)));
        let n = if part.n == 0 { Cell::Empty } else { Cell::whole(part.n as u64) };
        let [question, on, numbers, effect] = [&part.question, &part.on, &part.numbers, &part.effect].map(|text| Cell::Text(text.clone()));
        table.rows.push(vec![question, on, Cell::Text(planners(part)), n, numbers, part.test.into(), p, effect, part.answer.name().into()]);
    }
    table
}

/// Claims as a section of the document, or of a report.
pub fn markdown(claims: &[Judged]) -> String {
    let mut text = String::new();
    for claim in claims {
        let _ = write!(
            text,
            "#### {}: {} — {}\n\n> {} ({})\n\n{}.{}\n\n{}\n",
            claim.id,
            claim.says,
            claim.mark.name(),
            claim.quotation,
            claim.place,
            claim.because,
            if claim.reading.is_empty() { String::new() } else { format!(" {}", claim.reading) },
            table(claim).markdown()
        );
        if let Some(arm) = claim.parts.iter().flat_map(|part| &part.arms).find(|arm| !arm.command.is_empty()) {
            let _ = write!(text, "The first run: `{}`.\n\n", arm.command);
        }
    }
    text
}

/// Claims for a terminal, and a table of the questions of each; `say`: how texts in English are said.
pub fn text(claims: &[Judged], say: Say<'_>) -> String {
    let mut text = String::new();
    for claim in claims {
        let said = message!(
            "study-claim",
            "{id}: {says}: {mark}. {because}",
            id = claim.id,
            says = say(claim.says),
            mark = say(claim.mark.name()),
            because = say(&claim.because)
        );
        let _ = write!(text, "{said}\n{}\n", table(claim).text(say));
    }
    text
}

/// `27 claims: 3 upheld, 9 refuted, 15 undecided`.
pub fn counted<'a>(claims: impl IntoIterator<Item = &'a Judged>) -> String {
    let all: Vec<Mark> = claims.into_iter().map(|claim| claim.mark).collect();
    let count = |mark: Mark| all.iter().filter(|&&other| other == mark).count();
    let marks: Vec<String> = Mark::ALL.iter().map(|&mark| format!("{} {}", count(mark), mark.name())).collect();
    format!("{} claim{}: {}", all.len(), if all.len() == 1 { "" } else { "s" }, marks.join(", "))
}

/// A claim and its paper.
#[derive(Serialize)]
struct Entry<'a> {
    paper: &'a str,
    #[serde(flatten)]
    claim: &'a Judged,
}

/// All claims for programs: the papers, and each claim with its questions and answers; one of them a line.
///
/// # Errors
/// None that is known: it is written to memory.
pub fn json(reports: &[Report]) -> Result<String, Failure> {
    let claims = reports.iter().flat_map(|report| report.claims.iter().map(|claim| Entry { paper: report.paper(), claim }));
    Ok(format!("{{\"papers\":[\n{}\n],\"claims\":[\n{}\n]}}\n", lines(PAPERS.iter())?, lines(claims)?))
}

fn lines(items: impl Iterator<Item = impl Serialize>) -> Result<String, Failure> {
    let lines: Result<Vec<String>, _> = items.map(|item| serde_json::to_string(&item)).collect();
    Ok(lines.map_err(|problem| Error::malformed("claims", Message::verbatim(problem.to_string())))?.join(",\n"))
}
