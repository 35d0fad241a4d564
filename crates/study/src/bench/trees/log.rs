//! Logs as OMPL's benchmarks write them: `ompl_benchmark_statistics` makes a database of them, which Planner Arena shows.
//!
//! The format: <https://ompl.kavrakilab.org/benchmark.html>

use std::{
    fmt::Write as _,
    path::{Path, PathBuf},
    sync::Arc,
};

use forage::Scene;

use super::{
    super::{
        super::disk,
        super::failure::{Failure, at},
        suite::{distinct, recreate_folder, safe_file_name},
    },
    row::Row,
};

/// What is said of each run.
const PROPERTIES: [&str; 9] = [
    "time REAL",
    "solved BOOLEAN",
    "solution length REAL",
    "solution clearance REAL",
    "solution optimality gap REAL",
    "evaluations INTEGER",
    "iterations INTEGER",
    "graph states INTEGER",
    "random seed INTEGER",
];
/// And of how it went.
const PROGRESS: [&str; 3] = ["time REAL", "evaluations INTEGER", "best cost REAL"];

/// Writes a log for each scene, and the scene beside it, for scripts that run other planners there.
pub(super) fn write(rows: &[Row], scenes: &[Arc<Scene>], budget: u64, folder: &Path) -> Result<PathBuf, Failure> {
    recreate_folder(folder)?;
    for scene in scenes {
        let own: Vec<&Row> = rows.iter().filter(|row| row.scene == scene.name()).collect();
        if !own.is_empty() {
            let name = safe_file_name(scene.name());
            let file = folder.join(format!("{name}.log"));
            disk::write(&file, log(&own, scene, budget)).map_err(at(&file))?;
            let file = folder.join(format!("{name}.json"));
            disk::write(&file, scene.to_json()).map_err(at(&file))?;
        }
    }
    Ok(folder.to_owned())
}

fn log(rows: &[&Row], scene: &Scene, budget: u64) -> String {
    let mut out = String::new();
    let planners = distinct(rows.iter().map(|row| row.contender()));
    let runs = rows.iter().map(|row| row.seed).max().unwrap_or(0);
    let total: f64 = rows.iter().map(|row| row.seconds).sum();
    // Writing to a text cannot fail.
    let _ = writeln!(out, "Forage version {}\nExperiment {}", env!("CARGO_PKG_VERSION"), one_word(scene.name()));
    let _ = writeln!(out, "1 experiment properties\nbudget INTEGER = {budget}");
    // Rows are kept, and may have been computed on several machines: the log says of none when and where.
    let _ = writeln!(out, "Running on unknown\nStarting at unknown");
    let _ = writeln!(out, "<<<|\n{} ({})\n|>>>", scene.header().title.replace(['\n', '|'], " "), scene.kind().name());
    // Runs end by their evaluations: no time or memory is set.
    let _ = writeln!(out, "1 is the random seed\ninf seconds per run\ninf MB per run\n{runs} runs per planner");
    let _ = writeln!(out, "{total} seconds spent to collect the data\n0 enum types\n{} planners", planners.len());
    for planner in planners {
        let own: Vec<&&Row> = rows.iter().filter(|row| row.contender() == planner).collect();
        let set: Vec<&str> = own.first().map_or("", |row| &row.params).split(' ').filter(|pair| !pair.is_empty()).collect();
        let _ = writeln!(out, "{planner}\n{} common properties", set.len());
        set.iter().for_each(|pair| out.extend([&pair.replacen('=', " = ", 1), "\n"]));
        let _ = writeln!(out, "{} properties for each run\n{}\n{} runs", PROPERTIES.len(), PROPERTIES.join("\n"), own.len());
        for row in &own {
            let number = |number: Option<f64>| number.map_or(String::new(), |number| number.to_string());
            let values = [
                row.seconds.to_string(),
                u8::from(row.solved).to_string(),
                number(row.length),
                number(row.clearance),
                number(row.gap()),
                row.evaluations.to_string(),
                row.iterations.to_string(),
                number(row.nodes),
                row.seed.to_string(),
            ];
            values.iter().for_each(|value| out.extend([value, "; "]));
            out.push('\n');
        }
        let _ = writeln!(out, "{} progress properties for each run\n{}\n{} runs", PROGRESS.len(), PROGRESS.join("\n"), own.len());
        for row in &own {
            let mut before = None;
            for (evaluations, length, seconds) in row.progress() {
                // The database takes one entry a time.
                if before != Some(seconds) {
                    let _ = write!(out, "{seconds},{evaluations},{length},;");
                }
                before = Some(seconds);
            }
            out.push('\n');
        }
        out.push_str(".\n");
    }
    out
}

/// Names end at a blank.
fn one_word(name: &str) -> String {
    name.split_whitespace().collect::<Vec<_>>().join("_")
}
