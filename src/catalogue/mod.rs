//! Every planner and its parameters, one line each; nothing else lists planners.

mod view;

use std::sync::Arc;

use serde::{Serialize, Serializer};

use crate::{
    ants, dynamic,
    error::Error,
    frame::Role,
    params::{Fixed, Given, Parameter, Settings, Value, When, as_object},
    scene::{Body, Kind, Scene},
    search,
    session::AnyPlanner,
    swarm, tour, tree, tuning,
};

pub use view::{Catalogue, catalogue};

/// All planners, in the order in which they are offered.
pub const PLANNERS: &[Entry] = &[
    swarm::wcpso::ENTRY,
    swarm::pso::ENTRY,
    swarm::wpso::ENTRY,
    swarm::cpso::ENTRY,
    swarm::ltqpso::ENTRY,
    swarm::qpso::ENTRY,
    swarm::bat_continuous::ENTRY,
    swarm::cuckoo_search::ENTRY,
    swarm::pso_rrt::ENTRY,
    ants::aco_wolf::ENTRY,
    ants::aco_direction::ENTRY,
    ants::aco_dijkstra::ENTRY,
    ants::aco::ENTRY,
    search::a_star::ENTRY,
    search::dijkstra::ENTRY,
    search::theta_star::ENTRY,
    tour::bat::ENTRY,
    tour::hybrid_bat::ENTRY,
    tour::ga::ENTRY,
    tour::tour_pso::ENTRY,
    tour::sa::ENTRY,
    tour::two_opt::ENTRY,
    tour::held_karp::ENTRY,
    tree::rrt_guided::ENTRY,
    tree::rrt::ENTRY,
    tree::rrt_connect::ENTRY,
    tree::rrt_star::ENTRY,
    tree::rrt_joint::ENTRY,
    dynamic::wolf_ant_drive::ENTRY,
    dynamic::a_star_drive::ENTRY,
    dynamic::d_star_lite_drive::ENTRY,
    tuning::ENTRY,
];

/// Starts a run: refuses everything that can be refused.
pub type Start = fn(&Arc<Scene>, &Settings, u64) -> Result<Box<dyn AnyPlanner>, Error>;

/// What there is to know about a planner.
#[derive(Debug, Clone, Copy)]
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
    pub kinds: &'static [Kind],
    /// Whether it calls at a scene's stops instead of going from start to goal.
    pub stops: bool,
    /// The most stops that it can do with.
    pub most_stops: Option<usize>,
    /// Its parameters; every planner has `iterations`.
    pub parameters: &'static [Parameter],
    /// The numbers it tells after each iteration.
    pub readings: &'static [Reading],
    /// The equations it carries out.
    pub formulas: &'static [Formula],
    /// The layers it draws, in drawing order.
    pub layers: &'static [Layer],
    /// The numbers that it tells of each of those that search side by side.
    pub members: &'static [Member],
    /// The kinds of events that it tells of.
    pub events: &'static [EventKind],
    /// Parameters under a name: as published, or fitted to published figures.
    pub presets: &'static [Preset],
    /// What its paper recommends for these settings; `None` where it says nothing.
    pub suggest: fn(&Settings) -> Option<Suggestion>,
    /// How a run begins.
    pub start: Start,
}

/// The name of the preset with which a planner builds one of many roads between stops: sizes that make 66 runs take seconds.
pub const ROAD: &str = "road";

/// Parameters under a name.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Preset {
    /// The name in commands: `paper`, `fitted`.
    pub name: &'static str,
    /// A few words: As in the text.
    pub title: &'static str,
    /// What it is good for, and what it rests on.
    pub help: &'static str,
    /// A shipped scene on which to try it.
    pub scene: &'static str,
    /// The values that differ from the defaults.
    #[serde(rename = "params", serialize_with = "fixed")]
    pub values: &'static [(&'static str, Fixed)],
}

fn fixed<S: Serializer>(values: &[(&'static str, Fixed)], serializer: S) -> Result<S::Ok, S::Error> {
    as_object(&values.iter().map(|&(name, value)| (name, Value::from(value))).collect::<Vec<_>>(), serializer)
}

impl Preset {
    /// The values as overrides.
    pub fn given(&self) -> Given {
        self.values.iter().map(|&(name, value)| (name, Value::from(value))).collect()
    }
}

/// A number that a planner tells after each iteration.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Reading {
    /// Its name in readings, traces and formulas.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it says.
    pub help: &'static str,
    /// Where it belongs.
    pub group: Group,
}

impl Reading {
    /// A number by its name, TeX, title, group and help.
    pub const fn new(name: &'static str, symbol: &'static str, title: &'static str, group: Group, help: &'static str) -> Self {
        Self { name, symbol, title, help, group }
    }
}

/// What a reading belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Group {
    /// A cost: drawn in the convergence chart.
    Cost,
    /// A parameter that changes over the iterations.
    Schedule,
    /// A length in the scene's unit: drawn beside the exact optimum.
    Length,
    /// Something else that the result measures.
    Measure,
    /// How many of something.
    Count,
}

