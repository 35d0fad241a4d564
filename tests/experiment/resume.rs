//! Rows stay whatever happens, and only a sweep's own.

use std::fs;
#[cfg(unix)]
use std::process::Command;

use forage::experiment::sweep::{Kept, Part};

use crate::support::{LONG, SMALL, begin, carry_out, folder, in_process, refused, trivial, wait_for};

#[test]
fn killed_at_any_moment_it_goes_on_and_loses_nothing() {
    let folder = folder("killed", LONG);
    let [whole, out] = ["whole.csv", "out.csv"].map(|name| folder.join(name));
    carry_out(&folder, &["--out", whole.to_str().unwrap()]);
    let file = folder.join("sweep.toml");
    let args = ["experiment", file.to_str().unwrap(), "--out", out.to_str().unwrap(), "--jobs", "2"];
    let mut kept = Vec::new();
    for rows in [0, 1, 2, 5, 9, 14] {
        let mut child = begin(&args);
        wait_for(rows, &out, &mut child);
        // SIGKILL on Unix: nothing of the program's own is carried out any more.
        child.kill().unwrap();
        child.wait().unwrap();
        let now = fs::read_to_string(&out).unwrap();
        let lines: Vec<_> = now.split_inclusive('\n').filter(|line| line.ends_with('\n')).map(str::to_owned).collect();
        assert!(kept.iter().all(|line| lines.contains(line)), "a row that was there is gone");
        kept = lines;
    }
    // Killed while the file is put in order.
    let beside = folder.join("out.csv.new");
    fs::write(&beside, "scene,pla").unwrap();
    carry_out(&folder, &args[2..]);
    assert_eq!(fs::read(&out).unwrap(), fs::read(&whole).unwrap());
    assert!(!beside.exists());
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_what_is_finished_and_exits_with_130() {
    let folder = folder("interrupted", LONG);
    let out = folder.join("sweep.csv");
    let file = folder.join("sweep.toml");
    let mut child = begin(&["experiment", file.to_str().unwrap(), "--jobs", "1"]);
    wait_for(3, &out, &mut child);
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let kept = fs::read_to_string(&out).unwrap();
    assert!(kept.ends_with('\n') && kept.lines().count() > 3);
    carry_out(&folder, &[]);
    assert!(fs::read_to_string(&out).unwrap().contains(kept.lines().last().unwrap()));
}

/// Wherever the file is cut off, the rest is run again.
#[test]
fn every_cut_of_the_file_goes_on() {
    let folder = folder("cuts", "");
    let sweep = trivial("[3, 1]", "");
    for name in ["rows.csv", "rows.jsonl"] {
        let path = folder.join(name);
        in_process(&sweep, &path).unwrap();
        let whole = fs::read(&path).unwrap();
        for end in 0..whole.len() {
            fs::write(&path, &whole[..end]).unwrap();
            in_process(&sweep, &path).unwrap();
            assert!(fs::read(&path).unwrap() == whole, "{name} cut off after {end} bytes");
        }
    }
}

#[test]
fn what_is_there_is_not_run_again() {
    let folder = folder("again", SMALL);
    let first = carry_out(&folder, &["--json"]);
    let out = folder.join("sweep.csv");
    // Nobody would have got this hash: it stays, and so it was not carried out.
    let rows = fs::read_to_string(&out).unwrap();
    let hash = rows.lines().nth(5).unwrap().rsplit(',').next().unwrap();
    let marked = rows.replace(hash, "0123456789abcdef");
    fs::write(&out, &marked).unwrap();
    assert_eq!(carry_out(&folder, &["--json"]), first);
    assert_eq!(fs::read_to_string(&out).unwrap(), marked);
}

#[test]
fn rows_that_the_run_no_longer_gives_are_refused() {
    let folder = folder("version", "");
    let path = folder.join("rows.csv");
    in_process(&trivial("[1, 2]", ""), &path).unwrap();
    // Other runs are left, and the lightest that is kept is told to be near enough to the optimum now.
    let whole = fs::read_to_string(&path).unwrap();
    let some: String = whole.split_inclusive('\n').take(6).collect();
    fs::write(&path, &some).unwrap();
    let message = in_process(&trivial("[1, 2]", "within = 1000000"), &path).unwrap_err().to_string();
    assert!(message.contains("now gives another row") && message.contains("--fresh"), "{message}");
    assert_eq!(fs::read_to_string(&path).unwrap(), some, "nothing is lost");
}

#[test]
fn a_file_of_something_else_is_refused_and_stays() {
    let folder = folder("others", SMALL);
    let out = folder.join("rows.csv");
    let args = ["--out", out.to_str().unwrap()];
    carry_out(&folder, &args);
    let whole = fs::read_to_string(&out).unwrap();
    let cases = [
        ("notes, no newline".to_owned(), "does not begin like"),
        ("a,b\n1,2\n".to_owned(), "its first line is not scene,planner,seed,p.iterations,w,c1,population"),
        (whole.replace(",0.4,", ",0.5,"), "line 5: there is no run of pso on sphere, iterations=20, w=0.5, c1=2, seed 1"),
        (whole.replace("sphere,wcpso,2", "sphere,wcpso,4"), "seed 4"),
        (whole.replace("sphere,wcpso,2", "sphere,cpso,2"), "there is no run of cpso on sphere"),
        (whole.replace("true", "true,true"), "values, not 22"),
        (format!("{whole}{}", whole.lines().nth(1).unwrap().replace("exhausted", "solved") + "\n"), "came out otherwise"),
    ];
    for (text, part) in cases {
        fs::write(&out, &text).unwrap();
        let message = refused(&folder, &args);
        assert!(message.contains(part), "{part}: {message}");
        assert_eq!(fs::read_to_string(&out).unwrap(), text);
    }
    carry_out(&folder, &["--out", out.to_str().unwrap(), "--fresh"]);
    assert_eq!(fs::read_to_string(&out).unwrap(), whole);
    let message = refused(&folder, &["--out", out.to_str().unwrap(), "--shard", "1/2"]);
    assert!(message.contains("is not in part 1/2"), "{message}");
}

#[test]
fn two_at_once_are_refused() {
    let folder = folder("lock", SMALL);
    let sweep = trivial("[1]", "");
    let out = folder.join("sweep.csv");
    let first = Kept::open(&sweep, Part::WHOLE, &out, false).unwrap();
    assert!(refused(&folder, &[]).contains("no other `forage` is writing"));
    assert!(refused(&folder, &["--fresh"]).contains("no other `forage` is writing"));
    let merged = folder.join("merged.csv");
    assert!(refused(&folder, &["--out", merged.to_str().unwrap(), "--merge", out.to_str().unwrap()]).contains("no `forage` is writing"));
    drop(first);
    fs::remove_file(&out).unwrap();
    carry_out(&folder, &[]);
}
