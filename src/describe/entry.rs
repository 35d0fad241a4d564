//! A planner's entry: all that is known of it without running it, and the function that starts it, with what a start begins with.

use std::sync::Arc;

use serde::Serialize;

use crate::{
    kernel::{Error, LayerKey, Scene, SceneKindId, Started, Stops, error::list_of, message::ENGLISH, words},
    message,
    params::{Overrides, Param, Parameter, Parameters},
};

use super::{Case, EventKind, Formula, Layer, Member, Preset, Reading, Shown};

/// A planner's entry. Made by [`Entry::new`]; what is not set is empty.
#[derive(Debug, Clone, Copy)]
#[non_exhaustive]
pub struct Entry {
    /// The name in commands and links.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// The name of its family, e.g. `swarm`; [`OWN`](Self::OWN) for planners that are not of a program but were handed in.
    pub family: &'static str,
    /// The source, e.g. `[WCPSO] §2`.
    pub source: &'static str,
    /// A summary in one or two sentences.
    pub summary: &'static str,
    /// What one of its evaluations is, e.g. `a position`: budgets of planners are alike only where this is. Empty: it does not say.
    pub evaluation: &'static str,
    /// The kinds of scene it runs on.
    pub kinds: &'static [SceneKindId],
    /// Whether it visits a scene's stops instead of going from start to goal.
    pub stops: bool,
    /// The largest number of stops that it accepts; `None`: any number.
    pub most_stops: Option<usize>,
    /// Its parameters, in lists: its own and those that it shares; every planner has `iterations`. See [`Entry::all_parameters`].
    pub parameters: &'static [&'static [Parameter]],
    /// The numbers that it reports after each iteration.
    pub readings: &'static [Reading],
    /// The equations that it computes.
    pub formulas: &'static [Formula],
    /// What it does, line by line, two spaces a level: `$…$` is TeX, `@name@` a reading or a parameter. Not in a build without
    /// English.
    pub pseudocode: &'static [&'static str],
    /// The layers it draws, in drawing order, and after them those that only its explanations mark.
    pub layers: &'static [Layer],
    /// The numbers that it reports of each member of its population.
    pub members: &'static [Member],
    /// The kinds of events that it reports.
    pub events: &'static [EventKind],
    /// Named sets of parameters: as published, or fitted to published values.
    pub presets: &'static [Preset],
    /// Runs that show what it does. Not in a build without English, whose host has the catalogue.
    pub cases: &'static [Case],
    /// Whether it finds, with these parameters and enough iterations, the exact optimum by the rule that it keeps to.
    pub exact: fn(&Parameters) -> bool,
    /// The sizes that its paper recommends for these parameters; `None` if it recommends none.
    pub suggest: fn(&Parameters) -> Option<Suggestion>,
    /// Starts a run, and refuses all invalid input.
    pub start: fn(&Start) -> Result<Started, Error>,
}

/// Sizes that a paper recommends for a setup.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Suggestion {
    /// The number of particles.
    pub population: u64,
    /// The number of iterations.
    pub iterations: u64,
    /// The source, e.g. `[LTQPSO] (10)`.
    pub source: &'static str,
}

impl Entry {
    /// A planner with its name in commands, its title, its source, its summary and the function that starts it.
    pub const fn new(
        name: &'static str,
        title: &'static str,
        source: &'static str,
        summary: &'static str,
        start: fn(&Start) -> Result<Started, Error>,
    ) -> Self {
        Self {
            name,
            title: words(title),
            family: "",
            source: words(source),
            summary: words(summary),
            evaluation: "",
            kinds: &[],
            stops: false,
            most_stops: None,
            parameters: &[],
            readings: &[],
            formulas: &[],
            pseudocode: &[],
            layers: &[],
            members: &[],
            events: &[],
            presets: &[],
            cases: &[],
            exact: |_| false,
            suggest: |_| None,
            start,
        }
    }

    /// The family of planners that were handed in as code.
    pub const OWN: &'static str = "own";

    /// Sets the family.
    #[must_use]
    pub const fn family(self, family: &'static str) -> Self {
        Self { family, ..self }
    }

    /// Says what one of its evaluations is: `a position`.
    #[must_use]
    pub const fn evaluating(self, evaluation: &'static str) -> Self {
        Self { evaluation: words(evaluation), ..self }
    }

    /// Sets the kinds of scene it runs on.
    #[must_use]
    pub const fn kinds(self, kinds: &'static [SceneKindId]) -> Self {
        Self { kinds, ..self }
    }

    /// Declares that it visits a scene's stops, however many there are.
    #[must_use]
    pub const fn calls_at_stops(self) -> Self {
        Self { stops: true, ..self }
    }

    /// Declares that it visits a scene's stops, at most so many.
    #[must_use]
    pub const fn calls_at_most(self, stops: usize) -> Self {
        Self { stops: true, most_stops: Some(stops), ..self }
    }

