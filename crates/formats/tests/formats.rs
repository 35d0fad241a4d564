//! Other programs' files over the public face: round trips and fuzzing.
#![cfg(not(target_arch = "wasm32"))]

#[path = "../../../tests/support/generated.rs"]
mod generated;

use forage::{
    Error, Overrides, Scene, Value,
    describe::Generator,
    kernel::{ReferenceOptimum, TourEnds},
    scene::{GRID, GridScene, TourScene},
    standard,
};
use forage_formats::{Format, NamedFile, export, import, wanted};
use generated::{GENERATED, digest};
use proptest::prelude::*;

/// The generators of grids.
fn grids() -> Vec<&'static Generator> {
    standard().generators_of(GRID).collect()
}

fn small(generator: usize, columns: usize, rows: usize, seed: u64) -> Scene {
    let sides = [("columns", columns), ("rows", rows)].map(|(name, side)| (name, Value::from(side as f64)));
    standard().generate(grids()[generator].name, &Overrides::from_iter(sides), seed).unwrap()
}

#[test]
fn every_generator_gives_the_stored_grid() {
    assert_eq!(GENERATED.len(), grids().len());
    for (i, expected) in GENERATED.iter().enumerate() {
        let scene = small(i, 31, 22, 7);
        assert_eq!(digest(&scene.get::<GridScene>().unwrap().lines().join("\n")), *expected, "{}", scene.name());
    }
}

/// What a grid can be written as.
const OF_GRIDS: [Format; 3] = [Format::MovingAi, Format::Ros, Format::Json];

/// What stops can be written as.
const OF_TOURS: [Format; 3] = [Format::Tsplib, Format::Csv, Format::Json];

/// Random stops by one of TSPLIB's metrics, or else by a matrix, with places or without.
fn stops(n: usize, metric: usize, seed: u64) -> Scene {
    let given = Overrides::from_iter([("stops", Value::from(n as f64)), ("side", Value::from(60.0))]);
    let mut text = standard().generate("stops", &given, seed).unwrap().to_json();
    if let Some(metric) = ["euclidean", "euc-2d", "ceil-2d", "att", "geo"].get(metric) {
        text = text.replace("\"euc-2d\"", &format!("\"{metric}\""));
    } else {
        let row = |i: usize| (0..n).map(|j| (i.abs_diff(j) as u64 * (seed % 97 + 1)).to_string()).collect::<Vec<_>>().join(", ");
        let rows: Vec<_> = (0..n).map(|i| format!("[{}]", row(i))).collect();
        let matrix = format!("\"matrix\": [{}]", rows.join(", "));
        text = text.replace("\"metric\": \"euc-2d\"", &matrix);
        if metric > 5 {
            text = text.split("\"points\"").next().unwrap().to_owned() + &matrix + "}";
        }
    }
    standard().read_scene(&text).unwrap()
}

/// The error of a refusal must name a field and say something about it.
fn said(error: &Error) -> bool {
    let message = error.to_string();
    !error.field().is_empty() && !error.allowed().is_empty() && message.len() > error.field().len() + 2
}

/// A file of each sort that is in order, with its partner.
fn valid() -> Vec<Vec<NamedFile>> {
    let scene = small(0, 9, 7, 4);
    let picture = "P2\n# by hand\n3 2\n15\n15 0 7\n15 15 15 ";
    let yaml = "image: \"a.pgm\" # its picture\nmode: scale\nresolution: 0.05\norigin:\n- -1\n- 0\n- 0.5\nnegate: 0\nfree_thresh: 0.25\n";
    let mut all: Vec<_> = OF_GRIDS.map(|format| export(&scene, format, "a").unwrap().files).into();
    all.push(vec![NamedFile::new("a.yaml", yaml), NamedFile::new("a.pgm", picture)]);
    for (metric, formats) in [(4, &OF_TOURS[..2]), (5, &OF_TOURS[..1])] {
        all.extend(formats.iter().map(|&format| export(&stops(6, metric, 5), format, "a").unwrap().files));
    }
    let half = "NAME: h\nTYPE: TSP\nDIMENSION: 3\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: UPPER_ROW\nEDGE_WEIGHT_SECTION\n3 4 5\n";
    all.push(vec![NamedFile::new("a.tsp", half), NamedFile::new("a.opt.tour", "TYPE : TOUR\nTOUR_SECTION\n1 3 2 -1\nEOF\n")]);
    all
}

/// How many `valid` makes.
const VALID: usize = 8;

