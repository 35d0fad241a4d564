//! Files that were changed: nothing of it is accepted.

use std::{
    fs,
    path::Path,
    sync::{Arc, atomic::AtomicBool},
};

use forage::{kernel::rng::Stream, shipped, standard};

use super::{
    super::{
        super::{digest, failure::Failure, runner::Control},
        merge, read,
    },
    Kept, Part, Sweep,
};

const PLAN: &str =
    "scenes = ['sphere', 'matyas']\nseeds = [3, 1]\niterations = 1\n[[planner]]\nname = 'pso'\nparams = { population = [2, 3] }";

pub(super) fn sweep(text: &str) -> Sweep {
    read::read(standard(), "sweep.toml", "sweep", text, &|name| Ok(shipped(name)?)).unwrap().sweep
}

/// What the program does with a file, and what it says.
pub(super) fn carry_out(sweep: &Sweep, path: &Path, verify: Option<f64>) -> Result<Vec<String>, Failure> {
    let mut kept = Kept::open(sweep, Part::WHOLE, path, false)?;
    let control = Control { stop: &AtomicBool::new(false), progress: &|_, _| {} };
    super::super::carry_out(sweep, &mut kept, None, Some(1), verify, &control)?;
    Ok(kept.notes().to_vec())
}

fn merged(sweep: &Sweep, path: &Path, part: &Path, verify: Option<f64>) -> Result<Vec<String>, Failure> {
    let mut kept = Kept::open(sweep, Part::WHOLE, path, false)?;
    let control = Control { stop: &AtomicBool::new(false), progress: &|_, _| {} };
    merge(sweep, &mut kept, None, &[part.to_owned()], verify, &control)?;
    Ok(kept.notes().to_vec())
}

/// A place between two numbers, the second one excluded.
fn from_to(rng: &mut Stream, low: usize, high: usize) -> usize {
    low + rng.below(high - low)
}

/// One of the things that happen to files.
fn changed(whole: &[u8], others: &[Vec<u8>], rng: &mut Stream) -> Vec<u8> {
    let mut bytes = whole.to_vec();
    let mut lines: Vec<Vec<u8>> = whole.split_inclusive(|&byte| byte == b'\n').map(<[u8]>::to_vec).collect();
    let at = rng.below(bytes.len());
    let (one, other) = (rng.below(lines.len()), rng.below(lines.len()));
    match rng.below(12) {
        0..=2 => bytes[at] ^= 1 << rng.below(8),
        3 => bytes[at] = rng.below(256) as u8,
        4 => bytes.truncate(at),
        5 => drop(bytes.drain(at..from_to(rng, at, whole.len()))),
        6 => drop(bytes.splice(at..at, (0..=rng.below(40)).map(|_| rng.below(256) as u8).collect::<Vec<_>>())),
        7 => {
            let piece = bytes[at..from_to(rng, at, whole.len())].to_vec();
            let to = rng.below(bytes.len());
            drop(bytes.splice(to..to, piece));
        }
        8 => {
            lines.swap(one, other);
            bytes = lines.concat();
        }
        9 => {
            let line = lines[one].clone();
            lines.insert(other, line);
            bytes = lines.concat();
        }
        10 => {
            lines.remove(one);
            bytes = lines.concat();
        }
        // A row of another plan, or what stands in one place of a row in another row.
        _ => {
            if rng.below(2) == 0 {
                lines[one].clone_from(&others[rng.below(others.len())]);
            } else {
                let [mut a, b] = [one, other].map(|k| lines[k].split(|&byte| byte == b',').map(<[u8]>::to_vec).collect::<Vec<_>>());
                let place = rng.below(a.len());
                a[place].clone_from(&b[place.min(b.len() - 1)]);
                lines[one] = a.join(&b',');
            }
            bytes = lines.concat();
        }
    }
    bytes
}

#[test]
fn of_two_thousand_changes_none_is_accepted() {
    let folder = tempfile::tempdir().unwrap();
    let (ours, other) = (sweep(PLAN), sweep(&PLAN.replace("iterations = 1", "iterations = 2")));
    let mut rng = Stream::new(27, 0);
    let (mut restored, mut refused) = (0, 0);
    for name in ["rows.csv", "rows.jsonl"] {
        let [path, others, target] =
            [name.to_owned(), format!("others-{name}"), format!("merged-{name}")].map(|name| folder.path().join(name));
        carry_out(&ours, &path, None).unwrap();
        carry_out(&other, &others, None).unwrap();
        let whole = fs::read(&path).unwrap();
        let others: Vec<Vec<u8>> = fs::read(&others).unwrap().split_inclusive(|&byte| byte == b'\n').map(<[u8]>::to_vec).collect();
        let heading = if whole[0] == b'{' { 0 } else { whole.iter().position(|&byte| byte == b'\n').unwrap_or(0) + 1 };
        let mut changes = 0;
        while changes < 1000 {
            let bytes = changed(&whole, &others, &mut rng);
            if bytes == whole {
                continue;
            }
            changes += 1;
            let shown = || String::from_utf8_lossy(&bytes).into_owned();
            fs::write(&path, &bytes).unwrap();
            assert!(merged(&ours, &target, &path, None).is_err(), "merged: {}", shown());
            assert!(!target.exists(), "nothing is made of it: {}", shown());
            if let Ok(notes) = carry_out(&ours, &path, None) {
                assert!(fs::read(&path).unwrap() == whole, "accepted: {}", shown());
                // An empty file, or one with nothing but its heading, is one that was just made.
                assert!(!notes.is_empty() || bytes.len() <= heading, "nothing is said: {}", shown());
                restored += 1;
            } else {
                assert!(fs::read(&path).unwrap() == bytes, "refused, and yet written: {}", shown());
                refused += 1;
            }
            for entry in fs::read_dir(folder.path()).unwrap().map(Result::unwrap) {
                if entry.path().extension().is_some_and(|ending| ending == "bad") {
                    fs::remove_file(entry.path()).unwrap();
                }
            }
        }
    }
    assert_eq!(restored + refused, 2000);
    // Most of it is mended, and not just refused.
    assert!(restored > 1500, "{restored} restored, {refused} refused");
}

