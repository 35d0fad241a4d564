//! Whatever comes in, a reader refuses it with an error that says why, or what it has read is the same when it was written and read once
//! more.

use std::{str, sync::Arc};

use forage::{
    Error, Link, Run, Scene,
    kernel::ReferenceOptimum,
    run::{Task, handed_in},
    scene::{Formula, GridScene},
    standard,
};
use forage_formats::{Format, Imported, NamedFile, export, import};
use forage_study::{failure::Failure, sweep};

use super::{MOST_BYTES, check_refusal};

fn text(bytes: &[u8]) -> Option<&str> {
    str::from_utf8(bytes).ok().filter(|text| text.len() <= MOST_BYTES)
}

/// What is read from what was written.
fn check_scene(scene: &Scene) {
    let written = scene.to_json();
    let again = standard().read_scene(&written).unwrap_or_else(|error| panic!("{error}: {written}"));
    assert_eq!(again.to_json(), written);
    assert_eq!(&again, scene);
    if let Some((a, b)) = scene.ends() {
        // A place to begin is a place to stand.
        assert!(scene.is_free(a, a) && scene.is_free(b, b), "{written}");
    }
}

pub fn scene(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match standard().read_scene(text) {
        Ok(scene) => check_scene(&scene),
        Err(error) => check_refusal(&error),
    }
}

pub fn link(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match Link::parse(standard(), text) {
        Ok(link) => {
            let written = link.to_string();
            let again = Link::parse(standard(), &written).unwrap_or_else(|error| panic!("{error}: {written}"));
            assert_eq!(again.to_string(), written);
        }
        Err(error) => check_refusal(&error),
    }
}

/// What was imported is written in its format and in those that hold all of it, and read again.
fn imported(files: &[NamedFile], format: Format) -> Option<Imported> {
    let found = import(standard(), files, None).inspect_err(check_refusal).ok()?;
    check_scene(&found.scene);
    for format in [format, Format::Json] {
        match export(&found.scene, format, "again") {
            Ok(written) => {
                let again = import(standard(), &written.files, None).unwrap_or_else(|error| {
                    let files: Vec<_> = written.files.iter().map(|file| String::from_utf8_lossy(&file.bytes)).collect();
                    panic!("{error}: {files:?}")
                });
                assert_eq!(again.scene.kind(), found.scene.kind());
                assert_eq!(again.scene.ends().is_some(), found.scene.ends().is_some());
                assert_eq!(again.scene.stops().len(), found.scene.stops().len());
                if let (Ok(again), Ok(grid)) = (again.scene.get::<GridScene>(), found.scene.get::<GridScene>()) {
                    assert_eq!(again.lines(), grid.lines());
                }
            }
            Err(error) => check_refusal(&error),
        }
    }
    Some(found)
}

fn files(of: &[(&str, &[u8])]) -> Vec<NamedFile> {
    of.iter().map(|&(name, bytes)| NamedFile::new(name, bytes)).collect()
}

const MAP: &[u8] = b"type octile\nheight 4\nwidth 6\nmap\n..G.S.\n.@OT..\n...W..\n......\n";
const YAML: &[u8] = b"image: a.pgm\nresolution: 0.5\norigin: [0, 0, 0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";
const PGM: &[u8] = b"P2\n4 2\n255\n254 254 0 254\n205 254 0 254\n";
const TSP: &[u8] =
    b"NAME: five\nTYPE: TSP\nDIMENSION: 5\nEDGE_WEIGHT_TYPE: EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 4 0\n3 4 3\n4 0 3\n5 2 6\nEOF\n";

pub fn map(bytes: &[u8]) {
    if bytes.len() <= MOST_BYTES {
        imported(&files(&[("a.map", bytes)]), Format::MovingAi);
    }
}

pub fn scen(bytes: &[u8]) {
    let files = files(&[("a.map", MAP), ("a.map.scen", bytes)]);
    if let Some(found) = imported(&files, Format::MovingAi) {
        for k in 0..found.problems.len().min(8) {
            match import(standard(), &files, Some(k)) {
                Ok(other) => {
                    assert_eq!(other.scene.ends(), Some((found.problems[k].start, found.problems[k].goal)));
                    other.scene.exact_by(ReferenceOptimum::Cells);
                }
                // Its ends are in blocked cells, say.
                Err(error) => check_refusal(&error),
            }
        }
    }
}

