//! Golden runs on functions by formula, and what bad formulas are refused with. `tests/wasm.test.mjs` checks the same stored file in wasm
//! under Node. `FORAGE_BLESS=1 cargo test --test formulas` stores all again.
#![cfg(not(target_arch = "wasm32"))]

use forage::{
    Error, Overrides, Run, Scene, Setup, Status,
    scene::{Formula, function::FORMULA_FUNCTIONS},
    standard,
};
use serde::{Deserialize, Serialize};

const FILE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/formulas.json");

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Stored {
    runs: Vec<Golden>,
    refusals: Vec<Refused>,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Golden {
    planner: String,
    expression: String,
    dimension: usize,
    min: f64,
    max: f64,
    status: String,
    hash: String,
    /// The best cost's bits.
    cost: String,
}

#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
struct Refused {
    expression: String,
    message: String,
}

/// Formulas that have every function and every operator, with the box in which they are defined.
const RUNS: &[(&str, &str, usize, [f64; 2])] = &[
    ("pso", "sum(x[i]^2)", 10, [-100.0, 100.0]),
    ("wcpso", "sum(100*(x[i+1] - x[i]^2)^2 + (1 - x[i])^2, i, 1, n - 1)", 5, [-4.0, 4.0]),
    ("ltqpso", "-20*exp(-0.2*sqrt(sum(x[i]^2)/n)) - exp(sum(cos(2*pi*x[i]))/n) + 20 + e", 30, [-32.0, 32.0]),
    ("qpso", "sum(x[i]^2)/4000 - prod(cos(x[i]/sqrt(i))) + 1", 4, [-30.0, 30.0]),
    ("bat-continuous", "abs(sin(x)) + tan(y/4) + asin(x/9) + acos(y/9) + atan(x*y)", 2, [-3.0, 3.0]),
    ("cuckoo-search", "sinh(x/3) + cosh(y/3) + tanh(z) + cbrt(x*y*z)", 3, [-3.0, 3.0]),
    ("wpso", "ln(x) + log(y) + log2(x + y) + log10(x*y + 1) + x^y + pow(y, x) + 1/(x*y)", 2, [0.5, 3.0]),
    ("cpso", "floor(x) + ceil(y) + round(x*y) + sign(x - y) + x % 0.7 + mod(y, -0.3)", 2, [-3.0, 3.0]),
    (
        "pso",
        "atan2(y, x) + hypot(x, y) + min(x, y, 1) - max(x, y) + (x > y ? 1 : 0) + if(x <= 1 && !(y >= 2) || x != y, x, y) + (x == y) + tau/e*1e-3",
        2,
        [-3.0, 3.0],
    ),
    ("pso", "sum(sum(x[j], j, 1, i)^2) + prod(x[k]^3 - x[n + 1 - k]^4, k, 2, n - 1)", 4, [-2.0, 2.0]),
    ("pso", "sqrt(x) + y", 2, [-1.0, 1.0]),
];

const REFUSED: &[&str] = &["", "x +", "sum(x[i]", "x + foo", "sin", "sin(1, 2)", "x[3]", "2 x", "1e999", "sum(x[i], n)", "x < < y"];

fn scene(expression: &str, dimension: usize, [min, max]: [f64; 2]) -> Result<Scene, Error> {
    let value = serde_json::json!({
        "format": "forage-scene", "version": 1, "kind": "function", "name": "formula", "title": "Formula",
        "expression": expression, "dimension": dimension, "bounds": {"min": min, "max": max},
    });
    standard().read_scene_value(value)
}

fn made() -> Stored {
    let runs = RUNS.iter().map(|&(planner, expression, dimension, sides)| {
        let scene = scene(expression, dimension, sides).unwrap_or_else(|error| panic!("{expression}: {error}"));
        let setup = Setup { planner: planner.into(), scene: scene.into(), params: Overrides::new(), seed: 7 };
        let mut run = Run::new(standard(), setup).unwrap();
        run.step(50);
        let status = format!("{:?}", run.status()).to_lowercase();
        let cost = format!("{:016x}", run.best().unwrap().cost.to_bits());
        let (planner, expression, [min, max]) = (planner.to_owned(), expression.to_owned(), sides);
        Golden { planner, expression, dimension, min, max, status, hash: run.hash(), cost }
    });
    let refusals = REFUSED.iter().map(|&expression| {
        let message = scene(expression, 2, [-1.0, 1.0]).unwrap_err().to_string();
        Refused { expression: expression.to_owned(), message }
    });
    Stored { runs: runs.collect(), refusals: refusals.collect() }
}

#[test]
fn runs_on_formulas_have_the_stored_bits() {
    let made = made();
    assert!(made.runs.iter().any(|run| run.status == "failed") && made.runs.iter().any(|run| run.status == "running"));
    if std::env::var_os("FORAGE_BLESS").is_some() {
        std::fs::write(FILE, serde_json::to_string_pretty(&made).unwrap() + "\n").unwrap();
    }
    let stored: Stored = serde_json::from_str(&std::fs::read_to_string(FILE).unwrap()).unwrap();
    assert_eq!(made, stored);
}

#[test]
fn the_stored_formulas_call_every_function() {
    for function in FORMULA_FUNCTIONS {
        let called = format!("{}(", function.name);
        assert!(RUNS.iter().any(|(_, expression, ..)| expression.contains(&called)), "{}", function.name);
    }
}

/// What formulas are made of, and what they are not.
const PIECES: &[&str] = &[
    "x",
    "y",
    "x[",
    "]",
    "(",
    ")",
    "sum(",
    "prod(",
    ", i, 1, n",
    "sin(",
    "if(",
    ",",
    "+",
    "-",
    "*",
    "/",
    "^",
    "**",
    "%",
    "?",
    ":",
    "&&",
    "||",
    "!",
    "<",
    "<=",
    "==",
    "1",
    "2.5",
    "1e3",
    ".",
    "n",
    "i",
    "pi",
    " ",
    "é",
    "\u{0}",
    "max(",
];

/// A text of any characters is refused or compiled, at once.
#[test]
fn any_text_is_refused_or_compiled() {
    let mut seed = 1_u64;
    let mut next = |n: usize| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (seed >> 33) as usize % n
    };
    let (mut compiled, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let text: String = (0..next(14)).map(|_| PIECES[next(PIECES.len())]).collect();
        match Formula::new(&text, 1 + next(3)) {
            Ok(formula) => {
                compiled += 1;
                let _ = formula.value(&[0.5, -1.5, 2.0], &mut Vec::new());
            }
            Err(error) => {
                refused += 1;
                assert!(error.to_string().starts_with("expression: "), "{text}: {error}");
            }
        }
    }
    assert!(compiled > 200 && refused > 10_000, "{compiled} compiled, {refused} refused");
}

#[test]
fn a_failed_run_is_no_result_to_compare() {
    use forage::{Trial, run::trial::WITHIN};
    let setup =
        Setup { planner: "pso".into(), scene: scene("sqrt(x) + y", 2, [-1.0, 1.0]).unwrap().into(), params: Overrides::new(), seed: 1 };
    let mut trial = Trial::new(standard(), setup, WITHIN).unwrap();
    assert_eq!(trial.step(u64::MAX), Status::Failed);
    let record = trial.record();
    assert_eq!((record.value, record.feasible, record.status), (None, false, Status::Failed));
}
