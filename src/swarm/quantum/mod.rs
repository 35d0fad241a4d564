//! The quantum swarm of [LTQPSO](crate#papers): particles without velocity that leap about their attractors.
//!
//! `qpso` leaps by (1)–(4), `ltqpso` by (5)–(9): the same leap, with the pull scaled by evolution speed, the width by
//! dispersion, and natural selection afterwards. The flight of [WCPSO](crate#papers) shares the population with it and nothing
//! else.
//!
//! `leap` is the swarm and its step, `planner` the stepped contract, `explain` says why a particle leapt where it did.

mod explain;
mod leap;
pub mod ltqpso;
mod parameters;
mod planner;
pub mod qpso;
