//! The colony's formulas against hand-computed values, and what must hold for it on any map.

use std::{collections::BTreeSet, sync::Arc};

use super::{colony::Variant, ground::*, pheromone::Pheromone, update::Update, walk::*, *};
use crate::{
    Overrides, Run, Setup, Status, Value,
    describe::layers,
    kernel::rng::Stream,
    kernel::{Digest, Frame, Item, Part, Planner, ReferenceOptimum},
    scene::{GridScene, Header, Scene, grid},
    settled::Settled,
    standard,
};

fn scene(rows: &[&str], start: [f64; 2], goal: [f64; 2]) -> Arc<Scene> {
    let blocked = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
    let grid = GridScene { start: Some(start), goal: Some(goal), ..GridScene::new(1.0, rows[0].len(), blocked) };
    let header = Header { name: "test".into(), title: "Test".into(), note: None, source: None, units: None, exact: None, published: None };
    Arc::new(grid::KIND.scene(header, grid).unwrap())
}

const PLAIN: Variant = Variant::TRADITIONAL;

/// A colony with given lengths instead of walks of its own: ant k went right `k`'s number of steps.
fn colony(scene: &Arc<Scene>, variant: Variant) -> Colony {
    let ground = Ground::new(&scene.share().unwrap(), variant.heuristic, 2.0, variant.gamma, variant.direction).unwrap();
    Colony {
        variant,
        rules: Rules { backtracks: false, limit: 1000 },
        ants: 1,
        q: 12.0,
        smooth: false,
        pheromone: Pheromone::new(&ground.cells, 1.0, 1.0, 0.4, [0.1, 50.0]),
        walks: Walks::default(),
        kept: 1000,
        again: Walks::default(),
        seen: Seen::new(ground.cells.len()),
        lengths: Vec::new(),
        best: None,
        converged: 0,
        settled: Settled::default(),
        iteration: 0,
        limit: 100,
        rng: Stream::new(1, 0),
        part: Part::default(),
        ground: Arc::new(ground),
    }
}

fn run(scene: &Arc<Scene>, planner: &str, params: &[(&str, &str)], seed: u64) -> Run {
    let params: Overrides = params.iter().map(|&(name, value)| (name, Value::from(value))).collect();
    Run::new(standard(), Setup { planner: planner.into(), scene: Arc::clone(scene), params, seed }).unwrap()
}

/// [ANTBAT](crate#papers) (1) by hand: two cells to choose from, at distances 1 and √2 from the goal, η² = 1 and 1/2; τ = 1
/// and 3. Shares: 1 · 1 to 3 · 1/2, i.e. 0.4 and 0.6.
#[test]
fn probabilities_follow_the_formula() {
    let scene = scene(&["...", "...", "..."], [0.5, 0.5], [2.5, 1.5]);
    let mut colony = colony(&scene, PLAIN);
    // From (0, 0): east (1, 0) is √2 from (2, 1), south-east (1, 1) is 1 from it, south (0, 1) is 2 from it.
    colony.pheromone.favour(&colony.ground, 0, 0, 3.0);
    let inspection = explain::cell(&colony, Item { layer: layers::PHEROMONE.key, index: 0 }, None).unwrap();
    let p: Vec<_> = inspection.rows.iter().map(|row| *row.last().unwrap()).collect();
    let (east, diagonal, south) = (3.0 * 0.5, 1.0, 0.25);
    let sum = east + diagonal + south;
    for (p, weight) in p.iter().zip([east, diagonal, south, 0.0, 0.0, 0.0, 0.0, 0.0]) {
        assert!((p - weight / sum).abs() < 1e-15, "{p} {}", weight / sum);
    }
    assert_eq!(inspection.labels[1].text(), "south-east", "y grows downwards");
    // And that is how often it is chosen.
    let weights = *colony.pheromone.weights(&colony.ground.clone(), 0);
    let mut rng = Stream::new(3, 0);
    let n = 100_000;
    let chosen = (0..n).filter(|_| walk::choose(&weights, &[1.0; 8], 0b0000_0111, 0.0, rng.unit()) == 0).count();
    let (expected, deviation) = (east / sum, (east / sum * (1.0 - east / sum) / f64::from(n)).sqrt());
    assert!((chosen as f64 / f64::from(n) - expected).abs() < 5.0 * deviation);
}