#[test]
fn the_valid_files_are_valid() {
    let all = valid();
    assert_eq!(all.len(), VALID);
    for files in all {
        assert!(import(standard(), &files, None).is_ok(), "{files:?}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    /// Cells and ends survive; ROS has no place for ends, and y grows upwards there.
    #[test]
    fn what_is_written_is_read_back(generator in 0..grids().len(), columns in 1_usize..40, rows in 1_usize..40, seed in 0_u64..1 << 40) {
        let scene = small(generator, columns, rows, seed);
        for format in OF_GRIDS {
            let files = export(&scene, format, "a map").unwrap().files;
            prop_assert!(wanted(&files).unwrap().is_none());
            let read = import(standard(), &files, None).unwrap();
            let (was, is) = (scene.get::<GridScene>().unwrap(), read.scene.get::<GridScene>().unwrap());
            prop_assert_eq!(was.lines(), is.lines());
            prop_assert!(format == Format::Ros || was == is);
            if format == Format::MovingAi {
                prop_assert_eq!(read.scene.exact_by(ReferenceOptimum::Cells).unwrap().length, read.problems[0].length);
            }
            // And once more, from what was read.
            let again = export(&read.scene, format, "a map").unwrap().files;
            prop_assert_eq!(&files, &again);
        }
    }

    /// Places, distances and the shortest tour survive, but for what CSV has no place for.
    #[test]
    fn stops_that_are_written_are_read_back(n in 2_usize..20, metric in 0..7_usize, seed in 0_u64..1 << 40) {
        let scene = stops(n, metric, seed);
        let was = scene.get::<TourScene>().unwrap();
        for format in OF_TOURS {
            if metric == 6 && format == Format::Csv {
                let error = export(&scene, format, "a").unwrap_err();
                prop_assert_eq!(error.field(), "points");
                continue;
            }
            let files = export(&scene, format, "a").unwrap().files;
            let read = import(standard(), &files, None).unwrap();
            let is = read.scene.get::<TourScene>().unwrap();
            prop_assert_eq!(&was.points, &is.points);
            if format != Format::Csv {
                // Rounded where it was not.
                let rounded = if metric == 0 && format == Format::Tsplib { 0.5 } else { 0.0 };
                for (was, is) in was.distances().rows().flatten().zip(is.distances().rows().flatten()) {
                    prop_assert!((was - is).abs() <= rounded);
                }
                let [was, is] = [&scene, &read.scene].map(|scene| scene.exact_tour(ReferenceOptimum::default(), TourEnds::Closed).map(|exact| exact.length));
                prop_assert!(metric == 0 || was == is, "{was:?} {is:?}");
            }
            if metric > 0 {
                prop_assert_eq!(&files[0], &export(&read.scene, format, "a").unwrap().files[0]);
            }
        }
    }

    #[test]
    fn random_bytes_are_refused_with_a_reason_or_read(
        name in 0..10_usize, head in 0..8_usize, bytes in proptest::collection::vec(any::<u8>(), 0..200), partner in 0..VALID,
    ) {
        let name = ["a.map", "a.scen", "a.yaml", "a.pgm", "a.json", "a.tsp", "a.tour", "a.csv", "a", ""][name];
        let head: &[u8] = [b"" as &[u8], b"type octile\nheight 3\nwidth 3\nmap\n", b"version 1\n0\ta.map\t3\t3\t", b"P5 3 3 255\n", b"image: a.pgm\n", b"TYPE : TSP\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : GEO\nNODE_COORD_SECTION\n", b"TYPE : TOUR\nTOUR_SECTION\n", b"x,y\n"][head];
        let mut files = vec![NamedFile::new(name, [head, &bytes].concat())];
        files.extend(valid()[partner].iter().filter(|file| file.name != name).cloned());
        for count in 1..=files.len() {
            if let Err(error) = import(standard(), &files[..count], None) {
                prop_assert!(said(&error), "{error:?}");
            }
            let _ = wanted(&files[..count]);
        }
    }

    #[test]
    fn a_valid_file_with_some_bytes_changed_is_refused_with_a_reason_or_read(
        which in 0..VALID, part in 0..2_usize,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), 0..4_u8, prop::sample::select(&b"0 9-.\n\t:[]\"'#@x\xff\x00e+"[..])), 1..5),
    ) {
        let mut files = valid().swap_remove(which);
        let part = part % files.len();
        let bytes = &mut files[part].bytes;
        for (index, kind, byte) in changes {
            let at = index.index(bytes.len().max(1)).min(bytes.len());
            match kind {
                0 => bytes.insert(at, byte),
                1 => bytes.truncate(at),
                2 if at < bytes.len() => drop(bytes.remove(at)),
                _ => if let Some(there) = bytes.get_mut(at) { *there = byte },
            }
        }
        match import(standard(), &files, None) {
            Ok(read) => prop_assert_eq!(standard().read_scene(&read.scene.to_json()).unwrap(), read.scene),
            Err(error) => prop_assert!(said(&error), "{error:?}"),
        }
    }
}
