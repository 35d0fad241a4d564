//! `forage bench tsplib`.

use std::{
    fs,
    path::{Path, PathBuf},
};

use crate::support::{empty_folder, forage, text};

/// Stops on the sides of a rectangle: the shortest tour goes round.
fn round(name: &str, kind: &str, [width, height]: [usize; 2], more: &str) -> String {
    let along = (0..width).map(|x| [x, 0]).chain((0..height).map(|y| [width, y]));
    let back = (0..width).map(|x| [width - x, height]).chain((0..height).map(|y| [0, height - y]));
    let points: Vec<_> = along.chain(back).collect();
    // Neither in the order of the tour nor in one that the nearest neighbour finds.
    let order = |k: usize| points[k * 11 % points.len()];
    let lines: Vec<_> = (0..points.len()).map(|k| format!("{} {} {}", k + 1, 10 * order(k)[0], 10 * order(k)[1])).collect();
    let n = points.len();
    format!("NAME: {name}\nTYPE: TSP\nDIMENSION: {n}\nEDGE_WEIGHT_TYPE: {kind}\n{more}NODE_COORD_SECTION\n{}\nEOF\n", lines.join("\n"))
}

/// One instance in each of the forms that TSPLIB has, and two that are as published but for their stops.
fn instances(name: &str) -> PathBuf {
    let folder = empty_folder(name);
    let write = |name: &str, text: &str| fs::write(folder.join(name), text).unwrap();
    write("euclid.tsp", &round("euclid", "EUC_2D", [12, 9], ""));
    write("ceil.tsp", &round("ceil", "CEIL_2D", [8, 6], ""));
    write("att.tsp", &round("att", "ATT", [5, 4], ""));
    write("geo.tsp", &round("geo", "GEO", [3, 2], ""));
    // A tour along a diagonal, which costs nothing.
    write("fixed.tsp", &round("fixed", "EUC_2D", [4, 4], "FIXED_EDGES_SECTION\n1 9\n-1\n"));
    let matrix = |form: &str, rows: &str| {
        let head = format!("NAME: m\nTYPE: TSP\nDIMENSION: 4\nEDGE_WEIGHT_TYPE: EXPLICIT\nEDGE_WEIGHT_FORMAT: {form}\n");
        format!("{head}EDGE_WEIGHT_SECTION\n{rows}\nEOF\n")
    };
    write("full.tsp", &matrix("FULL_MATRIX", "0 1 9 2\n1 0 3 9\n9 3 0 4\n2 9 4 0"));
    write("upper.tsp", &matrix("UPPER_ROW", "1 9 2\n3 9\n4"));
    write("upper_diag.tsp", &matrix("UPPER_DIAG_ROW", "0 1 9 2\n0 3 9\n0 4\n0"));
    write("lower_diag.tsp", &matrix("LOWER_DIAG_ROW", "0\n1 0\n9 3 0\n2 9 4 0"));
    // Its tour says how long the shortest is.
    write("euclid.opt.tour", &{
        let back: Vec<usize> = (0..42).map(|k| (0..42).find(|stop| stop * 11 % 42 == k).unwrap_or(k) + 1).collect();
        let stops: Vec<_> = back.iter().map(ToString::to_string).collect();
        format!("TYPE: TOUR\nDIMENSION: 42\nTOUR_SECTION\n{}\n-1\nEOF\n", stops.join("\n"))
    });
    folder
}

fn bench(folder: &Path, more: &[&str]) -> std::process::Output {
    let out = folder.join("out");
    forage(&[&["bench", "tsplib", folder.to_str().unwrap(), "--out", out.to_str().unwrap()], more].concat())
}

fn rows(folder: &Path) -> Vec<csv::StringRecord> {
    csv::Reader::from_path(folder.join("out/rows.csv")).unwrap().records().map(Result::unwrap).collect()
}

