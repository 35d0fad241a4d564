//! Particle swarms: `pso`, `wpso`, `cpso` and `wcpso` of [WCPSO], one swarm with exchangeable parts.
//!
//! - [`objective`]: what a position means and costs. A function's value, or ([`waypoints`]) a path among discs.
//! - `population`: positions, costs, personal and global bests; whatever moves the particles.
//! - [`schedule`]: how ω, c1 and c2 change over the iterations.
//! - [`perturbation`]: hen and chick, for particles that stagnate.
//! - `flight`: the step that puts them together; `explain` says what it did to one particle, `draw` shows it.
//! - `parameters`: what the entries share. [`pso`], [`wpso`], [`cpso`], [`wcpso`]: a file a planner.

pub mod cpso;
mod draw;
mod explain;
mod flight;
pub mod objective;
mod parameters;
pub mod perturbation;
mod population;
pub mod pso;
pub mod schedule;
pub mod waypoints;
pub mod wcpso;
pub mod wpso;

use std::sync::Arc;

use crate::{
    params::Settings,
    scene::{Body, Scene},
    session::AnyPlanner,
};

pub use explain::SYMBOLS;

use flight::{Flight, Swarm};

/// Starts a swarm on whatever kind of scene it is given. This is where a position's meaning is chosen; the flight
/// does not know it.
fn start(scene: &Arc<Scene>, settings: &Settings, seed: u64, flight: Flight) -> Box<dyn AnyPlanner> {
    match scene.body() {
        Body::Function(function) => Box::new(Swarm::new(objective::FunctionObjective::new(function), settings, seed, flight)),
        Body::Discs(discs) => Box::new(Swarm::new(waypoints::Waypoints::new(discs, settings), settings, seed, flight)),
    }
}
