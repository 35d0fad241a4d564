//! Steps in parts, and the way back.

use super::*;
use crate::{Overrides, Setup, Value, describe::layers, kernel::part::MOST, shipped, standard};

/// With parts as small as can be, every planner's result is the same; whatever is asked of it in between is answered, going back gives
/// up the step that has begun, and every way of stepping completes it.
#[test]
fn a_step_in_parts_gives_the_same_state() {
    type Way = (&'static str, fn(&mut Run));
    const STEPS: u64 = 2;
    const WAYS: [Way; 3] = [
        ("step", |run| {
            run.step(1);
        }),
        ("step_to", |run| {
            run.step_to(0, 1);
        }),
        ("step_until", |run| {
            run.step_until(&|| false).unwrap();
        }),
    ];
    let mut in_parts = std::collections::BTreeSet::new();
    for entry in standard().planners() {
        for kind in entry.kinds {
            let scene = standard().scenes().iter().find(|scene| scene.kind() == *kind && entry.check_scene(scene).is_ok()).unwrap();
            let small = ["population", "ants", "moves", "seeds", "expand"].map(|name| (name, Value::from(3.0)));
            let wanted = small.into_iter().chain([("roads", Value::from("a-star"))]);
            let params = wanted.filter(|one| entry.configure(*kind, &[one.clone()].into_iter().collect()).is_ok()).collect();
            let setup = Setup { planner: entry.name.into(), scene: Arc::clone(scene), params, seed: 4 };
            let run = |most| {
                MOST.set(most);
                Run::new(standard(), setup.clone()).unwrap()
            };
            let mut whole = run(usize::MAX);
            whole.step(1);
            let first = whole.hash();
            whole.step(STEPS - 1);
            let mut run = run(1);
            let (mut frame, mut members, mut looks, start) = (Frame::default(), Vec::new(), 0, run.hash());
            if run.part() == Stepped::Partly && run.is_partly() {
                assert!(run.subtasks().is_empty());
                assert_eq!(run.link(), None);
                run.rewind(0);
                assert_eq!((run.is_partly(), run.hash()), (false, start), "{} on {}", entry.name, scene.name());
                for (way, complete) in WAYS {
                    assert_eq!(run.part(), Stepped::Partly);
                    complete(&mut run);
                    assert_eq!((run.iteration(), run.hash()), (1, first.clone()), "{way} of {} on {}", entry.name, scene.name());
                    run.rewind(0);
                }
            }
            while run.iteration() < STEPS && run.status() == Status::Running {
                if run.part() == Stepped::Partly && looks < 20 {
                    looks += 1;
                    in_parts.insert(entry.name);
                    run.draw(&mut frame, 1000);
                    run.members(&mut members);
                    run.readings();
                    run.curve();
                    run.hash();
                    run.outcome();
                    run.pick([0.0; 2], 1e9).map(|item| run.inspect(item));
                }
            }
            assert_eq!((run.iteration(), run.hash()), (whole.iteration(), whole.hash()), "{} on {}", entry.name, scene.name());
            assert_eq!(run.curve(), whole.curve(), "{} on {}", entry.name, scene.name());
        }
    }
    MOST.set(usize::MAX);
    let long = ["aco-wolf", "cuckoo-search", "dijkstra", "ga", "hybrid-bat", "ltqpso", "pso-tuning", "sa", "wolf-ant-drive"];
    assert!(long.iter().all(|name| in_parts.contains(name)), "{in_parts:?}");
}

/// Whatever way the state before was reached (keyframe, replay, or the one kept from the last inspection), the
/// explanation is the same, and asking for it changes nothing.
#[test]
fn an_explanation_does_not_depend_on_what_was_asked_before() {
    let setup = Setup { planner: "wcpso".into(), scene: shipped("wcpso-discs").unwrap(), params: Overrides::default(), seed: 2 };
    let item = Item { layer: layers::PARTICLES.key, index: 17 };
    let mut watched = Run::with_keyframes(standard(), setup.clone(), 200_000).unwrap();
    let mut hashes = Vec::new();
    let inspection: Vec<_> = (0..40)
        .map(|_| {
            watched.step(1);
            let inspection = watched.inspect(item).unwrap();
            hashes.push(watched.hash());
            inspection
        })
        .collect();
    let mut fresh = Run::with_keyframes(standard(), setup, 0).unwrap();
    for k in [40, 3, 17, 18, 16, 39_u64] {
        watched.seek(k);
        fresh.seek(k);
        assert_eq!(fresh.hash(), hashes[k as usize - 1]);
        assert_eq!(fresh.inspect(item).as_ref(), Some(&inspection[k as usize - 1]));
        assert_eq!(watched.inspect(item).as_ref(), Some(&inspection[k as usize - 1]));
    }
}
