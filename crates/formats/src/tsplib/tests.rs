//! Instances and tours that are read, and those that are refused, by their words.

use forage::{
    Scene,
    exact::Metric,
    kernel::{ReferenceOptimum, TourEnds},
    scene::{Header, TourScene, tour},
    standard,
};

use crate::{Format, NamedFile, export, import, wanted};

fn file(name: &str, text: impl AsRef<[u8]>) -> NamedFile {
    NamedFile::new(name, text.as_ref())
}

fn read(text: &str) -> Scene {
    import(standard(), &[file("a.tsp", text)], None).unwrap().scene
}

/// An instance of points given by their first and second coordinate.
fn instance(kind: &str, points: &[[f64; 2]]) -> String {
    let lines: Vec<_> = points.iter().enumerate().map(|(i, [a, b])| format!("{} {a} {b}\n", i + 1)).collect();
    format!("NAME: a\nTYPE: TSP\nDIMENSION: {}\nEDGE_WEIGHT_TYPE: {kind}\nNODE_COORD_SECTION\n{}EOF\n", points.len(), lines.concat())
}

fn shortest(scene: &Scene) -> f64 {
    scene.exact_tour(ReferenceOptimum::default(), TourEnds::Closed).unwrap().length
}

/// Fourteen towns of Burma, TSPLIB's burma14: latitudes and longitudes in degrees and minutes.
const BURMA: [[f64; 2]; 14] = [
    [16.47, 96.10],
    [16.47, 94.44],
    [20.09, 92.54],
    [22.39, 93.37],
    [25.23, 97.24],
    [22.00, 96.05],
    [20.47, 97.02],
    [17.20, 96.29],
    [16.30, 97.38],
    [14.05, 98.12],
    [16.53, 97.38],
    [21.52, 95.59],
    [19.41, 97.13],
    [20.09, 94.55],
];

/// The sixteen places of the Odyssey, TSPLIB's ulysses16.
const ULYSSES: [[f64; 2]; 16] = [
    [38.24, 20.42],
    [39.57, 26.15],
    [40.56, 25.32],
    [36.26, 23.12],
    [33.48, 10.54],
    [37.56, 12.19],
    [38.42, 13.11],
    [37.52, 20.44],
    [41.23, 9.10],
    [41.17, 13.05],
    [36.08, -5.21],
    [38.47, 15.13],
    [38.15, 15.35],
    [37.51, 15.17],
    [35.49, 14.32],
    [39.36, 19.56],
];

#[test]
fn geo_instances_have_the_optima_that_are_published_for_them() {
    assert_eq!(shortest(&read(&instance("GEO", &BURMA))), 3323.0);
    let ulysses = instance("GEO", &ULYSSES);
    let tour = "TYPE : TOUR\nTOUR_SECTION\n1 14 13 12 7 6 15 5 11 9 10 16 3 2 4 8 -1\nEOF\n";
    let with = import(standard(), &[file("u.tsp", &ulysses), file("u.opt.tour", tour)], None).unwrap();
    assert_eq!(shortest(&with.scene), 6859.0);
    // Latitude first in the file, longitude first in the scene, so that pictures have the north on top.
    let tour = with.scene.get::<TourScene>().unwrap();
    assert_eq!((tour.metric, tour.points[10]), (Metric::Geo, [-5.21, 36.08]));
}

#[test]
fn other_metrics_measure_as_their_formulas_say() {
    // A right triangle with legs 9 and 13: √250 = 15.81; over √10: 2.85, 4.11 and 5 exactly.
    for (kind, sides) in [("EUC_2D", [9.0, 13.0, 16.0]), ("CEIL_2D", [9.0, 13.0, 16.0]), ("ATT", [3.0, 5.0, 5.0])] {
        let scene = read(&instance(kind, &[[100.0, 100.0], [109.0, 100.0], [100.0, 113.0]]));
        let d = scene.get::<TourScene>().unwrap().distances().clone();
        assert_eq!([d.between(0, 1), d.between(0, 2), d.between(1, 2)], sides, "{kind}");
    }
    // √2 = 1.41 apart: rounded or rounded up.
    for (kind, length) in [("EUC_2D", 2.0), ("CEIL_2D", 4.0)] {
        assert_eq!(shortest(&read(&instance(kind, &[[0.0, 0.0], [1.0, 1.0]]))), length, "{kind}");
    }
}

