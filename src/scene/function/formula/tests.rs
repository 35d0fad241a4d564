use super::*;
use crate::{
    Overrides, Run, Scene, Setup,
    kernel::{ReferenceOptimum, Status, rng::Stream},
    scene::Function,
    standard,
};

fn value(text: &str, x: &[f64]) -> f64 {
    Formula::new(text, x.len()).unwrap_or_else(|error| panic!("{text}: {error}")).value(x, &mut Vec::new())
}

fn refused(text: &str, dimension: usize) -> String {
    match Formula::new(text, dimension) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("{text} is accepted"),
    }
}

#[test]
fn operators_bind_as_in_mathematics() {
    for (text, expected) in [
        ("1 + 2 * 3", 7.0),
        ("2 - 3 - 4", -5.0),
        ("2 ^ 3 ^ 2", 512.0),
        ("-2^2", -4.0),
        ("2^-1", 0.5),
        ("2**3", 8.0),
        ("-(2 + 1) * 4 / 3", -4.0),
        ("7 % 4 + -7 % 4", 4.0),
        ("1 < 2 && 2 >= 3 || !0", 1.0),
        ("2 == 2 ? 5 : 6", 5.0),
        ("0 ? 1 : 0 ? 2 : 3", 3.0),
        ("if(1 > 2, 1, 2)", 2.0),
        ("min(3, 1, 2) + max(4, 5)", 6.0),
        ("1.5e1 + .5 + 2.", 17.5),
        ("- -1", 1.0),
        ("2 * pi - tau", 0.0),
        ("sqrt(16) + abs(-1) + sign(-3) + floor(1.5) + mod(-1, 3)", 7.0),
    ] {
        assert_eq!(value(text, &[0.0]), expected, "{text}");
    }
}

#[test]
fn variables_sums_and_products_are_of_the_position() {
    let x = [2.0, 3.0, -1.0];
    for (text, expected) in [
        ("x + 10 * y + 100 * z", -68.0),
        ("x[1] + x[n]", 1.0),
        ("sum(x[i])", 4.0),
        ("prod(x[i])", -6.0),
        ("sum(i * x[i])", 5.0),
        ("sum(x[k]^2, k)", 14.0),
        ("sum(x[i+1] - x[i], i, 1, n - 1)", -3.0),
        ("sum(x[n + 1 - i] * i)", 11.0),
        ("sum(sum(x[i] * x[j], j, 1, i), i, 1, n)", 4.0 + 15.0 - 4.0),
        ("sum(prod(x[j], j, 1, i))", 2.0 + 6.0 - 6.0),
        ("sum(x[i], i, 2, 1) + prod(x[i], i, 2, 1)", 1.0),
        ("sum(2)", 6.0),
        ("sum(x[i] > 0 ? x[i] : 0)", 5.0),
        ("sum(x[2*i - 1], i, 1, 2)", 1.0),
    ] {
        assert_eq!(value(text, &x), expected, "{text}");
    }
}

#[test]
fn test_functions_by_formula_agree_with_those_built_in() {
    let x = [0.3, -1.7, 2.5, 0.01];
    for (function, text) in [
        (Function::Sphere, "sum(x[i]^2)"),
        (Function::Rosenbrock, "sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)"),
        (Function::Rastrigin, "sum(x[i]^2 - 10*cos(2*pi*x[i]) + 10)"),
        (Function::Ackley, "-20*exp(-0.2*sqrt(sum(x[i]^2)/n)) - exp(sum(cos(2*pi*x[i]))/n) + 20 + e"),
    ] {
        let (ours, built_in) = (value(text, &x), function.value(&x));
        assert!((ours - built_in).abs() < 1e-13 * built_in.abs(), "{}: {ours} is not {built_in}", function.name());
    }
    let x = [1.25, -0.75];
    assert_eq!(value("0.26*(x^2 + y^2) - 0.48*x*y", &x), Function::Matyas.value(&x));
    assert_eq!(value("x^2 + y^2 + 25*(sin(x)^2 + sin(y)^2)", &x), Function::EggCrate.value(&x));
}

