//! The shell's `forage reproduce`: what it prints, writes, refuses and keeps.

use std::{
    fs,
    process::{Command, Stdio},
};

use serde_json::Value;

use crate::support::{self, empty_folder, forage, text};

/// An empty folder of this test's own.
fn folder(name: &str) -> std::path::PathBuf {
    empty_folder(&format!("reproduce/{name}"))
}

#[test]
fn what_is_refused_exits_with_2_and_prints_nothing_on_standard_output() {
    for (args, part) in [
        (
            &["reproduce", "waldo"] as &[&str],
            "`waldo` is not a reproduction; it must be one of wcpso-functions, wcpso-fitted, wcpso-paths, ltqpso",
        ),
        (&["reproduce", "ltqpso", "--runs", "1"], "`--runs` is 1; it must be a whole number from 2"),
        (&["reproduce", "ltqpso", "--jobs", "0"], "--jobs"),
        (&["reproduce", "ltqpso", "--check", "."], "--check"),
        (&["reproduce", "ltqpso", "--out", "Cargo.toml", "--runs", "2"], "Cargo.toml"),
    ] {
        let output = forage(args);
        assert_eq!(output.status.code(), Some(2), "{args:?}");
        assert!(output.stdout.is_empty(), "{args:?}");
        assert!(text(&output.stderr).contains(part), "{args:?}: {}", text(&output.stderr));
    }
    let help = text(&forage(&["reproduce", "--help"]).stdout);
    assert!(help.contains("ltqpso-regression") && help.contains("--fresh"), "{help}");
}

/// Everything but the times, which are the last column.
fn without_times(csv: &str) -> Vec<String> {
    // Behind the time is the row's digest.
    csv.lines().map(|line| line.rsplitn(3, ',').last().unwrap().to_owned()).collect()
}

#[test]
fn every_row_of_the_functions_table_is_judged_and_can_be_repeated() {
    let out = folder("wcpso");
    let reports = |args: &[&str]| {
        let output = forage(&[args, &["--runs", "2", "--json", "--out", out.to_str().unwrap()]].concat());
        assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()[0].clone()
    };
    let report = reports(&["reproduce", "wcpso-functions"]);
    let figures = report["figures"].as_array().unwrap();
    assert_eq!(figures.len(), 8 * 4);
    // Eight rows, four planners, two seeds, with and without a limit of velocities.
    let rows = fs::read_to_string(out.join("wcpso-functions-runs.csv")).unwrap();
    assert_eq!(rows.lines().count(), 1 + 8 * 4 * 2 * 2);
    let matyas = &figures[3];
    assert_eq!((matyas["row"].as_str(), matyas["published_mean"].as_f64()), (Some("f1, 2 variables: wcpso"), Some(5.177_476e-156)));
    // Every figure has a value here, and a basis; each mark has its reason.
    let values = ["same digits", "no significant difference", "same power of ten", "differs"];
    assert!(figures.iter().all(|figure| values.contains(&figure["value"]["mark"].as_str().unwrap())));
    assert!(figures.iter().all(|figure| ["value", "basis"].iter().all(|kind| !figure[kind]["because"].as_str().unwrap().is_empty())));
    assert!(figures.iter().all(|figure| figure["runs"].as_u64() == Some(2)));
    // The command of a row gives its first run, and the best of the two is no worse.
    let words: Vec<_> = matyas["command"].as_str().unwrap().split_whitespace().filter(|word| *word != "forage").chain(["--json"]).collect();
    let again: Value = serde_json::from_slice(&forage(&words).stdout).unwrap();
    let row = rows.lines().find(|line| line.starts_with("matyas,wcpso,,1,")).unwrap();
    assert_eq!(row.split(',').nth(4).unwrap().parse(), Ok(again["cost"].as_f64().unwrap()));
    assert!(matyas["best"].as_f64().unwrap() <= again["cost"].as_f64().unwrap());

    let report = reports(&["reproduce", "wcpso-paths"]);
    let shortest = &report["figures"][0];
    assert_eq!((shortest["value"]["mark"].as_str(), shortest["published_mean"].as_f64()), (Some("same digits"), Some(12.141_59)));
    // Drawn and not printed: nothing to compare.
    assert!(report["figures"][1]["value"].is_null());
}

