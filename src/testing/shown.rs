//! What a run shows is what its entry lists.

use std::{collections::BTreeSet, sync::Arc};

use crate::{
    describe::{Layer, Weight},
    kernel::{Frame, Scene, SceneKindId, Shape, Span, Status, VERTEX},
    params::{Overrides, When},
    run::Run,
};

use super::{
    fault::{Checked, Fault, ensure},
    findings::Findings,
    subject::Subject,
};

const READINGS: &str =
    "Push every reading that the entry lists, and no other: after each iteration the same, each once, in the same order.";
const LAYERS: &str = "Draw only layers that the entry lists, or list `LayerKey(\"…\")` as a `Layer` in `.layers(…)`.";
const FINITE: &str = "Draw finite coordinates and weights only.";
const SHAPES: &str = "Push two vertices or more for a polyline, pairs for segments, and whole rows for a field.";
const WEIGHTS: &str = "Push weights of the meaning that the layer declares: `.weighted(Weight::…)`; a share and a rank are from 0 to 1.";
const MEMBERS: &str =
    "Push for each member one finite number for each of the entry's `members`, and list the facet: `Facets::default().members(self)`.";
const EVENTS: &str =
    "Report events in the order of time, of kinds that the entry lists in `.events(…)`, with the iteration after which they are known.";
const HIDE: &str = "Draw the same as often as it is asked for.";

/// So many steps at most where a run has stages.
const MOST: u64 = 10_000;

/// Runs on some scenes, and with every option of the choices on one scene of each kind, looked at after so many steps.
/// Returns whether every option was tried.
pub fn each_run<'a>(
    subject: &Subject,
    findings: &mut Findings,
    scenes: impl IntoIterator<Item = &'a Arc<Scene>>,
    looks: &[u64],
    mut look: impl FnMut(&mut Run) -> Checked,
) -> bool {
    let mut setups: Vec<_> = scenes.into_iter().map(|scene| (subject.setup(scene, 3, 120, &Overrides::new()), false)).collect();
    for scene in subject.one_scene_a_kind() {
        setups.extend(subject.options(scene.kind()).iter().map(|values| (subject.setup(scene, 3, 120, values), true)));
    }
    let mut tried = true;
    for (setup, optional) in setups {
        findings.watch(&setup, || {
            if optional && subject.refusal(&setup).is_some() {
                tried = false;
                return Ok(());
            }
            let mut run = subject.start(&setup)?;
            for iteration in looks {
                run.step(iteration.saturating_sub(run.iteration()));
                look(&mut run).map_err(|fault| fault.at(run.iteration()))?;
            }
            // What has stages shows some things only later.
            if !run.stages().is_empty() && run.status() == Status::Running {
                run.step(MOST);
                look(&mut run).map_err(|fault| fault.at(run.iteration()))?;
            }
            Ok(())
        });
    }
    tried
}

pub fn readings(subject: &Subject, findings: &mut Findings) {
    let listed: BTreeSet<&str> = subject.entry.readings.iter().map(|reading| reading.name).collect();
    let mut pushed = BTreeSet::new();
    let tried = each_run(subject, findings, subject.few_scenes(), &[0, 1, 20], |run| {
        let first: Vec<_> = run.trace().columns().to_vec();
        let names: Vec<_> = run.readings().iter().map(|(name, _)| name).collect();
        ensure(names == first, READINGS, || format!("it pushes {names:?}, and at first {first:?}"))?;
        let set: BTreeSet<_> = names.iter().copied().collect();
        ensure(set.len() == names.len(), READINGS, || format!("it pushes {names:?}"))?;
        if let Some(other) = set.difference(&listed).next() {
            return Err(Fault::new(READINGS, format!("it pushes `{other}`, which the entry does not list")));
        }
        pushed.extend(set);
        Ok(())
    });
    if let Some(missing) = listed.difference(&pushed).next().filter(|_| tried) {
        findings.look(Err(Fault::new(READINGS, format!("it never pushes `{missing}`, which the entry lists"))));
    }
}

