//! Rows stay whatever happens, and only a sweep's own.

#[cfg(unix)]
use std::process::Command;
use std::{fs, io::Write};

use forage_study::{runner::Control, sweep};

use super::support::{LONG, SMALL, begin, carry_out, fails, folder, forage, go_on, in_process, open, refused, trivial, wait_for};

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
    // Killed while the file is put in order, with something left to do, and surely out of order.
    let ordered = fs::read_to_string(&whole).unwrap();
    let lines: Vec<_> = ordered.split_inclusive('\n').collect();
    fs::write(&out, [lines[0], lines[3], lines[2], lines[1]].concat()).unwrap();
    let beside = folder.join(".out.csv.1.forage-new");
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
        // Everywhere in the heading, the first row and the last, and about the ends of the others.
        let ends: Vec<_> = (0..whole.len()).filter(|&at| whole[at] == b'\n').collect();
        let [first, last] = [ends[1], ends[ends.len() - 2]];
        for end in (0..whole.len()).filter(|&at| at <= first || at > last || ends.iter().any(|end| end.abs_diff(at) <= 1)) {
            fs::write(&path, &whole[..end]).unwrap();
            in_process(&sweep, &path).unwrap();
            assert!(fs::read(&path).unwrap() == whole, "{name} cut off after {end} bytes");
        }
    }
}

#[test]
fn what_is_there_is_neither_run_nor_written_again() {
    let folder = folder("again", SMALL);
    let first = carry_out(&folder, &["--json"]);
    let out = folder.join("sweep.csv");
    let (rows, written) = (fs::read(&out).unwrap(), fs::metadata(&out).unwrap().modified().unwrap());
    assert_eq!(carry_out(&folder, &["--json"]), first);
    assert_eq!((fs::read(&out).unwrap(), fs::metadata(&out).unwrap().modified().unwrap()), (rows, written));
    let sweep = trivial("[1, 2]", "");
    let out = folder.join("trivial.csv");
    in_process(&sweep, &out).unwrap();
    let progress = |_, _| panic!("a run is carried out");
    let control = Control { stop: &std::sync::atomic::AtomicBool::new(false), progress: &progress };
    sweep::carry_out(&sweep, &mut open(&sweep, &out).unwrap(), None, Some(1), None, &control).unwrap();
}

#[test]
fn kept_rows_are_run_again_where_that_is_wanted() {
    let folder = folder("verified", SMALL);
    carry_out(&folder, &[]);
    let file = folder.join("sweep.toml");
    for (share, said) in [(&["--verify"][..], "2 of 18 rows"), (&["--verify", "0.5"], "9 of 18 rows"), (&["--verify", "0"], "1 of 18 rows")]
    {
        let output = forage(&[&["experiment", file.to_str().unwrap()], share].concat());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.success() && message.contains(said) && message.contains("came out the same"), "{message}");
    }
    for wrong in ["2", "-0.1", "half", "NaN"] {
        let message = refused(&folder, &["--verify", wrong]);
        assert!(message.contains("a number from 0 to 1"), "{message}");
    }
}

#[test]
fn rows_of_another_plan_are_refused() {
    let folder = folder("version", "");
    let path = folder.join("rows.csv");
    in_process(&trivial("[1, 2]", ""), &path).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    // Whether other runs are left or not.
    for lines in [6, 9] {
        let some: String = whole.split_inclusive('\n').take(lines).collect();
        fs::write(&path, &some).unwrap();
        let near = trivial("[1, 2]", "within = 1000000");
        let message = in_process(&near, &path).unwrap_err().to_string();
        assert!(message.contains("line 2: its `within` is 0.01, not 1000000"), "{message}");
        assert_eq!(fs::read_to_string(&path).unwrap(), some, "nothing is lost");
    }
}

