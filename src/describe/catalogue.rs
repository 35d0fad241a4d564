//! The catalogue as the page, `forage list --json` and other programs read it.

use std::collections::BTreeMap;

use serde::{Serialize, Serializer};
use serde_json::Number;

use crate::{
    kernel::{LayerKey, Scene, SceneKindId, Shape, message::sentences},
    params::{Choice, Domain, Object, Parameter, Value, When},
};

use super::{
    Case, CentreBias, Color, Column, Entry, EventKind, Follower, Formula, Generator, Layer, Member, Preset, Reading, Registry, layers,
};

/// All that a registry lists, without the functions.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Catalogue<'a> {
    /// The crate's version.
    version: &'static str,
    planners: Vec<PlannerView>,
    /// The scenes that ship.
    #[cfg_attr(feature = "types", ts(type = "Scene[]"))]
    scenes: Vec<&'a Scene>,
    /// What makes random scenes.
    generators: Vec<GeneratorView>,
    /// How a robot drives along what a planner found, and how an arm follows it.
    #[serde(flatten)]
    #[cfg_attr(feature = "types", ts(skip))]
    followers: BTreeMap<&'static str, FollowerView>,
    /// The keys of all layers. A frame's table of spans counts its planner's `layers`, not these.
    roles: Vec<LayerKey>,
    /// The layers of a scene itself, whatever the planner draws.
    layers: &'static [Layer],
    /// The shapes in a frame's table of spans, by number.
    shapes: [Shape; 5],
    /// The colours of a function's heights, from the lowest value to the highest.
    heights: [Color; 5],
    /// Every TeX string outside a formula, so that a page can typeset them when it is built.
    symbols: Vec<&'static str>,
}

impl Registry {
    /// All that is listed, to be serialised.
    pub fn catalogue(&self) -> Catalogue<'_> {
        Catalogue {
            version: env!("CARGO_PKG_VERSION"),
            planners: self.planners().iter().copied().map(PlannerView::of).collect(),
            scenes: self.scenes().iter().map(|scene| &**scene).collect(),
            generators: self.generators().iter().copied().map(GeneratorView::of).collect(),
            followers: self.followers().iter().map(|follower| (follower.name, FollowerView::of(follower))).collect(),
            roles: self.layer_keys(),
            layers: layers::SCENE,
            shapes: Shape::ALL,
            heights: layers::HEIGHTS,
            symbols: self.symbols(),
        }
    }

    /// Every TeX string that can appear outside a formula, so that pages can typeset them when they are built.
    fn symbols(&self) -> Vec<&'static str> {
        let planners = self.planners().iter().flat_map(|entry| {
            let parameters = entry.all_parameters().map(|p| p.symbol);
            parameters.chain(entry.readings.iter().map(|r| r.symbol)).chain(entry.members.iter().map(|m| m.symbol))
        });
        let followers = self.followers().iter().flat_map(|follower| {
            let parameters = follower.parameters.iter().copied().flatten().map(|p| p.symbol);
            parameters.chain(follower.columns.iter().map(|column| column.symbol))
        });
        let summed = sentences().into_iter().map(|sentence| sentence.symbol);
        let mut symbols = Vec::new();
        for symbol in planners.chain(followers).chain(summed) {
            if !symbol.is_empty() && !symbols.contains(&symbol) {
                symbols.push(symbol);
            }
        }
        symbols
    }
}

/// A planner.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Planner"))]
struct PlannerView {
    #[cfg_attr(feature = "types", ts(type = "PlannerName"))]
    name: &'static str,
    title: &'static str,
    family: &'static str,
    /// E.g. `[WCPSO] (1–7)`.
    source: &'static str,
    summary: &'static str,
    /// What one of its evaluations is, e.g. `a position`. Empty: it does not say.
    evaluation: &'static str,
    /// The kinds of scene that it runs on.
    kinds: &'static [SceneKindId],
    /// It calls at a scene's stops instead of going from start to goal: grids need two stops at least.
    stops: bool,
    /// The most stops that it can do with. Absent: as many as a scene may have.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    most_stops: Option<usize>,
    parameters: Vec<ParameterView>,
    presets: &'static [Preset],
    /// Runs that show what it does.
    cases: &'static [Case],
    readings: &'static [Reading],
    formulas: &'static [Formula],
    /// What it does, line by line: `$…$` is TeX, `@name@` a reading or a parameter, two spaces are a level.
    pseudocode: &'static [&'static str],
    /// The layers that it draws, in drawing order. A frame's table of spans counts them from 0.
    layers: &'static [Layer],
    /// The layers that only its explanations mark.
    marks: &'static [Layer],
    /// The numbers that it reports of each member of its population; empty: none.
    members: &'static [Member],
    /// The kinds of events that it reports.
    events: &'static [EventKind],
    /// How much it owes to the middle of the search box. Absent: not measured.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional))]
    centre_bias: Option<CentreBias>,
}

impl PlannerView {
    fn of(entry: &'static Entry) -> Self {
        let (layers, marks) = entry.drawn_and_marked();
        let &Entry {
            name,
            title,
            family,
            source,
            summary,
            evaluation,
            kinds,
            stops,
            most_stops,
            presets,
            cases,
            readings,
            formulas,
            pseudocode,
            members,
            events,
            ..
        } = entry;
        let parameters = ParameterView::all(entry.parameters, kinds);
        Self {
            name,
            title,
            family,
            source,
            summary,
            evaluation,
            kinds,
            stops,
            most_stops,
            parameters,
            presets,
            cases,
            readings,
            formulas,
            pseudocode,
            layers,
            marks,
            members,
            events,
            centre_bias: CentreBias::of(name),
        }
    }
}