/// Distances of four stops, upper half by rows: 1-2, 1-3, 1-4, 2-3, 2-4, 3-4.
const FOUR: [f64; 6] = [3.0, 4.0, 5.0, 6.0, 7.0, 8.0];

fn matrix(form: &str, numbers: &str) -> String {
    format!(
        "NAME: four\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: {form}\nEDGE_WEIGHT_SECTION\n{numbers}\nEOF\n"
    )
}

#[test]
fn every_form_of_a_matrix_is_the_same_one() {
    let numbers = [
        ("FULL_MATRIX", "0 3 4 5\n3 0 6 7\n4 6 0 8\n5 7 8 0"),
        ("UPPER_ROW", "3 4 5\n6 7\n8"),
        ("UPPER_DIAG_ROW", "0 3 4 5\n0 6 7\n0 8\n0"),
        ("LOWER_ROW", "3\n4 6\n5 7 8"),
        ("LOWER_DIAG_ROW", "0\n3 0\n4 6 0\n5 7 8 0"),
        ("UPPER_COL", "3\n4 6\n5 7 8"),
        ("UPPER_DIAG_COL", "0\n3 0\n4 6 0\n5 7 8 0"),
        ("LOWER_COL", "3 4 5\n6 7\n8"),
        ("LOWER_DIAG_COL", "0 3 4 5\n0 6 7\n0 8\n0"),
    ];
    for (form, rows) in numbers {
        // In rows, in one line, in a line for each, and behind the keyword; whole or not.
        let behind = matrix(form, rows).replace("EDGE_WEIGHT_SECTION\n", "EDGE_WEIGHT_SECTION ");
        for text in [matrix(form, rows), matrix(form, &rows.replace('\n', " ")), matrix(form, &rows.replace(' ', "\n")), behind] {
            let scene = read(&text.replace('8', "8.0e+00"));
            let d = scene.get::<TourScene>().unwrap().matrix.clone().unwrap();
            let upper = [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)];
            assert_eq!(upper.map(|(i, j)| d.between(i, j)), FOUR, "{form}");
            assert_eq!(upper.map(|(i, j)| d.between(j, i)), FOUR, "{form}");
            assert_eq!(shortest(&scene), 3.0 + 7.0 + 8.0 + 4.0, "1-2-4-3");
        }
    }
}

#[test]
fn what_other_programs_write_is_read() {
    let text = "\u{feff}COMMENT : two\tstops\r\nCOMMENT: (far apart)\r\nNAME\t:  far.tsp \r\n\r\nTYPE : TSP (M. Hofmeister)\r\nDIMENSION:2\r\n\
                EDGE_WEIGHT_TYPE :EUC_2D\r\nNODE_COORD_TYPE : TWOD_COORDS\r\nDISPLAY_DATA_TYPE : COORD_DISPLAY\r\nBEST_KNOWN : 7\r\n\
                NODE_COORD_SECTION\r\n  2 1.0e+02 -0\r\n\t1   1\t-1.5E1  \r\n";
    for (name, text) in [("a.TSP", text.to_owned()), ("a", text.to_owned()), ("a.tsp", format!("{text}EOF\nand so on"))] {
        let read = import(standard(), &[file(name, text)], None).unwrap();
        assert_eq!(read.scene.get::<TourScene>().unwrap().points, [[1.0, -15.0], [100.0, 0.0]]);
        assert_eq!((read.scene.name(), read.notes.len()), ("far", 1));
        assert!(read.notes[0].text().starts_with("Line 10 of a") && read.notes[0].text().contains("`BEST_KNOWN`"), "{:?}", read.notes);
        assert!(read.scene.header().note.as_ref().unwrap().starts_with("two\tstops (far apart) Line 10"));
    }
    // Files with a formula may say so, before it or behind.
    for to in ["EDGE_WEIGHT_FORMAT: FUNCTION\nEDGE_WEIGHT_TYPE: GEO", "EDGE_WEIGHT_TYPE: GEO\nEDGE_WEIGHT_FORMAT: FUNCTION "] {
        let text = instance("GEO", &BURMA).replace("EDGE_WEIGHT_TYPE: GEO", to);
        assert_eq!(read(&text).get::<TourScene>().unwrap().metric, Metric::Geo);
    }
    // Places for pictures, of a matrix only.
    let places = "DISPLAY_DATA_SECTION\n3 3 0\n1 1 0\n2 2 0\n4 4 5\nEOF\n";
    let shown = read(&matrix("LOWER_ROW", "3\n4 6\n5 7 8").replace("EOF\n", places));
    assert_eq!(shown.get::<TourScene>().unwrap().points, [[1.0, 0.0], [2.0, 0.0], [3.0, 0.0], [4.0, 5.0]]);
    let twice = instance("EUC_2D", &[[0.0, 3.0], [4.0, 0.0]]).replace("EOF\n", "DISPLAY_DATA_SECTION\n1 0 0\n2 1 1\n");
    let twice = import(standard(), &[file("b.tsp", twice)], None).unwrap();
    assert_eq!((twice.scene.get::<TourScene>().unwrap().points[0], twice.notes.len()), ([0.0, 3.0], 1));
    let odd = import(standard(), &[file("c.tsp", matrix("LOWER_DIAG_ROW", "9 3 -1 4 6 0 5 7 8 0"))], None).unwrap();
    assert!(odd.notes[0].text().starts_with("2 distances from a stop to itself"), "{:?}", odd.notes);
}

