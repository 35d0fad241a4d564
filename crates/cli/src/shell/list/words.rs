//! What planners and the followers of a path are called on the overview and on their pages.

use forage::{
    arm,
    describe::{Entry, Follower},
    drive,
    kernel::SceneKindId,
    scene::{ARM, GRID},
};

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

/// The followers of a path by name, with the kind of scene that they apply to.
pub(super) fn follower(name: &str) -> Option<(&'static Follower, SceneKindId)> {
    match name {
        "drive" => Some((&drive::ENTRY, GRID)),
        "motion" => Some((&arm::MOTION, ARM)),
        _ => None,
    }
}
