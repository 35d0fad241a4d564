//! The families as building blocks: each with parts from outside, checked against what is known exactly.
#![cfg(not(target_arch = "wasm32"))]

#[path = "families/colonies.rs"]
mod colonies;
#[path = "families/searches.rs"]
mod searches;
#[path = "families/support.rs"]
mod support;
#[path = "families/swarms.rs"]
mod swarms;
#[path = "families/tours.rs"]
mod tours;
#[path = "families/trees.rs"]
mod trees;
