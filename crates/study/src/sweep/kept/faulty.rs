//! Disks that fail: after each fault the file is whole when the program starts again, and nothing that was said to be done is missing.

use std::{fs, path::Path, sync::atomic::AtomicBool};

use super::{
    super::{
        super::{
            disk::faults::{self, Fault, meets_every_fault},
            failure::Failure,
            runner::Control,
        },
        Curves, merge,
    },
    Kept, Part, Sweep,
    changed::sweep,
};

const PLAN: &str =
    "scenes = ['sphere']\nseeds = [3, 1, 2]\niterations = 1\n[[planner]]\nname = 'pso'\nparams = { population = 2, w = [0.4, 0.8] }";

fn carry_out(sweep: &Sweep, part: Part, path: &Path, curves: Option<&Path>, on_done: &(dyn Fn(u64) + Sync)) -> Result<(), Failure> {
    let mut curves = curves.map(|curves| Curves::open(curves, part, false)).transpose()?;
    let mut kept = Kept::open(sweep, part, path, false)?;
    // Each run is as much work as every other one.
    let each = sweep.work(part) / kept.counts().1 as u64;
    let progress = |done: u64, _| on_done(done / each);
    let control = Control { stop: &AtomicBool::new(false), progress: &progress };
    super::super::carry_out(sweep, &mut kept, curves.as_mut(), Some(1), None, &control)
}

/// Lines behind the heading that end.
fn lines(path: &Path) -> u64 {
    String::from_utf8_lossy(&fs::read(path).unwrap_or_default()).matches('\n').count().saturating_sub(1) as u64
}

#[test]
fn a_sweep_on_a_faulty_disk_loses_nothing() {
    let ours = sweep(PLAN);
    meets_every_fault(&|_| {}, &|folder, on_done| carry_out(&ours, Part::WHOLE, &folder.join("rows.csv"), None, on_done), &|folder| {
        lines(&folder.join("rows.csv"))
    });
}

#[test]
fn a_complete_file_on_a_read_only_disk_is_read_and_an_incomplete_one_says_why_not() {
    let _alone = faults::alone();
    let ours = sweep(PLAN);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rows.csv");
    carry_out(&ours, Part::WHOLE, &path, None, &|_| {}).unwrap();
    let whole = fs::read_to_string(&path).unwrap();
    faults::begin(Some((1, Fault::ReadOnly)));
    carry_out(&ours, Part::WHOLE, &path, None, &|_| {}).unwrap();
    faults::end();
    let half: String = whole.split_inclusive('\n').take(4).collect();
    for less in [half, whole[..whole.len() - 4].to_owned(), whole.replace("exhausted", "solved")] {
        fs::write(&path, &less).unwrap();
        faults::begin(Some((1, Fault::ReadOnly)));
        let problem = carry_out(&ours, Part::WHOLE, &path, None, &|_| {}).unwrap_err();
        faults::end();
        assert!(!matches!(problem, Failure::Interrupted { .. }), "{problem}");
        assert_eq!(fs::read_to_string(&path).unwrap(), less);
    }
}

#[test]
fn damaged_rows_are_mended_on_a_faulty_disk() {
    let ours = sweep(PLAN);
    let whole = tempfile::tempdir().unwrap();
    let path = whole.path().join("rows.csv");
    carry_out(&ours, Part::WHOLE, &path, None, &|_| {}).unwrap();
    let rows = fs::read_to_string(&path).unwrap();
    let mut lines_of: Vec<&str> = rows.split_inclusive('\n').collect();
    let damaged = lines_of[2].replace("exhausted", "solved");
    lines_of[2] = &damaged;
    lines_of.swap(3, 5);
    let damaged = lines_of.concat();
    meets_every_fault(
        &|folder| fs::write(folder.join("rows.csv"), &damaged).unwrap(),
        &|folder, on_done| carry_out(&ours, Part::WHOLE, &folder.join("rows.csv"), None, on_done),
        &|folder| lines(&folder.join("rows.csv")),
    );
    // Rows are compared and added by turns.
    meets_every_fault(
        &|folder| fs::write(folder.join("rows.csv"), &damaged).unwrap(),
        &|folder, on_done| carry_out(&ours, Part::WHOLE, &folder.join("rows.csv"), Some(&folder.join("curves.csv")), on_done),
        &|folder| lines(&folder.join("rows.csv")).min(lines(&folder.join("curves.csv.runs.csv"))),
    );
}

#[test]
fn parts_are_merged_on_a_faulty_disk() {
    let ours = sweep(PLAN);
    let parts = |folder: &Path| [1, 2].map(|k| folder.join(format!("{k}.csv")));
    let prepare = |folder: &Path| {
        for (k, path) in parts(folder).iter().enumerate() {
            carry_out(&ours, Part { index: k + 1, of: 2 }, path, None, &|_| {}).unwrap();
        }
    };
    let program = |folder: &Path, _: &(dyn Fn(u64) + Sync)| {
        let mut kept = Kept::open(&ours, Part::WHOLE, &folder.join("rows.csv"), false)?;
        let control = Control { stop: &AtomicBool::new(false), progress: &|_, _| {} };
        merge(&ours, &mut kept, None, &parts(folder), None, &control)
    };
    meets_every_fault(&prepare, &program, &|_| u64::MAX);
}

#[test]
fn curves_are_kept_on_a_faulty_disk() {
    let ours = sweep(PLAN);
    meets_every_fault(
        &|_| {},
        &|folder, on_done| carry_out(&ours, Part::WHOLE, &folder.join("rows.csv"), Some(&folder.join("curves.csv")), on_done),
        &|folder| lines(&folder.join("rows.csv")).min(lines(&folder.join("curves.csv.runs.csv"))),
    );
}
