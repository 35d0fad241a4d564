//! Whatever can be picked can be explained, and asking changes nothing.

use std::collections::BTreeSet;

use crate::{
    describe::{Formula, Layer},
    kernel::{Frame, Inspection, Item, Shape, VERTEX},
    run::Run,
};

use super::{
    entry::placeholders,
    fault::{Checked, Fault, ensure},
    findings::Findings,
    shown::{each_run, is_met, is_on},
    subject::Subject,
};

const EXPLAIN: &str = "Explain every piece of a pickable layer: list the facet (`Facets::default().explain(self)`), and return an `Inspection` \
                       for each index that is drawn and `None` beyond.";
const PICKABLE: &str = "Draw at least one piece of each pickable layer on its kinds of scene, or do not declare it `.pickable()`.";
const UNCHANGED: &str = "Explain a step on a copy of the state: explaining changes nothing.";
const AGAIN: &str = "Explain from the state alone: the same state has the same explanation.";
const SUPPOSED: &str = "Answer each of an explanation’s `suppositions` in `Explain::suppose`, from the state and the given stream alone.";
const FORMULAS: &str =
    "Name formulas that the entry lists and that are computed with these parameters, and give a value for each of their `@name@`.";
const TABLE: &str = "Give a label for each row, a number for each column, and finite numbers only.";
const MARKS: &str = "Mark layers that the entry lists: `.inspection()` for those that only explanations draw.";

/// So many pieces of a layer are asked about, about evenly spread.
const PIECES: usize = 12;

pub fn explained(subject: &Subject, findings: &mut Findings) {
    let pickable: Vec<_> = subject.entry.layers.iter().filter(|layer| layer.pickable).collect();
    let mut picked = BTreeSet::new();
    let before = findings.list.len();
    each_run(subject, findings, &subject.scenes, &[60], |run| {
        let (hash, kind) = (run.hash(), run.scene().kind());
        for layer in pickable.iter().filter(|layer| is_on(layer, kind)) {
            if explain_layer(subject, run, layer)? {
                picked.insert((layer.key, kind));
            }
        }
        ensure(run.hash() == hash, UNCHANGED, || "the hash is another after an explanation".to_owned())
    });
    // A run that was given up after a fault has shown too little.
    if findings.list.len() > before {
        return;
    }
    for &kind in subject.entry.kinds {
        for layer in pickable.iter().filter(|layer| is_on(layer, kind) && subject.scenes.iter().any(|scene| scene.kind() == kind)) {
            findings.look(ensure(picked.contains(&(layer.key, kind)), PICKABLE, || {
                format!("the layer `{}` has no piece on any scene of kind {}", layer.key.0, kind.name())
            }));
        }
    }
}

/// Asks about the pieces of a layer. Whether there are any.
fn explain_layer(subject: &Subject, run: &mut Run, layer: &Layer) -> Result<bool, Fault> {
    let (key, name) = (layer.key, layer.key.0);
    let mut frame = Frame::default();
    run.draw(&mut frame, usize::MAX);
    let (mut pieces, mut field) = (0, None);
    for span in frame.spans().filter(|span| span.layer == key) {
        pieces += match span.shape {
            Shape::Polyline | Shape::Tube => 1,
            Shape::Segments => span.count as usize / 2,
            Shape::Points | Shape::Field => span.count as usize,
        };
        field = field.or((span.shape == Shape::Field).then_some(span.first as usize));
    }
    for index in (0..pieces).step_by((pieces / PIECES).max(1)) {
        let item = Item { layer: key, index };
        let Some(inspection) = run.inspect(item) else {
            // A field has values for all cells, and nothing to say of some.
            let empty = field.is_some_and(|first| frame.vertices()[VERTEX * (first + index) + 3] < 0.0);
            ensure(empty, EXPLAIN, || format!("the piece {index} of the layer `{name}` has no explanation"))?;
            continue;
        };
        explanation(subject, run, &inspection)?;
        for supposition in &inspection.suppositions {
            let name = supposition.name;
            let supposed = |run: &mut Run, draw| run.suppose(item, name, draw).ok().flatten();
            let Some(first) = supposed(run, 0) else {
                return Err(Fault::new(SUPPOSED, format!("nothing is said about the supposition `{name}`")));
            };
            explanation(subject, run, &first)?;
            ensure(supposed(run, 0) == Some(first), SUPPOSED, || format!("what is said about the supposition `{name}` changes"))?;
        }
        if index == 0 {
            ensure(run.inspect(item) == Some(inspection), AGAIN, || format!("the explanation of a piece of `{name}` changes"))?;
        }
    }
    let beyond = run.inspect(Item { layer: key, index: usize::MAX });
    ensure(beyond.is_none(), EXPLAIN, || format!("a piece of the layer `{name}` that there is not has an explanation"))?;
    Ok(pieces > 0)
}

fn explanation(subject: &Subject, run: &Run, inspection: &Inspection) -> Checked {
    let layer = inspection.item.layer.0;
    for mark in &inspection.marks {
        ensure(subject.entry.layer(mark.layer).is_some(), MARKS, || format!("it marks `{}`, which the entry does not list", mark.layer.0))?;
    }
    for name in &inspection.formulas {
        let mut of_name = subject.entry.formulas.iter().filter(|formula| formula.name == *name).peekable();
        ensure(of_name.peek().is_some(), FORMULAS, || format!("an explanation of `{layer}` names the formula `{name}`"))?;
        let formula: Option<&Formula> = of_name.find(|formula| is_met(formula.when, run));
        let formula = formula.ok_or_else(|| Fault::new(FORMULAS, format!("the formula `{name}` is not computed with these parameters")))?;
        for value in placeholders(formula.live) {
            let filled = inspection.values.iter().any(|quantity| quantity.label.name == value);
            ensure(filled, FORMULAS, || format!("nothing fills @{value}@ in the formula `{name}`"))?;
        }
    }
    let rows = inspection.rows.len() == inspection.labels.len() && inspection.rows.iter().all(|row| row.len() == inspection.columns.len());
    let finite =
        inspection.rows.iter().flatten().chain(inspection.values.iter().map(|quantity| &quantity.value)).all(|value| value.is_finite());
    ensure(rows && finite, TABLE, || format!("the numbers of an explanation of `{layer}` are not complete"))
}