#[test]
fn what_is_not_supported_is_refused_by_its_name_and_line() {
    let plain = instance("EUC_2D", &[[0.0, 0.0], [3.0, 4.0], [9.0, 9.0]]);
    let full = matrix("FULL_MATRIX", "0 3 4 5\n3 0 6 7\n4 6 0 8\n5 7 8 0");
    let change = |from: &str, to: &str| {
        assert!(plain.contains(from), "{from}");
        plain.replacen(from, to, 1)
    };
    let of_matrix = |from: &str, to: &str| {
        assert!(full.contains(from), "{from}");
        full.replacen(from, to, 1)
    };
    let mut cases = vec![
        (change("TYPE: TSP\n", ""), "line 8: the file ends without `TYPE`".to_owned()),
        (change("DIMENSION: 3\n", ""), "line 4: `NODE_COORD_SECTION` before `DIMENSION`".to_owned()),
        (change("EDGE_WEIGHT_TYPE: EUC_2D\n", ""), "line 8: the file ends without `EDGE_WEIGHT_TYPE`".to_owned()),
        (plain.split("NODE").next().unwrap().to_owned(), "line 4: the file ends without `NODE_COORD_SECTION`".to_owned()),
        (String::new(), "line 1: the file ends without `TYPE`".to_owned()),
        (change("3 9 9\n", ""), "line 8: found `EOF`, expected a stop from 1 to 3".to_owned()),
        (change("3 9 9\nEOF\n", ""), "line 7: the file ends, expected a stop from 1 to 3".to_owned()),
        (change("3 9 9", "2 9 9"), "line 8: found `2`, expected a stop that is not listed above".to_owned()),
        (change("3 9 9", "0 9 9"), "line 8: found `0`, expected a stop from 1 to 3".to_owned()),
        (change("3 9 9", "3 9 9\n4 1 1"), "line 9: found `4`, expected a keyword, a section or EOF".to_owned()),
        (change("3 9 9", "3 9 9 9"), "line 8: found `9`, expected the end of the line after 3 stops".to_owned()),
        (change("3 9 9", "3 9 nan"), "line 8: found `nan`, expected for stop 3 coordinate 2 a number from -1000000000".to_owned()),
        (change("3 9 9", "3 2e9 9"), "line 8: found `2e9`, expected for stop 3 coordinate 1".to_owned()),
        (change("NAME: a", "NAME: a\nTYPE: TSP"), "line 3: `TYPE` again, first in line 2".to_owned()),
        (change("EOF", "NODE_COORD_SECTION"), "line 9: `NODE_COORD_SECTION` again, first in line 5".to_owned()),
        (change("EOF", "EDGE_WEIGHT_FORMAT: UPPER_ROW\nEDGE_WEIGHT_SECTION\n5 6 7"), "line 10: `EDGE_WEIGHT_SECTION`, but".to_owned()),
        (change("NAME: a", "Name: a"), "line 1: found `Name`, expected a keyword".to_owned()),
        (change("NAME: a", "NODE_COORD_TYPE: THREED_COORDS"), "line 1: found `THREED_COORDS`".to_owned()),
        (change("NAME: a", "DISPLAY_DATA_TYPE: 3D"), "line 1: found `3D`, expected for DISPLAY_DATA_TYPE COORD_DISPLAY".to_owned()),
        (of_matrix("4 6 0 8", "4 6.5 0 8"), "line 9: found `6.5`, expected 6 from stop 3 to 2, as in the other direction".to_owned()),
        (
            of_matrix("3 0 6 7", "3 0 -6 7"),
            "line 8: found `-6`, expected a distance from 0 to 1000000000000 between stops 2 and 3".to_owned(),
        ),
        (of_matrix("3 0 6 7", "3 0 1e13 7"), "line 8: found `1e13`".to_owned()),
        (of_matrix("3 0 6 7", "3 0 x 7"), "line 8: found `x`".to_owned()),
        (
            of_matrix("8 0\nEOF\n", "8"),
            "line 10: the file ends, expected a distance from 0 to 1000000000000 between stops 4 and 4".to_owned(),
        ),
        (of_matrix("8 0\n", "8 0 9\n"), "line 10: found `9`, expected the end of the line after the distances of 4 stops".to_owned()),
        (of_matrix("EDGE_WEIGHT_FORMAT: FULL_MATRIX\n", ""), "line 5: `EDGE_WEIGHT_SECTION` before `EDGE_WEIGHT_FORMAT`".to_owned()),
        (of_matrix("EDGE_WEIGHT_SECTION", "NODE_COORD_SECTION"), "line 7: found `0`, expected a stop from 1 to 4".to_owned()),
    ];
    for kind in ["ATSP", "CVRP", "HCP", "SOP", "TOUR", "tsp"] {
        cases.push((change("TYPE: TSP", &format!("TYPE: {kind}")), format!("line 2: found `{kind}`, expected for TYPE TSP")));
    }
    for kind in ["EUC_3D", "MAX_2D", "MAN_2D", "MAX_3D", "XRAY1", "SPECIAL", "GEOM", ""] {
        let part = format!("line 4: found `{kind}`, expected for EDGE_WEIGHT_TYPE EUC_2D, CEIL_2D, ATT, GEO or EXPLICIT");
        cases.push((change("EUC_2D", kind), part));
    }
    for form in ["FUNCTION", "UPPER", "SPARSE"] {
        cases.push((of_matrix("FULL_MATRIX", form), format!("line 5: found `{form}`, expected for EDGE_WEIGHT_FORMAT FULL_MATRIX")));
    }
    for section in ["EDGE_DATA_SECTION", "DEMAND_SECTION", "DEPOT_SECTION", "TOUR_SECTION"] {
        cases.push((change("EOF", section), format!("line 9: found `{section}`, expected NODE_COORD_SECTION")));
    }
    for n in ["1", "0", "100001", "three", "3.0"] {
        let part = format!("line 3: found `{n}`, expected for DIMENSION a number of stops from 2 to 100000");
        cases.push((change("DIMENSION: 3", &format!("DIMENSION: {n}")), part));
    }
    for (text, part) in cases {
        let error = import(standard(), &[file("folder/a.tsp", &text)], None).unwrap_err();
        assert_eq!(error.field(), "a.tsp");
        assert!(error.to_string().contains(&part), "{error}\nshould say\n{part}");
    }
}

