//! Whole searches: against hand-computed numbers, and against the oracles.

use std::sync::Arc;

use crate::{
    Overrides, Run, Scene, Setup, Status, Value,
    describe::layers,
    geometry,
    kernel::{Inspection, Item, ReferenceOptimum, Shape, rng::Stream},
    scene::{GridScene, Robot, grid},
    shipped, standard,
};

fn scene(grid: GridScene) -> Arc<Scene> {
    Arc::new(grid::KIND.scene(shipped("ant-bat-30").unwrap().header().clone(), grid).unwrap())
}

fn run(planner: &str, scene: &Arc<Scene>, params: &[(&str, f64)]) -> Run {
    let params: Overrides = params.iter().map(|&(name, value)| (name, Value::from(value))).collect();
    Run::new(standard(), Setup { planner: planner.to_owned(), scene: Arc::clone(scene), params, seed: 1 }).unwrap()
}

fn small(rows: &[&str], start: [f64; 2], goal: [f64; 2]) -> Arc<Scene> {
    let blocked = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
    scene(GridScene { start: Some(start), goal: Some(goal), ..GridScene::new(2.0, rows[0].len(), blocked) })
}

/// A grid of a random size, with a random robot, whose ends are free.
fn random(rng: &mut Stream, size: usize) -> Option<Arc<Scene>> {
    let [columns, rows] = [2 + rng.below(size), 2 + rng.below(size)];
    let density = 0.4 * rng.unit();
    let blocked: Vec<_> = (0..columns * rows).map(|_| rng.unit() < density).collect();
    let side = [1.0, 0.15, 20.0][rng.below(3)];
    let width = [0.0, 0.0, 0.3, 0.5, 0.9][rng.below(5)] * side;
    let robot = (width > 0.0).then(|| Robot { length: Some(width), width: Some(width), ..Robot::default() });
    let mut grid = GridScene { corner_cutting: rng.below(2) == 0, robot, ..GridScene::new(side, columns, blocked) };
    let mut end = || {
        let cell = rng.below(columns * rows);
        let off = if rng.below(2) == 0 { 0.5 } else { 0.3 + 0.4 * rng.unit() };
        Some([((cell % columns) as f64 + off) * side, ((cell / columns) as f64 + 0.5) * side])
    };
    (grid.start, grid.goal) = (end(), end());
    let scene = grid::KIND.scene(shipped("ant-bat-30").unwrap().header().clone(), grid).ok()?;
    scene.get::<GridScene>().unwrap().endpoints().is_ok().then(|| Arc::new(scene))
}

#[test]
fn from_cell_to_cell_the_searches_are_exact_to_the_bit() {
    let mut rng = Stream::new(11, 0);
    let mut count = [0; 2];
    for scene in (0..700).filter_map(|_| random(&mut rng, 24)) {
        let exact = scene.exact_by(ReferenceOptimum::Cells).map(|exact| exact.length.to_bits());
        for name in ["dijkstra", "a-star"] {
            let mut run = run(name, &scene, &[]);
            let status = run.step(u64::MAX);
            let outcome = run.outcome();
            assert_eq!(outcome.cost.map(f64::to_bits), exact, "{name} in {:?}", scene.to_json());
            assert_eq!(status, if exact.is_some() { Status::Solved } else { Status::Infeasible });
            assert_eq!(outcome.feasible, exact.is_some());
            assert!(run.iteration() <= 1024);
            if let Some(length) = outcome.length {
                let f = run.readings().get("f").unwrap();
                assert!((length - outcome.cost.unwrap()).abs() < 1e-9 && (name == "dijkstra" || (f - length).abs() < 1e-9));
                check_steps(&scene, outcome.path.as_ref().unwrap());
            }
        }
        count[usize::from(exact.is_some())] += 1;
    }
    assert!(count.iter().all(|&n| n > 30), "{count:?}");
}

/// Between the ends, each node is the centre of a free cell, the next one's neighbour, and no corner is cut unless it may be.
fn check_steps(scene: &Scene, path: &[[f64; 2]]) {
    let grid = scene.get::<GridScene>().unwrap();
    assert_eq!((Some(path[0]), path.last().copied()), (grid.start, grid.goal));
    let cell = |p: [f64; 2]| p.map(|c| c / grid.cell - 0.5);
    let inner: Vec<_> = path.iter().map(|&p| cell(p)).filter(|p| p.iter().all(|c| (c - c.round()).abs() < 1e-6)).collect();
    assert!(inner.len() + 2 >= path.len());
    let blocked = |x: f64, y: f64| grid.blocked[y.round() as usize * grid.columns + x.round() as usize];
    for w in inner.windows(2) {
        let ([ax, ay], [bx, by]) = (w[0], w[1]);
        assert!((ax - bx).abs() < 1.5 && (ay - by).abs() < 1.5 && !blocked(bx, by));
        assert!(grid.corner_cutting || !(blocked(ax, by) || blocked(bx, ay)));
    }
}

