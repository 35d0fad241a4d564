//! The catalogue as the page, `forage list --json` and other programs read it.

use std::sync::Arc;

use serde::{Serialize, Serializer, ser::SerializeStruct};

#[cfg(not(target_arch = "wasm32"))]
use crate::kernel::message::sentences;
use crate::{
    kernel::{Scene, SceneKindId, Shape},
    params::{Domain, Object, Parameter, Value},
};

use super::{Entry, Follower, Generator, Registry, layers};

/// All that a registry lists, without the functions.
#[derive(Debug)]
pub struct Catalogue<'a>(&'a Registry);

impl Registry {
    /// All that is listed, to be serialised.
    pub fn catalogue(&self) -> Catalogue<'_> {
        Catalogue(self)
    }

    /// Every TeX string that can appear outside a formula, so that pages can typeset them when they are built.
    #[cfg(not(target_arch = "wasm32"))]
    pub(crate) fn symbols(&self) -> Vec<&'static str> {
        let planners = self.planners().iter().flat_map(|entry| {
            let parameters = entry.all_parameters().map(|p| p.symbol);
            parameters.chain(entry.readings.iter().map(|r| r.symbol)).chain(entry.members.iter().map(|m| m.symbol))
        });
        let followers = self.followers().iter().flat_map(|follower| {
            let parameters = follower.parameters.iter().copied().flatten().map(|p| p.symbol);
            parameters.chain(follower.columns.iter().map(|column| column.symbol))
        });
        let told = sentences().into_iter().map(|sentence| sentence.symbol);
        let mut symbols = Vec::new();
        for symbol in planners.chain(followers).chain(told) {
            if !symbol.is_empty() && !symbols.contains(&symbol) {
                symbols.push(symbol);
            }
        }
        symbols
    }
}

impl Serialize for Catalogue<'_> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let registry = self.0;
        let scenes: Vec<&Scene> = registry.scenes().iter().map(Arc::as_ref).collect();
        let planners: Vec<_> = registry.planners().iter().copied().map(EntryView).collect();
        let generators: Vec<_> = registry.generators().iter().copied().map(GeneratorView).collect();
        let mut out = serializer.serialize_struct("Catalogue", 8 + registry.followers().len())?;
        out.serialize_field("version", env!("CARGO_PKG_VERSION"))?;
        out.serialize_field("planners", &planners)?;
        out.serialize_field("scenes", &scenes)?;
        out.serialize_field("generators", &generators)?;
        for follower in registry.followers() {
            out.serialize_field(follower.name, &FollowerView(follower))?;
        }
        // The keys of all layers.
        out.serialize_field("roles", &registry.layer_keys())?;
        // The layers of a scene itself, which no planner need draw.
        out.serialize_field("layers", layers::SCENE)?;
        out.serialize_field("shapes", &Shape::ALL.map(Shape::name))?;
        // A module's host has them: they are listed natively only.
        #[cfg(not(target_arch = "wasm32"))]
        out.serialize_field("symbols", &registry.symbols())?;
        out.end()
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
        out.serialize_field("parameters", &views(self.0.parameters, std::slice::from_ref(&self.0.kind)))?;
        out.end()
    }
}

/// How a robot, or an arm, follows a path.
#[derive(Debug)]
struct FollowerView(&'static Follower);

impl Serialize for FollowerView {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Follower", 5)?;
        out.serialize_field("source", self.0.source)?;
        out.serialize_field("summary", self.0.summary)?;
        out.serialize_field("parameters", &views(self.0.parameters, std::slice::from_ref(&self.0.kind)))?;
        out.serialize_field("columns", self.0.columns)?;
        out.serialize_field("formulas", self.0.formulas)?;
        out.end()
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
        let defaults: Vec<_> = p.defaults.iter().map(|&(kind, value)| (kind.name(), Value::from(value))).collect();
        let general = Parameter { defaults: &[], ..*p }.default_on(kinds.first().copied().unwrap_or(SceneKindId("")));
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