#[test]
fn fixed_edges_are_read_and_written() {
    // Four corners of a square: the tour must go along a diagonal.
    let square = instance("EUC_2D", &[[0.0, 0.0], [30.0, 0.0], [30.0, 40.0], [0.0, 40.0]]);
    let fixed = |pairs: &str| square.replace("NODE_COORD_SECTION", &format!("FIXED_EDGES_SECTION\n{pairs}\nNODE_COORD_SECTION"));
    let scene = read(&fixed("1 3\n-1"));
    assert_eq!(scene.get::<TourScene>().unwrap().fixed, [[0, 2]]);
    // 1 3 2 4 or 1 3 4 2: the other diagonal, 50, and two sides of 30. The fixed one costs nothing.
    assert_eq!(scene.exact_tour(forage::kernel::ReferenceOptimum::default(), forage::kernel::TourEnds::Closed).unwrap().length, 110.0);
    let written = export(&scene, Format::Tsplib, "x").unwrap();
    assert!(str::from_utf8(&written.files[0].bytes).unwrap().contains("FIXED_EDGES_SECTION\n1 3\n-1\nEOF"));
    assert_eq!(read(str::from_utf8(&written.files[0].bytes).unwrap()).get::<TourScene>().unwrap(), scene.get::<TourScene>().unwrap());
    for (pairs, part) in [
        ("1 3 2 -1", "found `-1`, expected a stop from 1 to 4"),
        ("1 5 -1", "found `5`, expected a stop from 1 to 4"),
        ("1 3 -1 2", "found `2`, expected a keyword"),
        ("1 1 -1", "found `1`, expected a stop that is not listed above"),
    ] {
        let error = import(standard(), &[file("x.tsp", fixed(pairs))], None).unwrap_err().to_string();
        assert!(error.contains(part), "{error}\nshould say\n{part}");
    }
    for pairs in ["1 2 1 3 1 4 -1", "1 2 2 3 3 1 -1"] {
        let error = import(standard(), &[file("x.tsp", fixed(pairs))], None).unwrap_err().to_string();
        assert!(error.contains("at most two fixed edges meet in a stop"), "{error}");
    }
}

