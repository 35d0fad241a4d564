use std::sync::Arc;

use crate::{
    describe::layers,
    kernel::Item,
    run::{Run, Setup},
    shipped, standard,
};

fn run() -> Run {
    let scene = Arc::clone(&shipped("wcpso-discs").unwrap());
    Run::new(standard(), Setup { planner: "wcpso".into(), scene, params: crate::Overrides::default(), seed: 3 }).unwrap()
}

/// Every particle of many iterations: the terms add up to the velocity, and the velocity (or the jump) leads from
/// where the particle was to where it is. All three events must come up.
#[test]
fn the_explanation_adds_up_and_ends_where_the_particle_is() {
    let mut run = run();
    let mut seen = std::collections::BTreeMap::new();
    for _ in 0..80 {
        run.step(1);
        let drawn = drawn_paths(&run);
        for (index, path) in drawn.iter().enumerate() {
            let inspection = run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap();
            *seen.entry(inspection.event).or_insert(0) += 1;
            let get = |row: &[f64], name| row[inspection.columns.iter().position(|c| c.name == name).unwrap()];
            for row in &inspection.rows {
                if inspection.event == "move" {
                    let sum = get(row, "inertia") + get(row, "cognitive") + get(row, "social");
                    let v = get(row, "v");
                    assert!((sum - v).abs() < 1e-12 || (v.abs() < sum.abs() && v.signum() == sum.signum()), "{sum} {v}");
                    let reached = get(row, "x_before") + v;
                    let inside = get(row, "x");
                    assert!((inside - reached).abs() < 1e-12 || !(0.0..=8.0).contains(&reached), "{reached} {inside}");
                }
            }
            let after: Vec<_> = inspection.marks.iter().find(|m| m.layer == layers::AFTER.key).unwrap().vertices.clone();
            for (a, b) in after.iter().zip(path) {
                assert!((a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5);
            }
        }
    }
    assert!(seen["move"] > 0 && seen["hen"] > 0 && seen["chick"] > 0, "{seen:?}");
}

/// How often each event was explained in 80 iterations; `check` sees every inspection.
fn explained(set: &[(&str, &str)], check: impl Fn(&crate::kernel::Inspection)) -> std::collections::BTreeMap<&'static str, usize> {
    let params = set.iter().map(|&(name, value)| (name, crate::Value::from(value))).collect();
    let scene = crate::shipped("wcpso-discs").unwrap();
    let mut run = Run::new(standard(), Setup { planner: "wcpso".into(), scene, params, seed: 4 }).unwrap();
    let mut seen = std::collections::BTreeMap::new();
    for _ in 0..80 {
        run.step(1);
        for (index, path) in drawn_paths(&run).iter().enumerate() {
            let inspection = run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap();
            *seen.entry(inspection.event).or_insert(0) += 1;
            let after = &inspection.marks.iter().find(|m| m.layer == layers::AFTER.key).unwrap().vertices;
            assert!(
                after.iter().zip(path).all(|(a, b)| (a[0] - b[0]).abs() < 1e-5 && (a[1] - b[1]).abs() < 1e-5),
                "{}",
                inspection.summary
            );
            check(&inspection);
        }
    }
    seen
}

/// What is supposed is otherwise, and nothing else is: the other terms of the same step, the same random numbers.
#[test]
fn a_supposition_changes_one_thing_of_a_step() {
    let mut run = run();
    let (mut moved, mut hens) = (0, 0);
    for _ in 0..30 {
        run.step(1);
        let hash = run.hash();
        for index in (0..150).step_by(7) {
            let item = Item { layer: layers::PARTICLES.key, index };
            let inspection = run.inspect(item).unwrap();
            let mut suppose = |name: &str, draw| run.suppose(item, name, draw).unwrap().unwrap();
            if inspection.event != "move" {
                assert_eq!(inspection.suppositions.len(), usize::from(inspection.event == "hen"), "{}", inspection.event);
                hens += usize::from(inspection.event == "hen" && suppose("random", 0).rows[0][1..3] != inspection.rows[0][1..3]);
                continue;
            }
            // The columns of `MOVE`: x, inertia, r1, own best, r2, swarm's best, v, x', p.
            for (name, column) in [("inertia", 1), ("own", 3), ("best", 5)] {
                let supposed = suppose(name, 0);
                for (was, is) in inspection.rows.iter().zip(&supposed.rows) {
                    assert_eq!(is[column], 0.0, "{name}");
                    for other in [0, 1, 2, 3, 4, 5, 8].into_iter().filter(|&other| other != column) {
                        assert_eq!(is[other], was[other], "{name}, column {other}");
                    }
                    let reached = is[0] + is[6];
                    let stops = reached < 0.0 && is[7] == 0.0 || reached > 8.0 && (is[7] == 8.0 || is[7] == 9.0);
                    assert!((is[7] - reached).abs() < 1e-12 || stops, "{name}: {} is not {reached}", is[7]);
                    moved += usize::from(is[7] != was[7]);
                }
                assert!(supposed.marks.iter().all(|mark| mark.layer == layers::SUPPOSED.key) && supposed.marks.len() == 2);
            }
            let [one, other] = [0, 1].map(|draw| suppose("random", draw).rows[0][2]);
            assert!(one != other && one != inspection.rows[0][2]);
        }
        assert_eq!(run.hash(), hash);
    }
    assert!(moved > 1000 && hens > 10, "{moved} coordinates elsewhere, {hens} hens");
    let error = run.suppose(Item { layer: layers::PARTICLES.key, index: 0 }, "luck", 0).unwrap_err();
    assert!(error.to_string().contains("supposition") && error.to_string().contains("luck"), "{error}");
}

