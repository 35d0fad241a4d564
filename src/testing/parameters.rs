//! Every value that an entry allows runs, and any other is refused by name.

use std::sync::Arc;

use crate::{
    kernel::{Error, Frame, Scene},
    params::{Domain, Overrides, Parameter, Value},
    run::{Run, Setup},
};

use super::{
    fault::{Checked, Fault, ensure, refusal},
    findings::Findings,
    subject::{ITERATIONS, SMALL, Subject, names},
};

const FINITE: &str = "Keep costs and readings finite for every value that the entry allows, or narrow the parameter's domain.";
const REFUSE: &str = "Leave it to the entry's `.parameters(…)` to refuse values: declare the domain there.";
const BUDGET: &str = "Draw every n-th piece only: `frame.thin(pieces, vertices, lines)` says which n keeps to the frame's budget.";

/// A run with a value from here on takes one step only.
const LARGE: f64 = 1000.0;

/// The values of a parameter that are tried: both ends of its range, or each option.
fn ends(parameter: &Parameter) -> Vec<Value> {
    match parameter.domain {
        Domain::Number { min, max, .. } => vec![Value::from(min), Value::from(max)],
        Domain::Integer { min, max, .. } => vec![Value::from(min as f64), Value::from(max as f64)],
        Domain::Choice { options } => names(options).into_iter().map(|name| Value::Text(name.to_owned())).collect(),
        Domain::Subset { options, .. } => {
            let all = names(options);
            all.first().map(|first| (*first).to_owned()).into_iter().chain([all.join(",")]).map(Value::Text).collect()
        }
        Domain::Flag { .. } => vec![Value::Flag(false), Value::Flag(true)],
    }
}

fn setup(subject: &Subject, scene: &Arc<Scene>, parameter: &Parameter, value: Value) -> Setup {
    let mut values = subject.sizes(scene.kind(), SMALL);
    subject.meet_conditions(parameter, &mut values);
    let mut setup = subject.setup(scene, 1, 20, &values);
    setup.params.insert(parameter.name, value);
    subject.drop_unmet(scene.kind(), &mut setup.params);
    setup
}

pub fn both_ends_run(subject: &Subject, findings: &mut Findings) {
    for scene in subject.one_scene_a_kind() {
        let iterations = subject.entry.parameter(ITERATIONS);
        for parameter in subject.free(scene.kind()).chain(iterations) {
            for value in ends(parameter) {
                let number = matches!(value, Value::Number(_));
                let large = matches!(value, Value::Number(value) if value >= LARGE);
                let setup = setup(subject, scene, parameter, value);
                findings.watch(&setup, || {
                    match subject.refusal(&setup) {
                        // Some options need more of a scene than others, and a scene may be too narrow for a value.
                        Some(error) if !number || error.field() != parameter.name => return Ok(()),
                        Some(error) => return Err(refusal(&error)),
                        None => {}
                    }
                    let mut run = subject.start(&setup)?;
                    run.step(if large { 1 } else { 20 });
                    finite(&mut run).and_then(|()| keeps_to_its_budget(&run)).map_err(|fault| fault.at(run.iteration()))
                });
            }
        }
    }
}

fn finite(run: &mut Run) -> Checked {
    if let Some(best) = run.best() {
        ensure(best.cost.is_finite(), FINITE, || format!("the best cost is {}", best.cost))?;
    }
    // What is not there yet is not a number; nothing is infinite.
    match run.readings().iter().find(|(_, value)| value.is_infinite()) {
        Some((name, value)) => Err(Fault::new(FINITE, format!("the reading `{name}` is {value}"))),
        None => Ok(()),
    }
}

fn keeps_to_its_budget(run: &Run) -> Checked {
    let mut frame = Frame::default();
    run.draw(&mut frame, Frame::BUDGET);
    for (index, layer) in frame.layers().iter().enumerate() {
        let vertices: u64 = frame.spans().filter(|span| span.index == index).map(|span| u64::from(span.count)).sum();
        // About the budget: the last piece may go beyond.
        ensure(vertices <= 2 * Frame::BUDGET as u64, BUDGET, || {
            format!("the layer `{}` has {vertices} vertices, with a budget of {}", layer.0, Frame::BUDGET)
        })?;
    }
    Ok(())
}

pub fn others_are_refused(subject: &Subject, findings: &mut Findings) {
    for scene in subject.one_scene_a_kind() {
        for parameter in subject.entry.parameters_on(scene.kind()) {
            let (min, max) = match parameter.domain {
                Domain::Number { min, max, .. } => (min, max),
                Domain::Integer { min, max, .. } => (min as f64, max as f64),
                Domain::Choice { .. } | Domain::Subset { .. } | Domain::Flag { .. } => (0.5, 0.5),
            };
            for value in [min - 1.0, max * 2.0 + 1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
                let setup = setup(subject, scene, parameter, Value::from(value));
                findings.watch(&setup, || {
                    let refused = Run::new(subject.registry, setup.clone()).err();
                    names_it(refused.as_ref(), parameter.name, value)
                });
            }
            let unknown = Overrides::from_iter([("no such parameter", Value::from(1.0))]);
            let setup = Setup { params: unknown, ..setup(subject, scene, parameter, Value::from(min)) };
            let refused = Run::new(subject.registry, setup.clone()).err();
            findings.watch(&setup, || {
                ensure(refused.is_some_and(|error| error.field() == "parameter"), REFUSE, || {
                    "it accepts a parameter that its entry does not list".to_owned()
                })
            });
        }
    }
}

fn names_it(refused: Option<&Error>, name: &str, value: f64) -> Checked {
    let Some(error) = refused else { return Err(Fault::new(REFUSE, format!("it accepts {name}={value}"))) };
    let named = error.field() == name && error.value() == value.to_string() && !error.allowed().is_empty();
    ensure(named, REFUSE, || format!("{name}={value} is refused without its name and value: {error}"))
}