#[test]
fn a_tour_is_measured_and_kept_only_if_it_is_said_to_be_the_shortest() {
    let tsp = file("x.tsp", instance("EUC_2D", &[[0.0, 0.0], [30.0, 40.0], [0.0, 40.0], [30.0, 0.0]]));
    let text = "NAME : x\nCOMMENT : Length 1\nTYPE : TOUR\nDIMENSION : 4\nTOUR_SECTION\n3\n2\n4\n1\n-1\nEOF\n";
    let optimal = import(standard(), &[file("x.OPT.tour", text), tsp.clone()], None).unwrap();
    let exact = optimal.scene.header().exact.clone().unwrap();
    assert_eq!((exact["length"].as_f64(), exact["order"].to_string()), (Some(140.0), "[2,1,3,0]".to_owned()));
    assert!(optimal.notes[0].text().contains("the length 140. That none is shorter is what"), "{:?}", optimal.notes);
    let other = import(standard(), &[tsp.clone(), file("x.tour", text.replace("3\n2\n4\n1\n-1", " 1 2 3 4"))], None).unwrap();
    assert_eq!((other.scene.header().exact.as_ref(), other.notes.len()), (None, 1));
    assert!(other.notes[0].text().contains("the length 160"), "{:?}", other.notes);
    // With a scene's own file, and by what is in it.
    let json = file("x.json", other.scene.to_json());
    assert_eq!(import(standard(), &[json.clone(), file("x.opt.tour", text)], None).unwrap().scene.header().exact, Some(exact));
    assert!(import(standard(), &[json, file("tour of x", text)], None).unwrap().notes[0].text().contains("length 140"));
    let lists = text.replace("-1\n", "-1\n-1\n");
    assert!(import(standard(), &[tsp.clone(), file("x.tour", lists)], None).is_ok(), "a list of one tour");
    for (from, to, part) in [
        ("TOUR\n", "TSP\n", "line 3: found `TSP`, expected for TYPE TOUR"),
        ("DIMENSION : 4", "DIMENSION : 5", "line 4: found `5`, expected for DIMENSION 4, as many as the scene has stops"),
        ("2\n4", "3\n4", "line 7: found `3`, expected a stop that is not listed above"),
        ("2\n4", "5\n4", "line 7: found `5`, expected a stop from 1 to 4"),
        ("2\n4", "4", "line 9: found `-1`, expected a stop from 1 to 4"),
        ("-1", "2", "line 10: found `2`, expected -1 after 4 stops"),
        ("-1\nEOF", "-1\n1 2 3 4 -1", "line 11: found `1`, expected the end of the file: one tour at a time"),
        ("TOUR_SECTION", "FIXED_EDGES_SECTION", "line 5: found `FIXED_EDGES_SECTION`, expected a keyword or TOUR_SECTION"),
        ("TOUR_SECTION\n3\n2\n4\n1\n-1\n", "", "line 5: the file ends without `TOUR_SECTION`"),
    ] {
        assert!(text.contains(from));
        let error = import(standard(), &[tsp.clone(), file("x.tour", text.replacen(from, to, 1))], None).unwrap_err();
        assert_eq!(error.field(), "x.tour");
        assert!(error.to_string().contains(part), "{error}\nshould say\n{part}");
    }
    for (name, expected) in [("some/x.opt.tour", "x.tsp"), ("x.tour", "x.tsp"), ("x.y.tour", "x.y.tsp")] {
        let alone = [file(name, text)];
        assert_eq!(wanted(&alone).unwrap().as_deref(), Some(expected));
        assert!(
            import(standard(), &alone, None)
                .unwrap_err()
                .to_string()
                .contains(&format!("the file `{expected}` that belongs to it is missing"))
        );
    }
    let map = file("m.map", "type octile\nheight 1\nwidth 2\nmap\n..\n");
    assert!(import(standard(), &[map, file("x.tour", text)], None).unwrap_err().to_string().contains("one scene at a time"));
    assert_eq!(wanted(&[tsp, file("x.tour", text)]).unwrap(), None);
}

