//! Measures TSPLIB's own tours by the crate's formulas. Its files do not ship, as it names no licence: who has them lays
//! `NAME.tsp` and `NAME.opt.tour` into a folder.
//!
//! `cargo run --release -p forage-lab-formats --example tsplib -- FOLDER` prints each length beside the published one; it fails where they differ.

use std::{path::Path, process::ExitCode};

use forage::scene::TourScene;
use forage_formats::{NamedFile, import};

/// Names of instances, and the lengths of their optimal tours.
const OPTIMA: [(&str, f64); 17] = [
    ("a280", 2579.0),
    ("att48", 10628.0),
    ("bayg29", 1610.0),
    ("bays29", 2020.0),
    ("berlin52", 7542.0),
    ("brg180", 1950.0),
    ("ch150", 6528.0),
    ("eil51", 426.0),
    ("fri26", 937.0),
    ("gr48", 5046.0),
    ("gr96", 55209.0),
    ("gr202", 40160.0),
    ("kroA100", 21282.0),
    ("pa561", 2763.0),
    ("st70", 675.0),
    ("ulysses16", 6859.0),
    ("ulysses22", 7013.0),
];

/// The lengths of the tours 1, 2, 3, … that TSPLIB gives so that programs can check their formulas.
const CANONICAL: [(&str, f64); 3] = [("pcb442", 221_440.0), ("gr666", 423_710.0), ("att532", 309_636.0)];

fn main() -> ExitCode {
    let Some(folder) = std::env::args().nth(1) else {
        eprintln!("usage: cargo run --release -p forage-lab-formats --example tsplib -- FOLDER");
        return ExitCode::from(2);
    };
    let read = |names: &[String]| -> Result<_, String> {
        let file = |name: &String| {
            let bytes = std::fs::read(Path::new(&folder).join(name)).map_err(|error| format!("{name}: {error}"))?;
            Ok(NamedFile::new(name.clone(), bytes))
        };
        let files = names.iter().map(file).collect::<Result<Vec<_>, String>>()?;
        import(forage::standard(), &files, None).map_err(|error| error.to_string())
    };
    let optimum = |name: &str| {
        let read = read(&[format!("{name}.tsp"), format!("{name}.opt.tour")])?;
        Ok(read.scene.header().exact.as_ref().and_then(|exact| exact["length"].as_f64()))
    };
    let canonical = |name: &str| {
        let read = read(&[format!("{name}.tsp")])?;
        Ok(read.scene.get::<TourScene>().ok().map(|tour| tour.distances().length(&(0..tour.len()).collect::<Vec<_>>(), true)))
    };
    let mut fine = true;
    let all = OPTIMA.map(|row| (row, true)).into_iter().chain(CANONICAL.map(|row| (row, false)));
    for ((name, published), optimal) in all {
        let found: Result<Option<f64>, String> = if optimal { optimum(name) } else { canonical(name) };
        match found {
            Ok(found) if found == Some(published) => println!("{name:12} {published}"),
            other => {
                fine = false;
                println!("{name:12} {published} was published, this is {other:?}");
            }
        }
    }
    ExitCode::from(u8::from(!fine))
}
