//! `forage bench movingai`.

use std::{
    env, fs,
    path::{Path, PathBuf},
    process::Command,
};

use crate::support::{empty_folder, forage, text};

/// 5 × 3 cells: a wall with a gap at the bottom, and water.
const MAP: &str = "type octile\nheight 3\nwidth 5\nmap\n..@..\n..@..\n....W\n";
/// From left to right through the gap; along the left side; into water; to where it begins.
const SCEN: &str = "version 1
0\tmaps/room.map\t5\t3\t0\t0\t3\t0\t6.41421356
0\tmaps/room.map\t5\t3\t0\t0\t0\t2\t2
0\tmaps/room.map\t5\t3\t0\t0\t4\t2\t5
1\tmaps/room.map\t5\t3\t0\t0\t0\t0\t0
";

/// A folder with problems in one folder, and their map in another one.
fn problems(name: &str, scen: &str) -> PathBuf {
    let folder = empty_folder(name);
    ["maps", "scens"].iter().for_each(|name| fs::create_dir(folder.join(name)).unwrap());
    fs::write(folder.join("maps/room.map"), MAP).unwrap();
    fs::write(folder.join("scens/room.map.scen"), scen).unwrap();
    folder
}

fn bench(folder: &Path, more: &[&str]) -> std::process::Output {
    let out = folder.join("out");
    forage(&[&["bench", "movingai", folder.to_str().unwrap(), "--out", out.to_str().unwrap()], more].concat())
}

fn rows(folder: &Path) -> Vec<csv::StringRecord> {
    csv::Reader::from_path(folder.join("out/rows.csv")).unwrap().records().map(Result::unwrap).collect()
}

#[test]
fn exact_searches_have_the_optimum_and_others_a_gap() {
    let folder = problems("movingai", SCEN);
    fs::write(folder.join("scens/lost.scen"), SCEN.replace("room.map", "lost.map")).unwrap();
    let output = bench(&folder, &["--planners", "a-star,dijkstra,theta-star,aco"]);
    let said = text(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    assert!(said.contains("2 of 4 problems of scens/room.map.scen are not run") && said.contains("its map maps/lost.map is not"), "{said}");
    let rows = rows(&folder);
    assert_eq!(rows.len(), 8);
    for row in &rows {
        let [optimum, length] = [5, 7].map(|column| row[column].parse::<f64>().unwrap());
        match &row[0] {
            "aco" => assert!(length > optimum - 1e-6, "{row:?}"),
            "theta-star" => assert!(length < optimum + 1e-6, "{row:?}"),
            _ => assert!((length - optimum).abs() < 1e-6, "{row:?}"),
        }
        assert_eq!(&row[6] == "true", ["a-star", "dijkstra"].contains(&&row[0]), "{row:?}");
    }
    let report = fs::read_to_string(folder.join("out/report.md")).unwrap();
    assert!(report.contains("missed the optimum in 0 of 4 runs") && report.contains("theta-star"), "{report}");
    for file in ["time.svg", "gap.svg", "buckets.csv"] {
        assert!(folder.join("out").join(file).exists(), "{file}");
    }
}

#[test]
fn an_exact_search_that_misses_the_optimum_is_a_failure() {
    let folder = problems("movingai-wrong", &SCEN.replace("6.41421356", "6.4"));
    let output = bench(&folder, &[]);
    let said = text(&output.stderr);
    assert!(output.status.code() == Some(1) && said.contains("a-star on scens/room.map.scen problem 0: a way of 6.414"), "{said}");
    assert!(fs::read_to_string(folder.join("out/report.md")).unwrap().contains("missed the optimum in 2 of 4 runs"));
    // Greedy it is not exact.
    let output = bench(&folder, &["--planners", "a-star", "--set", "weight=2", "--per-bucket", "1"]);
    assert_eq!((output.status.code(), text(&output.stdout).contains("weight=2")), (Some(0), true), "{}", text(&output.stderr));
}

/// Buckets need not be in order; a stop by the limit is not a missed optimum; a map's path may have backslashes.
#[test]
fn the_first_problems_of_each_bucket_are_taken_wherever_they_are() {
    let (head, lines) = SCEN.split_once('\n').unwrap();
    let two = lines.lines().take(2).collect::<Vec<_>>().join("\n") + "\n";
    let folder = problems("movingai-mixed", &format!("{head}\n{two}{two}").replace("maps/room", "maps\\room"));
    let output = bench(&folder, &["--planners", "a-star", "--per-bucket", "1"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert_eq!(rows(&folder).iter().map(|row| [row[3].to_owned(), row[4].to_owned()]).collect::<Vec<_>>(), [["0", "1"], ["1", "0"]]);
    let output = bench(&folder, &["--planners", "a-star", "--set", "iterations=1", "--set", "expand=1"]);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
}

#[test]
fn what_is_wrong_is_refused() {
    let folder = problems("movingai-refused", SCEN);
    let none = empty_folder("movingai-none");
    let out = folder.join("out");
    let bench = |folder: &Path, more: &[&str]| {
        forage(&[&["bench", "movingai", folder.to_str().unwrap(), "--out", out.to_str().unwrap()], more].concat())
    };
    for (folder, more, said) in [
        (&none, &[][..], "no .scen file"),
        (&none.join("nowhere"), &[], "no such"),
        (&folder, &["--per-bucket", "0"], "--per-bucket"),
        (&folder, &["--planners", "bat"], "--planners"),
        (&folder, &["--set", "a-star.weight=0"], "weight"),
        (&folder, &["--functions", "1"], "--functions"),
    ] {
        let output = bench(folder, more);
        assert_eq!(output.status.code(), Some(2), "{more:?}: {}", text(&output.stderr));
        assert!(text(&output.stderr).contains(said), "{more:?}: {}", text(&output.stderr));
        assert!(!out.exists(), "{more:?}");
    }
    fs::write(folder.join("maps/room.map"), MAP.replace("..@..", "..@.")).unwrap();
    let output = bench(&folder, &[]);
    assert!(output.status.code() == Some(2) && text(&output.stderr).contains("room.map: line 5"), "{}", text(&output.stderr));
}

/// The maps that the crate `movingai` ships with its tests: a small one, and a maze of 512 × 512 cells; a part of their problems. The
/// exit code says whether an exact search missed an optimum.
#[test]
fn the_optima_of_published_problems_are_found() {
    let cargo = env::var("CARGO").unwrap_or_else(|_| "cargo".to_owned());
    // What other systems need was perhaps never fetched.
    let host = Command::new("rustc").args(["--print", "host-tuple"]).output().unwrap();
    let only = ["--filter-platform", str::from_utf8(&host.stdout).unwrap().trim()];
    let output = Command::new(cargo).args(["metadata", "--format-version", "1", "--locked", "--offline"]).args(only).output().unwrap();
    let found: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{}", text(&output.stderr)));
    let package = found["packages"].as_array().unwrap().iter().find(|package| package["name"] == "movingai").unwrap();
    let data = Path::new(package["manifest_path"].as_str().unwrap()).with_file_name("tests");
    let out = empty_folder("movingai-published");
    let given = ["bench", "movingai", data.to_str().unwrap(), "--out", out.to_str().unwrap(), "--planners", "a-star,dijkstra"];
    let output = forage(&[&given[..], &["--per-bucket", "1", "--shard", "3/20"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    assert!(text(&output.stdout).contains("82 of 1634 runs"), "{}", text(&output.stdout));
}
