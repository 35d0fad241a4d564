//! The catalogue as the page, `forage list --json` and other programs read it.

use serde::{Serialize, Serializer, ser::SerializeStruct};

use crate::{
    ants, arm,
    describe::{Entry, Follower, Layer, layers},
    drive, dynamic,
    kernel::{LayerKey, SceneKindId, Shape},
    params::{Domain, Parameter, Value, as_object},
    scene::{
        ARM, FUNCTION, GRID, Scene, TOUR,
        generate::{GENERATORS, Generator, OTHERS},
        shipped_names,
    },
    search, swarm, tour, tree, tuning,
};

use super::{PLANNERS, layer_keys};

/// The whole catalogue as it crosses to the page and to `forage list --json`.
#[derive(Debug, Serialize)]
pub struct Catalogue {
    version: &'static str,
    planners: Vec<EntryView>,
    scenes: Vec<&'static Scene>,
    generators: Vec<GeneratorView>,
    drive: DriveView,
    motion: DriveView,
    /// The keys of all layers.
    roles: Vec<LayerKey>,
    /// The layers of a scene itself, which no planner need draw.
    layers: &'static [Layer],
    shapes: [&'static str; Shape::ALL.len()],
    /// Every TeX string that can appear outside a formula, so that pages can typeset them when they are built.
    symbols: Vec<&'static str>,
}

/// The whole catalogue.
pub fn catalogue() -> Catalogue {
    let all = PLANNERS
        .iter()
        .flat_map(|e| e.all_parameters().map(|p| p.symbol).chain(e.readings.iter().map(|r| r.symbol)))
        .chain(swarm::SYMBOLS.iter().copied())
        .chain(ants::SYMBOLS.iter().copied())
        .chain(tuning::SYMBOLS.iter().copied())
        .chain(search::SYMBOLS.iter().copied())
        .chain(tour::SYMBOLS.iter().copied())
        .chain(dynamic::SYMBOLS.iter().copied())
        .chain(tree::SYMBOLS.iter().copied())
        .chain(PLANNERS.iter().flat_map(|e| e.members.iter().map(|m| m.symbol)))
        .chain(drive::PARAMETERS.iter().map(|p| p.symbol))
        .chain(drive::COLUMNS.iter().map(|c| c.symbol))
        .chain(arm::MOTION.parameters.iter().copied().flatten().map(|p| p.symbol))
        .chain(arm::MOTION.columns.iter().map(|c| c.symbol));
    let mut symbols = Vec::new();
    for symbol in all {
        if !symbol.is_empty() && !symbols.contains(&symbol) {
            symbols.push(symbol);
        }
    }
    Catalogue {
        version: env!("CARGO_PKG_VERSION"),
        planners: PLANNERS.iter().map(EntryView).collect(),
        scenes: shipped_names().map(|scene| &**scene).collect(),
        generators: GENERATORS.iter().chain(OTHERS).map(GeneratorView).collect(),
        drive: DriveView(&drive::ENTRY, GRID),
        motion: DriveView(&arm::MOTION, ARM),
        roles: layer_keys(),
        layers: layers::SCENE,
        shapes: Shape::ALL.map(Shape::name),
        symbols,
    }
}

/// An entry without its function.
#[derive(Debug)]
struct EntryView(&'static Entry);

impl Serialize for EntryView {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let entry = self.0;
        let parameters = views(entry.parameters, entry.kinds);
        let mut out = serializer.serialize_struct("Planner", 16)?;
        out.serialize_field("name", entry.name)?;
        out.serialize_field("title", entry.title)?;
        out.serialize_field("family", entry.family)?;
        out.serialize_field("source", entry.source)?;
        out.serialize_field("summary", entry.summary)?;
        out.serialize_field("kinds", entry.kinds)?;
        out.serialize_field("stops", &entry.stops)?;
        if let Some(most) = entry.most_stops {
            out.serialize_field("most_stops", &most)?;
        }
        out.serialize_field("parameters", &parameters)?;
        out.serialize_field("presets", entry.presets)?;
        out.serialize_field("readings", entry.readings)?;
        out.serialize_field("formulas", entry.formulas)?;
        let (layers, marks) = entry.drawn_and_marked();
        out.serialize_field("layers", layers)?;
        out.serialize_field("marks", marks)?;
        out.serialize_field("members", entry.members)?;
        out.serialize_field("events", entry.events)?;
        out.end()
    }
}

/// A generator without its function.
#[derive(Debug)]
struct GeneratorView(&'static Generator);

impl Serialize for GeneratorView {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Generator", 4)?;
        out.serialize_field("name", self.0.name)?;
        out.serialize_field("title", self.0.title)?;
        out.serialize_field("help", self.0.help)?;
        let kinds: &[SceneKindId] = if self.0.kind() == TOUR { &[TOUR] } else { &[GRID] };
        out.serialize_field("parameters", &views(self.0.parameters, kinds))?;
        out.end()
    }
}

/// How a robot, or an arm, follows a path.
#[derive(Debug)]
struct DriveView(&'static Follower, SceneKindId);

impl Serialize for DriveView {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("DriveEntry", 5)?;
        out.serialize_field("source", self.0.source)?;
        out.serialize_field("summary", self.0.summary)?;
        out.serialize_field("parameters", &views(self.0.parameters, if self.1 == ARM { &[ARM] } else { &[GRID] }))?;
        out.serialize_field("columns", self.0.columns)?;
        out.serialize_field("formulas", self.0.formulas)?;
        out.end()
    }
}

/// Pairs as an object.
struct Object<'a>(&'a [(&'static str, Value)]);

impl Serialize for Object<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        as_object(self.0, serializer)
    }
}

struct ParameterView {
    parameter: &'static Parameter,
    /// The kinds of scene that it could mean something on.
    kinds: &'static [SceneKindId],
}

fn views(parameters: &'static [&'static [Parameter]], kinds: &'static [SceneKindId]) -> Vec<ParameterView> {
    parameters.iter().copied().flatten().map(|parameter| ParameterView { parameter, kinds }).collect()
}

