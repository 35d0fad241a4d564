//! `forage bench centre-bias`.

use std::fs;

use crate::support::{empty_folder, forage, text};

/// The numbers of a planner in a file of ratios: shifted with its interval, rotated with its interval.
fn ratios(file: &str, planner: &str) -> Vec<f64> {
    let line = file.lines().find(|line| line.split(',').next() == Some(planner)).unwrap();
    line.split(',').skip(1).map(|number| number.parse().unwrap()).collect()
}

/// What the catalogue says of each planner was measured by this version of the program.
#[test]
fn the_catalogue_has_what_is_measured_now() {
    let folder = empty_folder("bench-centre-bias");
    let output = forage(&["bench", "centre-bias", "--out", folder.to_str().unwrap()]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let measured = fs::read_to_string(folder.join("centre-bias.csv")).unwrap();
    assert!(
        measured == include_str!("../../../../../src/describe/centre_bias.csv"),
        "copy {} there",
        folder.join("centre-bias.csv").display()
    );
    for file in ["report.md", "shifted.svg"] {
        assert!(fs::read_to_string(folder.join(file)).unwrap().contains("random-search"), "{file}");
    }
}

/// A planner that gathers in the middle is found out; one that draws anywhere is not.
#[test]
fn a_planner_that_is_drawn_to_the_middle_is_found_out() {
    let folder = empty_folder("bench-drawn");
    let code = folder.join("drawn.js");
    let random = include_str!("../../../../../templates/random-search.js");
    // Each step draws from a box that is smaller than the one before, around 0.
    let drawn = random
        .replace("my-random-search", "drawn")
        .replace("return { tried, position", "return { share: 1, tried, position")
        .replace(
            "(box.high[k] - low) * random())\n    const cost",
            "(box.high[k] - low) * random()).map(x => x * state.share)\n    const cost",
        )
        .replace(
            "? { tried, position: tried, cost } : { ...state, tried }",
            "? { share: state.share * 0.98, tried, position: tried, cost } : { ...state, share: state.share * 0.98, tried }",
        );
    fs::write(&code, drawn).unwrap();
    let small = ["bench", "centre-bias", "--dimension", "2", "--budget", "200", "--instances", "10", "--planners", "random-search"];
    let out = folder.join("out");
    let output = forage(&[&small[..], &["--code", code.to_str().unwrap(), "--out", out.to_str().unwrap()]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let file = fs::read_to_string(out.join("centre-bias.csv")).unwrap();
    let [drawn, random] = ["drawn", "random-search"].map(|planner| ratios(&file, planner));
    assert!(drawn[1] > 20.0, "{drawn:?}");
    assert!(random[0] < 2.0 && random[1] < random[0] && random[0] < random[2], "{random:?}");
}

#[test]
fn bad_input_is_refused() {
    for (arguments, named) in [
        (&["--dimension", "1"][..], "--dimension"),
        (&["--dimension", "101"], "--dimension"),
        (&["--instances", "1"], "--instances"),
        (&["--planners", "a-star"], "--planners"),
        (&["--set", "pso.w=9"], "pso.w"),
        (&["--code", "no-such-file.js"], "no-such-file.js"),
    ] {
        let output = forage(&[&["bench", "centre-bias"], arguments].concat());
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(text(&output.stderr).contains(named), "{}", text(&output.stderr));
    }
}
