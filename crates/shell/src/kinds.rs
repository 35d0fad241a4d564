//! What kinds of scene and families of planners are called in what is printed for people.

use forage::{
    describe::Entry,
    kernel::{Message, SceneKindId},
    message,
    scene::GRID,
};

/// A kind of scene by the name that scene files use.
pub(super) fn name(kind: &str) -> String {
    let said = match kind {
        "discs" => message!("shell-kind-discs", "discs"),
        "grid" => message!("shell-kind-grid", "grid"),
        "function" => message!("shell-kind-function", "function"),
        "tour" => message!("shell-kind-tour", "tour"),
        "arm" => message!("shell-kind-arm", "arm"),
        other => Message::verbatim(other),
    };
    said.to_string()
}

/// Several kinds.
pub(super) fn names(kinds: &[SceneKindId]) -> Vec<String> {
    kinds.iter().map(|kind| name(kind.name())).collect()
}

/// The kinds of scene that a planner runs on.
pub(super) fn of_planner(entry: &Entry) -> Vec<String> {
    let stops = || message!("shell-kind-stops", "grid with stops").to_string();
    entry.kinds.iter().map(|kind| if entry.stops && *kind == GRID { stops() } else { name(kind.name()) }).collect()
}

/// The scenes of a kind, as a heading; `title` is what its description says.
pub(super) fn scenes(kind: &str, title: &'static str) -> Message {
    let kinds = match kind {
        "discs" => message!("shell-scenes-discs", "disc obstacles"),
        "grid" => message!("shell-scenes-grid", "grids"),
        "function" => message!("shell-scenes-function", "test functions"),
        "tour" => message!("shell-scenes-tour", "stops of a tour"),
        "arm" => message!("shell-scenes-arm", "arms"),
        _ if title.is_empty() => message!("shell-scenes-others", "others"),
        _ => Message::verbatim(title),
    };
    message!("shell-scenes", "Scenes: {kinds}", kinds)
}

/// A planner's family.
pub(super) fn family(entry: &Entry) -> Message {
    match entry.family {
        "swarm" => message!("shell-family-swarm", "particle swarms"),
        "ants" => message!("shell-family-ants", "ant colonies"),
        "search" => message!("shell-family-search", "graph search"),
        "tour" => message!("shell-family-tour", "tours through stops"),
        "tree" => message!("shell-family-tree", "rapidly-exploring random trees"),
        "dynamic" => message!("shell-family-dynamic", "driving among moving obstacles"),
        "tuning" => message!("shell-family-tuning", "parameter tuning"),
        other => Message::verbatim(other),
    }
}
