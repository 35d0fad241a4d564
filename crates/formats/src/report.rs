//! The results of reading and writing other programs' files.

use serde::Serialize;

use std::sync::Arc;

use forage::{
    kernel::{Error, Message, Optimum, SceneBody},
    message,
    scene::{GridScene, Header, Scene},
};

use super::file::{NamedFile, base, stem};

/// A problem of a MovingAI `.scen` file.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Problem {
    /// The centre of the start cell, in the scene's unit.
    pub start: [f64; 2],
    /// The centre of the goal cell, in the scene's unit.
    pub goal: [f64; 2],
    /// The optimal length that the file states, in cells.
    pub length: f64,
}

impl Problem {
    /// Which of the format's buckets it is in: each is four cells long.
    pub fn bucket(&self) -> u64 {
        (self.length / 4.0) as u64
    }
}

/// A scene that was read from another format.
#[derive(Debug, Clone, PartialEq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Imported {
    /// The scene.
    #[cfg_attr(feature = "types", ts(type = "Scene"))]
    pub scene: Scene,
    /// Interpretations that the user should know: unknown cells taken as blocked, start and goal chosen, …
    #[cfg_attr(feature = "types", ts(as = "Vec<String>"))]
    pub notes: Vec<Message>,
    /// The problems of a `.scen` file, if one was among the files.
    pub problems: Vec<Problem>,
}

impl Imported {
    /// A scene without problems to choose from.
    pub(super) fn new(scene: Scene, notes: Vec<Message>) -> Self {
        Self { scene, notes, problems: Vec::new() }
    }
}

/// A scene that was written in another format.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// The files; those that belong together name each other.
    pub files: Vec<NamedFile>,
    /// What the format cannot hold.
    pub notes: Vec<Message>,
}

/// What no format of grids has a place for.
pub(super) fn lost(grid: &GridScene, notes: &mut Vec<Message>) {
    for (there, what) in [
        (grid.robot.is_some(), message!("files-robot", "the robot")),
        (!grid.stops.is_empty(), message!("files-stops", "the stops")),
        (!grid.moving.is_empty(), message!("files-moving", "the moving discs")),
        (grid.corner_cutting, message!("files-corners", "that steps may cut corners")),
    ] {
        if there {
            not_kept(&what, notes);
        }
    }
}

/// Notes what a format has no place for.
pub(super) fn not_kept(what: &Message, notes: &mut Vec<Message>) {
    notes.push(message!("files-not-kept", "Not kept, as the format has no place for it: {what}.", what));
}

/// Notes in a row.
pub(super) fn joined(notes: &[Message]) -> String {
    notes.iter().map(Message::text).collect::<Vec<_>>().join(" ")
}

/// A scene that was read; `file` gives its name.
pub(super) fn scene(
    file: &NamedFile,
    source: &str,
    units: Option<&str>,
    optimum: Option<Optimum>,
    body: Arc<dyn SceneBody>,
    notes: &[Message],
) -> Result<Scene, Error> {
    scene_named(stem(&file.name), file, source, units, optimum, body, notes)
}

/// A scene that was read and has a name of its own.
pub(super) fn scene_named(
    name: &str,
    file: &NamedFile,
    source: &str,
    units: Option<&str>,
    optimum: Option<Optimum>,
    body: Arc<dyn SceneBody>,
    notes: &[Message],
) -> Result<Scene, Error> {
    // A scene's name has 1 to 100 bytes.
    let name = if name.is_empty() { "map" } else { &name[..name.floor_char_boundary(100)] };
    let header = Header {
        name: name.to_owned(),
        title: name.to_owned(),
        note: (!notes.is_empty()).then(|| joined(notes)),
        source: Some(format!("{source} {}", file.label())),
        units: units.map(str::to_owned),
        exact: None,
        published: None,
    };
    Scene::new(header, body, optimum).map_err(|error| Error::malformed(file.label(), error.message()))
}

/// Notes that the file named is not the one that was given.
pub(super) fn note_other_name(file: &NamedFile, named: &str, given: &NamedFile, notes: &mut Vec<Message>) {
    let (named, given) = (base(named), given.label());
    if named != given {
        notes.push(message!("files-other-name", "{file} belongs to {named}; {given} was taken.", file = file.label(), named, given));
    }
}