#[test]
fn errors_name_the_place_and_what_is_expected_there() {
    for (text, dimension, expected) in [
        ("", 2, "character 1: the formula ends here; expected: a number, a name or ("),
        ("1 +", 2, "character 4: the formula ends here"),
        ("1 + * 2", 2, "character 5: `*` can’t stand here; expected: a number, a name or ("),
        ("(1 + 2", 2, "character 7: the formula ends here; expected: )"),
        ("2 x", 2, "character 3: `x` can’t stand here; expected: an operator, or the end"),
        ("αx", 2, "character 1: `α` can’t stand here"),
        ("x + foo", 2, "character 5: there is no `foo`; known: x[i], x, y, z, n, pi, tau, e"),
        ("sum(x[i] + q)", 2, "known: x[i], x, y, z, n, pi, tau, e, i"),
        ("x + foo(2)", 2, "character 5: there is no function `foo`; known: sum, prod"),
        ("sin", 2, "`sin` is a function: it needs brackets"),
        ("sin(1, 2)", 2, "sin(…) is given one number"),
        ("atan2(1)", 2, "atan2(…) is given two numbers"),
        ("z", 2, "`z` is variable 3, and there are 2"),
        ("x[3]", 2, "x[3] is none of x[1] to x[2]"),
        ("sum(x[i+1])", 2, "x[3] is none of x[1] to x[2]"),
        ("x[0.5]", 2, "an index is a whole number"),
        ("x[x]", 2, "an index is a whole number"),
        ("y[1]", 2, "only x has an index"),
        ("sum(1, n, 1, 2)", 2, "`n` means something else"),
        ("sum(1, 2)", 2, "sum(…) is given a body"),
        ("1e999", 2, "`1e999` is no finite number"),
        ("sum(sum(sum(1, i, 1, 1000), j, 1, 1000), k, 1, 1000)", 2, "more than 300000 operations"),
    ] {
        let error = refused(text, dimension);
        assert!(error.contains(expected), "{text}: {error}");
    }
    assert!(refused(&"(".repeat(3000), 1).contains("40 deep"));
    assert!(refused(&format!("1{}", " + 1".repeat(2000)), 1).contains("at most 4096 bytes"));
    assert!(Formula::new(&"-".repeat(4000), 1).is_err() && Formula::new(&format!("1{}", "^1".repeat(2000)), 1).is_ok());
}

#[test]
fn outside_of_where_it_is_defined_a_value_is_not_finite() {
    assert!(value("ln(x)", &[-1.0]).is_nan() && value("1/x", &[0.0]).is_infinite());
    assert!(value("sum(0*ln(x[i]))", &[-1.0, 1.0]).is_nan());
    assert_eq!(value("x > 0 ? ln(x) : 0", &[-1.0]), 0.0);
}

/// Of the size of the batch nothing depends, to the last bit.
#[test]
fn many_positions_at_once_give_the_same_bits_as_one_by_one() {
    let mut rng = Stream::new(1, 0);
    for text in [
        "sum(x[i]^2 - 10*cos(2*pi*x[i]) + 10)",
        "-20*exp(-0.2*sqrt(sum(x[i]^2)/n)) - exp(sum(cos(2*pi*x[i]))/n) + 20 + e",
        "sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)",
        "sum(sum(x[j] * i - y, j, 1, i)^2) + prod(cos(x[i] / sqrt(i))) + sum(x[n + 1 - i] * i > 0 ? x[1] : x[i])",
        "x",
        "7",
        "sum(n) + sum(i) + sum(x[1]) + max(x, y, z) % 2",
    ] {
        for (dimension, positions) in [(3, 1), (3, 2), (3, 1000), (30, 100), (100, 7)] {
            let formula = Formula::new(text, dimension).unwrap();
            let xs: Vec<_> = (0..dimension * positions).map(|_| rng.between(-5.0, 5.0)).collect();
            let (mut room, mut all) = (Vec::new(), vec![0.0; positions]);
            formula.values(&xs, &mut room, &mut all);
            for (x, value) in xs.chunks_exact(dimension).zip(&all) {
                assert_eq!(formula.value(x, &mut room).to_bits(), value.to_bits(), "{text} in {dimension} dimensions");
            }
        }
    }
}

