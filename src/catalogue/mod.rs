//! Every planner and its parameters, one line each; nothing else lists planners.

mod view;

use crate::{
    ants,
    describe::{Entries, Entry, layers},
    dynamic,
    kernel::{Error, LayerKey},
    search, swarm, tour, tree, tuning,
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

/// The entry of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn find(name: &str) -> Result<&'static Entry, Error> {
    PLANNERS.planner(name)
}

/// The keys of all layers: those that planners draw or mark, and the scenes' own.
pub fn layer_keys() -> Vec<LayerKey> {
    let mut keys = Vec::new();
    for layer in PLANNERS.iter().flat_map(|entry| entry.layers).chain(layers::SCENE) {
        if !keys.contains(&layer.key) {
            keys.push(layer.key);
        }
    }
    keys
}

/// The key of the layers of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn layer_key(name: &str) -> Result<LayerKey, Error> {
    let keys = layer_keys();
    let known = keys.iter().copied().find(|key| key.0 == name);
    known.ok_or_else(|| Error::unknown("role", name, keys.iter().map(|key| key.0)))
}