/// [ANTBAT](crate#papers) (2)–(3): ψ for an ant that came from the west and turns by 45°, with the goal straight ahead.
#[test]
fn a_turn_costs_what_psi_says() {
    let scene = scene(&["....", "....", "...."], [0.5, 1.5], [3.5, 1.5]);
    // η: distances 1 and √2 to the goal, squared 1 and 1/2. θ1 = θ2 = π/4: ψ = exp(−(1/16 + 1/16)) or exp(−(1/2 + 1/2)),
    // and γ = 2 squares it.
    for (direction, psi) in [(Direction::Squared, -0.25), (Direction::Linear, -2.0)] {
        let colony = colony(&scene, Variant { gamma: 2.0, direction, ..PLAIN });
        let (cell, east, south_east) = (5, 0, 1);
        let weights = colony.pheromone.look(&colony.ground, cell);
        let ratio = weights[south_east] * colony.ground.turn[east][south_east] / (weights[east] * colony.ground.turn[east][east]);
        assert!((ratio - 0.5 * crate::math::exp(psi)).abs() < 1e-15);
    }
}

fn lay(update: Update, lengths: &[(&str, f64)]) -> Vec<f64> {
    // Ways differ by their directions, so each name becomes one.
    let mut walks = Walks::default();
    for &(way, length) in lengths {
        walks.push_for_test(way.as_bytes(), length);
    }
    let global = lengths.iter().map(|l| l.1).fold(f64::INFINITY, f64::min);
    update::lay(update, 12.0, global, &mut walks, &mut Vec::new());
    walks.ants.iter().map(|ant| ant.laid).collect()
}

#[test]
fn what_ants_lay_follows_the_formulas() {
    let lengths = [("a", 3.0), ("b", 4.0), ("c", 6.0)];
    assert_eq!(lay(Update::Traditional, &lengths), [4.0, 3.0, 2.0]);
    // [ANTBAT] (5), φ1 = 8, φ2 = 3, median 4, global 3: 4 + 2 + 0, 3 + 0 − 1, 2 − 4 − 3.
    assert_eq!(lay(Update::Reward { phi1: 8.0, phi2: 3.0 }, &lengths), [6.0, 2.0, -5.0]);
    // The median of an even number is the mean of the middle two, here 5: 12/4 + 10 · (5 − 4)/5 and so on.
    assert_eq!(lay(Update::Reward { phi1: 10.0, phi2: 0.0 }, &[("a", 4.0), ("b", 6.0)]), [5.0, 0.0]);
    // [WOLF-ANT] (9)–(12): two ants share the best way, which gets 2 · 4 + δ · 4 with δ = 2; the worst gets 2 − ω · 2.
    assert_eq!(lay(Update::Wolf, &[("a", 3.0), ("b", 4.0), ("a", 3.0), ("c", 6.0)]), [8.0, 3.0, 8.0, 0.0]);
    // Equally short, but another way: only the first is the best; an only way is best and worst at once.
    assert_eq!(lay(Update::Wolf, &[("a", 3.0), ("b", 3.0), ("c", 6.0)]), [8.0, 4.0, 0.0]);
    assert_eq!(lay(Update::Wolf, &[("a", 3.0)]), [4.0]);
}

/// [ANTBAT](crate#papers) (4) by hand on a corridor: one way, one ant.
#[test]
fn pheromone_evaporates_and_is_laid_on_the_way() {
    let scene = scene(&["....", "####"], [0.5, 0.5], [3.5, 0.5]);
    let mut colony = colony(&scene, PLAIN);
    colony.advance();
    // 0.6 · 1 + 12 / 3 along the way; 0.6 elsewhere, also on the way back.
    assert_eq!([0, 1, 2].map(|cell| colony.pheromone.tau(cell, 0)), [4.6; 3]);
    assert_eq!(colony.pheromone.tau(1, 4), 0.6);
    colony.advance();
    assert!((colony.pheromone.tau(0, 0) - (0.6 * 4.6 + 4.0)).abs() < 1e-15);
    for _ in 0..90 {
        colony.advance();
    }
    assert_eq!(colony.pheromone.tau(1, 4), 0.1, "no less than τ min");
}

