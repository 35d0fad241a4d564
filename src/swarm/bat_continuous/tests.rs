//! A bat’s move by the numbers that its explanation names, and what is kept of it.

use super::*;
use crate::{Run, Setup, Value, shipped, standard};

fn run(scene: &str, params: &[(&str, Value)], seed: u64) -> Run {
    let params = params.iter().cloned().collect();
    Run::new(standard(), Setup { planner: "bat-continuous".into(), scene: shipped(scene).unwrap(), params, seed }).unwrap()
}

/// (7) to (11) for every bat of several iterations, by the numbers that its explanation names; all four outcomes come up.
#[test]
fn a_bat_moves_by_the_printed_equations() {
    for (pull, sign) in [("printed", 1.0), ("toward", -1.0)] {
        let [r0, v_max] = [Value::from(0.6), Value::from(1000.0)];
        let mut run = run("sphere-2", &[("population", 9.0.into()), ("pull", pull.into()), ("r0", r0), ("v_max", v_max)], 3);
        let mut seen = std::collections::BTreeMap::new();
        for t in 1..=20 {
            let quiet: Vec<_> = (0..9).map(|i| inspection(&mut run, i)).collect();
            run.step(1);
            for (index, before) in quiet.iter().enumerate() {
                let after = inspection(&mut run, index);
                let of = |name: &str| after.values.iter().find(|v| v.label.name == name).unwrap().value;
                let walked = after.event == "walk";
                let v = of("v_before") + sign * (of("x_before") - of("g")) * of("f");
                let x = if walked { of("g") + of("random") * of("mean_loudness") * 2.0 } else { of("x_before") + of("v") };
                assert!((0.0..=2.0).contains(&of("f")) && (of("v") - v).abs() < 1e-12, "(7), (8)");
                assert!((of("x") - x.clamp(-100.0, 100.0)).abs() < 1e-12, "(9), or a walk");
                let accepted = after.formulas.contains(&"loudness");
                *seen.entry((walked, accepted)).or_insert(0) += 1;
                assert!(if accepted { of("cost") <= of("cost_before") } else { of("cost") == of("cost_before") });
                if t > 1 {
                    let was = |name: &str| before.values.iter().find(|v| v.label.name == name).unwrap().value;
                    let [quieter, rarer] = if accepted { [0.98, 1.0 - math::exp(-0.98 * f64::from(t))] } else { [1.0; 2] };
                    assert_eq!(of("loudness"), was("loudness") * quieter, "(10)");
                    assert_eq!(of("pulse_rate"), was("pulse_rate") * rarer, "(11)");
                }
            }
        }
        assert_eq!(seen.len(), 4, "{seen:?}");
    }
}

fn inspection(run: &mut Run, index: usize) -> Inspection {
    run.inspect(Item { layer: layers::PARTICLES.key, index }).unwrap()
}

#[test]
fn what_is_found_is_kept_although_it_was_not_accepted() {
    // So quiet that nothing is ever accepted: the bats stay, and the best still gets better.
    let mut run = run("sphere-2", &[("a0", Value::from(0.0))], 1);
    let (first, mean) = (run.best().unwrap().cost, reading(&mut run, "mean"));
    run.step(200);
    assert!(run.best().unwrap().cost < first / 10.0);
    assert_eq!((reading(&mut run, "mean"), reading(&mut run, "accepted")), (mean, 0.0));
}

fn reading(run: &mut Run, name: &str) -> f64 {
    run.readings().iter().find(|(known, _)| *known == name).unwrap().1
}
