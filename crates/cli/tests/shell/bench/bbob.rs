//! `forage bench bbob`.

use std::{fs, path::Path, process::Command};

use crate::{
    experiment::support::{begin, wait_for},
    support::{empty_folder, forage, text},
};

/// Everything but the folder.
const SMALL: &[&str] = &["bench", "bbob", "--planners", "pso,qpso", "--functions", "1,8", "--dimensions", "2,3", "--instances", "1-3"];

fn carry_out(folder: &Path, more: &[&str]) -> std::process::Output {
    forage(&[SMALL, &["--budget", "200", "--out", folder.to_str().unwrap()], more].concat())
}

#[test]
fn runs_are_kept_in_parts_or_whole_and_the_files_are_the_same() {
    let [whole, split] = ["bench-whole", "bench-split"].map(empty_folder);
    let output = carry_out(&whole, &["--jobs", "1"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    assert!(printed.contains("D = 2") && printed.contains("of 12"), "{printed}");
    for part in ["1/2", "2/2"] {
        let output = carry_out(&split, &["--shard", part]);
        assert!(text(&output.stdout).contains("12 of 24 runs"), "{}", text(&output.stdout));
    }
    assert_eq!(text(&carry_out(&split, &[]).stdout), printed);
    for file in ["rows.csv", "report.md", "targets.svg", "coco/pso/bbobexp_f8.info", "coco/qpso/data_f1/bbobexp_f1_DIM3.dat"] {
        assert_eq!(fs::read_to_string(whole.join(file)).unwrap(), fs::read_to_string(split.join(file)).unwrap(), "{file}");
    }
    // Other runs are added to what is there.
    let before = fs::read_to_string(whole.join("rows.csv")).unwrap();
    let more = ["bench", "bbob", "--planners", "pso", "--functions", "5", "--dimensions", "2", "--instances", "1", "--budget", "200"];
    let output = forage(&[&more[..], &["--out", whole.to_str().unwrap()]].concat());
    assert!(text(&output.stdout).contains("of 1"), "{}", text(&output.stderr));
    assert!(!whole.join("coco/qpso").exists() && whole.join("coco/pso/bbobexp_f5.info").exists());
    let after = fs::read_to_string(whole.join("rows.csv")).unwrap();
    assert!(after.lines().count() == before.lines().count() + 1 && before.lines().all(|line| after.contains(line)));
}

#[test]
fn rows_that_were_changed_are_run_again_and_folders_of_others_are_refused() {
    let folder = empty_folder("bench-version");
    carry_out(&folder, &["--shard", "1/2"]);
    carry_out(&folder, &["--shard", "2/2"]);
    // Of the second planner only, in one of the parts.
    let (part, rows) = (folder.join("rows.2-of-2.csv"), folder.join("rows.csv"));
    let kept = fs::read_to_string(&part).unwrap();
    let altered = kept.lines().map(|line| if line.starts_with("qpso") { format!("{line} 9999:0.0\n") } else { format!("{line}\n") });
    fs::write(&part, altered.collect::<String>()).unwrap();
    let output = carry_out(&folder, &[]);
    let said = text(&output.stderr);
    assert!(
        output.status.success() && said.contains("damaged lines in ") && said.contains("rows.2-of-2.csv: 6; their runs are repeated"),
        "{said}"
    );
    let mended = fs::read_to_string(&rows).unwrap();
    assert_eq!(carry_out(&folder, &["--fresh"]).status.code(), Some(0));
    assert_eq!(fs::read_to_string(&rows).unwrap(), mended);
    assert!(!part.exists());
    fs::remove_file(folder.join("coco/written-by-forage.txt")).unwrap();
    let output = carry_out(&folder, &[]);
    assert!(output.status.code() == Some(2) && text(&output.stderr).contains("choose another --out"), "{}", text(&output.stderr));
}

#[test]
fn no_run_has_more_evaluations_than_the_budget() {
    let folder = empty_folder("bench-budget");
    // The population does not divide the budget.
    let output = carry_out(&folder, &["--set", "pso.population=7"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let mut rows = csv::Reader::from_path(folder.join("rows.csv")).unwrap();
    let mut count = 0;
    for row in rows.records() {
        let row = row.unwrap();
        let [budget, evaluations] = [5, 6].map(|column| row[column].parse::<u64>().unwrap());
        assert!(evaluations <= budget, "{row:?}");
        assert_eq!(&row[1] == "population=7", &row[0] == "pso", "{row:?}");
        let last = row[8].rsplit(' ').next().unwrap().split_once(':').unwrap();
        assert!(last.0.parse::<u64>().unwrap() <= evaluations && last.1 == &row[7], "{row:?}");
        count += 1;
    }
    assert_eq!(count, 24);
}

#[test]
fn what_is_wrong_is_refused_before_anything_runs() {
    let folder = empty_folder("bench-refused");
    let out = folder.join("none");
    for (more, said) in [
        (&["--planners", "nobody"][..], "--planners"),
        (&["--planners", "pso,a-star"], "--planners"),
        (&["--set", "nobody.w=1"], "--set"),
        (&["--planners", "pso,pso"], "named once"),
        (&["--set", "w"], "[PLANNER.]NAME=VALUE"),
        (&["--planners", "qpso", "--set", "pso.w=0.7"], "takes part: qpso"),
        (&["--set", "0.7"], "is 0.7; it must be [PLANNER.]NAME=VALUE"),
        (&["--instances", "1-200000", "--planners", "pso,qpso"], "at most 1000000"),
        (&["--dimensions", "4"], "2, 3, 5, 10, 20 and 40"),
        (&["--functions", "25"], "from 1 to 24"),
        (&["--functions", "5-2"], "--functions"),
        (&["--dimensions", "1"], "--dimensions"),
        (&["--instances", "0"], "--instances"),
        (&["--shard", "3/2"], "--shard"),
        (&["--set", "pso.w=nine"], "w"),
    ] {
        let given = [&["bench", "bbob", "--out", out.to_str().unwrap(), "--budget", "10"], more].concat();
        let output = forage(&given);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains(said), "{more:?}: {}", text(&output.stderr));
        assert!(!out.join("rows.csv").exists(), "{more:?}");
    }
}

#[test]
fn damaged_lines_are_run_again() {
    let folder = empty_folder("bench-damaged");
    carry_out(&folder, &[]);
    let file = folder.join("rows.csv");
    let whole = fs::read_to_string(&file).unwrap();
    let damaged: String =
        whole.lines().enumerate().map(|(k, line)| if k == 5 { "garbage,,,\n".to_owned() } else { format!("{line}\n") }).collect();
    fs::write(&file, &damaged).unwrap();
    let output = carry_out(&folder, &[]);
    let stderr = text(&output.stderr);
    assert!(output.status.success() && stderr.contains("damaged lines in ") && stderr.contains("rows.csv.bad"), "{stderr}");
    assert!(fs::read_to_string(&file).unwrap() == whole);
    assert!(fs::read_to_string(folder.join("rows.csv.bad")).unwrap() == damaged);
    // What has no row of this kind at all is something else.
    fs::write(&file, "a,b\n1,2\n").unwrap();
    assert_eq!(carry_out(&folder, &[]).status.code(), Some(2));
}

#[test]
fn ctrl_c_keeps_what_is_finished_and_exits_with_130() {
    let folder = empty_folder("bench-interrupted");
    let out = folder.to_str().unwrap();
    let args = ["bench", "bbob", "--planners", "pso", "--dimensions", "20", "--budget", "3000", "--jobs", "1", "--out", out];
    let mut child = begin(&args);
    wait_for(3, &folder.join("rows.csv"), &mut child);
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let kept = fs::read_to_string(folder.join("rows.csv")).unwrap();
    assert!(kept.ends_with('\n') && kept.lines().count() < 24 * 15, "{}", kept.lines().count());
}
