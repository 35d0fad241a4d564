//! The examples run, and say what they are there to say. Cargo builds them beside the tests.
#![cfg(not(target_arch = "wasm32"))]

use std::process::Command;

/// What an example writes to standard output and to standard error.
fn run(example: &str) -> [String; 2] {
    let tests = std::env::current_exe().unwrap();
    let program = tests.ancestors().nth(2).unwrap().join("examples").join(example);
    let output = Command::new(&program).output().unwrap_or_else(|error| panic!("{}: {error}", program.display()));
    assert!(output.status.success(), "{example}: {output:?}");
    [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap())
}

#[test]
fn a_swarm_finds_the_tin_that_needs_least_metal() {
    let [out, _] = run("own_objective");
    let product: f64 = out.trim_end().rsplit(' ').next().unwrap().parse().unwrap();
    assert!((product - 1.0).abs() < 1e-5, "{out}");
}

#[test]
fn a_run_goes_back_and_is_drawn() {
    let [out, err] = run("step_and_draw");
    assert!(out.starts_with("<svg") && err.contains("iteration 40 again"), "{err}");
}

#[test]
fn stops_in_tsplibs_format_become_a_tour_in_it() {
    let [out, err] = run("tour");
    assert!(out.contains("DIMENSION : 8") && out.trim_end().ends_with("EOF") && err.contains("Matrix"), "{out}{err}");
}

#[test]
fn an_arm_follows_its_path() {
    let [out, _] = run("arm");
    assert!(out.contains("the arm arrives: true, touches nothing: true"), "{out}");
}

#[test]
fn two_planners_are_compared_over_seeds() {
    let [out, _] = run("seeds");
    assert!(out.contains("pso: mean") && out.contains("wcpso: mean") && out.contains("p = "), "{out}");
}