impl Serialize for ParameterView {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let p = self.parameter;
        let kinds: Vec<SceneKindId> = self.kinds.iter().copied().filter(|&kind| p.applies_to(kind)).collect();
        let defaults: Vec<_> = p.defaults.iter().map(|&(kind, value)| (kind.name(), value.into())).collect();
        let general = Parameter { defaults: &[], ..*p }.default_on(kinds.first().copied().unwrap_or(FUNCTION));
        let mut out = serializer.serialize_struct("Parameter", 15)?;
        out.serialize_field("name", p.name)?;
        out.serialize_field("symbol", p.symbol)?;
        out.serialize_field("title", p.title)?;
        out.serialize_field("help", p.help)?;
        out.serialize_field("default", &general)?;
        out.serialize_field("defaults", &Object(&defaults))?;
        out.serialize_field("kinds", &kinds)?;
        match p.domain {
            Domain::Number { min, max, .. } => {
                out.serialize_field("type", "number")?;
                out.serialize_field("min", &min)?;
                out.serialize_field("max", &max)?;
            }
            Domain::Integer { min, max, .. } => {
                out.serialize_field("type", "integer")?;
                out.serialize_field("min", &min)?;
                out.serialize_field("max", &max)?;
                out.serialize_field("step", &1)?;
            }
            Domain::Choice { options } => {
                out.serialize_field("type", "choice")?;
                out.serialize_field("options", options)?;
            }
            Domain::Subset { options, .. } => {
                out.serialize_field("type", "subset")?;
                out.serialize_field("options", options)?;
            }
            Domain::Flag { .. } => out.serialize_field("type", "flag")?,
        }
        if let Some(when) = &p.when {
            out.serialize_field("when", when)?;
        }
        if let Some((low, high)) = p.slider {
            out.serialize_field("soft_min", &low)?;
            out.serialize_field("soft_max", &high)?;
            out.serialize_field("logarithmic", &p.logarithmic)?;
        }
        out.end()
    }
}
