//! What is read from each format, what is refused, and with which words.

use forage::{exact::shortest_over_cells, geometry::YAxis, kernel::ReferenceOptimum, scene::GridScene, shipped, standard};

use super::{report::joined, *};

fn file(name: &str, bytes: impl AsRef<[u8]>) -> NamedFile {
    NamedFile::new(name, bytes.as_ref())
}

/// A map with every kind of cell.
const MAP: &str = "type octile\nheight 4\nwidth 6\nmap\n..G.S.\n.@OT..\n...W..\n......\n";

/// Its problems. The second, by hand: from (0, 0) to (5, 3) the blocked cells (1..4, 1) and (3, 2) may not be cut at their
/// corners. Down the left side: 2 down, then (0, 2) → (1, 3) diagonal, as (0, 3) and (1, 2) are free, then 4 right:
/// 6 + √2. Along the top: 4 right, then (4, 0) → (5, 1) diagonal, as (5, 0) and (4, 1) are free, 2 down: 6 + √2 as well.
/// No way has two diagonal steps, which would make 4 + 2√2: it would have to pass a corner.
const SCEN: &str = "version 1\n0\ttest.map\t6\t4\t0\t0\t0\t3\t3\n1\ttest.map\t6\t4\t0\t0\t5\t3\t7.41421356\n";

const YAML: &str =
    "image: test.pgm  # a comment\nresolution: 0.05\norigin: [-1.5, 2, 0.0]\nnegate: 0\n\noccupied_thresh: 0.65\nfree_thresh: 0.196\n";

const PGM: &str = "P2\n# made by hand\n4 2\n255\n254 254 0 254\n205 254 0 254\n";

fn rows(imported: &Imported) -> Vec<String> {
    imported.scene.get::<GridScene>().unwrap().lines()
}

#[test]
fn a_map_and_its_problems_are_read_and_the_exact_search_finds_their_optima() {
    let files = [file("some/folder/test.map", MAP), file("test.map.scen", SCEN)];
    let read = import(standard(), &files, None).unwrap();
    assert_eq!(rows(&read), ["......", ".###..", "...#..", "......"]);
    assert_eq!(read.scene.ends(), Some(([0.5, 0.5], [5.5, 3.5])));
    assert_eq!((read.scene.name(), read.problems.len()), ("test", 2));
    for (text, part) in read.notes.iter().zip(["1 cells are swamp", "1 cells are water", "Problem 1 of 2"]) {
        assert!(text.text().contains(part), "{text}");
    }
    for (i, problem) in read.problems.iter().enumerate() {
        let scene = import(standard(), &files, Some(i)).unwrap().scene;
        assert_eq!(scene.ends(), Some((problem.start, problem.goal)));
        let exact = scene.exact_by(ReferenceOptimum::Cells).unwrap().length;
        assert!((exact - problem.length).abs() < 1e-8, "{exact} {problem:?}");
    }
    assert!(import(standard(), &files, Some(2)).unwrap_err().allowed().contains("from 0 to 1"));
}

#[test]
fn a_map_without_ends_gets_them_far_apart_in_its_largest_region() {
    let read = import(standard(), &[file("a.map", "type octile\nheight 3\nwidth 6\nmap\n.@....\n@@@@@.\n.T....\n")], None).unwrap();
    assert_eq!(read.scene.ends(), Some(([2.5, 0.5], [2.5, 2.5])), "{:?}", read.notes);
    assert!(read.notes[0].text().contains("(2.5, 0.5)"));
    // The same picture, but y grows upwards: reading order begins at the top all the same.
    let picture = "P2 6 3 1 1 0 1 1 1 1 0 0 0 0 0 1 1 0 1 1 1 1";
    let read = import(standard(), &[file("a.yaml", "image: a.pgm\nresolution: 2"), file("a.pgm", picture)], None).unwrap();
    assert_eq!(rows(&read), [".#....", "#####.", ".#...."]);
    assert_eq!(read.scene.ends(), Some(([5.0, 5.0], [5.0, 1.0])));
}

