//! A step allocates nothing: counted by an allocator of the test's own.
#![cfg(not(target_arch = "wasm32"))]
#![expect(unsafe_code, reason = "an allocator can only be written with it")]

use std::{
    alloc::{GlobalAlloc, Layout, System},
    cell::Cell,
};

use forage::{
    describe::Start,
    kernel::Stepper,
    params::{Overrides, Parameters},
    run::run_subtasks,
    shipped, standard,
};

struct Counting;

thread_local!(static COUNT: Cell<u64> = const { Cell::new(0) });

unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        COUNT.with(|count| count.set(count.get() + 1));
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        unsafe { System.dealloc(pointer, layout) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

#[test]
fn no_step_of_any_swarm_allocates() {
    for entry in standard().planners().iter().copied().filter(|entry| entry.family == "swarm") {
        for name in ["wcpso-discs", "qpso-10m", "ackley"] {
            let scene = shipped(name).unwrap();
            if entry.check_scene(&scene).is_err() {
                continue;
            }
            let settings = Parameters::new(entry.parameters, scene.kind(), &Overrides::new()).unwrap();
            let mut run = Stepper::from(
                (entry.start)(&Start { entry, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() }).unwrap(),
            );
            let before = COUNT.with(Cell::get);
            assert!(before > 0, "the counter counts");
            for _ in 0..300 {
                run.step(|_| Vec::new());
            }
            assert_eq!(COUNT.with(Cell::get) - before, 0, "{} on {name}", entry.name);
        }
    }
}

/// What an iteration's ants leave is kept in buffers that soon are large enough; only a better way is new.
#[test]
fn no_step_of_any_ant_allocates() {
    for entry in standard().planners().iter().copied().filter(|entry| entry.family == "ants") {
        let scene = shipped("ant-bat-30").unwrap();
        let given = [("iterations", forage::Value::from(1000.0))].into_iter().collect();
        let settings = Parameters::new(entry.parameters, scene.kind(), &given).unwrap();
        let mut run =
            Stepper::from((entry.start)(&Start { entry, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() }).unwrap());
        for _ in 0..50 {
            run.step(|_| Vec::new());
        }
        let mut allocated = 0;
        let mut unchanged = 0;
        for _ in 0..300 {
            let best = run.planner.best().map(|best| best.cost);
            let before = COUNT.with(Cell::get);
            run.step(|_| Vec::new());
            let count = COUNT.with(Cell::get) - before;
            if run.planner.best().map(|best| best.cost) == best {
                allocated += count;
                unchanged += 1;
            }
        }
        assert!(unchanged > 200, "most iterations find nothing better");
        // More than ten thousand steps an ant; a buffer may still have doubled once or twice.
        assert!(allocated <= 4, "{}: {allocated} allocations", entry.name);
    }
}

/// Once the roads stand a tour's planner only moves stops about. (A planner that goes through sets of stops grows.)
#[test]
fn no_step_of_any_tour_allocates() {
    for entry in standard().planners().iter().copied().filter(|entry| entry.stops && entry.name != "held-karp") {
        for more in [None, Some(("polish", "true"))] {
            let scene = shipped("ant-bat-30").unwrap();
            let given = [("iterations", "1000"), ("roads", "a-star")].into_iter().chain(more);
            let known = |name: &str| entry.parameter(name).is_some();
            let given: Overrides = given.filter(|(name, _)| known(name)).map(|(name, value)| (name, forage::Value::from(value))).collect();
            let settings = Parameters::new(entry.parameters, scene.kind(), &given).unwrap();
            let started = (entry.start)(&Start { entry, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() }).unwrap();
            let roads = started.stages.first().and_then(|roads| roads.end).unwrap();
            let mut run = Stepper::from(started);
            while run.iteration < roads {
                run.step(|jobs| run_subtasks(standard(), &scene, &jobs).unwrap());
            }
            let before = COUNT.with(Cell::get);
            for _ in 0..300 {
                run.step(|_| Vec::new());
            }
            assert_eq!(COUNT.with(Cell::get) - before, 0, "{} {more:?}", entry.name);
        }
    }
}

/// A robot that drives on looks and foresees without allocating; only what it decides, tells and leaves behind is new.
#[test]
fn no_period_of_a_drive_allocates_where_nothing_is_decided() {
    for entry in standard().planners().iter().copied().filter(|entry| entry.family == "dynamic") {
        let scene = shipped("crossing").unwrap();
        let given: Overrides =
            [("iterations", forage::Value::from(if entry.name == "wolf-ant-drive" { 5.0 } else { 1e6 }))].into_iter().collect();
        let settings = Parameters::new(entry.parameters, scene.kind(), &given).unwrap();
        let mut run =
            Stepper::from((entry.start)(&Start { entry, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() }).unwrap());
        let happened = |run: &Stepper| run.planner.facets().timeline.unwrap().events().len();
        while happened(&run) == 0 {
            run.step(|_| Vec::new());
        }
        let (mut allocated, mut quiet) = (0, 0);
        loop {
            let events = happened(&run);
            let before = COUNT.with(Cell::get);
            if !run.step(|_| Vec::new()) {
                break;
            }
            let count = COUNT.with(Cell::get) - before;
            if happened(&run) == events {
                allocated += count;
                quiet += 1;
            }
        }
        assert!(quiet > 200, "most periods bring nothing new");
        // The track, and buffers that double once or twice.
        assert!(allocated <= 12, "{}: {allocated} allocations in {quiet} periods", entry.name);
    }
}

/// A tree's buffers double now and then; nothing else is new but a path.
#[test]
fn trees_allocate_only_as_they_grow() {
    for name in ["rrt", "rrt-guided", "rrt-connect"] {
        let entry = standard().planners().iter().copied().find(|entry| entry.name == name).unwrap();
        // Nothing is found: the goal is behind a wall of discs.
        let text = r#"{"format": "forage-scene", "version": 1, "kind": "discs", "name": "w", "title": "W", "bounds": {"min": [0, 0], "max": [10, 10]},
            "start": [1, 5], "goal": [9.5, 5], "discs": [{"center": [6, 2], "radius": 3}, {"center": [6, 7], "radius": 3.1}]}"#;
        let scene = std::sync::Arc::new(forage::standard().read_scene(text).unwrap());
        let settings = Parameters::new(entry.parameters, scene.kind(), &Overrides::new()).unwrap();
        let mut run =
            Stepper::from((entry.start)(&Start { entry, scene: &scene, parameters: &settings, seed: 1, entries: &**standard() }).unwrap());
        let before = COUNT.with(Cell::get);
        for _ in 0..4000 {
            run.step(|_| Vec::new());
        }
        assert_eq!(run.iteration, 4000, "{name} is not done");
        let count = COUNT.with(Cell::get) - before;
        assert!(count < 160, "{name}: {count} in 4000 steps");
    }
}
