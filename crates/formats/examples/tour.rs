//! Reads stops in TSPLIB's format, finds a tour, and writes it as TSPLIB does: `cargo run -p forage-lab-formats --example tour > eight.tour`.

use std::sync::Arc;

use forage::{Error, Overrides, Run, Setup, standard};
use forage_formats::{NamedFile, import, tour_file};

const STOPS: &str = "NAME: eight
TYPE: TSP
DIMENSION: 8
EDGE_WEIGHT_TYPE: EUC_2D
NODE_COORD_SECTION
1 0 0
2 10 80
3 40 20
4 60 90
5 80 30
6 95 75
7 30 55
8 70 5
EOF
";

fn main() -> Result<(), Error> {
    let scene = Arc::new(import(standard(), &[NamedFile::new("eight.tsp", STOPS)], None)?.scene);
    let mut run = Run::new(standard(), Setup { planner: "hybrid-bat".into(), scene, params: Overrides::new(), seed: 1 })?;
    run.step(run.limit());
    let outcome = run.outcome();
    eprintln!("length {:?}, shortest {:?} ({:?})", outcome.length, outcome.exact, outcome.exact_by);
    let file = tour_file("eight.tour", &outcome.order.unwrap_or_default());
    print!("{}", String::from_utf8_lossy(&file.bytes));
    Ok(())
}