#[test]
fn at_any_angle_a_path_is_free_and_between_the_optimum_and_the_way_over_cells() {
    let mut rng = Stream::new(12, 0);
    let mut shorter = 0;
    for scene in (0..500).filter_map(|_| random(&mut rng, 20)) {
        let mut run = run("theta-star", &scene, &[]);
        let status = run.step(u64::MAX);
        let outcome = run.outcome();
        let Some(over_cells) = scene.exact_by(ReferenceOptimum::Cells) else {
            assert_eq!((status, outcome.cost), (Status::Infeasible, None));
            continue;
        };
        let (cost, exact) = (outcome.cost.unwrap(), scene.exact().unwrap().length);
        assert!(outcome.feasible, "{:?} {}", outcome.path, scene.to_json());
        assert!(cost >= exact - 1e-9 && cost <= over_cells.length + 1e-9, "{exact} {cost} {}", over_cells.length);
        assert_eq!((outcome.exact_by, outcome.length.map(f64::to_bits)), (ReferenceOptimum::AnyAngle, Some(cost.to_bits())));
        shorter += usize::from(cost < over_cells.length - 1e-9);
    }
    assert!(shorter > 100, "{shorter}");
}

#[test]
fn how_many_cells_a_step_settles_does_not_change_the_result() {
    let mut rng = Stream::new(13, 0);
    for scene in (0..60).filter_map(|_| random(&mut rng, 40)) {
        for name in ["dijkstra", "a-star", "theta-star"] {
            let run = |expand: f64| {
                let mut run = run(name, &scene, &[("expand", expand)]);
                run.step(u64::MAX);
                let outcome = run.outcome();
                assert_eq!(run.step(1), outcome.status, "a step afterwards does nothing");
                assert_eq!((run.iteration(), outcome.hash), (outcome.iterations, run.hash()));
                (outcome.status, outcome.cost.map(f64::to_bits), outcome.path, outcome.evaluations)
            };
            let one = run(1.0);
            assert_eq!(one, run(7.0));
            assert_eq!(one, run(0.0));
            assert_eq!(one, run(4_194_304.0));
        }
    }
}

/// Without a reading of what was settled twice: f of A* only rises, and stays below the result.
#[test]
fn the_lowest_f_rises_to_the_result() {
    let scene = shipped("wolf-ant-20").unwrap();
    for name in ["dijkstra", "a-star"] {
        let mut run = run(name, &scene, &[("expand", 1.0)]);
        let best = scene.exact_by(ReferenceOptimum::Cells).unwrap().length;
        let mut last = 0.0;
        loop {
            let f = run.readings().get("f").unwrap();
            assert!(f >= last && f <= best + 1e-9, "{name}: {last} {f} {best}");
            last = f;
            if run.step(1) != Status::Running {
                break;
            }
        }
        assert_eq!(run.readings().get("converged"), Some(run.iteration() as f64));
    }
}

/// Side 2, by hand. A* from (0, 0) to (2, 0) around the blocked (1, 0): down, right, right, up.
#[test]
fn g_h_and_f_are_those_computed_by_hand() {
    let scene = small(&[".#.", "...", "..."], [1.0, 1.0], [5.0, 1.0]);
    let mut run = run("a-star", &scene, &[("expand", 1.0)]);
    let value = |run: &mut Run, cell: usize, name: &str| {
        let inspection = run.inspect(Item { layer: layers::CLOSED.key, index: cell }).unwrap();
        (inspection.event, inspection.values.iter().find(|v| v.label.name == name).map(|v| (v.value * 1e9).round() / 1e9))
    };
    let root = std::f64::consts::SQRT_2;
    let digits = |v: f64| Some((v * 1e9).round() / 1e9);
    assert_eq!(value(&mut run, 0, "f"), ("frontier", Some(4.0)));
    assert_eq!(value(&mut run, 4, "g"), ("unreached", None));
    run.step(1);
    assert_eq!(value(&mut run, 0, "g"), ("settled", Some(0.0)));
    // (0, 1) is two columns and one row from the goal: h = 2 (2 + (√2 − 1)).
    assert_eq!(value(&mut run, 3, "g"), ("frontier", Some(2.0)));
    assert_eq!(value(&mut run, 3, "h"), ("frontier", digits(2.0 + 2.0 * root)));
    assert_eq!(value(&mut run, 3, "f"), ("frontier", digits(4.0 + 2.0 * root)));
    run.step(1);
    // (1, 1): g = 2 + 2, h = 2 √2 (the diagonal counts, though it may not be taken); (1, 2): g = 2 + 2 √2.
    assert_eq!(value(&mut run, 4, "f"), ("frontier", digits(4.0 + 2.0 * root)));
    assert_eq!(value(&mut run, 7, "g"), ("frontier", digits(2.0 + 2.0 * root)));
    assert_eq!(run.step(u64::MAX), Status::Solved);
    assert_eq!(run.outcome().cost, Some(8.0));
    assert_eq!(run.inspect(Item { layer: layers::CLOSED.key, index: 1 }), None, "it is blocked");
    assert_eq!(run.inspect(Item { layer: layers::CLOSED.key, index: 9 }), None);
    let inspection = run.inspect(Item { layer: layers::CLOSED.key, index: 2 }).unwrap();
    let way = inspection.marks.iter().find(|mark| mark.layer == layers::WAY.key).unwrap();
    assert_eq!(way.vertices, [[1.0, 1.0, 0.0], [1.0, 3.0, 0.0], [3.0, 3.0, 0.0], [5.0, 3.0, 0.0], [5.0, 1.0, 0.0]]);
}