/// What makes random scenes.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Generator"))]
struct GeneratorView {
    #[cfg_attr(feature = "types", ts(type = "GeneratorName"))]
    name: &'static str,
    title: &'static str,
    help: &'static str,
    parameters: Vec<ParameterView>,
}

impl GeneratorView {
    fn of(generator: &'static Generator) -> Self {
        let &Generator { name, title, help, ref kind, parameters, .. } = generator;
        Self { name, title, help, parameters: ParameterView::all(parameters, std::slice::from_ref(kind)) }
    }
}

/// How a robot, or an arm, follows a path.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "DriveEntry"))]
pub(crate) struct FollowerView {
    /// E.g. `[LTQPSO] §5`.
    source: &'static str,
    summary: &'static str,
    parameters: Vec<ParameterView>,
    /// The numbers of each row.
    columns: &'static [Column],
    formulas: &'static [Formula],
}

impl FollowerView {
    fn of(follower: &'static Follower) -> Self {
        let &Follower { source, summary, parameters, ref kind, columns, formulas, .. } = follower;
        Self { source, summary, parameters: ParameterView::all(parameters, std::slice::from_ref(kind)), columns, formulas }
    }
}

/// What a parameter means and what it may be: enough to make a control of it.
#[derive(Debug, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(rename = "Parameter", optional_fields))]
struct ParameterView {
    name: &'static str,
    /// TeX.
    symbol: &'static str,
    title: &'static str,
    help: &'static str,
    default: Value,
    /// Defaults that differ on a kind of scene (the published values).
    #[serde(serialize_with = "as_object")]
    #[cfg_attr(feature = "types", ts(type = "Partial<Record<Kind, ParameterValue>>"))]
    defaults: Vec<(&'static str, Value)>,
    /// The kinds of scene on which it means something.
    kinds: Vec<SceneKindId>,
    /// `subset`: any of the options, as text, with commas between: `alpha,beta`.
    #[cfg_attr(feature = "types", ts(type = "'number' | 'integer' | 'choice' | 'flag' | 'subset'"))]
    r#type: &'static str,
    /// Numbers and integers only: the smallest value allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<f64>"))]
    min: Option<Number>,
    /// Numbers and integers only: the largest value allowed.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(feature = "types", ts(optional, as = "Option<f64>"))]
    max: Option<Number>,
    /// The step of a slider; absent: continuous.
    #[serde(skip_serializing_if = "Option::is_none")]
    step: Option<u8>,
    /// Choices and subsets only.
    #[serde(skip_serializing_if = "Option::is_none")]
    options: Option<&'static [Choice]>,
    /// The value of another parameter without which it means nothing.
    #[serde(skip_serializing_if = "Option::is_none")]
    when: Option<When>,
    /// The smallest value that a slider offers; typing may go beyond it, down to `min`.
    #[serde(skip_serializing_if = "Option::is_none")]
    soft_min: Option<f64>,
    /// The largest value that a slider offers.
    #[serde(skip_serializing_if = "Option::is_none")]
    soft_max: Option<f64>,
    /// Whether a slider is logarithmic.
    #[serde(skip_serializing_if = "Option::is_none")]
    logarithmic: Option<bool>,
}

fn as_object<S: Serializer>(values: &[(&'static str, Value)], serializer: S) -> Result<S::Ok, S::Error> {
    Object(values).serialize(serializer)
}

impl ParameterView {
    fn all(parameters: &[&'static [Parameter]], kinds: &[SceneKindId]) -> Vec<Self> {
        parameters.iter().copied().flatten().map(|parameter| Self::of(parameter, kinds)).collect()
    }

    /// `kinds`: those of the scenes that it could mean something on.
    fn of(p: &'static Parameter, kinds: &[SceneKindId]) -> Self {
        let kinds: Vec<SceneKindId> = kinds.iter().copied().filter(|&kind| p.applies_to(kind)).collect();
        let general = Parameter { defaults: &[], ..*p }.default_on(kinds.first().copied().unwrap_or(SceneKindId("")));
        let (r#type, range, step, options) = match p.domain {
            Domain::Number { min, max, .. } => ("number", Number::from_f64(min).zip(Number::from_f64(max)), None, None),
            Domain::Integer { min, max, .. } => ("integer", Some((min.into(), max.into())), Some(1), None),
            Domain::Choice { options } => ("choice", None, None, Some(options)),
            Domain::Subset { options, .. } => ("subset", None, None, Some(options)),
            Domain::Flag { .. } => ("flag", None, None, None),
        };
        let (min, max) = range.unzip();
        let (soft_min, soft_max) = p.slider.unzip();
        Self {
            name: p.name,
            symbol: p.symbol,
            title: p.title,
            help: p.help,
            default: general,
            defaults: p.defaults.iter().map(|&(kind, value)| (kind.name(), Value::from(value))).collect(),
            kinds,
            r#type,
            min,
            max,
            step,
            options,
            when: p.when,
            soft_min,
            soft_max,
            logarithmic: p.slider.map(|_| p.logarithmic),
        }
    }
}
