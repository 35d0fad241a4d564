//! The shell: what it prints, what it refuses, and its exit codes.

use std::{
    path::PathBuf,
    process::{Command, Stdio},
};

use serde_json::Value;

use crate::support::{command, forage};

fn json(args: &[&str]) -> Value {
    let output = forage(args);
    assert!(output.status.code() != Some(2), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn temporary(name: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR"));
    std::fs::create_dir_all(&folder).unwrap();
    folder.join(name)
}

#[test]
fn a_preset_sets_what_its_page_says_and_set_overrides_it() {
    let run = |more: &[&str]| json(&[&["run", "wpso", "--scene", "matyas", "--iterations", "20", "--json"], more].concat());
    let fitted = run(&["--preset", "fitted"]);
    assert_eq!(fitted["hash"], run(&["--set", "w_max=0.9", "--set", "c1=1.5", "--set", "c2=1.5", "--set", "random=particle"])["hash"]);
    assert_ne!(fitted["hash"], run(&[])["hash"]);
    assert_eq!(run(&["--preset", "paper"])["hash"], run(&[])["hash"]);
    assert_eq!(run(&["--preset", "fitted", "--set", "w_max=0.8"])["parameters"]["w_max"], 0.8);
    let page = String::from_utf8(forage(&["list", "wpso"]).stdout).unwrap();
    assert!(page.contains("Presets (--preset NAME)") && page.contains("c1=1.5 c2=1.5 random=particle w_max=0.9"), "{page}");
    for (planner, name, expected) in
        [("wpso", "fited", "`fited` is not a preset of wpso; did you mean `fitted`?"), ("a-star", "paper", "has no presets")]
    {
        let output = forage(&["run", planner, "--scene", "matyas", "--preset", name]);
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2));
        assert!(stderr.contains(expected), "{stderr}");
    }
}

#[test]
fn run_prints_the_contract_and_exits_with_0() {
    let output = forage(&["run", "wcpso", "--scene", "scenes/wcpso-discs.json", "--seed", "3", "--json"]);
    assert_eq!(output.status.code(), Some(0));
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    for key in [
        "planner",
        "scene",
        "seed",
        "iterations",
        "evaluations",
        "status",
        "cost",
        "length",
        "feasible",
        "clearance",
        "exact",
        "gap",
        "path",
        "readings",
        "hash",
        "elapsed_ms",
        "parameters",
    ] {
        assert!(!result[key].is_null(), "{key}");
    }
    assert_eq!((&result["status"], &result["seed"], &result["iterations"]), (&"exhausted".into(), &3.into(), &500.into()));
    assert_eq!(result["path"][0], serde_json::json!([0.0, 0.0]));
    let gap = (result["length"].as_f64().unwrap() - result["exact"].as_f64().unwrap()) / result["exact"].as_f64().unwrap();
    assert_eq!(result["gap"].as_f64().unwrap(), gap);
    assert_eq!(result["parameters"]["population"], 150.0);
}

#[test]
fn a_result_that_collides_exits_with_1_and_is_said_to() {
    let output = forage(&["run", "pso", "--scene", "wcpso-discs", "--set", "penalty=waypoints"]);
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8_lossy(&output.stdout).contains("NO, it cuts"));
}

