//! What an entry must say, seen without running its planner; and its presets.

use std::collections::BTreeSet;

use crate::{
    describe::{Entry, Group, Layer, Scope, Shown},
    params::{Domain, Overrides, Parameter, Value, When},
};

use super::{
    fault::{Checked, Fault, ensure},
    findings::Findings,
    subject::{ITERATIONS, Subject},
};

const NAME: &str = "Name it by lower-case letters, digits and hyphens, a letter first: commands and links use the name.";
const TEXTS: &str = "Give the entry a title, a source (or \"not published\") and a summary, and every part of it a title.";
const KINDS: &str = "List the kinds of scene in `.kinds(…)`, and those kinds in the registry.";
const SCENES: &str = "List a scene that it can run on in its kind's `shipped`, or give the suite one: `Suite::with_scene`.";
const LIMIT: &str = "Declare `Param::integer(\"iterations\", …)`, list it, and use its value as the run's limit.";
const TWICE: &str = "Use each name once within a list of the entry.";
const DEFAULTS: &str = "Choose a default and a slider within the parameter's domain.";
const CONDITIONS: &str = "Let `when` name a parameter of the same entry and a value that this parameter may have.";
const PLACEHOLDERS: &str = "Let `@name@` in a formula name a reading or a parameter, or make it a `Formula::of_item`.";
const TERMS: &str = "Let `\\class{name}{…}` in a formula name a layer that the entry lists.";
const COST: &str = "List a reading of `Group::Cost`: the convergence chart draws it.";
const MARKS: &str = "List the layers that only explanations mark (`.inspection()`) after those that are drawn.";
const GROUND: &str = "Give fields, and lines that are drawn from near, a lower `Look::order` than all else: they hide nothing.";
const PRESETS: &str = "Let a preset name a shipped scene, and parameters with allowed values that differ from the defaults.";

pub fn is_complete(subject: &Subject, findings: &mut Findings) {
    let checks: [fn(&Subject) -> Checked; 9] = [names, texts, kinds, limit, unique, parameters, conditions, contents, ground];
    checks.iter().for_each(|check| findings.look(check(subject)));
}

fn names(subject: &Subject) -> Checked {
    let name = subject.entry.name;
    let letters = name.bytes().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == b'-');
    ensure(letters && name.starts_with(|c: char| c.is_ascii_lowercase()), NAME, || format!("its name is `{name}`"))
}

fn texts(subject: &Subject) -> Checked {
    let entry = subject.entry;
    let own = [("title", entry.title), ("source", entry.source), ("summary", entry.summary)];
    let parameters = entry.all_parameters().map(|p| (p.name, p.title));
    let readings = entry.readings.iter().map(|r| (r.name, r.title));
    let layers = entry.layers.iter().map(|l| (l.key.0, l.title));
    let members = entry.members.iter().map(|m| (m.name, m.title));
    match own.into_iter().chain(parameters).chain(readings).chain(layers).chain(members).find(|(_, text)| text.trim().is_empty()) {
        Some((name, _)) => Err(Fault::new(TEXTS, format!("the text of `{name}` is empty"))),
        None => Ok(()),
    }
}

fn kinds(subject: &Subject) -> Checked {
    let kinds = subject.entry.kinds;
    ensure(!kinds.is_empty(), KINDS, || "it lists no kind of scene".to_owned())?;
    for kind in kinds {
        subject.registry.kind(kind.name()).map_err(|error| Fault::new(KINDS, error.to_string()))?;
        let found = subject.scenes.iter().any(|scene| scene.kind() == *kind);
        ensure(found, SCENES, || format!("no scene of kind {} is there to run on", kind.name()))?;
    }
    Ok(())
}

fn limit(subject: &Subject) -> Checked {
    let declared = subject.entry.parameter(ITERATIONS).is_some_and(|p| matches!(p.domain, Domain::Integer { .. }));
    ensure(declared, LIMIT, || "it has no whole-number parameter `iterations`".to_owned())
}

fn unique(subject: &Subject) -> Checked {
    let entry = subject.entry;
    let lists: [(&str, Vec<&str>); 7] = [
        ("parameters", entry.all_parameters().map(|p| p.name).collect()),
        ("readings", entry.readings.iter().map(|r| r.name).collect()),
        // Those with a condition may take turns under one name.
        ("formulas", entry.formulas.iter().filter(|f| f.when.is_none()).map(|f| f.name).collect()),
        ("layers", entry.layers.iter().map(|l| l.key.0).collect()),
        ("members", entry.members.iter().map(|m| m.name).collect()),
        ("events", entry.events.iter().map(|e| e.name).collect()),
        ("presets", entry.presets.iter().map(|p| p.name).collect()),
    ];
    for (list, names) in lists {
        let mut seen = BTreeSet::new();
        let twice = names.into_iter().find(|name| !seen.insert(*name));
        ensure(twice.is_none(), TWICE, || format!("{list} have `{}` twice", twice.unwrap_or_default()))?;
    }
    Ok(())
}