fn scene(tour: TourScene) -> Scene {
    let text = instance("EUC_2D", &[[0.0, 0.0], [1.0, 0.0]]);
    let header = Header { note: None, ..read(&text).header().clone() };
    tour::KIND.scene(header, tour).unwrap()
}

#[test]
fn what_is_written_says_what_it_lost() {
    let points = vec![[0.0, 0.0], [1.5, 0.0], [0.0, -2.0]];
    let plain = scene(TourScene::through(points.clone(), Metric::Euclidean));
    let written = export(&plain, Format::Tsplib, "x").unwrap();
    assert_eq!(written.files.iter().map(|f| f.name.as_str()).collect::<Vec<_>>(), ["x.tsp", "x.tour"]);
    assert!(written.notes[0].text().contains("EUC_2D rounds"), "{:?}", written.notes);
    let text =
        "NAME : x\nTYPE : TSP\nCOMMENT : a\nDIMENSION : 3\nEDGE_WEIGHT_TYPE : EUC_2D\nNODE_COORD_SECTION\n1 0 0\n2 1.5 0\n3 0 -2\nEOF\n";
    assert_eq!(str::from_utf8(&written.files[0].bytes), Ok(text));
    let mut open = TourScene::through(points, Metric::Att);
    open.closed = false;
    let open = scene(open);
    let written = export(&open, Format::Tsplib, "x").unwrap();
    assert_eq!((written.files.len(), written.notes[0].text().contains("that tours are open")), (1, true));
    let refused = import(standard(), &[file("o.json", open.to_json()), file("o.tour", "TOUR_SECTION 1 2 3 -1")], None).unwrap_err();
    assert!(refused.to_string().contains("those of the scene are open"));
    let matrix = read(&matrix("UPPER_ROW", "3 4 5 6 7.5 8"));
    let written = export(&matrix, Format::Tsplib, "m").unwrap();
    assert!(written.notes[0].text().contains("no whole numbers"), "{:?}", written.notes);
    assert!(str::from_utf8(&written.files[0].bytes).unwrap().contains("EDGE_WEIGHT_SECTION\n0 3 4 5\n3 0 6 7.5\n4 6 0 8\n5 7.5 8 0\nEOF"));
    for format in [Format::MovingAi, Format::Ros] {
        assert_eq!(export(&matrix, format, "m").unwrap_err().allowed(), "grid");
    }
    let grid = forage::shipped("wolf-ant-20").unwrap();
    for format in [Format::Tsplib, Format::Csv] {
        let error = export(&grid, format, "m").unwrap_err();
        assert_eq!((error.field(), error.value(), &*error.allowed()), ("kind", "grid", "tour"));
    }
    // Twenty stops whose shortest tour nobody knows.
    let many = scene(TourScene::through((0..20).map(|i| [f64::from(i), f64::from(i * i % 7)]).collect(), Metric::Euc2d));
    assert_eq!(export(&many, Format::Tsplib, "m").unwrap().files.len(), 1);
}