#[test]
fn a_weight_trades_length_for_fewer_cells() {
    let mut rng = Stream::new(14, 0);
    let (mut fewer, mut more) = (0, 0);
    for scene in (0..80).filter_map(|_| random(&mut rng, 40)) {
        let Some(exact) = scene.exact_by(ReferenceOptimum::Cells) else { continue };
        let run = |weight: f64| {
            let mut run = run("a-star", &scene, &[("weight", weight)]);
            run.step(u64::MAX);
            run.outcome()
        };
        let (plain, greedy) = (run(1.0), run(3.0));
        assert!(greedy.feasible && greedy.cost.unwrap() >= exact.length && greedy.cost.unwrap() <= 3.0 * exact.length + 1e-9);
        fewer += usize::from(greedy.evaluations < plain.evaluations);
        more += usize::from(greedy.evaluations > plain.evaluations);
    }
    assert!(fewer > 12 && more < fewer / 4, "{fewer} {more}");
}

#[test]
fn smoothing_hands_over_fewer_nodes_and_is_measured_at_any_angle() {
    let scene = shipped("ant-bat-30").unwrap();
    for name in ["dijkstra", "a-star", "theta-star"] {
        let mut raw = run(name, &scene, &[]);
        let params = [("smooth", Value::Flag(true))].into_iter().collect();
        let mut smooth = Run::new(standard(), Setup { planner: name.to_owned(), scene: Arc::clone(&scene), params, seed: 1 }).unwrap();
        raw.step(u64::MAX);
        smooth.step(u64::MAX);
        let (a, b) = (raw.outcome(), smooth.outcome());
        assert_eq!(a.cost, b.cost, "smoothing is not part of the search");
        assert!(
            b.feasible && b.length <= a.length && b.turns <= a.turns && b.exact_by == ReferenceOptimum::AnyAngle && b.gap > Some(-1e-12)
        );
        let path = b.path.unwrap();
        let mut read = |name| raw.readings().get(name).unwrap();
        assert_eq!([read("smooth_length"), read("smooth_turns")], [geometry::length(&path), geometry::turns(&path) as f64]);
        assert_eq!([read("length"), read("turns")], [a.length.unwrap(), a.turns.unwrap() as f64]);
    }
}

/// Every cell is closed, open or neither as the field shows it, on a budget smaller than the grid too.
#[test]
fn the_picture_keeps_to_its_budget() {
    let scene = shipped("ant-bat-30").unwrap();
    let mut run = run("dijkstra", &scene, &[("expand", 1.0)]);
    run.step(300);
    let mut frame = crate::Frame::default();
    for (budget, cells) in [(usize::MAX, 900), (900, 900), (899, 225), (100, 100), (1, 1)] {
        run.draw(&mut frame, budget);
        let field = frame.spans().find(|span| span.layer == layers::CLOSED.key).unwrap();
        assert_eq!(field.count, cells);
        assert!(frame.spans().all(|span| span.count as usize <= budget.max(1)));
    }
    run.draw(&mut frame, usize::MAX);
    let field = frame.spans().find(|span| span.layer == layers::CLOSED.key).unwrap();
    let weights: Vec<_> = frame.vertices()[field.first as usize * 4..][..4 * 900].chunks_exact(4).map(|v| v[3]).collect();
    assert_eq!(weights.iter().filter(|&&w| w >= 0.0).count(), 300);
    let open = frame.spans().find(|span| span.layer == layers::FRONTIER.key).unwrap();
    assert_eq!(f64::from(open.count), run.readings().get("frontier").unwrap());
}