pub fn yaml(bytes: &[u8]) {
    imported(&files(&[("a.yaml", bytes), ("a.pgm", PGM)]), Format::Ros);
    let _ = forage_formats::wanted(&files(&[("a.yaml", bytes)])).inspect_err(check_refusal);
}

pub fn pgm(bytes: &[u8]) {
    if bytes.len() <= MOST_BYTES {
        imported(&files(&[("a.yaml", YAML), ("a.pgm", bytes)]), Format::Ros);
    }
}

pub fn tsp(bytes: &[u8]) {
    if bytes.len() <= MOST_BYTES {
        imported(&files(&[("a.tsp", bytes)]), Format::Tsplib);
    }
}

pub fn tour(bytes: &[u8]) {
    if let Some(found) = imported(&files(&[("a.tsp", TSP), ("a.opt.tour", bytes)]), Format::Tsplib) {
        // No tour of these five is shorter than their convex hull.
        if let Some(best) = found.scene.optimum(ReferenceOptimum::default()) {
            assert!(best >= 15.0, "a tour of {best}");
        }
    }
}

pub fn csv(bytes: &[u8]) {
    if bytes.len() <= MOST_BYTES {
        imported(&files(&[("a.csv", bytes)]), Format::Csv);
    }
}

pub fn plan(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let load = |name: &str| -> Result<Arc<Scene>, Failure> { Ok(standard().scene(name)?) };
    match sweep::read::read(standard(), "plan.toml", "plan", text, &load) {
        Ok(found) => {
            let sweep = &found.sweep;
            assert!(!sweep.is_empty());
            // Any run of it can be said.
            for k in [0, sweep.len() / 2, sweep.len() - 1] {
                sweep.setup(k);
            }
        }
        Err(failure) => assert!((10..2 * MOST_BYTES + 4000).contains(&failure.to_string().len()), "{failure:.200}"),
    }
}

/// Tasks, by themselves and as lessons have them.
pub fn task(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    match Task::read(standard(), text) {
        Ok(task) => {
            assert!(task.evaluations.is_none_or(|evaluations| evaluations > 0));
            for link in ["#v=1&planner=pso&scene=sphere&seed=1&at=2&p.population=4", "#v=1&planner=sa&scene=open-12&seed=1&at=1&hash=0"] {
                let Ok(link) = Link::parse(standard(), link) else { panic!("{link} is a link") };
                let judgement = task.judge(standard(), &link).unwrap_or_else(|error| panic!("{error}"));
                // What was not reached, or is not as it is given, has a reason.
                assert!(judgement.reached && judgement.verified || !judgement.reasons.is_empty());
                assert!(!judgement.reached || task.evaluations.is_none_or(|most| judgement.evaluations <= most));
            }
        }
        Err(error) => check_refusal(&error),
    }
}

pub fn grading_list(bytes: &[u8]) {
    let Some(text) = text(bytes) else { return };
    let mut last = 0;
    for one in handed_in(text) {
        assert!(one.line > last && text.contains(one.link) && text.contains(one.name));
        last = one.line;
        let _ = Run::from_link(standard(), one.link).inspect_err(check_refusal);
    }
}

pub fn expression(bytes: &[u8]) {
    let Some((&dimension, rest)) = bytes.split_first() else { return };
    let Some(text) = text(rest) else { return };
    let dimension = usize::from(dimension % 7);
    match Formula::new(text, dimension) {
        Ok(formula) => {
            let xs: Vec<f64> = (0..4 * dimension).map(|i| [0.0, -1.5, 2.0, 1e9, -1e-9, 0.25][i % 6]).collect();
            let (mut room, mut out) = (Vec::new(), [0.0; 4]);
            formula.values(&xs, &mut room, &mut out);
            // One by one they have the same bits.
            for (x, together) in xs.chunks(dimension).zip(out) {
                assert_eq!(formula.value(x, &mut room).to_bits(), together.to_bits(), "{text}");
            }
            let again = Formula::new(formula.text(), dimension).unwrap_or_else(|error: Error| panic!("{error}: {text}"));
            assert_eq!(again.value(&xs[..dimension], &mut room).to_bits(), out[0].to_bits(), "{text}");
        }
        Err(error) => check_refusal(&error),
    }
}