fn scene(fields: &str) -> Result<Scene, Error> {
    let head = r#""format": "forage-scene", "version": 1, "kind": "function", "name": "own", "title": "Own""#;
    standard().read_scene(&format!("{{{head}, {fields}}}"))
}

fn run(fields: &str, planner: &str, seed: u64) -> Run {
    let setup = Setup { planner: planner.into(), scene: scene(fields).unwrap().into(), params: Overrides::new(), seed };
    Run::new(standard(), setup).unwrap()
}

#[test]
fn a_scene_is_written_as_it_was_read() {
    for fields in [
        r#""expression": "x^2 + y^2", "dimension": 2, "bounds": {"min": -5, "max": [5, 6.5]}"#,
        r#""expression": "sum(x[i])", "dimension": 3, "bounds": {"min": [-1, 0, 1], "max": 2}, "optimum": 0"#,
        r#""expression": "(x - 1)^2", "dimension": 1, "bounds": {"min": 0, "max": 2}, "optimum": {"value": 0, "position": [1]}"#,
    ] {
        let read = scene(fields).unwrap();
        let written = read.to_json();
        assert_eq!(standard().read_scene(&written).unwrap(), read);
        let [written, given]: [serde_json::Value; 2] = [written, format!("{{{fields}}}")].map(|text| serde_json::from_str(&text).unwrap());
        let number = |value: &serde_json::Value| value.to_string().replace(".0", "");
        for (name, value) in given.as_object().unwrap() {
            assert_eq!(number(&written[name]), number(value), "{name}");
        }
    }
}