/// Whatever is wrong with the rest, rows are thrown away only when new ones come.
#[test]
fn fresh_throws_nothing_away_that_it_does_not_run_anew() {
    let folder = folder("fresh", SMALL);
    carry_out(&folder, &[]);
    let out = folder.join("sweep.csv");
    let whole = fs::read_to_string(&out).unwrap();
    let message = refused(&folder, &["--fresh", "--merge", out.to_str().unwrap()]);
    assert!(message.contains("cannot be used with"), "{message}");
    assert_eq!(fs::read_to_string(&out).unwrap(), whole);

    // A planner that refuses to start.
    let sweep = "scenes = ['wolf-ant-20']\nseeds = [1]\n[[planner]]\nname = 'pso-tuning'\nparams = { colony = 'aco', tune = 'gamma' }\n";
    fs::write(folder.join("sweep.toml"), sweep).unwrap();
    assert!(refused(&folder, &["--fresh"]).contains("planner[0].params.tune"));
    assert_eq!(fs::read_to_string(&out).unwrap(), whole);

    fs::write(folder.join("sweep.toml"), SMALL).unwrap();
    for (name, notes) in [("notes.csv", "x,y\n1,2\n"), ("notes.jsonl", "{\"x\":1}\n"), ("mine.csv", "scene,planner,seed,mine\na,b,1,2\n")] {
        let path = folder.join(name);
        fs::write(&path, notes).unwrap();
        let message = refused(&folder, &["--fresh", "--out", path.to_str().unwrap()]);
        assert!(message.contains("`--fresh` is ") && message.contains("stays as it is"), "{message}");
        let message = refused(&folder, &["--out", path.to_str().unwrap()]);
        assert!(!message.contains("--fresh"), "{message}");
        assert_eq!(fs::read_to_string(&path).unwrap(), notes);
    }
    // What the sweep is read from.
    let points = "name,x,y\na,0,0\nb,0,3\nc,4,0\nd,4,3\n";
    fs::write(folder.join("cities.csv"), points).unwrap();
    fs::write(folder.join("cities.toml"), "scenes = ['cities.csv']\nseeds = [1]\n[[planner]]\nname = 'two-opt'\n").unwrap();
    let file = folder.join("cities.toml");
    for fresh in [&[] as &[&str], &["--fresh"]] {
        let output = forage(&[&["experiment", file.to_str().unwrap()], fresh].concat());
        let message = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && message.contains("`out` is ") && message.contains("another file than"), "{message}");
        assert_eq!(fs::read_to_string(folder.join("cities.csv")).unwrap(), points);
    }
}

#[test]
fn what_a_damaged_line_told_is_run_again() {
    let folder = folder("damaged", "");
    let sweep = trivial("[1, 2]", "");
    for (name, line) in [("rows.csv", "\0\0\0,7\n"), ("rows.jsonl", "{\"sce\0\n"), ("blank.csv", "\n")] {
        let path = folder.join(name);
        in_process(&sweep, &path).unwrap();
        let whole = fs::read_to_string(&path).unwrap();
        let mut lines: Vec<&str> = whole.split_inclusive('\n').collect();
        lines[3] = line;
        lines.push("\n");
        fs::write(&path, lines.concat()).unwrap();
        let mut kept = open(&sweep, &path).unwrap();
        assert_eq!(kept.counts(), (7, 8), "{name}");
        go_on(&sweep, &mut kept).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), whole, "{name}");
        assert_eq!(fs::read_to_string(folder.join(format!("{name}.bad"))).unwrap(), lines.concat());
        let notes = kept.notes().join("; ");
        assert!(notes.contains("line 4 is damaged") && notes.contains("and 1 more; missing runs are repeated"), "{notes}");
        assert!(notes.contains("7 of 8 rows were there; the first that was missing is that of"), "{notes}");
        drop(kept);
        // A second time the first copy stays.
        fs::write(&path, lines[..4].concat()).unwrap();
        go_on(&sweep, &mut open(&sweep, &path).unwrap()).unwrap();
        let [first, second] = ["bad", "2.bad"].map(|ending| fs::read_to_string(folder.join(format!("{name}.{ending}"))).unwrap());
        assert_eq!((first, second), (lines.concat(), lines[..4].concat()));
    }
}

