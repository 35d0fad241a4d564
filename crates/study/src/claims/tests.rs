use std::collections::{BTreeMap, BTreeSet};

use super::{
    judge::judge,
    measure::value_on,
    paper::{PaperClaims, Rows},
    run::Run,
    task::Task,
    *,
};
use crate::{
    papers::{PAPERS, Paper},
    runner::Job,
};
use forage::{params::Parameters, standard};

/// All claims of all papers, without what a tuning finds.
fn all() -> Vec<(&'static str, Claim)> {
    let papers = [&wcpso::CLAIMS, &ltqpso::CLAIMS, &antbat::CLAIMS, &arm_rrt::CLAIMS, &wolf_ant::CLAIMS];
    let of = |(paper, claims): (&Paper, &PaperClaims)| {
        (claims.claims)(&Rows::new()).into_iter().map(|claim| (paper.tag, claim)).collect::<Vec<_>>()
    };
    PAPERS.iter().zip(papers).flat_map(of).collect()
}

/// The values of two planners' runs.
type Pair<'a> = (&'a [Option<f64>], &'a [Option<f64>]);

const FEASIBLE: Event = Event { name: "feasible", of: |run| run.feasible };

/// A part of two arms with so many seeds.
fn part(question: Question, seeds: u64) -> Part {
    Part::on("wcpso-discs", ["wcpso", "wpso"].map(|planner| Arm::new(planner, "")), question).seeds([1, seeds])
}

/// Rows of a part whose runs have these values; `None`: not feasible.
fn rows(part: &Part, values: &[&[Option<f64>]]) -> BTreeMap<String, Run> {
    let row = |task: Task, value: Option<f64>| {
        let run = Run {
            scene: String::new(),
            planner: task.arm.planner.to_owned(),
            parameters: String::new(),
            until: String::new(),
            seed: task.seed,
            feasible: value.is_some(),
            solved: value.is_some(),
            value,
            cost: value,
            gap: value,
            iterations: 100,
            evaluations: 100,
            reached: value.map(|value| value as u64),
            longest_wait: 0,
            numbers: value.map_or(String::new(), |value| format!("turns=3 spread={value}")),
        };
        (task.key(), run)
    };
    let of = |arm: usize| part.tasks(arm).zip(values[arm]).map(|(task, value)| row(task, *value)).collect::<Vec<_>>();
    (0..values.len()).flat_map(of).collect()
}

fn claim(universal: bool, parts: Vec<Part>) -> Claim {
    Claim { id: "T1", quotation: "", says: "", place: "", universal, tables: &[], reading: "", parts }
}

/// One question's answer, of two samples.
fn answer(question: Question, first: &[Option<f64>], second: &[Option<f64>]) -> Answered {
    let part = part(question, first.len() as u64);
    let rows = rows(&part, &[first, second]);
    judge(&claim(false, vec![part]), &rows).parts.remove(0)
}

fn numbers(from: f64, step: f64) -> Vec<Option<f64>> {
    (0..20).map(|k| Some(from + step * f64::from(k))).collect()
}

#[test]
fn a_test_and_an_effect_decide_a_question() {
    let ask = |question, first: &[Option<f64>], second: &[Option<f64>]| answer(question, first, second).answer;
    let [low, high] = [numbers(1.0, 0.1), numbers(10.0, 0.1)];
    assert_eq!(ask(Question::Less(VALUE), &low, &high), Answer::AsClaimed);
    assert_eq!(ask(Question::Less(VALUE), &high, &low), Answer::Contrary);
    assert_eq!(ask(Question::More(VALUE), &high, &low), Answer::AsClaimed);
    assert_eq!(ask(Question::Less(VALUE), &low, &low), Answer::Undecided);
    // A run without a result is the worst.
    assert_eq!(ask(Question::Less(VALUE), &high, &vec![None; 20]), Answer::AsClaimed);
    // What is smaller than the floor is rounding.
    assert_eq!(ask(Question::Less(value_on("ackley")), &numbers(1e-16, 0.0), &numbers(9e-15, 0.0)), Answer::Undecided);
    assert_eq!(ask(Question::SpreadsLess(LENGTH), &numbers(5.0, 0.01), &numbers(5.0, 1.0)), Answer::AsClaimed);
    assert_eq!(ask(Question::SpreadsLess(LENGTH), &numbers(5.0, 1.0), &numbers(5.0, 0.01)), Answer::Contrary);
    assert_eq!(ask(Question::MoreOften(FEASIBLE), &low, &vec![None; 20]), Answer::AsClaimed);
    assert_eq!(ask(Question::MoreOften(FEASIBLE), &vec![None; 20], &low), Answer::Contrary);
    assert_eq!(ask(Question::MoreOftenInPairs(FEASIBLE), &low, &vec![None; 20]), Answer::AsClaimed);
    let reached = Measure::new("reached", "evaluations", 3);
    assert_eq!(ask(Question::Sooner { at: reached, end: EVALUATIONS }, &numbers(1.0, 1.0), &numbers(60.0, 1.0)), Answer::AsClaimed);
    assert_eq!(ask(Question::Sooner { at: reached, end: EVALUATIONS }, &numbers(60.0, 1.0), &numbers(1.0, 1.0)), Answer::Contrary);
}