#[test]
fn fields_of_a_scene_are_checked() {
    let with = |bounds: &str, more: &str| format!(r#""expression": "x + y", "dimension": 2, "bounds": {bounds}{more}"#);
    let unit = r#"{"min": 0, "max": 1}"#;
    for (fields, field, expected) in [
        (r#""expression": "x +", "dimension": 2"#.to_owned(), "expression", "character 4"),
        (r#""expression": "x", "dimension": 0"#.to_owned(), "dimension", "1 to 100"),
        (r#""expression": "x", "dimension": 101, "bounds": {"min": 0, "max": 1}"#.to_owned(), "dimension", "1 to 100"),
        (r#""expression": "x", "dimension": 2"#.to_owned(), "bounds", "min and max"),
        (with("[0, 1]", ""), "bounds", "an object"),
        (with(r#"{"min": 0}"#, ""), "bounds.max", "2 of them"),
        (with(r#"{"min": [0], "max": 1}"#, ""), "bounds.min", "2 of them"),
        (with(r#"{"min": 0, "max": [1, 0]}"#, ""), "bounds.max[1]", "above 0"),
        (with(r#"{"min": -1e16, "max": 1}"#, ""), "bounds.min[0]", "-1000000000000000"),
        (with(r#"{"min": 0, "max": 1, "mid": 0}"#, ""), "bounds.mid", "left out"),
        (with(unit, r#", "optimum": "low""#), "optimum", "a number, or an object"),
        (with(unit, r#", "optimum": {"position": [0, 0]}"#), "optimum.value", "a finite number"),
        (with(unit, r#", "optimum": {"value": 0, "position": [0]}"#), "optimum.position", "2 numbers"),
        (with(unit, r#", "optimum": {"value": 0, "position": [0, 2]}"#), "optimum.position[1]", "from 0 to 1"),
        (with(unit, r#", "optimum": {"value": 0, "position": [0, 0.5]}"#), "optimum.value", "0.5"),
        (with(unit, r#", "function": "sphere""#), "function", "left out"),
    ] {
        let error = scene(&fields).unwrap_err();
        assert!(error.field() == field && error.to_string().contains(expected), "{fields}: {error}");
    }
}

/// Every planner for functions finds the minimum of a formula, and says what it costs to believe a stated one.
#[test]
fn all_planners_for_functions_take_formulas() {
    let fields = r#""expression": "(x - 1)^2 + (y + 2)^2 - 3", "dimension": 2, "bounds": {"min": [0, -4], "max": [3, 5]}"#;
    let planners: Vec<_> = standard().suited(&scene(fields).unwrap()).map(|entry| entry.name).collect();
    assert!(planners.len() >= 8, "{planners:?}");
    for planner in planners {
        let run_with = |optimum: &str| {
            let mut run = run(&format!("{fields}{optimum}"), planner, 3);
            while run.step(u64::MAX) == Status::Running {}
            run.outcome()
        };
        let outcome = run_with("");
        assert!(outcome.cost.unwrap() + 3.0 < 0.1 && outcome.exact.is_none(), "{planner}: {:?}", outcome.cost);
        let stated = run_with(r#", "optimum": -3"#);
        assert_eq!((stated.exact, stated.exact_by, stated.cost), (Some(-3.0), ReferenceOptimum::Stored, outcome.cost));
        let refuted = run_with(r#", "optimum": 0"#);
        assert_eq!((refuted.exact, refuted.exact_by), (None, ReferenceOptimum::Refuted));
    }
}

/// Sphere by formula and by name: the same run, to the last bit.
#[test]
fn a_formula_gives_the_same_run_as_the_function_that_it_is() {
    let named = scene(r#""function": "sphere", "dimension": 10"#).unwrap();
    let formula = scene(r#""expression": "sum(x[i]^2)", "dimension": 10, "bounds": {"min": -100, "max": 100}"#).unwrap();
    for planner in ["pso", "wcpso", "ltqpso", "cuckoo-search"] {
        let end = |scene: &Scene| {
            let setup = Setup { planner: planner.into(), scene: scene.clone().into(), params: Overrides::new(), seed: 9 };
            let mut run = Run::new(standard(), setup).unwrap();
            run.step(100);
            let outcome = run.outcome();
            (outcome.cost.map(f64::to_bits), outcome.position, outcome.readings)
        };
        assert_eq!(end(&named), end(&formula), "{planner}");
    }
}

#[test]
fn a_cost_that_is_no_number_ends_a_run_and_says_where() {
    let fields = r#""expression": "ln(x) + y", "dimension": 2, "bounds": {"min": -1, "max": 1}"#;
    for planner in standard().suited(&scene(fields).unwrap()).map(|entry| entry.name) {
        let mut run = run(fields, planner, 1);
        while run.step(1) == Status::Running {}
        let outcome = run.outcome();
        let position = outcome.failed_at.clone().unwrap();
        assert_eq!((outcome.status, position.len()), (Status::Failed, 2), "{planner}");
        assert!(position[0] < 0.0 && outcome.failure.unwrap().text().contains("is not a number"), "{planner}: {position:?}");
        run.seek(0);
        assert_eq!(run.iteration(), 0);
        while run.step(1) == Status::Running {}
        assert_eq!(run.outcome().failed_at, Some(position), "{planner}: the same again");
    }
    let mut infinite = run(r#""expression": "x > 0 ? 1/0 : x", "dimension": 1, "bounds": {"min": -1, "max": 1}"#, "pso", 1);
    while infinite.step(1) == Status::Running {}
    assert!(infinite.outcome().failure.unwrap().text().contains("is infinite"));
}