#[test]
fn a_dijkstra_path_seeds_the_pheromone() {
    let scene = scene(&["....", "####"], [0.5, 0.5], [3.5, 0.5]);
    let run = run(&scene, "aco-dijkstra", &[("seeded", "7"), ("tau_0", "2")], 1);
    let mut frame = Frame::default();
    run.draw(&mut frame, Frame::BUDGET);
    let weights: Vec<_> = frame.vertices().chunks(4).take(8).map(|v| v[3]).collect();
    assert_eq!(weights, [12.0, 12.0, 12.0, 0.0, -1.0, -1.0, -1.0, -1.0]);
}

/// A pocket whose mouth faces the start: ants that cannot go back stay in it, those that can arrive.
#[test]
fn dead_ends_and_unreachable_goals_end_and_are_told() {
    let pocket = scene(&[".....#...", ".....#...", "######...", "........."], [0.5, 0.5], [8.5, 0.5]);
    let mut unreachable = run(&pocket, "aco", &[], 1);
    assert_eq!(unreachable.step(10), Status::Infeasible);
    assert_eq!((unreachable.iteration(), unreachable.outcome().cost), (0, None));
    // One cell wide: who goes in can't turn round.
    let trap = scene(&["......", ".####.", "....#.", ".####.", "......"], [0.5, 2.5], [5.5, 2.5]);
    for planner in ["aco", "aco-direction", "aco-dijkstra", "aco-wolf"] {
        let mut dies = run(&trap, planner, &[("iterations", "5"), ("dead_end", "stay")], 1);
        dies.step(1);
        let stuck = dies.readings().get("stuck").unwrap();
        assert!(stuck > 0.0, "{planner}: the pocket is a dead end");
        let mut returns = run(&trap, planner, &[("iterations", "5")], 1);
        returns.step(5);
        let readings = returns.readings();
        assert_eq!(readings.get("arrived"), Some(if planner == "aco-wolf" { 30.0 } else { 50.0 }), "{planner}");
        let mut lost = run(&trap, planner, &[("iterations", "2"), ("step_limit", "3")], 1);
        assert_eq!(lost.step(9), Status::Exhausted);
        let outcome = lost.outcome();
        assert_eq!((outcome.cost, outcome.feasible), (None, false), "no ant arrives in three steps");
        assert!(lost.readings().get("lost").unwrap() > 0.0);
    }
}

/// On any map: ways are connected and free, cut no corner, and cost what they say; τ keeps to its bounds.
#[test]
fn ways_and_pheromone_keep_to_the_rules_on_random_maps() {
    let mut rng = Stream::new(11, 0);
    let mut found = 0;
    for round in 0..60 {
        let (columns, rows) = (4 + rng.below(12), 4 + rng.below(12));
        let mut blocked: Vec<_> = (0..columns * rows).map(|_| rng.unit() < 0.25).collect();
        let (start, goal) = (rng.below(blocked.len()), rng.below(blocked.len()));
        (blocked[start], blocked[goal]) = (false, false);
        let centre = |i: usize| Some([(i % columns) as f64 * 0.5 + 0.25, (i / columns) as f64 * 0.5 + 0.25]);
        let grid =
            GridScene { start: centre(start), goal: centre(goal), corner_cutting: round % 3 == 0, ..GridScene::new(0.5, columns, blocked) };
        let header =
            Header { name: "test".into(), title: "Test".into(), note: None, source: None, units: None, exact: None, published: None };
        let scene = Arc::new(grid::KIND.scene(header, grid).unwrap());
        let exact = scene.exact_by(ReferenceOptimum::Cells).map(|exact| exact.length);
        for planner in ["aco", "aco-direction", "aco-dijkstra", "aco-wolf"] {
            let mut run = run(&scene, planner, &[("iterations", "12"), ("tau_min", "0.01"), ("tau_max", "1000")], round);
            let mut frame = Frame::default();
            while run.step(1) == Status::Running {
                run.draw(&mut frame, Frame::BUDGET);
                let field = frame.spans().find(|span| span.layer == layers::PHEROMONE.key).unwrap();
                let mut more = frame.vertices()[..4 * field.count as usize].chunks(4).map(|v| v[3]);
                assert!(more.all(|more| more == -1.0 || (0.0..1000.0).contains(&more)));
            }
            let outcome = run.outcome();
            let Some(exact) = exact else {
                assert_eq!((outcome.status, outcome.cost), (Status::Infeasible, None));
                continue;
            };
            found += 1;
            let (path, cells) = (outcome.path.unwrap(), scene.get::<GridScene>().unwrap().cells());
            let way: Vec<_> = path.iter().map(|&point| cells.at(point)).collect();
            for w in way.windows(2) {
                assert!((0..8).any(|d| cells.moves(w[0]) >> d & 1 == 1 && cells.next(w[0], d) == w[1]), "{planner}: {w:?}");
            }
            assert_eq!((way[0], way[way.len() - 1]), (start, goal));
            assert_eq!(outcome.cost.unwrap(), 0.5 * cells.steps(&way).length());
            assert!(outcome.feasible && outcome.cost.unwrap() >= exact - 1e-12);
            let readings = run.readings();
            assert!(readings.get("smooth_length").unwrap() <= readings.get("length").unwrap() + 1e-12);
        }
    }
    assert!(found > 100, "most of the maps have a way");
}

