//! Particle swarms: `pso`, `wpso`, `cpso` and `wcpso` of [WCPSO](crate#papers), `qpso` and `ltqpso` of [LTQPSO](crate#papers),
//! the continuous bats of [ANTBAT](crate#papers), and what it compares with (`cuckoo-search`, `pso-rrt`), with exchangeable
//! parts.
//!
//! - [`objective`]: what a position means and costs: a function's value, or a path. Two encodings of paths,
//!   [`waypoints`] and [`polar`], over a `terrain` of discs or of blocked cells; `encoding` chooses.
//! - `population`: positions, costs, personal and global bests; whatever moves the particles. `clock`: when it stops.
//! - `flight`: particles with velocities, by a [`schedule`] of ω, c1 and c2 and (for some) a [`perturbation`].
//! - `quantum`: particles that leap. `bat_continuous`: bats. `cuckoo_search`: nests, whose flights `levy` draws.
//! - `explain` says what a step did to one particle, with the tables of `sheet`, `draw` shows it.
//! - `parameters` and `paths`: what the entries share. [`pso`], [`wpso`], [`cpso`], [`wcpso`], [`qpso`], [`ltqpso`]: a file a planner.

pub mod bat_continuous;
mod clock;
pub mod cpso;
pub mod cuckoo_search;
mod draw;
mod encoding;
mod explain;
mod flight;
mod levy;
pub mod objective;
mod parameters;
mod paths;
pub mod perturbation;
pub mod polar;
mod population;
pub mod pso;
pub mod pso_rrt;
mod quantum;
pub mod schedule;
mod sheet;
mod terrain;
pub mod waypoints;
pub mod wcpso;
pub mod wpso;

use crate::{
    describe::Start,
    kernel::{Error, Planner, Started},
    params::Parameters,
};

pub use quantum::{ltqpso, qpso};

use flight::{Flight, Swarm};
use parameters::ITERATIONS;
use paths::EARLY_STOP;

/// Starts a swarm that flies on whatever kind of scene it is given.
fn start(start: &Start, flight: Flight) -> Result<Started, Error> {
    let &Start { scene, parameters: settings, seed, .. } = start;
    Ok(started(Swarm::new(encoding::objective(scene, settings)?, settings, seed, flight), settings))
}

/// A run of a swarm, with the settings `iterations` and `early_stop`.
fn started(swarm: impl Planner, settings: &Parameters) -> Started {
    let started = Started::new(swarm, settings[ITERATIONS]);
    if settings[EARLY_STOP] > 0 { started.open_ended() } else { started }
}
