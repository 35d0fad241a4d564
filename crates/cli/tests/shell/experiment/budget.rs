//! Equal evaluations for all planners, and how their best fell.

use std::{fs, fs::File, path::Path};

use parquet::{
    file::reader::{FileReader, SerializedFileReader},
    record::Field,
};

use super::support::{carry_out, column, folder, forage, refused, rows, text};

const UNEQUAL: &str = "
scenes = ['sphere', 'wcpso-discs']
seeds = [1, 2]
[[planner]]
name = 'pso'
params = { population = 10, iterations = 30 }
[[planner]]
name = 'wcpso'
params = { population = 40, hen_timing = 'after' }
[[planner]]
name = 'cuckoo-search'
";

/// The numbers of a column, by planner.
fn numbers(out: &Path, planner: &str, name: &str) -> Vec<f64> {
    let at = column(out, name);
    rows(out).iter().filter(|row| &row[1] == planner).map(|row| row[at].parse().unwrap_or(f64::NAN)).collect()
}

#[test]
fn all_planners_stop_at_the_evaluations_that_the_first_takes() {
    let folder = folder("budget", UNEQUAL);
    let printed = carry_out(&folder, &[]);
    let out = folder.join("sweep.csv");
    // 10 particles are evaluated once before 30 iterations.
    for planner in ["pso", "wcpso", "cuckoo-search"] {
        assert_eq!(numbers(&out, planner, "budget"), [310.0; 4], "{planner}");
        // The iteration that was begun is finished: at most another population's, of hens and chicks twice.
        let spent = numbers(&out, planner, "evaluations");
        assert!(spent.iter().all(|spent| (310.0..310.0 + 2.0 * 60.0).contains(spent)), "{planner}: {spent:?}");
    }
    assert_eq!(numbers(&out, "pso", "limit"), [30.0; 4]);
    assert_eq!(numbers(&out, "pso", "evaluations"), [310.0; 4]);
    assert!(printed.contains("with a budget of 310 evaluations") && printed.contains("An evaluation is a position."), "{printed}");

    // A run of the row is one of the program, as long as it may be.
    let row = rows(&out).into_iter().find(|row| &row[1] == "wcpso" && &row[0] == "sphere").unwrap();
    let set = ["--set", "population=40", "--set", "hen_timing=after", "--iterations", &row[column(&out, "limit")]];
    let trace = folder.join("trace.csv");
    let run = forage(&[&["run", "wcpso", "--scene", "sphere", "--seed", "1", "--trace", trace.to_str().unwrap()], &set[..]].concat());
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let iterations: usize = row[column(&out, "iterations")].parse().unwrap();
    let best = rows(&trace)[iterations][column(&trace, "best")].parse::<f64>().unwrap();
    assert_eq!(best, row[column(&out, "cost")].parse::<f64>().unwrap());
}

#[test]
fn a_budget_is_what_the_file_says() {
    let own = folder("budget-own", &format!("budget = 'own'\n{UNEQUAL}"));
    let printed = carry_out(&own, &[]);
    let out = own.join("sweep.csv");
    assert!(numbers(&out, "wcpso", "budget").iter().all(|budget| budget.is_nan()));
    assert_eq!(numbers(&out, "pso", "evaluations"), [310.0; 4]);
    assert!(numbers(&out, "cuckoo-search", "evaluations").iter().all(|spent| *spent > 1000.0));
    assert!(printed.contains("each with its own iterations") && !printed.contains("An evaluation is"), "{printed}");

    // What is set for a planner counts more than the budget; the rest spend it.
    let number = folder("budget-number", &format!("budget = 2000\n{UNEQUAL}"));
    carry_out(&number, &[]);
    let out = number.join("sweep.csv");
    assert_eq!(numbers(&out, "pso", "evaluations"), [310.0; 4]);
    for planner in ["wcpso", "cuckoo-search"] {
        assert!(numbers(&out, planner, "evaluations").iter().all(|spent| (2000.0..2200.0).contains(spent)), "{planner}");
    }
    // Rows of another budget are others.
    fs::write(number.join("sweep.toml"), format!("budget = 2001\n{UNEQUAL}")).unwrap();
    assert!(refused(&number, &[]).contains("`budget` is 2000, not 2001"));
    // With so many iterations for all each has its own evaluations, as the file says.
    let iterations = folder("budget-iterations", &UNEQUAL.replacen("seeds", "iterations = 3\nseeds", 1));
    carry_out(&iterations, &[]);
    assert!(numbers(&iterations.join("sweep.csv"), "wcpso", "budget").iter().all(|budget| budget.is_nan()));
    for (wrong, shown) in [("0", "0"), ("-5", "-5"), ("1.5", "1.5"), ("'all'", "\"all\""), ("[5]", "a list of 1")] {
        let wrong = folder("budget-refused", &format!("budget = {wrong}\n{UNEQUAL}"));
        assert!(refused(&wrong, &[]).contains(&format!("`budget` is {shown}; it must be evaluations")), "{}", refused(&wrong, &[]));
    }
}

/// What improves its first tours before the first iteration takes more than the budget has, and the statistics say so.
#[test]
fn planners_that_exceed_the_budget_are_named() {
    let folder = folder(
        "budget-over",
        "scenes = ['random-52']\nseeds = [1, 2]\nbudget = 2000\n[[planner]]\nname = 'sa'\n[[planner]]\nname = 'bat'\n",
    );
    let printed = carry_out(&folder, &[]);
    assert!(printed.contains("more than the budget") && printed.contains("bat (up to ") && !printed.contains("sa (up to"), "{printed}");
}

