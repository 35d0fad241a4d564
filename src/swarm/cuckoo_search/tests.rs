//! A nest's two moves by the numbers that its explanation names, and what is kept of them.

use super::*;
use crate::{Run, Setup, Value, shipped, standard};

fn run(scene: &str, params: &[(&str, Value)], seed: u64) -> Run {
    let params = params.iter().cloned().collect();
    Run::new(standard(), Setup { planner: "cuckoo-search".into(), scene: shipped(scene).unwrap(), params, seed }).unwrap()
}

fn inspection(run: &mut Run, index: usize) -> Inspection {
    run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap()
}

fn close(value: f64, expected: f64) {
    assert!((value - expected).abs() < 1e-14 * (1.0 + expected.abs()), "{value} is not {expected}");
}

/// Both moves of every nest of several iterations, by the numbers that its explanation names; all four outcomes come up.
#[test]
fn a_nest_moves_by_the_equations() {
    let mut run = run("sphere-2", &[("population", 9.0.into()), ("alpha", 0.5.into())], 3);
    let mut seen = std::collections::BTreeSet::new();
    let sigma = Levy::new(1.5).sigma;
    for _ in 0..30 {
        run.step(1);
        for index in 0..9 {
            let inspection = inspection(&mut run, index);
            let of = |name: &str| inspection.values.iter().find(|v| v.label.name == name).unwrap().value;
            assert_eq!(of("sigma"), sigma);
            close(of("s"), of("u") / crate::math::pow(of("v").abs(), 1.0 / 1.5));
            let candidate = of("x_before") + 0.5 * of("s") * (of("x_before") - of("g")) * of("epsilon");
            close(of("candidate"), candidate.clamp(-100.0, 100.0));
            let flown = of("cost_flown") <= of("cost_before");
            assert_eq!(of("x_between"), if flown { of("candidate") } else { of("x_before") });
            let rebuilt = of("x_between") + of("r") * of("changes") * (of("x_j") - of("x_k"));
            close(of("rebuilt"), rebuilt.clamp(-100.0, 100.0));
            assert_eq!(of("cost"), of("cost_before").min(of("cost_flown")).min(of("cost_walked")), "the better one is kept");
            let between = if flown { of("cost_flown") } else { of("cost_before") };
            seen.insert((flown, of("cost_walked") <= between));
        }
    }
    assert_eq!(seen.len(), 4, "{seen:?}");
}

#[test]
fn every_nest_is_evaluated_twice_in_an_iteration() {
    let mut run = run("matyas", &[("population", 12.0.into())], 1);
    assert_eq!(run.outcome().evaluations, 12);
    run.step(5);
    assert_eq!(run.outcome().evaluations, 12 + 5 * 24);
}

#[test]
fn nothing_is_rebuilt_where_nothing_is_abandoned() {
    let mut run = run("matyas", &[("population", 12.0.into()), ("p_a", 0.0.into()), ("alpha", 0.0.into())], 1);
    let before = run.best().unwrap().cost;
    run.step(20);
    assert_eq!(run.best().unwrap().cost, before, "neither a flight of length 0 nor a walk leads away");
    let mut run = self::run("matyas", &[("population", 12.0.into()), ("p_a", 1.0.into())], 1);
    run.step(1);
    assert!(inspection(&mut run, 3).rows.iter().all(|row| row[4] == 1.0));
}

/// [Yang and Deb 2009] has no figures to compare with; 60,000 evaluations are enough for a bowl.
#[test]
fn it_finds_the_bottom_of_a_bowl() {
    for seed in 1..=3 {
        let mut run = run("sphere-2", &[], seed);
        run.step(u64::MAX);
        assert!(run.best().unwrap().cost < 1e-9, "{}", run.best().unwrap().cost);
    }
}
