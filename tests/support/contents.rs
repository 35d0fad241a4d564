//! What a run shows and finds, apart from how its state is hashed: the proof that a change of structure changes nothing.

use std::collections::BTreeMap;

use forage::{Frame, Run, kernel::Digest};

/// Digests of what a run showed at its beginning, half way and at its end, by `planner on scene, seed, parameters`.
pub type Contents = BTreeMap<String, [String; 3]>;

/// The stored ones. `FORAGE_BLESS=contents cargo test --test golden` writes them anew: only where results are meant to change.
pub fn stored() -> Contents {
    serde_json::from_str(include_str!("../contents.json")).expect("tests/contents.json is a list of digests")
}

/// What a run is stored under.
pub fn key(planner: &str, scene: &str, seed: u32, set: &str) -> String {
    format!("{planner} on {scene}, seed {seed}, {set}").trim_end_matches([',', ' ']).to_owned()
}

/// Pieces of a frame: enough for all of what golden runs draw.
const BUDGET: usize = 1_000_000;

/// The fields of an outcome that mean something beyond the run's own state.
const OUTCOME: [&str; 19] = [
    "iterations",
    "evaluations",
    "status",
    "cost",
    "length",
    "feasible",
    "clearance",
    "exact",
    "exact_by",
    "gap",
    "turns",
    "turning",
    "path",
    "tip_path",
    "joints",
    "order",
    "position",
    "readings",
    "trouble",
];

/// The digest of what a run shows now: numbers bit by bit, and whatever is drawn, by the names of layers and shapes.
pub fn shown(run: &mut Run) -> String {
    let mut digest = Digest::default();
    let outcome = serde_json::to_value(run.outcome()).unwrap();
    for field in OUTCOME {
        digest.bytes(format!("{field}: {}", outcome[field]).as_bytes());
    }
    for event in run.events() {
        digest.bytes(serde_json::to_string(event).unwrap().as_bytes());
    }
    let mut frame = Frame::default();
    run.draw(&mut frame, BUDGET);
    let vertices = frame.vertices();
    for span in frame.spans() {
        digest.bytes(span.layer.0.as_bytes());
        digest.bytes(span.shape.name().as_bytes());
        for vertex in vertices.chunks_exact(4).skip(span.first as usize).take(span.count as usize) {
            vertex.iter().for_each(|number| digest.word(u64::from(number.to_bits())));
        }
    }
    digest.hex()
}