#[test]
fn both_tables_are_printed_written_and_repeatable() {
    let out = folder("ltqpso");
    let args = ["reproduce", "ltqpso", "--runs", "2", "--out", out.to_str().unwrap()];
    let output = forage(&args);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    for part in ["2 runs a cell, published: 50", "Table 3: uniform start, D = 8, N = 30, M = 50", "16.4604", "Table 4", "1.1982"] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    assert!(printed.contains("Evaluations are equal seed by seed"), "{printed}");
    let rows = fs::read_to_string(out.join("ltqpso-runs.csv")).unwrap();
    assert_eq!(rows.lines().count(), 1 + 4 * 2 * 2);
    assert!(fs::read_to_string(out.join("ltqpso.md")).unwrap().contains("| qpso "));
    assert!(fs::read_to_string(out.join("ltqpso-table-3.csv")).unwrap().starts_with("planner,of,published mean"));

    // The command that is named gives the row of seed 1 again.
    let command = printed.lines().find(|line| line.contains("forage run ltqpso") && line.contains("normal")).unwrap();
    let words: Vec<_> = command.split_once("forage ").expect("a command and its words").1.split_whitespace().chain(["--json"]).collect();
    let again: Value = serde_json::from_slice(&forage(&words).stdout).unwrap();
    let row = rows.lines().find(|line| line.starts_with("table-4,ltqpso,1,")).unwrap();
    assert_eq!(row.split(',').nth(3).unwrap().parse(), Ok(again["cost"].as_f64().unwrap()));
    assert_eq!(row.split(',').nth(4).unwrap().parse(), Ok(again["length"].as_f64().unwrap()));

    // Killed after some rows, in the middle of a line: on one core the rest gives the same rows.
    fs::write(out.join("ltqpso-runs.csv"), &rows[..rows.len() * 3 / 4]).unwrap();
    let resumed = forage(&[&args[..], &["--jobs", "1", "--json"]].concat());
    assert_eq!(without_times(&fs::read_to_string(out.join("ltqpso-runs.csv")).unwrap()), without_times(&rows));
    let report: Value = serde_json::from_slice(&resumed.stdout).unwrap();
    assert_eq!(report[0]["tables"][0]["rows"][0]["published mean"], 16.4604);
}

/// The cells of a JSON report's first row that has these texts.
fn row<'a>(table: &'a Value, planner: &str, of: &str) -> &'a Value {
    table["rows"].as_array().unwrap().iter().find(|row| row["planner"] == planner && row["of"] == of).unwrap()
}

#[test]
fn ants_on_the_thirty_cells_are_printed_drawn_and_repeatable() {
    let out = folder("antbat-paths");
    let args = ["reproduce", "antbat-paths", "--runs", "3", "--out", out.to_str().unwrap()];
    let output = forage(&args);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    let impossible = "45.53 (next to it are 45.4558 and 45.5563), 42.06 (next to it are 42.0416 and 42.1838)";
    for part in ["3 seeds a planner instead of 30", "13.38", "length, smoothed", impossible, "All runs are feasible"] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    let read = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let rows = read("antbat-paths-runs.csv");
    assert_eq!(rows.lines().count(), 1 + 3 * 3);
    let curves = read("antbat-paths-convergence.csv");
    assert!(curves.starts_with("iteration,aco,aco-dijkstra,aco-direction\n1,") && curves.lines().count() == 101, "{curves}");
    let picture = read("antbat-paths-convergence.svg");
    assert!(picture.starts_with("<svg") && ["aco-dijkstra", "exact optimum"].iter().all(|part| picture.contains(part)));

    // Killed in the middle of a line and gone on with one thread: the same bytes.
    fs::write(out.join("antbat-paths-runs.csv"), &rows[..rows.len() / 2]).unwrap();
    let resumed = forage(&[&args[..], &["--jobs", "1", "--json"]].concat());
    assert_eq!((read("antbat-paths-runs.csv"), read("antbat-paths-convergence.csv")), (rows.clone(), curves.clone()));

    // The tables follow from the rows.
    let report: Value = serde_json::from_slice(&resumed.stdout).unwrap();
    let found = row(&report[0]["tables"][0], "aco-direction", "length");
    let lengths: Vec<f64> = rows
        .lines()
        .filter(|line| line.starts_with("aco-direction,"))
        .map(|line| line.split(',').nth(4).unwrap().parse().unwrap())
        .collect();
    assert!((found["mean"].as_f64().unwrap() - lengths.iter().sum::<f64>() / 3.0).abs() < 1e-12);
    assert_eq!((found["published"].as_f64(), found["exact"].as_f64().map(|exact| exact > 42.0416)), (Some(42.06), Some(true)));
    let last: Vec<f64> = curves.lines().last().unwrap().split(',').map(|number| number.parse().unwrap()).collect();
    assert!((last[3] - found["mean"].as_f64().unwrap()).abs() < 1e-9, "the curve ends at the mean");

    // And the command that is named gives the row of seed 1 again.
    let command = printed.lines().find(|line| line.contains("forage run aco-dijkstra")).unwrap();
    let words: Vec<_> = command.split_once("forage ").expect("a command and its words").1.split_whitespace().chain(["--json"]).collect();
    let again: Value = serde_json::from_slice(&forage(&words).stdout).unwrap();
    let first = rows.lines().find(|line| line.starts_with("aco-dijkstra,,1,")).unwrap();
    assert_eq!(first.split(',').nth(4).unwrap().parse(), Ok(again["length"].as_f64().unwrap()));
}