#[test]
fn a_length_that_differs_by_less_than_half_a_per_cent_is_trivial() {
    let found = answer(Question::Less(LENGTH), &numbers(100.0, 0.001), &numbers(100.2, 0.001));
    assert!(found.p.unwrap() < 0.001 && found.answer == Answer::Trivial, "{found:?}");
    assert!(found.effect.contains("means differ by -0.20 %"), "{}", found.effect);
    assert_eq!(answer(Question::Less(LENGTH), &numbers(100.0, 0.001), &numbers(101.0, 0.001)).answer, Answer::AsClaimed);
    // Not so of a function's value, and not where all runs have one number: nothing can differ there.
    assert_eq!(answer(Question::Less(VALUE), &numbers(100.0, 0.001), &numbers(100.2, 0.001)).answer, Answer::AsClaimed);
    assert_eq!(answer(Question::Less(LENGTH), &numbers(7.0, 0.0), &numbers(7.0, 0.0)).answer, Answer::Undecided);
}

#[test]
fn an_interval_decides_a_question_about_one_planner() {
    let ask = |question, first: &[Option<f64>]| {
        let part = Part { arms: vec![Arm::new("wcpso", "")], ..part(question, first.len() as u64) };
        let rows = rows(&part, &[first]);
        judge(&claim(false, vec![part]), &rows).parts[0].answer
    };
    let most: Vec<_> = (0..100).map(|k| (k > 0).then_some(1.0)).collect();
    assert_eq!(ask(Question::AtLeast(FEASIBLE, 0.9), &most), Answer::AsClaimed);
    assert_eq!(ask(Question::AtLeast(FEASIBLE, 0.98), &most), Answer::Undecided);
    assert_eq!(
        ask(Question::AtLeast(FEASIBLE, 0.9), &most.iter().map(|value| value.filter(|_| false)).collect::<Vec<_>>()),
        Answer::Contrary
    );
    assert_eq!(ask(Question::Never(FEASIBLE), &most), Answer::Contrary);
    assert_eq!(ask(Question::Never(FEASIBLE), &vec![None; 30]), Answer::AsClaimed);
    assert_eq!(ask(Question::AtMost(LENGTH, 4.0), &numbers(1.0, 0.1)), Answer::AsClaimed);
    assert_eq!(ask(Question::AtMost(LENGTH, 1.0), &numbers(1.0, 0.1)), Answer::Contrary);
    assert_eq!(ask(Question::AtMost(LENGTH, 2.0), &numbers(1.0, 0.1)), Answer::Undecided);
    // Of half of the runs nothing is known.
    let half: Vec<_> = (0..20).map(|k| (k % 2 == 0).then_some(1.0)).collect();
    assert_eq!(ask(Question::AtMost(LENGTH, 4.0), &half), Answer::Undecided);
    assert_eq!(ask(Question::SpreadsAtMost(LENGTH, 1.0), &numbers(1.0, 0.1)), Answer::AsClaimed);
    assert_eq!(ask(Question::SpreadsAtMost(LENGTH, 0.1), &numbers(1.0, 0.1)), Answer::Contrary);
}

#[test]
fn maps_are_pairs_and_arms_have_an_order() {
    let across = |first: f64, second: f64| {
        let part = Part::across("columns=9 rows=9", ["aco", "aco-wolf"].map(|planner| Arm::new(planner, "")), Question::LessAcross(LENGTH));
        let runs = part.tasks(0).count();
        let of = |factor: f64| (0..runs).map(|k| Some(factor * (10.0 + (k / 5) as f64))).collect::<Vec<_>>();
        let rows = rows(&part, &[&of(first), &of(second)]);
        judge(&claim(false, vec![part]), &rows).parts.remove(0)
    };
    let shorter = across(1.0, 1.1);
    assert_eq!((shorter.n, shorter.answer, shorter.numbers.as_str()), (24, Answer::AsClaimed, "smaller on 24 maps, larger on 0"));
    assert_eq!((across(1.1, 1.0).answer, across(1.0, 1.001).answer), (Answer::Contrary, Answer::Trivial));
    let three = |order: [f64; 3]| {
        let part = Part { arms: ["pso", "wpso", "cpso"].map(|planner| Arm::new(planner, "")).to_vec(), ..part(Question::Grows(VALUE), 20) };
        let values = order.map(|from| numbers(from, 0.01));
        let rows = rows(&part, &values.each_ref().map(Vec::as_slice));
        judge(&claim(false, vec![part]), &rows).parts[0].answer
    };
    assert_eq!((three([1.0, 2.0, 3.0]), three([3.0, 2.0, 1.0])), (Answer::AsClaimed, Answer::Contrary));
}

