//! Colonies of ants with parts from outside.

use std::sync::Arc;

use forage::{
    Overrides, Status,
    ants::{self, Colony, Direction, Heuristic, Update, Variant, aco},
    describe::{Entry, layers},
    kernel::{Item, Planner},
    scene::GridScene,
    search::dijkstra,
};

use crate::support::{run_to_end, scene, start};

/// A wall with a door between start and goal.
const TEXT: &str = r#"{"format": "forage-scene", "version": 1, "kind": "grid", "name": "g", "title": "G", "cell": 2,
    "rows": ["....#...", "....#...", "........", "....#...", "....#..."], "start": [1, 9], "goal": [15, 9]}"#;

/// Sight by the larger of columns and rows; only what is better than the median is rewarded.
const MIXED: Variant = Variant {
    heuristic: Heuristic::Own(|cells, next, goal| {
        let [[x, y], [to_x, to_y]] = [next, goal].map(|cell| cells.place(cell));
        1.0 / (x.abs_diff(to_x).max(y.abs_diff(to_y)) as f64).max(0.5)
    }),
    update: Update::Own(|ant| {
        let [shortest, median, longest] = ant.iteration;
        assert!(ant.global <= shortest && shortest <= median && median <= longest);
        assert!((shortest..=longest).contains(&ant.length));
        if ant.length <= median { ant.q / ant.length } else { f64::NAN }
    }),
    gamma: 1.0,
    direction: Direction::Linear,
    greed: [0.0, 0.5],
    ..Variant::TRADITIONAL
};

const ENTRY: Entry = Entry::new("aco-mixed", "", "", "", |start| ants::start(start, MIXED)).like(&aco::ENTRY);

#[test]
fn a_colony_with_parts_from_outside_finds_the_length_that_dijkstra_finds() {
    let exact = run_to_end(start(&dijkstra::ENTRY, &scene(TEXT), &[], 1).unwrap()).planner.best().unwrap().cost;
    let run = run_to_end(start(&ENTRY, &scene(TEXT), &[], 1).unwrap());
    assert_eq!((run.iteration, run.status), (100, Status::Exhausted));
    let best = run.planner.best().unwrap();
    assert!((best.cost - exact).abs() < 1e-9, "{} {exact}", best.cost);
    let explain = run.planner.facets().explain.unwrap();
    let cell = explain.inspect(Item { layer: layers::PHEROMONE.key, index: 0 }).unwrap();
    assert!(cell.columns.iter().any(|column| column.name == "psi") && cell.formulas == ["choice", "direction_linear"], "{cell:?}");
    let ant = explain.inspect(Item { layer: layers::ANTS.key, index: 0 }).unwrap();
    assert!(ant.event == "arrived" && ant.formulas.is_empty(), "{ant:?}");
}

#[test]
fn a_colony_can_be_looked_into() {
    let scene = scene(TEXT);
    let grid = scene.share::<GridScene>().unwrap();
    let parameters = ENTRY.configure(scene.kind(), &Overrides::new()).unwrap();
    let mut colony = Colony::new(&grid, &parameters, 1, MIXED).unwrap();
    assert!(colony.is_reachable() && colony.path().is_none());
    (0..100).for_each(|_| {
        colony.advance();
    });
    let (path, cells) = (colony.path().unwrap(), colony.cells());
    assert_eq!(colony.length(), colony.best().map(|best| best.cost));
    assert!(path.windows(2).all(|step| (0..8).any(|d| cells.moves(step[0]) >> d & 1 != 0 && cells.next(step[0], d) == step[1])));
    // All ants set out from the start, none goes on from the goal.
    let most = |cell| (0..8).map(|d| colony.pheromone(cell, d)).fold(0.0, f64::max);
    assert!(most(path[0]) > most(path[path.len() - 1]));
}

#[test]
fn a_variant_beyond_its_range_and_a_heuristic_that_is_no_number_do_no_harm() {
    let scene = scene(TEXT);
    let grid = scene.share::<GridScene>().unwrap();
    let parameters = ENTRY.configure(scene.kind(), &Overrides::new()).unwrap();
    let colony = |variant| Colony::new(&grid, &parameters, 1, variant).map(Arc::new);
    let refused = |variant| colony(variant).map(|_| ()).unwrap_err().to_string();
    assert_eq!(refused(Variant { greed: [0.0, 2.0], ..MIXED }), "greed[1]: 2 is not allowed; it must be a number from 0 to 1");
    assert!(refused(Variant { gamma: f64::NAN, ..MIXED }).starts_with("gamma: NaN"));
    for eta in [f64::NAN, f64::INFINITY, -1.0] {
        let heuristic = match eta {
            eta if eta.is_nan() => Heuristic::Own(|_, _, _| f64::NAN),
            eta if eta > 0.0 => Heuristic::Own(|_, _, _| f64::INFINITY),
            _ => Heuristic::Own(|_, _, _| -1.0),
        };
        let mut colony = Colony::new(&grid, &parameters, 1, Variant { heuristic, ..Variant::TRADITIONAL }).unwrap();
        (0..20).for_each(|_| {
            colony.advance();
        });
        assert!(colony.length().is_some_and(f64::is_finite), "{eta}: all steps attract alike");
    }
}