#[test]
fn what_is_refused_exits_with_2_and_prints_nothing_on_standard_output() {
    for (args, part) in [
        (&["run", "wcpso", "--scene", "nowhere.json"] as &[&str], "`nowhere.json`: no such file"),
        (&["run", "waldo", "--scene", "sphere"], "waldo"),
        (&["run", "pso", "--scene", "sphere", "--set", "w=9"], "`w` is 9; it must be a number from 0 to 1.5"),
        (&["run", "pso", "--scene", "sphere", "--set", "population=0"], "`population` is 0"),
        (&["run", "pso", "--scene", "sphere", "--set", "population"], "name=value"),
        (&["run", "pso", "--scene", "sphere", "--iterations", "ten"], "`iterations` is ten"),
        (&["run", "pso", "--scene", "sphere", "--seed", "-0.5"], "`seed` is -0.5"),
        (&["run", "pso", "--scene", "sphere", "--seed=9007199254740992"], "`seed` is 9007199254740992"),
        (&["run", "pso"], "--scene"),
        (&["run", "pso", "--scene", "#v=9&planner=pso"], "version 9"),
        (&["run", "pso", "--scene", "sphere", "--svg", "no/such/folder/a.svg"], "no/such/folder/a.svg"),
        (&["run", "ltqpso", "--scene", "qpso-10m", "--drive-set", "gear=0"], "`gear` is 0"),
        (&["run", "ltqpso", "--scene", "qpso-10m", "--drive-set", "gear"], "name=value"),
        (
            &["run", "pso", "--scene", "sphere", "--drive", "a.csv"],
            "--drive needs a grid whose robot has a length and a width; `sphere` is of kind function",
        ),
        (&["exact", "--scene", "Cargo.toml"], "not JSON"),
        (&["fly"], "fly"),
        (&["run", "#v=1&planner=pso&scene=sphere&at=9007199254740993"], "`at` is 9007199254740993"),
    ] {
        let output = forage(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(output.stdout.is_empty(), "{args:?}");
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(message.contains(part), "{args:?}: {message}");
    }
}

#[test]
fn a_link_reproduces_its_hash_where_it_stands() {
    let whole = json(&["run", "wcpso", "--scene", "wcpso-discs", "--seed", "7", "--set", "w_max=0.8", "--json"]);
    let at_120 = json(&["run", "#v=1&planner=wcpso&scene=wcpso-discs&seed=7&p.w_max=0.8&at=120", "--json"]);
    assert_eq!((&at_120["iterations"], &at_120["status"]), (&120.into(), &"running".into()));
    let link = format!(
        "https://example.org/forage/#v=1&planner=wcpso&scene=wcpso-discs&seed=7&p.w_max=0.8&at=500&hash={}",
        whole["hash"].as_str().unwrap()
    );
    let again = forage(&["run", "wcpso", "--scene", &link, "--json"]);
    assert_eq!(serde_json::from_slice::<Value>(&again.stdout).unwrap()["hash"], whole["hash"]);
    assert!(again.stderr.is_empty(), "the promised hash is the one found");
    assert_eq!(again.status.code(), Some(0));
    let wrong = link.replace("hash=", "hash=0");
    let broken = forage(&["run", &wrong, "--json"]);
    let message = String::from_utf8_lossy(&broken.stderr).into_owned();
    assert_eq!(broken.status.code(), Some(1), "{message}");
    assert!(message.contains("at iteration 500 the link's hash is") && message.contains("--ignore-hash"), "{message}");
    assert_eq!(serde_json::from_slice::<Value>(&broken.stdout).unwrap()["hash"], whole["hash"], "the result is printed all the same");
    let late = forage(&["run", &link.replace("at=500", "at=501"), "--json"]);
    assert_eq!(late.status.code(), Some(0), "the run ended at 500, and in this very state");
    let early = forage(&["run", &wrong.replace("at=500", "at=501"), "--json"]);
    assert!(String::from_utf8_lossy(&early.stderr).contains("this run stopped at iteration 500"));
    let ignored = forage(&["run", &wrong, "--ignore-hash", "--json"]);
    assert_eq!((ignored.status.code(), ignored.stderr.is_empty()), (Some(0), true));
    let other = json(&["run", "pso", "--scene", &link, "--json"]);
    assert_eq!((&other["planner"], &other["seed"]), (&"pso".into(), &7.into()));
}

#[test]
fn exact_and_list_speak_json() {
    let exact = json(&["exact", "--scene", "wcpso-discs", "--json"]);
    assert!((exact["length"].as_f64().unwrap() - 12.141_590).abs() < 5e-7);
    assert!(exact["path"].as_array().unwrap().len() > 3);
    let tip = json(&["exact", "--scene", "arm-cuboid", "--json"]);
    assert!((tip["length"].as_f64().unwrap() - 1.351_621).abs() < 5e-7);
    assert_eq!(tip["path"][0], serde_json::json!([-0.2, 0.022, 0.05]));
    let list = json(&["list", "--json"]);
    let names: Vec<_> = list["planners"].as_array().unwrap().iter().map(|p| p["name"].as_str().unwrap()).collect();
    assert!(["pso", "wpso", "cpso", "wcpso"].iter().all(|name| names.contains(name)));
}

#[test]
fn svg_and_trace_are_written() {
    let (svg, csv) = (temporary("run.svg"), temporary("run.csv"));
    let args =
        ["run", "cpso", "--scene", "wcpso-discs", "--iterations", "40", "--svg", svg.to_str().unwrap(), "--trace", csv.to_str().unwrap()];
    let code = forage(&args).status.code().unwrap();
    assert!(code < 2);
    let picture = std::fs::read_to_string(svg).unwrap();
    assert!(picture.starts_with("<svg") && picture.contains(r#"class="best""#) && picture.contains(r#"class="exact""#));
    let rows = std::fs::read_to_string(csv).unwrap();
    assert_eq!(rows.lines().count(), 42, "a heading, the start and a row per iteration");
    assert!(rows.starts_with("iteration,best,mean,spread,free,length,smoothness,k,w,c1,c2"));
}

#[test]
fn a_drive_is_summed_up_and_written() {
    let csv = temporary("drive.csv");
    let path = csv.to_str().unwrap();
    let run = ["run", "ltqpso", "--scene", "qpso-10m", "--seed", "2"];
    let plain = json(&[&run[..], &["--json"]].concat());
    assert_eq!((&plain["drive"]["arrived"], &plain["drive"]["touched"]), (&true.into(), &false.into()));
    assert!(plain["turning"].as_f64().unwrap() > 0.1 && plain["drive"]["touched_at"].is_null());
    let slow = json(&[&run[..], &["--json", "--drive", path, "--drive-set", "speed=0.12", "--drive-set", "look_ahead=0.3"]].concat());
    assert_eq!(slow["hash"], plain["hash"]);
    assert!(slow["drive"]["time"].as_f64().unwrap() > 1.5 * plain["drive"]["time"].as_f64().unwrap());
    let rows = std::fs::read_to_string(csv).unwrap();
    assert!(rows.starts_with("time,x,y,heading,speed,turn_rate,left,right,left_count,right_count,error,clearance\n0,0,0,"), "{rows}");
    let last: Vec<f64> = rows.lines().last().unwrap().split(',').map(|number| number.parse().unwrap()).collect();
    assert_eq!((last[0], last[8]), (slow["drive"]["time"].as_f64().unwrap(), slow["drive"]["counts"][0].as_f64().unwrap()));
    let text = String::from_utf8(forage(&run).stdout).unwrap();
    let line = text.lines().find(|line| line.starts_with("  drive ")).unwrap();
    assert!(["cross-track error at most", "clearance", "encoder counts"].iter().all(|part| line.contains(part)), "{line}");
    let scraping = forage(&[&run[..], &["--drive-set", "look_ahead=1.5"]].concat());
    assert!(String::from_utf8(scraping.stdout).unwrap().contains("COLLIDES with an obstacle at ("));
}

#[cfg(unix)]
#[test]
fn an_interrupt_prints_the_best_so_far() {
    let child = command(&["run", "wcpso", "--scene", "wcpso-discs", "--iterations", "1000000000", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    // Long enough to be stepping; the run itself would take days.
    std::thread::sleep(std::time::Duration::from_millis(1500));
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(result["status"], "running");
    assert!(result["iterations"].as_u64().unwrap() > 0 && result["cost"].is_number());
    assert!(String::from_utf8_lossy(&output.stderr).contains("interrupted"));
}

/// A step that takes hours is not waited for: no row, no hash, and what it has found so far.
#[cfg(unix)]
#[test]
fn an_interrupt_within_a_step_writes_no_row_and_no_hash() {
    let csv = temporary("interrupted.csv");
    let args = ["run", "sa", "--scene", "random-280", "--set", "moves=100000", "--iterations", "1000", "--json", "--trace"];
    let child = command(&args).arg(&csv).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1500));
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    let message = String::from_utf8_lossy(&output.stderr);
    let result: Value = serde_json::from_slice(&output.stdout).unwrap();
    let iterations = result["iterations"].as_u64().unwrap();
    assert!(result["status"] == "running" && result["cost"].is_number(), "{result}");
    assert!(message.contains(&format!("interrupted within the step after iteration {iterations}")), "{message}");
    assert!(result.get("hash").is_none(), "{result}");
    let rows: Vec<_> = std::fs::read_to_string(csv).unwrap().lines().map(|row| row.split(',').next().unwrap().to_owned()).collect();
    let expected: Vec<_> = std::iter::once("iteration".to_owned()).chain((0..=iterations).map(|k| k.to_string())).collect();
    assert_eq!(rows, expected);
}

/// [LTQPSO](forage#papers) (10) by hand: 0.4321 · 8^1.7292 = 15.75, 0.2855 · 8^2.218 = 28.75.
#[test]
fn suggested_sizes_are_printed_and_used() {
    let suggested = json(&["suggest", "ltqpso", "--scene", "qpso-10m", "--json"]);
    assert_eq!((&suggested["population"], &suggested["iterations"]), (&16.into(), &29.into()));
    let run = json(&["run", "ltqpso", "--scene", "qpso-10m", "--suggested", "--set", "population=9", "--json"]);
    assert_eq!((&run["parameters"]["population"], &run["parameters"]["iterations"]), (&9.0.into(), &29.0.into()));
    for args in [&["suggest", "wcpso", "--scene", "qpso-10m"][..], &["run", "qpso", "--scene", "sphere", "--suggested"]] {
        let output = forage(args);
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0));
        assert!(String::from_utf8_lossy(&output.stderr).contains("recommends sizes"));
    }
}

#[test]
fn a_run_on_a_grid_tells_what_smoothing_and_driving_made_of_the_path() {
    let file = temporary("drive-refused.csv");
    let run = json(&["run", "ltqpso", "--scene", "scenes/qpso-10m.json", "--json", "--drive", file.to_str().unwrap()]);
    let number = |value: &Value| value.as_f64().unwrap();
    assert!(number(&run["length"]) < number(&run["readings"]["length"]), "shorter after smoothing");
    assert!(run["feasible"] == true && number(&run["gap"]) > 0.0 && number(&run["clearance"]) >= 0.0);
    assert!(run["drive"]["touched"] == false && run["drive"]["arrived"] == true);
    let rows = std::fs::read_to_string(file).unwrap();
    assert!(rows.starts_with("time,x,y,heading,speed,turn_rate,left,right,left_count,right_count,error,clearance\n0,0,0,"));
    assert_eq!(rows.lines().last().unwrap().split(',').next().unwrap(), run["drive"]["time"].to_string());
    let refused = forage(&["run", "ltqpso", "--scene", "qpso-10m", "--drive-set", "look_ahead=-1"]);
    assert_eq!((refused.status.code(), refused.stdout.len()), (Some(2), 0));
    assert!(String::from_utf8_lossy(&refused.stderr).contains("look_ahead"));
}

#[test]
fn formulas_are_run_from_a_file_and_refused_with_the_place() {
    let scene = |name: &str, expression: &str, more: &str| {
        let path = temporary(name);
        let text = format!(
            r#"{{"format": "forage-scene", "version": 1, "kind": "function", "name": "own", "title": "Own", "expression": "{expression}",
                "dimension": 2, "bounds": {{"min": -5, "max": [5, 6]}}{more}}}"#
        );
        std::fs::write(&path, text).unwrap();
        path.to_string_lossy().into_owned()
    };
    let whole = scene("whole.json", "(x - 1)^2 + (y + 2)^2", r#", "optimum": {"value": 0, "position": [1, -2]}"#);
    let outcome = json(&["run", "pso", "--scene", &whole, "--json"]);
    assert!(outcome["cost"].as_f64().unwrap() < 1e-9 && outcome["exact"] == 0.0 && outcome["exact_by"] == "stored", "{outcome}");
    let said = |args: &[&str]| {
        let output = forage(args);
        (output.status.code(), String::from_utf8_lossy(&[output.stdout, output.stderr].concat()).into_owned())
    };
    assert_eq!(said(&["exact", "--scene", &whole]), (Some(0), "own: minimum 0, stated in the scene file\n".into()));
    let unknown = scene("unknown.json", "sin(x) + y", "");
    assert_eq!(said(&["exact", "--scene", &unknown]), (Some(1), "own: the minimum of this function is not known\n".into()));
    let (code, text) = said(&["run", "pso", "--scene", &scene("bad.json", "sin(x", "")]);
    assert!(code == Some(2) && text.contains("expression: character 6: the formula ends here; expected: )"), "{text}");
    let failed = scene("failed.json", "ln(x)", "");
    assert_eq!(forage(&["run", "pso", "--scene", &failed]).status.code(), Some(1));
    let failed = json(&["run", "pso", "--scene", &failed, "--json"]);
    assert_eq!(failed["status"], "failed");
    assert!(failed["trouble"].as_str().unwrap().contains("not a number") && failed["failed_at"].as_array().unwrap().len() == 2, "{failed}");
}