    /// Sets its parameters, in lists: its own and those that it shares. Every planner has `iterations`.
    #[must_use]
    pub const fn parameters(self, parameters: &'static [&'static [Parameter]]) -> Self {
        Self { parameters, ..self }
    }

    /// Sets the numbers that it reports after each iteration.
    #[must_use]
    pub const fn readings(self, readings: &'static [Reading]) -> Self {
        Self { readings, ..self }
    }

    /// Sets the equations that it computes.
    #[must_use]
    pub const fn formulas(self, formulas: &'static [Formula]) -> Self {
        Self { formulas: if ENGLISH { formulas } else { &[] }, ..self }
    }

    /// Sets what it does, line by line: `$…$` is TeX, `@name@` a reading or a parameter, two spaces are a level.
    #[must_use]
    pub const fn pseudocode(self, lines: &'static [&'static str]) -> Self {
        Self { pseudocode: if ENGLISH { lines } else { &[] }, ..self }
    }

    /// The layers it draws, in drawing order.
    #[must_use]
    pub const fn layers(self, layers: &'static [Layer]) -> Self {
        Self { layers, ..self }
    }

    /// Sets the numbers that it reports of each member of its population.
    #[must_use]
    pub const fn members(self, members: &'static [Member]) -> Self {
        Self { members, ..self }
    }

    /// Sets the kinds of events that it reports.
    #[must_use]
    pub const fn events(self, events: &'static [EventKind]) -> Self {
        Self { events, ..self }
    }

    /// Sets the named sets of parameters.
    #[must_use]
    pub const fn presets(self, presets: &'static [Preset]) -> Self {
        Self { presets, ..self }
    }

    /// Sets runs that show what it does.
    #[must_use]
    pub const fn cases(self, cases: &'static [Case]) -> Self {
        Self { cases: if ENGLISH { cases } else { &[] }, ..self }
    }

    /// Declares with which parameters it finds the exact optimum. The conformance suite holds it to that.
    #[must_use]
    pub const fn exact(self, exact: fn(&Parameters) -> bool) -> Self {
        Self { exact, ..self }
    }

    /// Sets the function that gives the sizes that its paper recommends.
    #[must_use]
    pub const fn suggest(self, suggest: fn(&Parameters) -> Option<Suggestion>) -> Self {
        Self { suggest, ..self }
    }

    /// What another entry describes (kinds, parameters, readings, formulas, layers, members, events), for a variant of its planner
    /// under a name and with a start of its own.
    #[must_use]
    pub const fn like(self, other: &Self) -> Self {
        Self {
            name: self.name,
            title: self.title,
            source: self.source,
            summary: self.summary,
            start: self.start,
            presets: &[],
            cases: &[],
            exact: |_| false,
            suggest: |_| None,
            ..*other
        }
    }

    /// A value for each parameter on a kind of scene: what is given, and defaults for the rest.
    ///
    /// # Errors
    /// As [`Parameters::new`].
    pub fn configure(&self, kind: SceneKindId, given: &Overrides) -> Result<Parameters, Error> {
        Parameters::new(self.parameters, kind, given)
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
    /// As [`Entry::check_kind`]; [`Error::Refused`] for a scene without the goal or the stops that the planner needs, and for
    /// too many stops.
    pub fn check_scene(&self, scene: &Scene) -> Result<(), Error> {
        self.check_kind(scene.kind())?;
        if !self.stops {
            return scene.plane().map_or(Ok(()), |plane| plane.ends().map(|_| ()));
        }
        let Stops { field, places } = scene.body().stops();
        match places.len() {
            n if n < 2 => {
                let found = if n == 0 { message!("error-nothing", "nothing") } else { list_of(n) };
                let allowed = message!("error-needs-stops", "a list of at least two stops: this planner visits stops");
                Err(Error::refused(field, found, allowed))
            }
            n => self.check_most(field, n),
        }
    }

    /// The values of a preset that apply to this kind of scene.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist; [`Error::Refused`] for a planner without presets.
    pub fn preset(&self, name: &str, kind: SceneKindId) -> Result<Overrides, Error> {
        if self.presets.is_empty() {
            let allowed = message!("error-no-presets", "left out: {planner} has no presets", planner = self.name);
            return Err(Error::refused("preset", name, allowed));
        }
        let preset = self.presets.iter().find(|preset| preset.name == name);
        let preset = preset.ok_or_else(|| Error::unknown("preset", name, self.presets.iter().map(|preset| preset.name)))?;
        let applies = |name: &str| self.parameters_on(kind).any(|parameter| parameter.name == name);
        Ok(preset.given().iter().filter(|(name, _)| applies(name)).map(|(name, value)| (name, value.clone())).collect())
    }

    fn check_most(&self, field: &str, n: usize) -> Result<(), Error> {
        match self.most_stops {
            Some(most) if n > most => {
                let allowed = message!("error-most-stops", "at most {most} stops for {planner}", most, planner = self.name);
                Err(Error::refused(field, list_of(n), allowed))
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

    /// The parameters that apply to this kind of scene.
    pub fn parameters_on(&self, kind: SceneKindId) -> impl Iterator<Item = &'static Parameter> + use<> {
        self.all_parameters().filter(move |p| p.applies_to(kind))
    }
}

/// What a planner is started with.
#[derive(Clone, Copy)]
pub struct Start<'a> {
    /// The entry that is started.
    pub entry: &'static Entry,
    /// The scene, of a kind that the planner runs on.
    pub scene: &'a Arc<Scene>,
    /// A value for each of the planner's parameters.
    pub parameters: &'a Parameters,
    /// The seed, from 0 to 2^53 − 1.
    pub seed: u64,
    /// All planners, for a planner that needs others.
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

/// Finds planners by name.
pub trait Entries {
    /// The entry of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    fn planner(&self, name: &str) -> Result<&'static Entry, Error>;
}
