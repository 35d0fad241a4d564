//! A planner's entry: all that is known of it without running it, and the function that starts it, with what a start begins with.

use std::sync::Arc;

use serde::Serialize;

use crate::{
    kernel::{Error, LayerKey, Scene, SceneKindId, Started, Stops},
    params::{Overrides, Param, Parameter, Parameters},
};

use super::{EventKind, Formula, Layer, Member, Preset, Reading, Shown};

/// What there is to know about a planner. Made by [`Entry::new`]; what is not set is empty.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Entry {
    /// The name in commands and links.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// What it belongs to.
    pub family: &'static str,
    /// Where it comes from, e.g. `[WCPSO] §2`.
    pub source: &'static str,
    /// A sentence or two.
    pub summary: &'static str,
    /// The kinds of scene it runs on.
    pub kinds: &'static [SceneKindId],
    /// Whether it calls at a scene's stops instead of going from start to goal.
    pub stops: bool,
    /// The most stops that it can do with.
    pub most_stops: Option<usize>,
    /// Its parameters, in lists: its own and those that it shares; every planner has `iterations`. See [`Entry::all_parameters`].
    pub parameters: &'static [&'static [Parameter]],
    /// The numbers it tells after each iteration.
    pub readings: &'static [Reading],
    /// The equations it carries out.
    pub formulas: &'static [Formula],
    /// What its explanations use in TeX besides the symbols of its parameters, readings and members.
    pub symbols: &'static [&'static str],
    /// The layers it draws, in drawing order, and after them those that only its explanations mark.
    pub layers: &'static [Layer],
    /// The numbers that it tells of each of those that search side by side.
    pub members: &'static [Member],
    /// The kinds of events that it tells of.
    pub events: &'static [EventKind],
    /// Parameters under a name: as published, or fitted to published figures.
    pub presets: &'static [Preset],
    /// What its paper recommends for these settings; `None` where it says nothing.
    pub suggest: fn(&Parameters) -> Option<Suggestion>,
    /// How a run begins: refuses everything that can be refused.
    pub start: fn(&Start) -> Result<Started, Error>,
}

/// Sizes that a paper recommends for a setup.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct Suggestion {
    /// How many particles.
    pub population: u64,
    /// How many iterations.
    pub iterations: u64,
    /// Where the recommendation comes from, e.g. `[LTQPSO] (10)`.
    pub source: &'static str,
}

impl Entry {
    /// A planner by its name in commands, its title, source and summary, and how a run begins.
    pub const fn new(
        name: &'static str,
        title: &'static str,
        source: &'static str,
        summary: &'static str,
        start: fn(&Start) -> Result<Started, Error>,
    ) -> Self {
        Self {
            name,
            title,
            family: "",
            source,
            summary,
            kinds: &[],
            stops: false,
            most_stops: None,
            parameters: &[],
            readings: &[],
            formulas: &[],
            symbols: &[],
            layers: &[],
            members: &[],
            events: &[],
            presets: &[],
            suggest: |_| None,
            start,
        }
    }

    /// What it belongs to.
    #[must_use]
    pub const fn family(self, family: &'static str) -> Self {
        Self { family, ..self }
    }

    /// The kinds of scene it runs on.
    #[must_use]
    pub const fn kinds(self, kinds: &'static [SceneKindId]) -> Self {
        Self { kinds, ..self }
    }

    /// It calls at a scene's stops, however many there are.
    #[must_use]
    pub const fn calls_at_stops(self) -> Self {
        Self { stops: true, ..self }
    }

    /// It calls at a scene's stops, at most so many.
    #[must_use]
    pub const fn calls_at_most(self, stops: usize) -> Self {
        Self { stops: true, most_stops: Some(stops), ..self }
    }