/// A digest is no seal against somebody who computes it, too.
#[test]
fn a_row_that_was_made_up_is_found_when_it_is_verified() {
    let folder = tempfile::tempdir().unwrap();
    let [path, target] = ["rows.csv", "merged.csv"].map(|name| folder.path().join(name));
    let ours = sweep(PLAN);
    carry_out(&ours, &path, None).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    assert_eq!(carry_out(&ours, &path, Some(0.5)).unwrap().join(""), "4 of 8 rows were computed again, and came out the same");
    let line = whole.lines().nth(2).unwrap();
    let (row, _) = line.rsplit_once(',').unwrap();
    let row = row.replace("exhausted", "solved");
    let forged = format!("{row},{}", digest::of(&ours.origins[0], row.as_bytes()));
    fs::write(&path, whole.replace(line, &forged)).unwrap();
    for problem in [carry_out(&ours, &path, Some(1.0)), merged(&ours, &target, &path, Some(1.0))] {
        let problem = problem.unwrap_err().to_string();
        assert!(problem.contains("now gives another row"), "{problem}");
    }
    assert!(!target.exists());
}

#[test]
fn rows_without_digests_and_of_another_scene_are_refused_with_the_reason() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rows.csv");
    let ours = sweep(PLAN);
    carry_out(&ours, &path, None).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    let old: String = whole.lines().map(|line| line.rsplit_once(',').unwrap().0.to_owned() + "\n").collect();
    fs::write(&path, &old).unwrap();
    let problem = carry_out(&ours, &path, None).unwrap_err().to_string();
    assert!(problem.contains("its rows have no digests") && problem.contains("--fresh"), "{problem}");
    assert_eq!(fs::read_to_string(&path).unwrap(), old);
    // The same name, and another scene.
    let plan = PLAN.replace(", 'matyas'", "");
    fs::remove_file(&path).unwrap();
    carry_out(&sweep(&plan), &path, None).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    let load = |name: &str| {
        let scene = shipped(name)?.to_json().replace("Sphere,", "A sphere,");
        Ok(Arc::new(standard().read_scene(&scene)?))
    };
    let other = read::read(standard(), "sweep.toml", "sweep", &plan, &load).unwrap().sweep;
    let problem = carry_out(&other, &path, None).unwrap_err().to_string();
    assert!(problem.contains("line 2: it does not fit its digest") && problem.contains("another scene"), "{problem}");
    assert_eq!(fs::read_to_string(&path).unwrap(), whole);
}

/// Rows that would be those of other runs if their columns were called otherwise.
#[test]
fn rows_of_a_plan_with_other_columns_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let plan = |first: &str, second: &str| {
        format!(
            "scenes = ['sphere']\nseeds = [1, 2]\niterations = 1\n[[planner]]\nname = 'pso'\nparams = {{ population = 3, {first} = [1.5, 1], {second} = [1.5, 1] }}"
        )
    };
    for name in ["rows.csv", "rows.jsonl"] {
        let path = folder.path().join(name);
        carry_out(&sweep(&plan("c1", "c2")), &path, None).unwrap();
        let whole = fs::read(&path).unwrap();
        for (first, second) in [("c2", "c1"), ("c1", "w")] {
            assert!(carry_out(&sweep(&plan(first, second)), &path, None).is_err(), "{name} {first} {second}");
            assert!(fs::read(&path).unwrap() == whole);
        }
    }
}

/// What only looks like rows, or what a loss of power might have left of them.
#[test]
fn files_of_others_are_neither_cut_nor_taken() {
    let folder = tempfile::tempdir().unwrap();
    let ours = sweep(PLAN);
    for (name, bytes) in [
        ("rows.csv", &b"\0binary of somebody"[..]),
        ("rows.jsonl", b"{\"scene\":\"my own data\",\"x\":1}"),
        ("rows.csv", b"my notes"),
        ("rows.csv", b"x,y\n1,2\n3,4"),
    ] {
        let path = folder.path().join(name);
        fs::write(&path, bytes).unwrap();
        assert!(carry_out(&ours, &path, None).is_err(), "{name}");
        assert_eq!(fs::read(&path).unwrap(), bytes);
        assert!(crate::sweep::Curves::open(&folder.path().join("c.csv"), Part::WHOLE, false).is_ok());
        let kept = folder.path().join("c.csv.runs.csv");
        fs::write(&kept, bytes).unwrap();
        for fresh in [false, true] {
            assert!(
                crate::sweep::Curves::open(&folder.path().join("c.csv"), Part::WHOLE, fresh).is_err() || bytes.starts_with(b"x,y"),
                "{name}"
            );
            assert_eq!(fs::read(&kept).unwrap(), bytes);
        }
        fs::remove_file(&kept).unwrap();
    }
    let zeros = folder.path().join("zeros.csv");
    fs::write(&zeros, [0; 700]).unwrap();
    carry_out(&ours, &zeros, None).unwrap();
}
