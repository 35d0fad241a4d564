//! Searches over cells with a heuristic from outside.

use forage::{
    Status,
    describe::Entry,
    search::{self, Heuristic, Relaxation, a_star, dijkstra},
};

use crate::support::{run_to_end, scene, start};

const fn entry(name: &'static str, run: fn(&forage::describe::Start) -> Result<forage::kernel::Started, forage::Error>) -> Entry {
    Entry::new(name, "", "", "", run).like(&dijkstra::ENTRY)
}

/// Columns and rows: too long where it goes diagonally.
const GREEDY: Entry =
    entry("greedy", |start| search::start(start, Heuristic::Own(|[columns, rows]| columns + rows), 1e6, Relaxation::Step));
/// The larger of both: never too long.
const CHEBYSHEV: Entry =
    entry("chebyshev", |start| search::start(start, Heuristic::Own(|[columns, rows]| columns.max(rows)), 1.0, Relaxation::Step));
const NONSENSE: Entry = entry("nonsense", |start| search::start(start, Heuristic::Own(|_| f64::NAN), 1.0, Relaxation::Step));
const ENDLESS: Entry = entry("endless", |start| search::start(start, Heuristic::Own(|_| f64::INFINITY), 1.0, Relaxation::Sight));
const BACKWARDS: Entry = entry("backwards", |start| search::start(start, Heuristic::Straight, -1.0, Relaxation::Step));

/// A dead end between start and goal.
const TEXT: &str = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "g", "title": "G", "cell": 1,
    "rows": ["............", ".........##.", "..........#.", "..........#.", ".......####.", "............"],
    "start": [0.5, 3.5], "goal": [11.5, 3.5]}"#;

#[test]
fn a_heuristic_from_outside_keeps_the_shortest_path_if_it_is_never_too_long() {
    let run = |entry: &'static Entry| {
        let run = run_to_end(start(entry, &scene(TEXT), &[("expand", "1")], 1).unwrap());
        assert_eq!(run.status, Status::Solved, "{}", entry.name);
        (run.planner.best().unwrap().cost, run.planner.evaluations())
    };
    let (exact, all) = run(&dijkstra::ENTRY);
    let [(informed, some), (greedy, few), (nonsense, as_many)] = [&CHEBYSHEV, &GREEDY, &NONSENSE].map(run);
    assert_eq!((informed, nonsense, as_many), (exact, exact, all), "what is no number counts as 0");
    assert!(some < all && few < some && greedy > exact, "{all} {some} {few} {exact} {greedy}");
    assert!(run(&a_star::ENTRY).1 <= some, "the octile distance says more");
    assert!(run(&ENDLESS).0.is_finite());
}

#[test]
fn a_weight_below_0_is_refused() {
    let error = start(&BACKWARDS, &scene(TEXT), &[], 1).map(|_| ()).unwrap_err();
    assert_eq!(error.to_string(), "weight: -1 is not allowed; it must be a finite number from 0 on");
}
