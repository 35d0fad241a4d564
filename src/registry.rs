//! What ships: every planner, kind of scene, generator and follower, a line each; nothing else lists them. Planners stand in
//! groups, in the order in which they are offered: what a WebAssembly module loads at a time.

use std::sync::{Arc, LazyLock};

use crate::{
    ants,
    describe::{Entry, Follower, Generator, Registry, SceneKind},
    dynamic,
    follow::{drive, motion},
    kernel::{Error, Scene},
    scene::{arm, discs, function, generate, grid, tour as tours},
    search, swarm, tour, tree, tuning,
};

/// Kinds of scenes, in the order in which their scenes are offered.
const KINDS: &[&SceneKind] = &[&discs::KIND, &grid::KIND, &tours::KIND, &arm::KIND, &function::KIND];

/// Particle swarms and quantum swarms.
pub const SWARMS: &[&Entry] =
    &[&swarm::pso::ENTRY, &swarm::wpso::ENTRY, &swarm::cpso::ENTRY, &swarm::wcpso::ENTRY, &swarm::qpso::ENTRY, &swarm::ltqpso::ENTRY];

/// What searches on maps: other swarms, ants, and searches of cells.
pub const SEARCHES: &[&Entry] = &[
    &swarm::bat_continuous::ENTRY,
    &swarm::cuckoo_search::ENTRY,
    &swarm::pso_rrt::ENTRY,
    &ants::aco::ENTRY,
    &ants::aco_direction::ENTRY,
    &ants::aco_dijkstra::ENTRY,
    &ants::aco_wolf::ENTRY,
    &search::a_star::ENTRY,
    &search::dijkstra::ENTRY,
    &search::theta_star::ENTRY,
];

/// Tours of many stops.
pub const TOURS: &[&Entry] = &[
    &tour::bat::ENTRY,
    &tour::hybrid_bat::ENTRY,
    &tour::ga::ENTRY,
    &tour::tour_pso::ENTRY,
    &tour::sa::ENTRY,
    &tour::two_opt::ENTRY,
    &tour::held_karp::ENTRY,
];

/// Random trees.
pub const TREES: &[&Entry] =
    &[&tree::rrt::ENTRY, &tree::rrt_guided::ENTRY, &tree::rrt_connect::ENTRY, &tree::rrt_star::ENTRY, &tree::rrt_joint::ENTRY];

/// Drives among moving obstacles, and the tuning of other planners.
pub const DRIVES: &[&Entry] =
    &[&dynamic::wolf_ant_drive::ENTRY, &dynamic::a_star_drive::ENTRY, &dynamic::d_star_lite_drive::ENTRY, &tuning::ENTRY];

/// Generators of random scenes.
pub const GENERATORS: &[&Generator] = &[
    &generate::RANDOM,
    &generate::RUBBLE,
    &generate::ROOMS,
    &generate::MAZE,
    &generate::STOPS,
    &generate::DISCS,
    &generate::SHIFTED,
    &generate::BBOB,
];

/// Who follows a path.
const FOLLOWERS: &[&Follower] = &[&drive::ENTRY, &motion::ENTRY];

impl Registry {
    /// All that ships, in the order in which it is offered; add to it with [`Registry::with`].
    pub fn standard() -> Self {
        [SWARMS, SEARCHES, TOURS, TREES, DRIVES]
            .into_iter()
            .fold(Self::new().with_all(KINDS), Self::with_all)
            .with_all(GENERATORS)
            .with_all(FOLLOWERS)
    }
}

/// All that ships, made once and shared.
pub fn standard() -> &'static Arc<Registry> {
    static STANDARD: LazyLock<Arc<Registry>> = LazyLock::new(|| Arc::new(Registry::standard()));
    &STANDARD
}

/// The shipped scene of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn shipped(name: &str) -> Result<Arc<Scene>, Error> {
    standard().scene(name)
}
