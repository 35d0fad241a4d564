//! The shell's `forage experiment`: the same rows whatever happens on the way, and what is refused.
#![cfg(not(target_arch = "wasm32"))]

mod parts;
mod refused;
mod resume;
mod rows;
mod support;