/// An equation.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Formula {
    /// An identifier within the planner.
    pub name: &'static str,
    /// Where it comes from, e.g. `[WCPSO] (3)`.
    pub source: &'static str,
    /// A few words.
    pub title: &'static str,
    /// TeX, as in the paper.
    pub tex: &'static str,
    /// TeX with `@name@` where a number of the moment goes.
    #[serde(skip_serializing_if = "str::is_empty")]
    pub live: &'static str,
    /// Where those numbers come from.
    pub scope: Scope,
    /// A parameter's value without which another equation stands in its place.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub when: Option<When>,
}

impl Formula {
    /// An equation that is filled in from an inspection's values.
    pub const fn of_item(name: &'static str, source: &'static str, title: &'static str, tex: &'static str, live: &'static str) -> Self {
        Self { name, source, title, tex, live, scope: Scope::Item, when: None }
    }

    /// The same, carried out only while a parameter has this value.
    #[must_use]
    pub const fn when(mut self, parameter: &'static str, value: &'static str) -> Self {
        self.when = Some(When { parameter, value });
        self
    }
}

/// Where a formula's numbers come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Scope {
    /// The readings of the iteration, and the parameters.
    Iteration,
    /// An inspection's values.
    Item,
}

/// A layer that a planner draws.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Layer {
    /// What it shows.
    pub role: Role,
    /// For a legend.
    pub title: &'static str,
    /// A sentence.
    pub help: &'static str,
    /// Drawn without being asked for.
    pub on: bool,
    /// Its pieces can be inspected.
    pub pickable: bool,
    /// A parameter's value without which there is nothing to draw.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub when: Option<When>,
    /// The kinds of scene on which there is something to draw; empty: all that the planner runs on.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub kinds: &'static [Kind],
}

impl Layer {
    /// A layer that there is whatever the parameters are.
    pub const fn new(role: Role, title: &'static str, on: bool, pickable: bool, help: &'static str) -> Self {
        Self { role, title, help, on, pickable, when: None, kinds: &[] }
    }
}

/// A number of each of those that search side by side.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct Member {
    /// An identifier.
    pub name: &'static str,
    /// TeX.
    pub symbol: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it says.
    pub help: &'static str,
    /// From 0 to this: drawn as a bar. `None`: only written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub full: Option<f64>,
    /// What the numbers 0, 1, … stand for, if they are not numbers.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub words: &'static [&'static str],
}

/// A kind of event in simulated time.
#[derive(Debug, Clone, Copy, Serialize)]
pub struct EventKind {
    /// An identifier.
    pub name: &'static str,
    /// A few words.
    pub title: &'static str,
    /// What it means.
    pub help: &'static str,
    /// How it is to be taken.
    pub tone: Tone,
}

/// How an event is to be taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Tone {
    /// Something came about.
    Plain,
    /// Something was seen or foreseen that calls for a decision.
    Warning,
    /// A decision.
    Decision,
    /// Something went as it should.
    Good,
    /// Something must not happen and did.
    Bad,
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

/// The entry of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn find(name: &str) -> Result<&'static Entry, Error> {
    PLANNERS.iter().find(|entry| entry.name == name).ok_or_else(|| Error::unknown("planner", name, PLANNERS.iter().map(|e| e.name)))
}

impl Entry {
    /// Refuses a kind of scene that this planner does not run on.
    ///
    /// # Errors
    /// [`Error::Unsupported`] with the kinds it runs on.
    pub fn check_kind(&self, kind: Kind) -> Result<(), Error> {
        if self.kinds.contains(&kind) {
            return Ok(());
        }
        let kinds: Vec<_> = self.kinds.iter().map(|k| k.name()).collect();
        Err(Error::Unsupported { planner: self.name.to_owned(), kind: kind.name().to_owned(), kinds: kinds.join(", ") })
    }

    /// Refuses a scene that this planner does not run on.
    ///
    /// # Errors
    /// As [`Entry::check_kind`]; [`Error::Refused`] for a grid without what the planner goes to, and for too many stops.
    pub fn check_scene(&self, scene: &Scene) -> Result<(), Error> {
        self.check_kind(scene.kind())?;
        match scene.body() {
            Body::Grid(grid) if self.stops && grid.stops.len() < 2 => {
                let found = if grid.stops.is_empty() { "nothing" } else { "a list of 1" };
                Err(Error::refused("stops", found, "two stops at least: this planner calls at stops"))
            }
            Body::Grid(grid) if !self.stops => grid.ends().map(|_| ()),
            Body::Grid(grid) => self.check_most("stops", grid.stops.len()),
            Body::Tour(tour) => self.check_most(if tour.matrix.is_some() { "matrix" } else { "points" }, tour.len()),
            _ => Ok(()),
        }
    }

    /// The values of a preset that mean something on this kind of scene.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist; [`Error::Refused`] for a planner without presets.
    pub fn preset(&self, name: &str, kind: Kind) -> Result<Given, Error> {
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

    /// The parameters that mean something on this kind of scene.
    pub fn parameters_on(&self, kind: Kind) -> impl Iterator<Item = &'static Parameter> {
        self.parameters.iter().filter(move |p| p.applies_to(kind))
    }
}
