//! What several native tests share: the stored files. The wasm's tests read the same ones.

use serde::{Deserialize, Serialize};

/// One complete run and what came of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Golden {
    /// The planner's name.
    pub planner: String,
    /// A shipped scene's name.
    pub scene: String,
    /// The seed.
    pub seed: u32,
    /// Parameters beside the iterations, as the inside of a JSON object.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub set: String,
    /// The digest of the path that is handed over, smoothed and all, and of the exact one; `none` where there is no path.
    pub paths: String,
    /// The hash of the whole state half way.
    pub half: String,
    /// The hash at the end.
    pub end: String,
    /// The best cost's bits, in hexadecimal.
    pub cost: String,
}

/// The stored runs. `FORAGE_BLESS=1 cargo test --test golden` writes them anew (only after a deliberate change).
pub fn stored() -> Vec<Golden> {
    serde_json::from_str(include_str!("../golden.json")).expect("tests/golden.json is a list of runs")
}

/// The iterations of a golden run: enough for every part of a planner to come into play.
pub const ITERATIONS: u32 = 200;

/// A cost's bits.
pub fn bits(cost: Option<f64>) -> String {
    cost.map_or_else(|| "none".to_owned(), |cost| format!("{:016x}", cost.to_bits()))
}

/// A drive along what a complete run found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Driven {
    /// The planner's name.
    pub planner: String,
    /// A shipped scene's name.
    pub scene: String,
    /// The seed.
    pub seed: u32,
    /// The look-ahead distance.
    pub look_ahead: f64,
    /// The digest of all rows' bits.
    pub rows: String,
}

/// The stored drives, written anew as [`stored`] is.
pub fn drives() -> Vec<Driven> {
    serde_json::from_str(include_str!("../drives.json")).expect("tests/drives.json is a list of drives")
}

/// An arm following what a complete run found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Followed {
    /// The planner's name.
    pub planner: String,
    /// A shipped scene's name.
    pub scene: String,
    /// The seed.
    pub seed: u32,
    /// The motion's parameters, as the inside of a JSON object.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub set: String,
    /// The digest of all rows' bits.
    pub rows: String,
}

/// The stored motions, written anew as [`stored`] is.
pub fn motions() -> Vec<Followed> {
    serde_json::from_str(include_str!("../motions.json")).expect("tests/motions.json is a list of motions")
}

/// The events of a complete run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Log {
    /// The planner's name.
    pub planner: String,
    /// A shipped scene's name.
    pub scene: String,
    /// The seed.
    pub seed: u32,
    /// Parameters, as the inside of a JSON object.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub set: String,
    /// An event each.
    pub lines: Vec<String>,
}

/// The stored logs, written anew as [`stored`] is.
pub fn logs() -> Vec<Log> {
    serde_json::from_str(include_str!("../events.json")).expect("tests/events.json is a list of logs")
}

/// An event with all digits: two lines are the same only if all bits are.
pub fn line(iteration: u64, time: f64, [x, y]: [f64; 2], kind: &str, obstacle: Option<usize>, reason: &str) -> String {
    let about = obstacle.map_or(String::new(), |number| format!(" {number}"));
    format!("{iteration} {time:?} ({x:?}, {y:?}) {kind}{about}: {reason}")
}

/// The digest of the bits of many numbers.
pub fn digest(numbers: &[f64]) -> String {
    let mut digest = forage::kernel::Digest::default();
    digest.numbers(numbers);
    digest.hex()
}