#[test]
fn an_occupancy_grid_is_read_with_its_thresholds() {
    let read = |yaml: &str, picture: &[u8]| import(standard(), &[file("map/test.yaml", yaml), file("test.pgm", picture)], None).unwrap();
    let plain = read(YAML, PGM.as_bytes());
    assert_eq!(rows(&plain), ["..#.", "#.#."]);
    let grid = plain.scene.get::<GridScene>().unwrap();
    assert_eq!((grid.cell, grid.y_axis, plain.scene.header().units.as_deref()), (0.05, YAxis::Up, Some("m")));
    assert!(plain.notes[0].text().contains("(-1.5, 2)") && plain.notes[1].text().contains("1 of 8 cells are unknown"), "{:?}", plain.notes);
    let negated = read(&YAML.replace("negate: 0", "negate: True"), PGM.as_bytes());
    assert_eq!(rows(&negated), ["##.#", "##.#"], "205 is blocked, not unknown");
    let scale = read(&format!("{YAML}mode: 'scale'\n"), PGM.as_bytes());
    assert!(scale.notes[1].text().contains("1 of 8 cells are partly occupied"), "{:?}", scale.notes);
    // Raw: 0 is free, 60 between, 100 occupied, 255 unknown.
    let raw = read(&format!("{YAML}mode: \"raw\"\n"), b"P5 4 1 255 \x00\x3c\x64\xff");
    assert_eq!(rows(&raw), [".###"]);
    assert!(raw.notes[1].text().contains("2 of 4"), "{:?}", raw.notes);
    // Two bytes a pixel, the high one first; a list below its key; what is not known is noted.
    let yaml = "image: 'test.pgm'\nresolution: 1\norigin:\n  - 0\n  - 0\n  - 1.5 # turned\nfree_thresh: 0.25\nsensor: lidar\n";
    let ended = read(yaml, b"P5\r\n2 1\r\n255\r\n\xfe\x00");
    assert_eq!(rows(&ended), [".#"], "a heading whose lines end in two bytes");
    let wide = read(yaml, b"P5\n2 2\n65535\n\xff\xff\x00\x00\xc0\x00\xbf\xff\n");
    assert_eq!(rows(&wide), [".#", ".#"]);
    let notes = joined(&wide.notes);
    for part in ["1.5 rad", "Line 8 of test.yaml, `sensor`", "last 1 bytes", "1 of 4 cells"] {
        assert!(notes.contains(part), "{notes}");
    }
    assert_eq!(wide.scene.header().note.as_ref(), Some(&notes));
}