#[test]
fn one_pair_of_random_numbers_serves_a_whole_particle() {
    let at = |row: &[f64], name: &str, inspection: &crate::kernel::Inspection| {
        row[inspection.columns.iter().position(|c| c.name == name).unwrap()]
    };
    let seen = explained(&[("random", "particle")], |inspection| {
        let pair = match inspection.event {
            "move" => ["r1", "r2"],
            "hen" => ["r", "r_"],
            _ => return,
        };
        for name in pair {
            assert!(
                inspection.rows.iter().all(|row| at(row, name, inspection) == at(&inspection.rows[0], name, inspection)),
                "{}",
                inspection.summary
            );
        }
    });
    assert!(seen["move"] > 0 && seen["hen"] > 0, "{seen:?}");
}

#[test]
fn a_hen_that_must_be_better_never_raises_the_cost() {
    let value = |inspection: &crate::kernel::Inspection, name: &str| inspection.values.iter().find(|v| v.label.name == name).unwrap().value;
    let refused = std::cell::Cell::new(0);
    let seen = explained(&[("hen_keep", "better")], |inspection| {
        if inspection.event == "hen" {
            assert!(value(inspection, "cost") <= value(inspection, "cost_before"), "{}", inspection.summary);
            refused.set(refused.get() + usize::from(inspection.summary.text().ends_with("so it stays.")));
        }
    });
    assert!(refused.get() > 0 && refused.get() < seen["hen"], "{seen:?}, {} refused", refused.get());
}

#[test]
fn a_hen_after_the_flight_jumps_from_where_it_led_towards_a_personal_best() {
    let seen = explained(&[("hen_timing", "after"), ("hen_partner", "best"), ("s2", "source")], |inspection| {
        if inspection.event == "hen" {
            assert!(
                inspection.marks.iter().any(|m| m.layer == layers::VELOCITY.key)
                    && inspection.marks.iter().any(|m| m.layer == layers::JUMP.key)
            );
            assert_eq!(inspection.formulas, ["hen_best", "s1", "s2_source"]);
            let [s1, s2, g] = ["s1", "s2", "g"].map(|name| inspection.values.iter().find(|v| v.label.name == name).unwrap().value);
            let [x, r, r_, x_t, to] = inspection.rows[0][..] else { panic!("five columns") };
            let expected = (x + s1 * r * (g - x) + s2 * r_ * (x_t - x)).clamp(0.0, 9.0);
            assert!((to - expected).abs() < 1e-12, "{to} {expected}");
        }
    });
    assert!(seen["move"] > 0 && seen["hen"] > 0 && seen["chick"] > 0, "{seen:?}");
}

fn drawn_paths(run: &Run) -> Vec<Vec<[f64; 2]>> {
    let mut frame = crate::Frame::default();
    run.draw(&mut frame, usize::MAX);
    frame.spans().filter(|s| s.layer == layers::PARTICLES.key).map(|s| frame.points(s).collect()).collect()
}

#[test]
fn nothing_is_said_about_a_particle_that_does_not_exist() {
    let mut run = run();
    assert_eq!(run.inspect(Item { layer: layers::PARTICLES.key, index: 0 }).unwrap().event, "start");
    assert_eq!(run.inspect(Item { layer: layers::PARTICLES.key, index: 150 }), None);
    run.step(2);
    assert_eq!(run.inspect(Item { layer: layers::BEST.key, index: 0 }), None);
}
