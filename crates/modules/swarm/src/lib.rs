//! The WebAssembly module with the swarms, among discs and on functions.
#![cfg(target_arch = "wasm32")]

use forage::{
    Registry,
    describe::Entry,
    scene::{discs, function},
    swarm::{cpso, ltqpso, pso, qpso, wcpso, wpso},
};
use wasm_bindgen::prelude::wasm_bindgen;

const PLANNERS: &[&Entry] = &[&wcpso::ENTRY, &pso::ENTRY, &wpso::ENTRY, &cpso::ENTRY, &ltqpso::ENTRY, &qpso::ENTRY];

#[wasm_bindgen(start)]
fn start() {
    forage_face::know(Registry::new().with(&discs::KIND).with(&function::KIND).with_all(PLANNERS));
}