#[test]
fn every_malformed_file_is_refused_with_its_name_the_line_and_the_reason() {
    let map = |from: &str, to: &str| vec![file("a.map", MAP.replacen(from, to, 1))];
    let scen = |from: &str, to: &str| vec![file("test.map", MAP), file("a.scen", SCEN.replacen(from, to, 1))];
    let yaml = |from: &str, to: &str| vec![file("a.yaml", YAML.replacen(from, to, 1)), file("test.pgm", PGM)];
    let pgm = |from: &str, to: &str| vec![file("test.yaml", YAML), file("a.pgm", PGM.replacen(from, to, 1))];
    let bytes = |bytes: &[u8]| vec![file("test.yaml", YAML), file("a.pgm", bytes)];
    let cases = [
        (map("octile", "tile"), "line 1: found `type tile`, expected `type octile`"),
        (map("type octile\n", ""), "line 3: `map` before all of"),
        (map("4", "0"), "line 2: found `0`, expected a height from 1 to 2048"),
        (map("4", "-4"), "line 2: found `-4`"),
        (map("6", "2049"), "line 3: found `2049`, expected a width from 1 to 2048"),
        (map("height 4\n", ""), "line 3: `map` before"),
        (map("width 6", "columns 6"), "line 3: found `columns 6`"),
        (map(MAP, ""), "line 1: the file ends before the line `map`"),
        (map("G.S", "G#S"), "line 5: found `#`, expected one of . G S @ O T W in column 4"),
        (map("G.S", "GäS"), "line 5: found `ä`"),
        (map(".@OT..", ".@OT."), "line 6: found 5 cells, expected 6"),
        (map(".@OT..", ".@OT..."), "line 6: found 7 cells, expected 6"),
        (map("......\n", ""), "line 8: the file ends after 3 rows, expected 4"),
        (map("......\n", "......\n\n.\n"), "line 10: found `.`, expected the end of the file after 4 rows"),
        (vec![file("a.map", b"type octile\nheight \xff\n")], "line 2: bytes that are no text"),
        (vec![file("a.map", "type octile\nheight 1\nwidth 2\nmap\nTT\n")], "no cell of the map is free"),
        (scen("version 1", "version 2"), "line 1: found `version 2`, expected `version 1`"),
        (scen("version 1\n", ""), "line 1: found `0\ttest.map"),
        (scen(SCEN, "version 1.0\n\n"), "line 2: the file ends before the first problem"),
        (scen("\t3\n", "\n"), "line 2: found 8 fields, expected 9"),
        (scen("1\ttest.map", "1\tother.map"), "line 3: found `other.map`, expected test.map, as above"),
        (scen("\t6\t4", "\t12\t4"), "line 2: found `12`, expected 6, the map's width"),
        (scen("\t6\t4", "\t6\tx"), "line 2: found `x`, expected 4, the map's height"),
        (scen("5\t3\t7", "6\t3\t7"), "line 3: found `6`, expected a goal's column from 0 to 5"),
        (scen("5\t3\t7", "5\t-3\t7"), "line 3: found `-3`, expected a goal's row from 0 to 3"),
        (scen("7.41421356", "nan"), "line 3: found `nan`, expected a length in cells"),
        (scen("7.41421356", "-1"), "line 3: found `-1`"),
        (scen("0\t0\t5", "1\t1\t5"), "line 3: the start is in a blocked cell of test.map"),
        (scen("5\t3\t7", "3\t2\t7"), "line 3: the goal is in a blocked cell"),
        (yaml("image: test.pgm", ""), "line 8: the file ends without `image:`"),
        (yaml("image: test.pgm", "image:"), "line 1: `image` has 0 values, expected the name of a .pgm file"),
        (yaml("resolution: 0.05\n", ""), "line 7: the file ends without `resolution:`"),
        (yaml("0.05", "0"), "line 2: found `0`, expected for resolution a number from 0.000001"),
        (yaml("0.05", "5 cm"), "line 2: found `5 cm`"),
        (yaml("0.05", "1e999"), "line 2: found `1e999`"),
        (yaml("0.05", "\"0.05"), "line 2: found `\"0.05`, expected a text between two quotes"),
        (yaml("[-1.5, 2, 0.0]", "[-1.5, 2]"), "line 3: found `-1.5, 2`, expected for origin three numbers"),
        (yaml("[-1.5, 2, 0.0]", "[-1.5, 2, 0.0"), "line 3: found `[-1.5, 2, 0.0`, expected a list with `]`"),
        (yaml("negate: 0", "negate: 2"), "line 4: found `2`, expected for negate 0 or 1"),
        (yaml("negate: 0", "mode: dual"), "line 4: found `dual`, expected for mode trinary, scale or raw"),
        (yaml("negate: 0", "resolution: 1"), "line 4: `resolution` again, first in line 2"),
        (yaml("negate: 0", "negate 0"), "line 4: found `negate 0`, expected `key: value`"),
        (yaml("negate: 0", "  negate: 0"), "line 4: found `  negate: 0`, expected `key: value`, not indented"),
        (yaml("negate: 0", "- 3"), "line 4: found `- 3`, expected a list's key"),
        (yaml("0.65", "65"), "line 6: found `65`, expected for occupied_thresh a number from 0 to 1"),
        (yaml("0.196", "0.7"), "line 7: free_thresh is 0.7, expected at most occupied_thresh, 0.65"),
        (yaml("0.196", "0"), "test.pgm: no cell of the map is free"),
        (yaml("0.05", "1000000"), "line 2: resolution is 1000000, expected at most 250000"),
        (pgm("P2", "P6"), "line 1: found `P6`, expected P2 or P5"),
        (pgm("4 2", "4 x"), "line 3: found `x`, expected a height from 1 to 2048"),
        (pgm("4 2", "4000 2"), "line 3: found `4000`, expected a width from 1 to 2048"),
        (pgm("\n255", "\n70000"), "line 4: found `70000`, expected the value of white from 1 to 65535"),
        (pgm("205", "256"), "line 6: found `256`, expected a pixel from 0 to 255"),
        (pgm("205", ""), "line 7: the file ends, expected a pixel"),
        (bytes(b"P5\n3 2\n255\n12345"), "line 4: found 5 bytes of pixels, expected 6"),
        (bytes(b"P5\n3 1\n100\nab\xc8"), "line 4: found `200`, expected a pixel from 0 to 100 in row 1, column 3"),
        (bytes(b"P5 1 1 255"), "line 1: found 0 bytes of pixels, expected 1"),
        (bytes(b""), "line 1: found ``, expected P2 or P5"),
        (vec![file("a.scen", SCEN)], "the file `test.map` that belongs to it is missing"),
        (vec![file("a.yaml", YAML)], "the file `test.pgm` that belongs to it is missing"),
        (vec![file("some/a.pgm", PGM)], "the file `a.yaml` that belongs to it is missing"),
        (vec![file("a.map", MAP), file("test.yaml", YAML), file("test.pgm", PGM)], "one scene at a time"),
        (vec![file("test.map", MAP), file("a.map", MAP)], "of the same sort as test.map: one scene at a time"),
        (vec![file("a.png", b"\x89PNG")], "line 1: neither a MovingAI .map or .scen"),
        (vec![file("a.json", "{")], "not JSON"),
        (vec![], "files: nothing is not allowed"),
    ];
    for (files, part) in cases {
        let error = import(standard(), &files, None).unwrap_err();
        let message = error.to_string();
        assert!(message.contains(part), "{message}\nshould say\n{part}");
        assert!(matches!(error.field(), "scene" | "files" | "test.pgm") || error.field().starts_with("a."), "{message}");
    }
    assert!(import(standard(), &map("", ""), Some(0)).unwrap_err().to_string().contains("problem: 0"));
    assert_eq!(wanted(&[file("a.scen", SCEN)]).unwrap().as_deref(), Some("test.map"));
    assert_eq!(wanted(&map("", "")).unwrap(), None);
}