#[test]
fn a_claims_mark_follows_from_its_answers() {
    let [low, high, tie] = [numbers(1.0, 0.1), numbers(10.0, 0.1), numbers(1.0, 0.1)];
    let mark = |universal: bool, samples: &[Pair]| {
        let planners = ["pso", "wpso", "cpso", "wcpso"];
        let parts: Vec<Part> = (0..samples.len())
            .map(|k| Part {
                arms: vec![Arm::new(planners[k], ""), Arm::new("qpso", &format!("population={}", k + 2))],
                ..part(Question::Less(VALUE), 20)
            })
            .collect();
        let rows = parts.iter().zip(samples).flat_map(|(part, (first, second))| rows(part, &[first, second])).collect();
        let judged = judge(&claim(universal, parts), &rows);
        (judged.mark, judged.because)
    };
    let (as_claimed, contrary, undecided) = ((&low[..], &high[..]), (&high[..], &low[..]), (&low[..], &tie[..]));
    assert_eq!(mark(false, &[as_claimed, as_claimed]).0, Mark::Upheld);
    assert_eq!(mark(false, &[contrary, contrary]).0, Mark::Refuted);
    assert_eq!(mark(false, &[as_claimed, contrary]).0, Mark::Undecided);
    let (mark_of_all, because) = mark(true, &[as_claimed, as_claimed, contrary]);
    assert_eq!(
        (mark_of_all, because.as_str()),
        (Mark::Refuted, "3 questions: 2 as claimed, 1 contrary; one contrary case refutes a claim about all cases")
    );
    assert_eq!(mark(true, &[as_claimed, undecided]).0, Mark::Undecided);
    let open = judge(&claim(false, vec![Part::open("no numbers")]), &BTreeMap::new());
    assert_eq!((open.mark, open.parts[0].numbers.as_str()), (Mark::Undecided, "no numbers"));
}

/// A p of 0.03 is significant alone, and not as one of three.
#[test]
fn p_values_are_corrected_for_the_other_questions_of_a_claim() {
    let first: Vec<_> = (0..10).map(|k| Some(f64::from(k))).collect();
    let second: Vec<_> = (0..10).map(|k| Some(f64::from(k) + 3.6)).collect();
    let ask = |count: usize| {
        let parts: Vec<Part> = (0..count).map(|_| part(Question::Less(VALUE), 10)).collect();
        let rows = rows(&parts[0], &[&first, &second]);
        judge(&claim(false, parts), &rows).parts.remove(0)
    };
    let [alone, of_three] = [ask(1), ask(3)];
    assert!(alone.p == of_three.p && (0.005..0.05).contains(&alone.p.unwrap()), "{:?}", alone.p);
    assert_eq!((alone.answer, of_three.answer), (Answer::AsClaimed, Answer::Undecided));
}

#[test]
fn all_claims_are_of_known_planners_parameters_and_scenes() {
    let mut ids = BTreeSet::new();
    for (paper, claim) in all() {
        assert!(ids.insert(claim.id), "{} twice", claim.id);
        assert!(!claim.quotation.is_empty() && !claim.says.ends_with('.'), "{}", claim.id);
        for part in &claim.parts {
            for arm in &part.arms {
                for on in part.on.iter().take(1) {
                    let scene = on.scene().unwrap();
                    let entry = standard().planner(arm.planner).unwrap();
                    entry.check_scene(&scene).unwrap();
                    let parameters = Parameters::new(entry.parameters, scene.kind(), &arm.params);
                    assert!(parameters.is_ok(), "[{paper}] {}: {} {:?}", claim.id, arm.planner, parameters.err());
                }
            }
        }
    }
    // Each picture's claims exist, and ../papers has as many claims as its list.
    for paper in &PAPERS {
        for id in paper.pictures.iter().flat_map(|picture| picture.claims) {
            assert!(ids.contains(id), "[{}] {id}", paper.tag);
        }
    }
    let sentences: BTreeSet<&str> = ids.iter().map(|id| id.trim_end_matches(char::is_lowercase)).collect();
    assert_eq!(sentences.len(), 27);
}

/// The whole way from a claim to the document, with few seeds.
#[test]
fn a_claim_becomes_a_section_and_an_object() {
    let part = part(Question::Less(LENGTH), 20);
    let rows = rows(&part, &[&numbers(1.0, 0.1), &numbers(10.0, 0.1)]);
    let judged = judge(&Claim { says: "Shorter", place: "§3", quotation: "短", ..claim(false, vec![part]) }, &rows);
    let text = markdown(std::slice::from_ref(&judged));
    for expected in [
        "#### T1: Shorter — upheld",
        "> 短 (§3)",
        "One question: 1 as claimed.",
        "smaller length",
        "forage run wcpso --scene wcpso-discs --seed 1",
    ] {
        assert!(text.contains(expected), "{expected}: {text}");
    }
    assert_eq!(counted([&judged]), "1 claim: 1 upheld, 0 refuted, 0 undecided");
}