#[test]
fn ants_with_wolves_shares_and_their_tuning_stand_beside_the_paper() {
    let out = folder("wolf-ant");
    let args = ["reproduce", "wolf-ant", "--runs", "2", "--out", out.to_str().unwrap()];
    let output = forage(&args);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    for part in ["602.8420", "40.1421", "found, seed 1", "A true A* cannot be longer", "it cannot be identified"] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    let read = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let (rows, tunings) = (read("wolf-ant-runs.csv"), read("wolf-ant-tunings.csv"));
    // A search, two colonies and the one tuned set.
    assert_eq!((rows.lines().count(), tunings.lines().count()), (1 + 4 * 2, 1 + 1));

    fs::write(out.join("wolf-ant-runs.csv"), &rows[..rows.len() / 2]).unwrap();
    // The tuning that is kept is carried out again to see whether it is this version's: with one thread it agrees.
    let resumed = forage(&[&args[..], &["--jobs", "1", "--json"]].concat());
    assert_eq!(resumed.status.code(), Some(0), "{}", text(&resumed.stderr));
    assert_eq!((read("wolf-ant-runs.csv"), read("wolf-ant-tunings.csv")), (rows, tunings));
    let report: Value = serde_json::from_slice(&resumed.stdout).unwrap();
    let table = &report[0]["tables"][0];
    let exact = row(table, "a-star", "length");
    assert!((exact["mean"].as_f64().unwrap() - 562.842_712_474_619).abs() < 1e-9, "{exact}");
    for planner in ["a-star", "aco", "aco-wolf"] {
        let [length, turns, seconds] = ["length", "turns", "seconds"].map(|of| row(table, planner, of)["mean"].as_f64().unwrap());
        assert!((seconds - length / 20.0 - turns).abs() < 1e-9, "20 px a second and a second for each turn");
    }
    let published = &report[0]["tables"][1]["rows"][0];
    assert_eq!((published["α"].as_f64(), published["Q"].as_f64(), published["fitness"].as_f64()), (Some(1.0), Some(333.0), None));
}

/// The words of the first printed command with this part, as `forage` takes them.
fn command<'a>(printed: &'a str, part: &str) -> Vec<&'a str> {
    let command = printed.lines().find(|line| line.contains(part)).unwrap();
    command.split_once("forage ").expect("a command and its words").1.split_whitespace().chain(["--json"]).collect()
}