    /// Its parameters, in lists: its own and those that it shares. Every planner has `iterations`.
    #[must_use]
    pub const fn parameters(self, parameters: &'static [&'static [Parameter]]) -> Self {
        Self { parameters, ..self }
    }

    /// The numbers it tells after each iteration.
    #[must_use]
    pub const fn readings(self, readings: &'static [Reading]) -> Self {
        Self { readings, ..self }
    }

    /// The equations it carries out.
    #[must_use]
    pub const fn formulas(self, formulas: &'static [Formula]) -> Self {
        Self { formulas, ..self }
    }

    /// What its explanations use in TeX besides the symbols of its parameters, readings and members.
    #[must_use]
    pub const fn symbols(self, symbols: &'static [&'static str]) -> Self {
        Self { symbols, ..self }
    }

    /// The layers it draws, in drawing order.
    #[must_use]
    pub const fn layers(self, layers: &'static [Layer]) -> Self {
        Self { layers, ..self }
    }

    /// The numbers that it tells of each of those that search side by side.
    #[must_use]
    pub const fn members(self, members: &'static [Member]) -> Self {
        Self { members, ..self }
    }

    /// The kinds of events that it tells of.
    #[must_use]
    pub const fn events(self, events: &'static [EventKind]) -> Self {
        Self { events, ..self }
    }

    /// Parameters under a name.
    #[must_use]
    pub const fn presets(self, presets: &'static [Preset]) -> Self {
        Self { presets, ..self }
    }

    /// What its paper recommends for some settings.
    #[must_use]
    pub const fn suggest(self, suggest: fn(&Parameters) -> Option<Suggestion>) -> Self {
        Self { suggest, ..self }
    }

    /// The layers that frames consist of, and those that only explanations mark. A frame's table counts the former.
    pub fn drawn_and_marked(&self) -> (&'static [Layer], &'static [Layer]) {
        let drawn = self.layers.iter().position(|layer| layer.shown == Shown::Inspection);
        self.layers.split_at(drawn.unwrap_or(self.layers.len()))
    }

    /// The layer of this name.
    pub fn layer(&self, key: LayerKey) -> Option<&'static Layer> {
        self.layers.iter().find(|layer| layer.key == key)
    }

    /// Refuses a kind of scene that this planner does not run on.
    ///
    /// # Errors
    /// [`Error::Unsupported`] with the kinds it runs on.
    pub fn check_kind(&self, kind: SceneKindId) -> Result<(), Error> {
        if self.kinds.contains(&kind) {
            return Ok(());
        }
        let kinds: Vec<_> = self.kinds.iter().map(|k| k.name()).collect();
        Err(Error::Unsupported { planner: self.name.to_owned(), kind: kind.name().to_owned(), kinds: kinds.join(", ") })
    }

    /// Refuses a scene that this planner does not run on.
    ///
    /// # Errors
    /// As [`Entry::check_kind`]; [`Error::Refused`] for a scene without what the planner goes to, and for too many stops.
    pub fn check_scene(&self, scene: &Scene) -> Result<(), Error> {
        self.check_kind(scene.kind())?;
        if !self.stops {
            return scene.plane().map_or(Ok(()), |plane| plane.ends().map(|_| ()));
        }
        let Stops { field, places } = scene.body().stops();
        match places.len() {
            n if n < 2 => {
                let found = if n == 0 { "nothing" } else { "a list of 1" };
                Err(Error::refused(field, found, "two stops at least: this planner calls at stops"))
            }
            n => self.check_most(field, n),
        }
    }

    /// The values of a preset that mean something on this kind of scene.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist; [`Error::Refused`] for a planner without presets.
    pub fn preset(&self, name: &str, kind: SceneKindId) -> Result<Overrides, Error> {
        if self.presets.is_empty() {
            return Err(Error::refused("preset", name, format!("left out: {} has no presets", self.name)));
        }
        let preset = self.presets.iter().find(|preset| preset.name == name);
        let preset = preset.ok_or_else(|| Error::unknown("preset", name, self.presets.iter().map(|preset| preset.name)))?;
        let applies = |name: &str| self.parameters_on(kind).any(|parameter| parameter.name == name);
        Ok(preset.given().iter().filter(|(name, _)| applies(name)).map(|(name, value)| (name, value.clone())).collect())
    }

    fn check_most(&self, field: &str, n: usize) -> Result<(), Error> {
        match self.most_stops {
            Some(most) if n > most => {
                Err(Error::refused(field, format!("a list of {n}"), format!("at most {most} stops for {}", self.name)))
            }
            _ => Ok(()),
        }
    }

    /// All parameters, in the order in which they are offered.
    pub fn all_parameters(&self) -> impl Iterator<Item = &'static Parameter> + use<> {
        self.parameters.iter().copied().flatten()
    }

    /// The parameter of this name.
    pub fn parameter(&self, name: &str) -> Option<&'static Parameter> {
        self.all_parameters().find(|parameter| parameter.name == name)
    }

    /// The parameters that mean something on this kind of scene.
    pub fn parameters_on(&self, kind: SceneKindId) -> impl Iterator<Item = &'static Parameter> + use<> {
        self.all_parameters().filter(move |p| p.applies_to(kind))
    }
}

/// What a run of a planner begins with.
#[derive(Clone, Copy)]
pub struct Start<'a> {
    /// What is planned in: of a kind that the planner runs on.
    pub scene: &'a Arc<Scene>,
    /// A value for each of its parameters.
    pub parameters: &'a Parameters,
    /// 0 to 2^53 − 1.
    pub seed: u64,
    /// All planners, for one that needs others.
    pub entries: &'a dyn Entries,
}

impl Start<'_> {
    /// The planner that a parameter names.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the parameter's name, its value and the planners that there are.
    pub fn planner(&self, parameter: Param<&'static str>) -> Result<&'static Entry, Error> {
        self.entries.planner(self.parameters[parameter]).map_err(|error| match error {
            Error::Unknown { value, known, .. } => Error::Unknown { field: parameter.name().to_owned(), value, known },
            other => other,
        })
    }
}

/// Planners by name.
pub trait Entries {
    /// The entry of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    fn planner(&self, name: &str) -> Result<&'static Entry, Error>;
}