#[test]
fn every_form_is_toured_and_measured_against_what_is_known() {
    let folder = instances("tsplib");
    let output = bench(&folder, &["--planners", "two-opt,sa,held-karp", "--budget", "1000", "--runs", "2"]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.contains("no optimum is published of"), "{said}");
    let rows = rows(&folder);
    // Held and Karp tour at most 15 stops: four instances of 4 and one of 10.
    assert_eq!(rows.len(), 2 * (2 * 9 + 5));
    for row in &rows {
        let [budget, evaluations] = [5, 9].map(|column| row[column].parse::<u64>().unwrap());
        // Short annealing need not come to a tour with the fixed edge.
        let length: f64 = row[7].parse().unwrap_or_else(|_| if &row[2] == "fixed" { f64::INFINITY } else { f64::NAN });
        assert!(!length.is_nan(), "{row:?}");
        match &row[2] {
            "fixed" if &row[0] == "two-opt" => assert!(length.is_finite(), "{row:?}"),
            "euclid" => assert!(&row[6] == "420.0" && length >= 420.0, "{row:?}"),
            "ceil" => assert!(row[6].is_empty() && length >= 280.0, "{row:?}"),
            "full" | "upper" | "upper_diag" | "lower_diag" if &row[0] == "held-karp" => assert_eq!(length, 10.0, "{row:?}"),
            _ => {}
        }
        // Annealing takes as many iterations as come near the budget.
        assert!(&row[0] != "sa" || evaluations * 2 > budget, "{row:?}");
    }
    let gaps = fs::read_to_string(folder.join("out/gaps.csv")).unwrap();
    assert!(gaps.starts_with("instance,stops,optimum,two-opt,sa,held-karp\n") && gaps.contains("\neuclid,42,420,"), "{gaps}");
    for file in ["report.md", "gap.svg", "time.svg"] {
        assert!(folder.join("out").join(file).exists(), "{file}");
    }
    // The same command carries nothing out again.
    let before = fs::read(folder.join("out/rows.csv")).unwrap();
    bench(&folder, &["--planners", "two-opt,sa,held-karp", "--budget", "1000", "--runs", "2"]);
    assert_eq!(fs::read(folder.join("out/rows.csv")).unwrap(), before);
}

/// As many stops as have no matrix of distances, and the published optimum of an instance with that name, which is none of theirs.
#[test]
fn thousands_of_stops_are_toured_without_a_matrix() {
    let folder = empty_folder("tsplib-large");
    fs::write(folder.join("d2103.tsp"), round("d2103", "EUC_2D", [800, 700], "")).unwrap();
    let output = bench(&folder, &["--planners", "two-opt"]);
    assert_eq!(output.status.code(), Some(1), "{}", text(&output.stderr));
    assert!(text(&output.stderr).contains("is shorter than the published optimum, 80450"), "{}", text(&output.stderr));
    let rows = rows(&folder);
    assert!(&rows[0][3] == "3000" && rows[0][7].parse::<f64>().unwrap() >= 30_000.0, "{rows:?}");
}

#[test]
fn what_is_wrong_is_refused() {
    let folder = instances("tsplib-refused");
    let none = empty_folder("tsplib-none");
    for (folder, more, said) in [
        (&none, &[][..], "no .tsp file"),
        (&folder, &["--largest", "3"], "all 9 instances have more stops"),
        (&folder, &["--largest", "0"], "--largest"),
        (&folder, &["--budget", "0"], "--budget"),
        (&folder, &["--planners", "a-star"], "--planners"),
        (&empty_large("tsplib-all-large"), &["--planners", "held-karp"], "as many stops as an instance has"),
        (&folder, &["--planners", "two-opt", "--set", "iterations=0"], "iterations"),
    ] {
        let output = bench(folder, more);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains(said), "{more:?}: {}", text(&output.stderr));
        assert!(!folder.join("out").exists(), "{more:?}");
    }
    fs::write(folder.join("bad.tsp"), "TYPE: TSP\nDIMENSION: 1\n").unwrap();
    let output = bench(&folder, &[]);
    assert!(output.status.code() == Some(2) && text(&output.stderr).contains("bad.tsp: line 2"), "{}", text(&output.stderr));
}

/// A folder whose only instance has more stops than an exact tour.
fn empty_large(name: &str) -> PathBuf {
    let folder = empty_folder(name);
    fs::write(folder.join("large.tsp"), round("large", "EUC_2D", [12, 9], "")).unwrap();
    folder
}

/// Two instances of the same name, in folders of their own; and a tour that comes after the first run.
#[test]
fn instances_are_told_apart_by_their_folders() {
    let folder = empty_folder("tsplib-same");
    for (name, size) in [("a", [5, 4]), ("b", [4, 4])] {
        fs::create_dir(folder.join(name)).unwrap();
        fs::write(folder.join(name).join("x.tsp"), round("x", "EUC_2D", size, "")).unwrap();
    }
    for _ in 0..2 {
        let output = bench(&folder, &["--planners", "two-opt"]);
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        assert_eq!(rows(&folder).iter().map(|row| row[2].to_owned()).collect::<Vec<_>>(), ["b/x", "a/x"]);
    }
    let stops: Vec<_> = (1..=18).map(|stop| stop.to_string()).collect();
    let tour = format!("TYPE: TOUR\nCOMMENT: optimal\nDIMENSION: 18\nTOUR_SECTION\n{}\n-1\nEOF\n", stops.join("\n"));
    fs::write(folder.join("a/x.opt.tour"), tour).unwrap();
    let output = bench(&folder, &["--planners", "two-opt"]);
    assert!(text(&output.stderr).contains("a/x seed 1") && output.status.code() == Some(1), "{}", text(&output.stderr));
}