#[test]
fn tours_of_twelve_stops_stand_beside_all_five_published_rows() {
    let out = folder("antbat-tours");
    let args = ["reproduce", "antbat-tours", "--runs", "2", "--out", out.to_str().unwrap()];
    let output = forage(&args);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    for (planner, published) in [
        ("bat", "122.02 123.98 122.74 0.95"),
        ("hybrid-bat", "122.88 125.94 123.46 1.83"),
        ("ga", "123.04 127.27 124.27 2.59"),
        ("tour-pso", "123.67 129.18 124.55 3.43"),
        ("sa", "125.94 131.02 128.32 5.46"),
    ] {
        let has = |line: &str| published.split(' ').all(|figure| line.split_whitespace().any(|word| word == figure));
        let found = printed.lines().any(|line| line.split_whitespace().next() == Some(planner) && has(line));
        assert!(found, "{planner}: {published}: {printed}");
    }
    for part in ["2 runs a cell, published: 30", "the exact tour is 122.0833", "0.95 of bat (at most 0.94)", "All runs are feasible"] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    let read = |name: &str| fs::read_to_string(out.join(format!("antbat-tours{name}"))).unwrap();
    let names = ["-runs.csv", "-ants.csv", "-exact-roads.csv", "-smoothed.csv", ".md"];
    let files = names.map(read);
    let rows = &files[0];
    assert_eq!(rows.lines().count(), 1 + 3 * 7 * 2);

    // Killed in the middle of a line and gone on with one thread: the same bytes, and so without any roads to share.
    fs::write(out.join("antbat-tours-runs.csv"), &rows[..rows.len() / 2]).unwrap();
    let resumed = forage(&[&args[..], &["--jobs", "1", "--json"]].concat());
    assert_eq!(names.map(read), files);

    // The tables follow from the rows.
    let report: Value = serde_json::from_slice(&resumed.stdout).unwrap();
    let tables = report[0]["tables"].as_array().unwrap();
    let found = &tables[0]["rows"][0];
    let lengths: Vec<f64> =
        rows.lines().filter(|line| line.starts_with("ants,bat,")).map(|line| line.split(',').nth(4).unwrap().parse().unwrap()).collect();
    let [a, b] = lengths[..] else { panic!("{lengths:?}") };
    assert!((found["mean"].as_f64().unwrap() - f64::midpoint(a, b)).abs() < 1e-12);
    assert!((found["variance"].as_f64().unwrap() - (a - b) * (a - b) / 2.0).abs() < 1e-12, "with n − 1");
    for table in tables {
        let exact = table["rows"].as_array().unwrap().iter().find(|row| row["planner"] == "held-karp").unwrap();
        assert_eq!(exact["best order"], "2 of 2", "{table}");
    }
    assert_eq!(tables[1]["rows"][6]["exact tour"], "2 of 2");

    let again: Value = serde_json::from_slice(&forage(&command(&printed, "forage run bat")).stdout).unwrap();
    assert_eq!(again["length"].as_f64(), Some(a));
}

#[test]
fn the_time_of_tours_is_measured_and_drawn_over_the_number_of_stops() {
    let out = folder("antbat-time");
    let args = ["reproduce", "antbat-time", "--runs", "2", "--out", out.to_str().unwrap()];
    let output = forage(&args);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    for part in ["2 runs a planner and number of stops instead of 5", "The times are not reproducible", "timed one after the other"] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    let read = |name: &str| fs::read_to_string(out.join(name)).unwrap();
    let (rows, picture) = (read("antbat-time-runs.csv"), read("antbat-time.svg"));
    // Six numbers of stops; held-karp takes three of them, the two other methods two when runs are few.
    assert_eq!(rows.lines().count(), 1 + (6 * 6 + 3 + 2 * 2) * 2);
    assert!(rows.starts_with("method,stops,seed,feasible,length,gap,evaluations,measured_threads,measured_roads_ms,"), "{rows}");
    assert!(picture.starts_with("<svg") && ["order alone", "held-karp", "stops"].iter().all(|part| picture.contains(part)));
    assert!(read("antbat-time-growth.csv").lines().count() > 3);

    // Everything but what was measured is the same, interrupted and with two at once.
    let computed = |rows: &str| rows.lines().map(|line| line.split(',').take(7).collect::<Vec<_>>().join(",")).collect::<Vec<_>>();
    fs::write(out.join("antbat-time-runs.csv"), &rows[..rows.len() - 150]).unwrap();
    let resumed = forage(&[&args[..], &["--jobs", "2", "--json"]].concat());
    assert_eq!(computed(&read("antbat-time-runs.csv")), computed(&rows));
    let report: Value = serde_json::from_slice(&resumed.stdout).unwrap();
    assert!(report[0]["notes"].as_array().unwrap().iter().any(|note| note.as_str().unwrap().contains("SIDE BY SIDE")));
    let found = &report[0]["tables"][0]["rows"][0];
    assert_eq!((found["method"].as_str(), found["stops"].as_f64(), found["roads"].as_f64()), (Some("bat"), Some(5.0), Some(10.0)));

    // The scenes are written, so that the commands that are named work.
    let again: Value = serde_json::from_slice(&forage(&command(&printed, "ant-bat-30-10-stops.json")).stdout).unwrap();
    let row = rows.lines().find(|line| line.starts_with("bat,10,1,")).unwrap();
    assert_eq!(row.split(',').nth(4).unwrap().parse().ok(), again["length"].as_f64());
}