#[test]
fn a_run_ends_at_its_limit_and_a_start_may_be_the_goal() {
    let scene = shipped("ant-bat-30").unwrap();
    let mut stopped = run("a-star", &scene, &[("expand", 1.0), ("iterations", 5.0)]);
    assert_eq!((stopped.step(u64::MAX), stopped.iteration()), (Status::Exhausted, 5));
    let readings = stopped.readings();
    assert!(readings.get("best").unwrap().is_nan() && readings.get("smooth_length").unwrap().is_nan());
    let here = small(&["..", ".."], [0.5, 1.0], [1.5, 1.0]);
    for name in ["dijkstra", "a-star", "theta-star"] {
        let mut run = run(name, &here, &[]);
        assert_eq!(run.step(u64::MAX), Status::Solved);
        assert_eq!(run.outcome().cost, Some(1.0));
    }
}

/// Rewound over keyframes or replayed from the start, an iteration is the same; whatever an inspection says, the entry
/// lists, and its formulas have their numbers.
#[test]
fn every_iteration_comes_back_and_every_cell_explains_itself() {
    let scene = shipped("ant-bat-30").unwrap();
    for name in ["dijkstra", "a-star", "theta-star"] {
        let mut run = run(name, &scene, &[("expand", 3.0)]);
        let mut hashes = vec![run.hash()];
        while run.step(1) == Status::Running {
            hashes.push(run.hash());
        }
        hashes.push(run.hash());
        for k in [hashes.len() / 2, 1, 40, 17, 0, hashes.len() - 1] {
            run.seek(k as u64);
            assert_eq!(run.hash(), hashes[k], "{name} {k}");
        }
        run.seek(hashes.len() as u64 / 2);
        let entry = run.entry();
        for index in 0..900 {
            let Some(inspection) = run.inspect(Item { layer: layers::CLOSED.key, index }) else {
                assert!(!scene.get::<GridScene>().unwrap().cells().is_free(index));
                continue;
            };
            assert!(
                inspection.rows.len() == inspection.labels.len() && inspection.rows.iter().all(|row| row.len() == inspection.columns.len())
            );
            assert!(inspection.values.iter().all(|v| v.value.is_finite()));
            for formula in &inspection.formulas {
                let formula = entry.formulas.iter().find(|f| f.name == *formula).unwrap();
                let parts: Vec<_> = formula.live.split('@').collect();
                let mut numbers = parts.chunks(2).filter_map(|pair| pair.get(1));
                assert!(numbers.all(|name| inspection.values.iter().any(|v| v.label.name == *name)), "{name}: {}", formula.name);
            }
        }
    }
}

/// What is supposed of a cell is what the other search does: cells settled, on the frontier, and the ways to them.
#[test]
fn a_search_without_its_heuristic_is_the_one_that_never_had_any() {
    let scene = shipped("ant-bat-30").unwrap();
    let [mut guided, mut even] = ["a-star", "dijkstra"].map(|planner| run(planner, &scene, &[("expand", 1.0)]));
    guided.step(120);
    even.step(120);
    let item = |index: usize| Item { layer: layers::CLOSED.key, index };
    let points =
        |inspection: &Inspection, shape: Shape| inspection.marks.iter().find(|mark| mark.shape == shape).map(|mark| mark.vertices.clone());
    let mut events = std::collections::BTreeMap::new();
    for index in 0..900 {
        for supposition in ["unguided", "guided"] {
            let [run, other] = if supposition == "unguided" { [&mut guided, &mut even] } else { [&mut even, &mut guided] };
            let Some(theirs) = other.inspect(item(index)) else { continue };
            let inspection = run.suppose(item(index), supposition, 0).unwrap().unwrap();
            assert_eq!(inspection.event, theirs.event, "cell {index}, {supposition}");
            *events.entry((supposition, inspection.event)).or_insert(0) += 1;
            if inspection.event != "unreached" {
                let way = theirs.marks.iter().find(|mark| mark.layer == layers::WAY.key).map(|mark| mark.vertices.clone());
                assert!(way.is_none() || points(&inspection, Shape::Polyline) == way, "cell {index}, {supposition}");
            }
        }
    }
    assert_eq!(events.len(), 6, "{events:?}");
    assert!(even.suppose(item(31), "unguided", 0).is_err(), "it has no heuristic");
    // With twice its weight the goal comes sooner, and the way may be longer.
    let doubled = guided.suppose(item(31), "doubled", 0).unwrap().unwrap();
    guided.step(u64::MAX);
    let whole = guided.suppose(item(31), "doubled", 0).unwrap().unwrap();
    assert!(doubled.event != "unreached" && whole.event == "solved", "{}, {}", doubled.event, whole.event);
}