/// With less pheromone on each way (`q=10`) three of these colonies of [ANTBAT](crate#papers) never settle: the ants' mean
/// stays at several times their best.
#[test]
fn colonies_with_direction_settle_on_hard_maps() {
    for (generator, columns, rows, seed) in
        [("rubble", 40.0, 30.0, 2), ("rubble", 40.0, 30.0, 77), ("rooms", 50.0, 50.0, 80), ("random", 50.0, 50.0, 1)]
    {
        let given = [("columns", Value::from(columns)), ("rows", Value::from(rows))].into_iter().collect();
        let scene = Arc::new(standard().generate(generator, &given, seed).unwrap());
        let mut run = run(&scene, "aco-direction", &[], 1);
        run.step(u64::MAX);
        let readings = run.readings();
        assert_eq!(readings.get("arrived"), Some(50.0), "{generator} {seed}");
        assert!(readings.get("settled").is_some_and(f64::is_finite), "{generator} {seed}");
    }
}

/// Forgetting the walks costs time and nothing else.
#[test]
fn ants_whose_ways_are_not_kept_go_them_again() {
    let scene = crate::shipped("ant-bat-30").unwrap();
    for update in [Update::Traditional, Update::Wolf, Update::Reward { phi1: 1.0, phi2: 1.0 }] {
        let [mut keeps, mut forgets] = [100_000, 60].map(|kept| {
            let variant = Variant { update, greed: [0.1, 0.5], ..PLAIN };
            Colony { kept, ants: 20, ..colony(&scene, variant) }
        });
        for _ in 0..30 {
            keeps.advance();
            forgets.advance();
            assert!(forgets.walks.ants.iter().any(|ant| ant.again.is_some()));
            assert!(keeps.walks.ants.iter().all(|ant| ant.again.is_none()));
            assert_eq!(Digest::of(&keeps.pheromone).hex(), Digest::of(&forgets.pheromone).hex());
            assert_eq!(keeps.best().map(|best| best.solution), forgets.best().map(|best| best.solution));
        }
    }
}

/// What decides how many ants are a part of an iteration.
#[test]
fn an_ant_that_goes_its_way_again_counts_all_its_steps() {
    let scene = crate::shipped("ant-bat-30").unwrap();
    let rules = Rules { backtracks: true, limit: 10_000 };
    let mut colony = Colony { kept: 0, ants: 20, rules, ..colony(&scene, PLAIN) };
    colony.advance();
    let arrived: Vec<usize> = (0..20).filter(|&i| colony.walks.ants[i].end == End::Arrived).collect();
    assert!(arrived.iter().all(|&i| colony.walks.ants[i].again.is_some()));
    let mut taken_back = 0;
    for &i in &arrived {
        let before = colony.again.taken;
        let steps = colony.lay(i);
        let way = colony.way(i).len() as u64;
        // Laying goes the way once, asking for it here once more.
        assert_eq!(colony.again.taken - before, 2 * steps);
        assert!(steps >= way);
        taken_back += steps - way;
    }
    assert!(taken_back > 0, "some ants met a dead end");
}

/// q0 goes evenly from its start in the first iteration to its end in the last.
#[test]
fn greed_is_what_is_told() {
    let scene = crate::shipped("ant-bat-30").unwrap();
    let params = [("q0_start", "1"), ("q0_end", "0"), ("iterations", "3")];
    let mut run = run(&scene, "aco-dijkstra", &params, 1);
    let mut inspection = Vec::new();
    for _ in 0..3 {
        run.step(1);
        let readings = run.readings();
        inspection.push(readings.get("q0").unwrap());
        let alike = (readings.get("mean").unwrap() - readings.get("best").unwrap()).abs() < 1e-9;
        assert_eq!(alike, inspection.len() == 1, "all greedy: all alike");
    }
    assert_eq!(inspection, [1.0, 0.5, 0.0]);
}

