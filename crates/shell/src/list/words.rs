//! What families and kinds are called on the overview and on the pages.

use forage::{describe::Entry, kernel::SceneKindId, scene::GRID};

/// A planner's family for people.
pub(super) fn family(entry: &Entry) -> &'static str {
    match entry.family {
        "swarm" => "particle swarms",
        "ants" => "ant colonies",
        "search" => "graph search",
        "tour" => "tours through stops",
        "tree" => "rapidly-exploring random trees",
        "dynamic" => "driving among moving obstacles",
        "tuning" => "parameter tuning",
        other => other,
    }
}

/// The kinds of scene that a planner runs on.
pub(super) fn kinds(entry: &Entry) -> String {
    let name = |kind: &SceneKindId| if entry.stops && *kind == GRID { "grid with stops" } else { kind.name() };
    entry.kinds.iter().map(name).collect::<Vec<_>>().join(", ")
}
