//! What planners and the followers of a path are called on the overview and on their pages.

use forage::{
    arm,
    describe::{Entry, Follower},
    drive,
    kernel::Kind,
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
    let name = |kind: &Kind| if entry.stops && *kind == Kind::Grid { "grid with stops" } else { kind.name() };
    entry.kinds.iter().map(name).collect::<Vec<_>>().join(", ")
}

/// The followers of a path by name, with the kind of scene that they apply to.
pub(super) fn follower(name: &str) -> Option<(&'static Follower, Kind)> {
    match name {
        "drive" => Some((&drive::ENTRY, Kind::Grid)),
        "motion" => Some((&arm::MOTION, Kind::Arm)),
        _ => None,
    }
}