#[test]
fn files_are_recognised_by_what_is_in_them_and_other_names_are_noted() {
    let read = import(standard(), &[file("one", SCEN), file("two", MAP)], Some(0)).unwrap();
    assert!(read.notes.iter().any(|note| note.text() == "one belongs to test.map; two was taken."), "{:?}", read.notes);
    let read = import(standard(), &[file("one.YML", YAML), file("two", PGM)], None).unwrap();
    assert_eq!(read.scene.name(), "one");
    let scene = shipped("wcpso-discs").unwrap();
    assert_eq!(import(standard(), &[file("x", scene.to_json())], None).unwrap().scene, *scene);
    assert_eq!(Format::of_file("a/b.SCEN"), Some(Format::MovingAi));
    assert_eq!((Format::of_file("a/map"), &*Format::named("png").unwrap_err().allowed()), (None, "movingai, ros, tsplib, csv, json"));
}

#[test]
fn what_a_format_has_no_place_for_is_said() {
    let scene = shipped("qpso-10m").unwrap();
    let notes = joined(&export(&scene, Format::Ros, "a").unwrap().notes);
    assert!(notes.contains("the robot") && notes.contains("start and goal"), "{notes}");
    let there = export(&scene, Format::MovingAi, "b\t/c").unwrap();
    assert_eq!(there.files.iter().map(|f| f.name.as_str()).collect::<Vec<_>>(), ["b--c.map", "b--c.scen"]);
    assert!(joined(&there.notes).contains("a cell is"), "{:?}", there.notes);
    assert_eq!(export(&shipped("sphere").unwrap(), Format::Ros, "a").unwrap_err().field(), "kind");
    assert_eq!(export(&shipped("sphere").unwrap(), Format::Tsplib, "a").unwrap_err().allowed(), "tour");
    // Without a way there is no optimum, and so no .scen.
    let split = import(standard(), &[file("a.json", shut("...#.", "[4.5, 0.5]"))], None).unwrap().scene;
    let out = export(&split, Format::MovingAi, "a").unwrap();
    assert_eq!((out.files.len(), out.notes[0].text().contains("no way")), (1, true));
}

fn shut(row: &str, goal: &str) -> String {
    format!(
        r#"{{"format": "forage-scene", "version": 1, "kind": "grid", "name": "a", "title": "A", "cell": 1, "rows": ["{row}"],
            "start": [0.5, 0.5], "goal": {goal}}}"#
    )
}

/// All that ships, y upwards or not: the same cells, and the same ends at their cells' centres.
#[test]
fn shipped_grids_survive_the_way_through_every_format() {
    let mut grids = 0;
    for scene in forage::standard().scenes().iter().filter(|scene| scene.get::<GridScene>().is_ok()) {
        let grid = scene.get::<GridScene>().unwrap();
        grids += 1;
        for format in [Format::MovingAi, Format::Ros, Format::Json] {
            let written = export(scene, format, scene.name()).unwrap();
            let read = import(standard(), &written.files, None).unwrap();
            assert_eq!(rows(&read), grid.lines(), "{} as {}", scene.name(), format.name());
            if format == Format::MovingAi {
                let exact = read.scene.exact_by(ReferenceOptimum::Cells).unwrap();
                assert_eq!(exact.length, read.problems[0].length);
                let endpoints = read.scene.get::<GridScene>().unwrap().endpoints().unwrap();
                let cells = read.scene.get::<GridScene>().unwrap().cells();
                assert_eq!(shortest_over_cells(cells, &endpoints).unwrap().length, exact.length);
            }
            if format == Format::Ros {
                assert_eq!(
                    (read.scene.get::<GridScene>().unwrap().cell, read.scene.get::<GridScene>().unwrap().y_axis),
                    (grid.cell, YAxis::Up)
                );
            }
        }
        assert_eq!(
            standard().read_scene(str::from_utf8(&export(scene, Format::Json, "a").unwrap().files[0].bytes).unwrap()).unwrap(),
            **scene
        );
    }
    assert!(grids >= 4);
}