#[test]
fn trees_with_and_without_a_cuboid_are_told_with_every_seed_that_failed() {
    let out = folder("arm-rrt");
    let args = ["reproduce", "arm-rrt", "--runs", "2", "--out", out.to_str().unwrap()];
    let output = forage(&args);
    assert_eq!(output.status.code(), Some(0), "{}", text(&output.stderr));
    let printed = text(&output.stdout);
    for part in ["2 seeds a cell instead of 100", "exact optimum 1.3516 m", "feasible runs, %", "its largest sideways deviation, m"] {
        assert!(printed.contains(part), "{part}: {printed}");
    }
    let read = |name: &str| fs::read_to_string(out.join(format!("arm-rrt-{name}.csv"))).unwrap();
    let rows = read("runs");
    // Two scenes; four planners with two steps, and the joints' tree with its own.
    assert_eq!(rows.lines().count(), 1 + 2 * (4 * 2 + 1) * 2);
    assert!(rows.lines().next().unwrap().ends_with(",measured_ms,digest"), "the time is the last column but the digest: {rows}");

    // Killed in the middle of a line and gone on with one thread: the same but for the times.
    fs::write(out.join("arm-rrt-runs.csv"), &rows[..rows.len() / 2]).unwrap();
    let resumed = forage(&[&args[..], &["--jobs", "1", "--json"]].concat());
    assert_eq!(without_times(&read("runs")), without_times(&rows));

    // The tables follow from the rows, and no path is shorter than the optimum.
    let report: Value = serde_json::from_slice(&resumed.stdout).unwrap();
    let heading: Vec<&str> = rows.lines().next().unwrap().split(',').collect();
    let column = |name: &str| heading.iter().position(|column| *column == name).unwrap();
    let guided: Vec<Vec<&str>> =
        rows.lines().filter(|line| line.starts_with("arm-cuboid,rrt-guided,0.03,")).map(|line| line.split(',').collect()).collect();
    let number = |row: &[&str], name: &str| row[column(name)].parse::<f64>().unwrap();
    let found = report[0]["tables"][0]["rows"].as_array().unwrap().iter().find(|row| row["planner"] == "rrt-guided").unwrap();
    let nodes = guided.iter().map(|row| number(row, "nodes")).sum::<f64>() / 2.0;
    assert_eq!((found["found"].as_str(), found["nodes, mean"].as_f64()), (Some("2 of 2"), Some(nodes)));
    assert!(found["over exact %"].as_f64().unwrap() > 0.0);

    // And the command that is named gives the row of seed 1 again.
    let again: Value = serde_json::from_slice(&forage(&command(&printed, "forage run rrt-guided --scene arm-cuboid")).stdout).unwrap();
    assert_eq!(again["length"].as_f64(), Some(number(&guided[0], "length")));
}

/// Ctrl-C: what is finished is kept, and the same command goes on from there.
#[cfg(unix)]
#[test]
fn an_interrupt_keeps_what_is_finished() {
    let out = folder("interrupt");
    let args = ["reproduce", "ltqpso", "--runs", "500", "--jobs", "1", "--out", out.to_str().unwrap()];
    let child = support::command(&args).stderr(Stdio::piped()).spawn().unwrap();
    let rows = out.join("ltqpso-runs.csv");
    let lines = || fs::read_to_string(&rows).map_or(0, |text| text.lines().count());
    for _ in 0..600 {
        if lines() > 2 {
            break;
        }
        std::thread::sleep(std::time::Duration::from_millis(20));
    }
    Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(130));
    let message = text(&output.stderr);
    assert!(message.contains(&format!("{} of 4000 rows are kept", lines() - 1)), "{message}");
}