/// Locks are not to be had everywhere: what a second writer adds is found.
#[test]
fn rows_of_another_writer_are_not_cut_up() {
    let folder = folder("two", "");
    let sweep = trivial("[1, 2]", "");
    let path = folder.join("rows.csv");
    in_process(&sweep, &path).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    let lines: Vec<&str> = whole.split_inclusive('\n').collect();
    let write = |text: &str| fs::OpenOptions::new().append(true).open(&path).unwrap().write_all(text.as_bytes()).unwrap();
    fs::write(&path, lines[..5].concat()).unwrap();
    // As it finds the first row, there is one more: as it would be in the middle.
    for extra in [lines[7], lines[5]] {
        fs::write(&path, lines[..5].concat()).unwrap();
        let mut kept = open(&sweep, &path).unwrap();
        let first = std::sync::atomic::AtomicBool::new(true);
        let progress = |_, _| {
            if first.swap(false, std::sync::atomic::Ordering::Relaxed) {
                write(extra);
            }
        };
        let control = Control { stop: &std::sync::atomic::AtomicBool::new(false), progress: &progress };
        sweep::carry_out(&sweep, &mut kept, None, Some(2), None, &control).unwrap();
        assert_eq!(fs::read_to_string(&path).unwrap(), whole);
        assert!(kept.notes().join(" ").contains("another program wrote in it"));
    }
}

#[cfg(unix)]
#[test]
fn a_link_to_the_rows_stays_one() {
    let folder = folder("link", "");
    let (real, link) = (folder.join("real.csv"), folder.join("rows.csv"));
    let sweep = trivial("[1, 2]", "");
    in_process(&sweep, &real).unwrap();
    let whole = fs::read_to_string(&real).unwrap();
    let mut lines: Vec<&str> = whole.split_inclusive('\n').collect();
    lines[1..].reverse();
    fs::write(&real, lines.concat()).unwrap();
    std::os::unix::fs::symlink(&real, &link).unwrap();
    in_process(&sweep, &link).unwrap();
    assert!(link.symlink_metadata().unwrap().is_symlink());
    assert_eq!(fs::read_to_string(&real).unwrap(), whole);
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
    ];
    for (text, part) in cases {
        fs::write(&out, &text).unwrap();
        let message = refused(&folder, &args);
        assert!(message.contains(part), "{part}: {message}");
        assert_eq!(fs::read_to_string(&out).unwrap(), text);
    }
    fs::write(&out, whole.lines().next().unwrap().to_owned() + "\nnothing\n").unwrap();
    carry_out(&folder, &["--out", out.to_str().unwrap(), "--fresh"]);
    assert_eq!(fs::read_to_string(&out).unwrap(), whole);
    // What was changed in our rows is run again.
    for (ours, theirs) in [(",0.4,", ",0.5,"), ("sphere,wcpso,2", "sphere,cpso,2"), (",true,", ",false,")] {
        fs::write(&out, whole.replacen(ours, theirs, 5)).unwrap();
        carry_out(&folder, &args);
        assert_eq!(fs::read_to_string(&out).unwrap(), whole);
    }
    // What the plan no longer has is another's.
    for (ours, theirs, part) in [
        ("0.8, 0.4", "0.8, 0.5", "there is no run of pso on sphere, iterations=20, w=0.4, c1=2, seed 1"),
        ("count = 3", "count = 2", "seed 3"),
        ("\"wcpso\"", "\"cpso\"", "there is no run of wcpso on sphere"),
    ] {
        fs::write(folder.join("sweep.toml"), SMALL.replace(ours, theirs)).unwrap();
        let message = refused(&folder, &args);
        assert!(message.contains(part) && message.contains("another experiment"), "{part}: {message}");
        assert_eq!(fs::read_to_string(&out).unwrap(), whole);
    }
    fs::write(folder.join("sweep.toml"), SMALL).unwrap();
    let message = refused(&folder, &["--out", out.to_str().unwrap(), "--shard", "1/2"]);
    assert!(message.contains("is not in part 1/2"), "{message}");
}

#[test]
fn two_at_once_are_refused() {
    let folder = folder("lock", SMALL);
    let sweep = trivial("[1]", "");
    let out = folder.join("sweep.csv");
    let first = open(&sweep, &out).unwrap();
    assert!(fails(&folder, &[]).contains("another `forage` is writing"));
    assert!(fails(&folder, &["--fresh"]).contains("another `forage` is writing"));
    let merged = folder.join("merged.csv");
    assert!(fails(&folder, &["--out", merged.to_str().unwrap(), "--merge", out.to_str().unwrap()]).contains("another `forage` is writing"));
    drop(first);
    fs::remove_file(&out).unwrap();
    carry_out(&folder, &[]);
}
