//! Links that are as they say, and those that are not.

use super::*;
use crate::{Setup, kernel::rng::Stream, shipped, standard};

fn task(text: &str) -> Task {
    Task::read(standard(), text).unwrap()
}

fn run(planner: &str, scene: &str, seed: u64, at: u64) -> Run {
    let setup = Setup { planner: planner.into(), scene: shipped(scene).unwrap(), params: Overrides::new(), seed };
    let mut run = Run::new(standard(), setup).unwrap();
    run.step(at);
    run
}

fn judged(task: &Task, link: &str) -> Judgement {
    task.judge(standard(), &Link::parse(standard(), link).unwrap()).unwrap()
}

#[test]
fn a_goal_is_reached_as_soon_as_a_valid_result_meets_it_within_the_budget() {
    let mut run = run("pso", "wcpso-discs", 3, 0);
    let link = {
        run.step(300);
        run.link().unwrap()
    };
    let gap = run.outcome().gap.unwrap();
    // The iteration in which the result of the end was found, by stepping once more.
    let (mut again, mut spent) = (self::run("pso", "wcpso-discs", 3, 0), 0);
    while again.outcome().gap.is_none_or(|is| is > gap) || !again.outcome().feasible {
        again.step(1);
        spent = again.evaluations();
    }
    let reached = judged(&task(&format!(r#"{{"goal": {{"gap": {gap}}}}}"#)), &link);
    assert!(reached.reached && reached.verified && reached.reasons.is_empty());
    assert_eq!(reached.evaluations, spent);
    let exactly = judged(&task(&format!(r#"{{"goal": {{"gap": {gap}}}, "budget": {{"evaluations": {spent}}}}}"#)), &link);
    assert!(exactly.reached);
    let late = judged(&task(&format!(r#"{{"goal": {{"gap": {gap}}}, "budget": {{"evaluations": {}}}}}"#, spent - 1)), &link);
    assert!(!late.reached && late.verified && late.reasons[0].text().contains("after more than"), "{:?}", late.reasons);
    let more = judged(&task(&format!(r#"{{"goal": {{"gap": {}}}}}"#, gap / 2.0)), &link);
    assert!(!more.reached && more.evaluations == run.evaluations() && more.reasons[0].text().contains("The gap is"));
    let length = run.outcome().length.unwrap();
    assert!(judged(&task(&format!(r#"{{"goal": {{"length": {length}}}}}"#)), &link).reached);
    let cost = task(r#"{"goal": {"cost": 0.5}, "scene": "sphere-2"}"#);
    assert!(judged(&cost, &self::run("pso", "sphere-2", 1, 60).link().unwrap()).reached);
    assert!(judged(&cost, &link).reasons.iter().any(|reason| reason.text().contains("The scene is wcpso-discs")));
}

#[test]
fn what_is_given_must_be_so() {
    let link = run("wpso", "wcpso-discs", 3, 200).link().unwrap();
    let given = |rest: &str| judged(&task(&format!(r#"{{"goal": {{"gap": 10}}, {rest}}}"#)), &link);
    for (rest, reason) in [
        (r#""planner": "pso""#, "The planner is wpso, not pso."),
        (r#""scene": "discs-gate""#, "The scene is wcpso-discs"),
        (r#""own": true"#, "A planner of your own is asked for; the link's is wpso."),
        (r#""params": {"population": 7}"#, "population is"),
        (r#""params": {"beta": 7}"#, "beta is not there"),
    ] {
        let judged = given(rest);
        assert!(!judged.reached && judged.verified, "{rest}");
        assert!(judged.reasons[0].text().contains(reason), "{:?}", judged.reasons);
    }
    let whole = serde_json::to_string(&*shipped("wcpso-discs").unwrap()).unwrap();
    for rest in [r#""planner": "wpso""#, r#""scene": "wcpso-discs""#, &format!(r#""scene": {whole}"#), r#""params": {"c1": 2}"#] {
        assert!(given(rest).reached, "{rest}: {:?}", given(rest).reasons);
    }
}

/// A thousand links in which one thing was changed: not one of them passes, and each says why.
#[test]
fn tampered_links_are_caught() {
    let anything = task(r#"{"goal": {"cost": 1e300}}"#);
    let mut rng = Stream::new(23, 0);
    let plans = [("pso", "sphere-2"), ("wcpso", "wcpso-discs"), ("aco", "rooms-20"), ("rrt", "wcpso-discs"), ("sa", "open-12")];
    let honest: Vec<_> =
        plans.iter().flat_map(|&(planner, scene)| [1, 2].map(|seed| run(planner, scene, seed, 12).link().unwrap())).collect();
    for link in &honest {
        assert!(judged(&anything, link).verified, "{link}");
    }
    let mut caught = 0;
    for k in 0..1000 {
        let link = &honest[k % honest.len()];
        let (setup, hash) = link.split_once("&hash=").unwrap();
        let other = 3 + rng.below(1_000_000);
        let tampered = match k / honest.len() % 5 {
            0 => link.replace("&seed=1", &format!("&seed={other}")).replace("&seed=2", &format!("&seed={other}")),
            1 => link.replace("&at=12", &format!("&at={}", 1 + rng.below(11))),
            2 => link.replace("&at=12", &format!("&at={}", 13 + rng.below(9))),
            3 => {
                // Another digit of the hash.
                let at = rng.below(hash.len());
                let digit = u8::from_str_radix(&hash[at..=at], 16).unwrap();
                format!("{setup}&hash={}{:x}{}", &hash[..at], digit ^ (1 + rng.below(15) as u8), &hash[at + 1..])
            }
            _ => format!("{setup}&p.iterations={}&hash={hash}", 30 + rng.below(60)),
        };
        assert_ne!(&tampered, link);
        let judged = judged(&anything, &tampered);
        assert!(!judged.verified && judged.reasons.iter().any(|reason| !reason.text().is_empty()), "{tampered}");
        caught += 1;
    }
    assert_eq!(caught, 1000);
    let judged = judged(&anything, honest[0].split_once("&hash=").unwrap().0);
    assert!(!judged.verified && judged.reasons[0].text().contains("no hash"));
}

#[test]
fn a_task_that_makes_no_sense_is_refused_with_its_field() {
    for (text, field) in [
        ("{", "task"),
        ("[]", "task"),
        ("{}", "goal"),
        (r#"{"goal": {"gap": -1}}"#, "goal"),
        (r#"{"goal": {"gap": 1, "cost": 2}}"#, "goal"),
        (r#"{"goal": {"speed": 1}}"#, "goal"),
        (r#"{"goal": {"gap": 1}, "budget": 5000}"#, "budget"),
        (r#"{"goal": {"gap": 1}, "budget": {"evaluations": 0}}"#, "budget.evaluations"),
        (r#"{"goal": {"gap": 1}, "budget": {"evaluations": 5, "time": 3}}"#, "budget.time"),
        (r#"{"goal": {"gap": 1}, "planner": "magic"}"#, "planner"),
        (r#"{"goal": {"gap": 1}, "planner": "pso", "own": true}"#, "own"),
        (r#"{"goal": {"gap": 1}, "own": "yes"}"#, "own"),
        (r#"{"goal": {"gap": 1}, "scene": "nowhere"}"#, "scene"),
        (r#"{"goal": {"gap": 1}, "params": 3}"#, "params"),
        (r#"{"goal": {"gap": 1}, "params": {"w": [1]}}"#, "params.w"),
        (r#"{"goal": {"gap": 1}, "params": {"weight_of": 1}}"#, "weight_of"),
        (r#"{"goal": {"gap": 1}, "planner": "pso", "params": {"beta": 1}}"#, "beta"),
        (r#"{"goal": {"gap": 1}, "planner": "pso", "params": {"population": -1}}"#, "population"),
        (r#"{"goal": {"gap": 1}, "goals": 3}"#, "task.goals"),
    ] {
        let error = Task::read(standard(), text).unwrap_err();
        assert!(error.to_string().contains(field), "{text}: {error}");
    }
}

#[test]
fn a_run_far_beyond_the_budget_is_given_up_on_the_way() {
    let [near, far] = [10, 100].map(|at| run("pso", "wcpso-discs", 3, at));
    let budget = near.evaluations().div_ceil(10);
    let task = task(&format!(r#"{{"goal": {{"gap": 0}}, "budget": {{"evaluations": {budget}}}}}"#));
    assert!(judged(&task, &near.link().unwrap()).verified);
    let given_up = judged(&task, &far.link().unwrap());
    assert!(!given_up.verified && !given_up.reached);
    assert!((near.evaluations()..far.evaluations() / 2).contains(&given_up.outcome.evaluations));
    assert!(given_up.reasons[0].text().contains("The run goes on beyond"), "{:?}", given_up.reasons);
}

#[test]
fn a_lesson_has_its_task() {
    let task = task(r#"{"format": "forage-lesson", "task": {"text": "task", "goal": {"cost": 1e-12}, "planner": "pso"}, "steps": []}"#);
    assert_eq!((task.planner.as_deref(), task.evaluations, task.goal), (Some("pso"), None, Goal::Cost(1e-12)));
    let error = Task::read(standard(), r#"{"format": "forage-lesson"}"#).unwrap_err();
    assert!(error.to_string().contains("task"), "{error}");
}