#[test]
fn what_an_evaluation_is_differs() {
    let folder = folder(
        "budget-things",
        "scenes = ['qpso-10m']\nseeds = [1, 2]\nbudget = 200\n[[planner]]\nname = 'a-star'\n[[planner]]\nname = 'aco'\n",
    );
    let printed = carry_out(&folder, &[]);
    assert!(
        printed.contains("Evaluations are of different kinds: a cell that is closed (a-star); an ant’s path from the start (aco)."),
        "{printed}"
    );
}

#[test]
fn curves_say_when_the_best_fell() {
    let folder = folder("curves", UNEQUAL);
    let [csv, parquet] = ["curves.csv", "curves.parquet"].map(|name| folder.join(name));
    carry_out(&folder, &["--curves", csv.to_str().unwrap()]);
    let points = rows(&csv);
    let out = folder.join("sweep.csv");
    let [scene, planner, seed, evaluations, value] = ["scene", "planner", "seed", "evaluations", "value"].map(|name| column(&csv, name));
    for row in rows(&out) {
        let own: Vec<_> =
            points.iter().filter(|point| point[scene] == row[0] && point[planner] == row[1] && point[seed] == row[2]).collect();
        let number = |point: &csv::StringRecord, at: usize| point[at].parse::<f64>().unwrap();
        assert!(own.windows(2).all(|pair| number(pair[0], evaluations) < number(pair[1], evaluations)), "{row:?}");
        let best = row[column(&out, "value")].parse::<f64>().ok();
        assert_eq!(own.last().map(|point| number(point, value)), best, "{row:?}");
    }
    // The same table in the other format; the runs are carried out again for it, and must be the same.
    carry_out(&folder, &["--curves", parquet.to_str().unwrap()]);
    let reader = SerializedFileReader::new(File::open(&parquet).unwrap()).unwrap();
    let names: Vec<String> = reader.metadata().file_metadata().schema().get_fields().iter().map(|field| field.name().to_owned()).collect();
    assert_eq!(names.join(","), fs::read_to_string(&csv).unwrap().lines().next().unwrap());
    let found: Vec<Vec<(String, Field)>> = reader.get_row_iter(None).unwrap().map(|row| row.unwrap().into_columns()).collect();
    assert_eq!(found.len(), points.len());
    for (point, found) in points.iter().zip(&found) {
        for (at, (name, field)) in found.iter().enumerate() {
            match field {
                Field::Null => assert_eq!(&point[at], "", "{name}"),
                Field::Str(text) => assert_eq!(&point[at], text, "{name}"),
                Field::Long(number) => assert_eq!(point[at].parse().ok(), Some(*number), "{name}"),
                Field::Double(number) => assert_eq!(point[at].parse().ok(), Some(*number), "{name}"),
                other => panic!("{name}: {other}"),
            }
        }
    }
    let population = names.iter().position(|name| name == "population").unwrap();
    assert_eq!([&found[0], found.last().unwrap()].map(|row| row[population].1.clone()), [Field::Double(10.0), Field::Null]);
}

#[test]
fn curves_of_parts_are_taken_together_and_what_is_kept_is_not_run_again() {
    let folder = folder("curves-parts", UNEQUAL);
    let [csv, whole, merged] = ["curves.csv", "whole.csv", "merged.csv"].map(|name| folder.join(name));
    for part in ["1/2", "2/2"] {
        carry_out(&folder, &["--shard", part, "--curves", csv.to_str().unwrap()]);
    }
    assert!(!csv.exists());
    let parts = ["sweep.1-of-2.csv", "sweep.2-of-2.csv"].map(|part| folder.join(part).to_str().unwrap().to_owned());
    let mut args = vec!["--out", merged.to_str().unwrap(), "--curves", csv.to_str().unwrap(), "--merge"];
    args.extend(parts.iter().map(String::as_str));
    carry_out(&folder, &args);
    carry_out(&folder, &["--out", folder.join("other.csv").to_str().unwrap(), "--curves", whole.to_str().unwrap()]);
    assert!(fs::read(&csv).unwrap() == fs::read(&whole).unwrap());
    let kept = folder.join("whole.csv.runs.csv");
    let text = fs::read_to_string(&kept).unwrap();
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let hash = lines[2].split(',').find(|cell| cell.len() == 16 && cell.chars().all(|c| c.is_ascii_hexdigit())).unwrap();
    let again = |kept_now: String| {
        fs::write(&kept, kept_now).unwrap();
        carry_out(&folder, &["--out", folder.join("other.csv").to_str().unwrap(), "--curves", whole.to_str().unwrap()]);
        assert!(fs::read_to_string(&kept).unwrap().lines().count() >= lines.len());
        fs::read_to_string(&whole).unwrap()
    };
    // A run whose curve is not kept is carried out again, whether it is missing, cut off, or changed.
    let all = fs::read_to_string(&csv).unwrap();
    let changed = text.replace(lines[2], &lines[2].replacen(':', ":1", 1));
    for kept_now in [lines[..7].concat(), text[..text.len() - 9].to_owned(), text.replace(hash, "0123456789abcdef"), changed] {
        assert!(kept_now != text && again(kept_now) == all);
    }
    let message = refused(&folder, &["--curves", "curves.xls"]);
    assert!(message.contains("`--curves` is curves.xls; it must be a file that ends in .csv or .parquet"), "{message}");
}