fn parameters(subject: &Subject) -> Checked {
    for parameter in subject.entry.all_parameters() {
        for &kind in subject.entry.kinds.iter().filter(|kind| parameter.applies_to(**kind)) {
            let checked = parameter.check(&parameter.default_on(kind));
            checked.map_err(|error| Fault::new(DEFAULTS, format!("the default on {}: {error}", kind.name())))?;
        }
        slider(parameter)?;
    }
    Ok(())
}

fn slider(parameter: &Parameter) -> Checked {
    let Some((low, high)) = parameter.slider else { return Ok(()) };
    let name = parameter.name;
    for end in [low, high] {
        parameter.check(&Value::from(end)).map_err(|error| Fault::new(DEFAULTS, format!("an end of the slider: {error}")))?;
    }
    let ordered = low < high && (low > 0.0 || !parameter.logarithmic);
    ensure(ordered, DEFAULTS, || format!("the slider of `{name}` goes from {low} to {high}"))
}

fn conditions(subject: &Subject) -> Checked {
    let entry = subject.entry;
    let parameters = entry.all_parameters().filter_map(|p| p.when);
    let layers = entry.layers.iter().filter_map(|l| l.when);
    for When { parameter, value } in parameters.chain(layers).chain(entry.formulas.iter().filter_map(|f| f.when)) {
        let other = entry.parameter(parameter);
        let other = other.ok_or_else(|| Fault::new(CONDITIONS, format!("a condition names `{parameter}`, which is no parameter")))?;
        other.check(&Value::from(value)).map_err(|error| Fault::new(CONDITIONS, format!("a condition that cannot be met: {error}")))?;
    }
    Ok(())
}

fn contents(subject: &Subject) -> Checked {
    let entry = subject.entry;
    for formula in entry.formulas {
        for tex in [formula.tex, formula.live] {
            for name in tex.split("\\class{").skip(1).filter_map(|rest| rest.split('}').next()) {
                let listed = entry.layers.iter().any(|layer| layer.key.0 == name);
                ensure(listed, TERMS, || format!("a term of the formula `{}` is marked by `{name}`", formula.name))?;
            }
        }
    }
    let known = |name: &str| entry.parameter(name).is_some() || entry.readings.iter().any(|reading| reading.name == name);
    for formula in entry.formulas.iter().filter(|formula| formula.scope == Scope::Iteration) {
        for name in placeholders(formula.live) {
            ensure(known(name), PLACEHOLDERS, || format!("nothing fills @{name}@ in the formula `{}`", formula.name))?;
        }
    }
    ensure(entry.readings.iter().any(|reading| reading.group == Group::Cost), COST, || "no reading is a cost".to_owned())?;
    let (_, marks) = entry.drawn_and_marked();
    let drawn = marks.iter().find(|layer| layer.shown != Shown::Inspection);
    ensure(drawn.is_none(), MARKS, || format!("the layer `{}` comes after one of explanations", drawn.map_or("", |layer| layer.key.0)))
}

/// What covers the ground lies beneath all else.
fn ground(subject: &Subject) -> Checked {
    let is_ground = |layer: &&Layer| layer.look.ramp.is_some() || layer.look.near;
    let (fields, others): (Vec<&Layer>, Vec<&Layer>) = subject.entry.layers.iter().partition(is_ground);
    let lowest = others.iter().map(|layer| layer.look.order).min().unwrap_or(i16::MAX);
    let above = fields.iter().find(|layer| layer.look.order >= lowest);
    ensure(above.is_none(), GROUND, || format!("the layer `{}` is not beneath all others", above.map_or("", |layer| layer.key.0)))
}

/// The names between `@` in a formula.
pub fn placeholders(live: &str) -> impl Iterator<Item = &str> {
    live.split('@').skip(1).step_by(2)
}

pub fn presets_run(subject: &Subject, findings: &mut Findings) {
    let entry = subject.entry;
    for preset in entry.presets {
        let refused = |problem: String| Fault::new(PRESETS, format!("the preset `{}`: {problem}", preset.name));
        let scene = match subject.registry.scene(preset.scene) {
            Ok(scene) => scene,
            Err(error) => {
                findings.look(Err(refused(error.to_string())));
                continue;
            }
        };
        wrong_values(entry, &preset.given()).into_iter().for_each(|problem| findings.look(Err(refused(problem))));
        let Ok(mut params) = entry.preset(preset.name, scene.kind()) else { continue };
        if params.get(ITERATIONS).is_none() {
            params.insert(ITERATIONS, Value::from(3.0));
        }
        let setup = subject.setup(&scene, 1, 3, &params);
        findings.watch(&setup, || {
            subject.start(&setup)?.step(2);
            Ok(())
        });
    }
}

/// What is wrong with values that an entry gives for its own parameters.
pub fn wrong_values(entry: &Entry, given: &Overrides) -> Vec<String> {
    let wrong = |(name, value): (&str, &Value)| match entry.parameter(name) {
        None => Some(format!("there is no parameter `{name}`")),
        Some(parameter) if entry.kinds.iter().all(|&kind| parameter.default_on(kind) == *value) => {
            Some(format!("{value} is the default of `{name}`"))
        }
        Some(parameter) => parameter.check(value).err().map(|error| error.to_string()),
    };
    given.iter().filter_map(wrong).collect()
}
