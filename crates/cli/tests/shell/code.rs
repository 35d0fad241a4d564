//! `forage run --code`: planners in JavaScript.

use std::{fs, path::PathBuf};

use serde_json::Value;

use crate::support::{forage, text};

fn template(name: &str) -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("../../templates/{name}.js"))
}

#[test]
fn a_planner_in_javascript_is_run() {
    let file = template("two-opt");
    let run = forage(&["run", "--code", file.to_str().unwrap(), "--scene", "random-52", "--seed", "3", "--iterations", "20", "--json"]);
    assert!(run.status.success(), "{}", text(&run.stderr));
    let outcome: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert!(outcome["planner"] == "my-two-opt" && outcome["iterations"] == 20 && outcome["length"].as_f64().unwrap() > 7000.0);
}

#[test]
fn code_that_is_wrong_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    for (name, code, words) in [
        ("loop.js", "for (;;);", "took longer than 900 ms"),
        ("half.js", "register({ name: 'half' })", "`kinds` is missing"),
        ("taken.js", &fs::read_to_string(template("pso")).unwrap().replace("my-pso", "pso"), "there is a planner `pso`"),
        ("typed.js", "register({\n  name: 5 + })", "(line 2)"),
    ] {
        let file = folder.path().join(name);
        fs::write(&file, code).unwrap();
        let run = forage(&["run", "--code", file.to_str().unwrap(), "--scene", "sphere"]);
        let said = text(&run.stderr);
        assert!(run.status.code() == Some(2) && said.contains(words) && said.contains(name), "{name}: {said}");
    }
}
