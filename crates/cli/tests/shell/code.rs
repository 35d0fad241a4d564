//! `forage run --code`: planners in JavaScript.

use std::{fs, path::PathBuf, sync::Arc};

use forage::{Overrides, Registry, Run, Setup, shipped};
use serde_json::Value;

use crate::support::{empty_folder, forage, text};

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
        (
            "keys.js",
            "const all = Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => [k, k])); for (;;) Object.keys(all);",
            "took longer than 900 ms",
        ),
        ("half.js", "register({ name: 'half' })", "`kinds` is missing"),
        ("taken.js", &fs::read_to_string(template("pso")).unwrap().replace("my-pso", "pso"), "no other planner has"),
        ("typed.js", "register({\n  name: 5 + })", "(line 2)"),
    ] {
        let file = folder.path().join(name);
        fs::write(&file, code).unwrap();
        let run = forage(&["run", "--code", file.to_str().unwrap(), "--scene", "sphere"]);
        let said = text(&run.stderr);
        assert!(run.status.code() == Some(2) && said.contains(words) && (said.contains(name) || name == "keys.js"), "{name}: {said}");
    }
}

/// A link of a run of a template at an iteration, with its code.
fn link(code: &str, scene: &str, at: u64) -> String {
    let entry = forage_isolate::entry(code).unwrap();
    let registry = Arc::new(Registry::standard().with(entry));
    let setup = Setup { planner: entry.name.into(), scene: shipped(scene).unwrap(), params: Overrides::new(), seed: 1 };
    let mut run = Run::new(&registry, setup).unwrap();
    run.step(at);
    forage_isolate::with_code(&run.link().unwrap(), code).unwrap()
}

#[test]
fn a_link_with_code_is_run() {
    let link = link(&fs::read_to_string(template("hill-climber")).unwrap(), "sphere-2", 50);
    let run = forage(&["run", &link, "--json"]);
    assert!(run.status.success(), "{}", text(&run.stderr));
    let outcome: Value = serde_json::from_slice(&run.stdout).unwrap();
    assert!(outcome["planner"] == "my-hill-climber" && outcome["iterations"] == 50);
}

#[test]
fn planners_that_are_handed_in_are_graded() {
    let climber = fs::read_to_string(template("hill-climber")).unwrap();
    // Two hand in planners of one name, and one that is no good.
    let slow = climber.replace("default: 0.05", "default: 0.001");
    let endless = climber.replace("advance(state, {", "advance(state) { for (;;); }, unused(state, {").replace("unused(", "draw(");
    let links = [(climber.as_str(), 400), (slow.as_str(), 400)].map(|(code, at)| link(code, "sphere-2", at));
    let stuck = forage_isolate::with_code("#v=1&planner=my-hill-climber&scene=sphere-2&seed=1&at=400", &endless).unwrap();
    // The clock is not looked at within what is built in: such a code ends with the program that runs it.
    let built_in = "const all = Object.fromEntries(Array.from({ length: 1e5 }, (_, k) => [k, k])); for (;;) Object.keys(all);";
    let built_in = climber.replace("const cost = evaluate(tried)", built_in);
    let hangs = forage_isolate::with_code("#v=1&planner=my-hill-climber&scene=sphere-2&seed=1&at=400", &built_in).unwrap();
    let ours = "#v=1&planner=pso&scene=sphere-2&seed=1&at=10";
    let folder = empty_folder("graded-code");
    let [list, task] = ["links.txt", "task.json"].map(|name| folder.join(name));
    fs::write(
        &list,
        format!(
            "Ada {}\nBob {}\nCyd {stuck}\nDan #v=1&planner=my-hill-climber&scene=sphere-2&at=4\nEve {ours}\nFay {hangs}\nGus {}\n",
            links[0], links[1], links[0]
        ),
    )
    .unwrap();
    fs::write(&task, r#"{"own": true, "scene": "sphere-2", "goal": {"cost": 1}, "budget": {"evaluations": 1000}}"#).unwrap();
    let output = forage(&["grade", list.to_str().unwrap(), "--task", task.to_str().unwrap()]);
    let rows: Vec<String> = text(&output.stdout).lines().map(str::to_owned).collect();
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(rows[1].starts_with("true,") && rows[1].contains("Ada") && rows[1].contains("true,"), "{rows:?}");
    assert!(rows[2].starts_with("false,") && rows[2].contains("Bob"), "{rows:?}");
    assert!(rows[3].starts_with("false,") && rows[3].contains("Cyd"), "{rows:?}");
    assert!(rows[4].contains("my-hill-climber") && rows[4].contains("Dan"), "{rows:?}");
    assert!(rows[5].starts_with("false,") && rows[5].contains("A planner of your own is asked for"), "{rows:?}");
    assert!(rows[6].starts_with("false,") && rows[6].contains("could not be stopped") && rows[6].contains("Fay"), "{rows:?}");
    assert_eq!(rows[7].replace("7,Gus", "1,Ada"), rows[1], "{rows:?}");
}
