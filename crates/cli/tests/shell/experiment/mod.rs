//! The shell's `forage experiment`: the same rows whatever happens on the way, and what is refused.

mod budget;
mod parts;
mod refused;
mod resume;
mod rows;
pub(crate) mod support;