/// An ant in a dead end has neither a length nor a share of pheromone.
#[test]
fn an_ant_s_card_has_a_length_where_it_arrived() {
    let scene = scene(&["......", ".####.", "....#.", ".####.", "......"], [0.5, 2.5], [5.5, 2.5]);
    let mut ends = BTreeSet::new();
    for seed in 0..20 {
        let mut run = run(&scene, "aco", &[("ants", "10"), ("dead_end", "stay")], seed);
        run.step(1);
        for index in 0..10 {
            let inspection = run.inspect(Item { layer: layers::ANTS.key, index }).unwrap();
            let has = |name: &str| inspection.values.iter().any(|value| value.label.name == name);
            assert_eq!([has("length"), has("laid")], [inspection.event == "arrived"; 2], "{}", inspection.summary);
            ends.insert(inspection.event);
        }
    }
    assert!(ends.contains("arrived") && ends.contains("stuck"), "{ends:?}");
}

/// No ant goes back to where the best way has come from, so the card gives it no chance.
#[test]
fn a_cell_s_card_leaves_out_what_lies_behind() {
    let scene = scene(&["....", "####"], [0.5, 0.5], [3.5, 0.5]);
    let mut colony = colony(&scene, PLAIN);
    colony.advance();
    let inspection = explain::cell(&colony, Item { layer: layers::PHEROMONE.key, index: 2 }, None).unwrap();
    let p: Vec<_> = inspection.rows.iter().map(|row| *row.last().unwrap()).collect();
    assert_eq!((p[0], p[4]), (1.0, 0.0));
    assert!(inspection.summary.text().contains("coming from the west"));
}

/// Each factor of (3) can be left out: what is left is divided by its own sum.
#[test]
fn a_cell_without_one_of_its_factors_is_the_product_of_the_others() {
    let mut run = run(&crate::shipped("ant-bat-30").unwrap(), "aco-direction", &[("iterations", "20"), ("beta", "2")], 4);
    run.step(20);
    let item = Item { layer: layers::PHEROMONE.key, index: 26 * 30 + 1 };
    let inspection = run.inspect(item).unwrap();
    let column = |inspection: &crate::kernel::Inspection, name: &str| -> Vec<f64> {
        let k = inspection.columns.iter().position(|label| label.name == name).unwrap();
        inspection.rows.iter().map(|row| row[k]).collect()
    };
    let [tau, eta, psi] = ["tau", "eta", "psi"].map(|name| column(&inspection, name));
    let exponent = |name: &str| inspection.values.iter().find(|value| value.label.name == name).unwrap().value;
    let exponents = ["alpha", "beta", "gamma"].map(exponent);
    for (k, name) in ["pheromone", "sight", "direction"].into_iter().enumerate() {
        let weights: Vec<f64> = (0..8)
            .map(|d| {
                let factors = [tau[d], eta[d], psi[d]];
                let kept = (0..3).filter(|&j| j != k).map(|j| crate::math::pow(factors[j], exponents[j]));
                if eta[d] > 0.0 { kept.product() } else { 0.0 }
            })
            .collect();
        let sum: f64 = weights.iter().sum();
        let supposed = run.suppose(item, name, 0).unwrap().unwrap();
        for (p, weight) in column(&supposed, "p").into_iter().zip(weights) {
            assert!((p - weight / sum).abs() < 1e-12, "{name}: {p} is not {}", weight / sum);
        }
        assert!(supposed.marks.iter().all(|mark| mark.layer == layers::SUPPOSED.key && mark.vertices.len() == 2));
    }
}

#[test]
fn start_and_goal_in_one_cell_is_a_way_of_no_length() {
    let scene = scene(&["..", ".."], [0.5, 0.5], [0.5, 0.5]);
    for planner in ["aco", "aco-direction", "aco-wolf"] {
        let mut run = run(&scene, planner, &[("iterations", "2")], 1);
        run.step(2);
        let outcome = run.outcome();
        assert_eq!((outcome.cost, outcome.length.map(f64::to_bits), outcome.feasible), (Some(0.0), Some(0), true));
        assert!(run.readings().iter().all(|(_, value)| value.is_finite()));
    }
}