pub fn layers(subject: &Subject, findings: &mut Findings) {
    let (mut frame, mut again) = (Frame::default(), Frame::default());
    each_run(subject, findings, subject.few_scenes(), &[0, 1, 20], |run| {
        run.draw(&mut frame, Frame::BUDGET);
        run.draw(&mut again, Frame::BUDGET);
        ensure(frame.vertices().iter().map(|v| v.to_bits()).eq(again.vertices().iter().map(|v| v.to_bits())), HIDE, || {
            "two drawings of a state differ".to_owned()
        })?;
        if let Some(layer) = frame.unlisted().first() {
            return Err(Fault::new(LAYERS, format!("it draws the layer `{}`, which the entry does not list as one of frames", layer.0)));
        }
        frame.spans().try_for_each(|span| span_is_right(&frame, span, &subject.entry.layers[span.index]))
    });
}

fn span_is_right(frame: &Frame, span: Span, layer: &Layer) -> Checked {
    let (name, count) = (span.layer.0, span.count as usize);
    let from = span.first as usize * VERTEX;
    let vertices = frame.vertices()[from..from + count * VERTEX].chunks_exact(VERTEX);
    ensure(vertices.clone().flatten().all(|x| x.is_finite()), FINITE, || format!("a vertex of the layer `{name}` is not finite"))?;
    let row = vertices.clone().next().map_or(0, |first| first[2] as usize);
    let whole = match span.shape {
        Shape::Polyline => count >= 2,
        Shape::Segments => count.is_multiple_of(2),
        Shape::Field => count == 0 || (row > 0 && count.is_multiple_of(row)),
        Shape::Points | Shape::Tube => true,
    };
    ensure(whole, SHAPES, || format!("the layer `{name}` has {} with {count} vertices", span.shape.name()))?;
    let mut weights = vertices.map(|vertex| vertex[3]);
    let right = match layer.weight {
        Weight::Rank | Weight::Share => weights.all(|weight| (0.0..=1.0).contains(&weight)),
        _ => true,
    };
    ensure(right, WEIGHTS, || format!("the layer `{name}` has weights that are no share"))
}

pub fn members_and_events(subject: &Subject, findings: &mut Findings) {
    let columns = subject.entry.members.len();
    let mut reported = false;
    each_run(subject, findings, subject.few_scenes(), &[0, 1, 20], |run| {
        let mut numbers = Vec::new();
        run.members(&mut numbers);
        reported |= !numbers.is_empty();
        let whole = if columns == 0 { numbers.is_empty() } else { numbers.len().is_multiple_of(columns) };
        ensure(whole, MEMBERS, || format!("it pushes {} numbers, and the entry lists {columns} of each member", numbers.len()))?;
        ensure(!numbers.iter().any(|x| x.is_infinite()), MEMBERS, || "a number of a member is infinite".to_owned())?;
        let events = run.events();
        for event in events {
            let listed = subject.entry.events.iter().any(|kind| kind.name == event.kind);
            ensure(listed, EVENTS, || format!("it reports an event `{}`, which the entry does not list", event.kind))?;
            ensure(event.iteration <= run.iteration(), EVENTS, || {
                format!("an event `{}` is of iteration {}", event.kind, event.iteration)
            })?;
        }
        ensure(events.is_sorted_by(|a, b| a.time <= b.time), EVENTS, || "events are not in the order of time".to_owned())
    });
    let missing = columns > 0 && !reported;
    findings.look(ensure(!missing, MEMBERS, || "the entry lists members, and no run reports any".to_owned()));
}

/// Whether a condition holds with a run's parameters.
pub fn is_met(when: Option<When>, run: &Run) -> bool {
    when.is_none_or(|When { parameter, value }| {
        run.parameters().all().iter().any(|(name, set)| *name == parameter && set.to_string() == value)
    })
}

/// Whether a layer has something to draw on a kind of scene.
pub fn is_on(layer: &Layer, kind: SceneKindId) -> bool {
    layer.kinds.is_empty() || layer.kinds.contains(&kind)
}
