//! What a script gives back, as numbers and texts.

use std::sync::Mutex;

use forage::{
    kernel::{Candidate, Error, Inspection, Item, Label, Message, Solution, TourEnds},
    message,
};

/// A solution of this cost: where `kind` is 0, the coordinates of a position; 1, the corners of a path, x and y each; 2, the numbers of
/// stops in the order in which they are visited.
pub fn candidate(cost: f64, kind: u32, numbers: Vec<f64>) -> Candidate {
    let solution = match kind {
        0 => Solution::Position(numbers),
        1 => Solution::Path(numbers.as_chunks::<2>().0.to_vec()),
        _ => Solution::Tour { order: stops(&numbers), ends: TourEnds::default(), path: Vec::new() },
    };
    Candidate { cost, solution }
}

/// The numbers of stops. What is no whole number is no stop's.
pub fn stops(numbers: &[f64]) -> Vec<usize> {
    numbers.iter().map(|&stop| if stop >= 0.0 && stop.fract() == 0.0 { stop as usize } else { usize::MAX }).collect()
}

/// An explanation of an item: texts, and numbers with their names.
pub fn inspection(item: Item, title: String, summary: String, values: Vec<(String, f64)>) -> Inspection {
    let mut inspection = Inspection::new(item, Message::verbatim(title), "", Message::verbatim(summary));
    inspection.values = values.into_iter().filter_map(|(name, value)| Some(Label::verbatim(kept(name)?).is(value))).collect();
    inspection
}

/// How many names of numbers are kept at most.
const MOST_NAMES: usize = 1000;

/// A name that lives as long as the program, once for all of the same. There are so many at most: code could make up more and more.
fn kept(name: String) -> Option<&'static str> {
    static KEPT: Mutex<Vec<&str>> = Mutex::new(Vec::new());
    let mut all = KEPT.lock().ok()?;
    if let Some(known) = all.iter().find(|known| **known == name) {
        return Some(known);
    }
    if all.len() == MOST_NAMES {
        return None;
    }
    all.push(name.leak());
    all.last().copied()
}

/// What is said of code that uses what is lent to it at another time.
pub fn not_lent() -> Error {
    Error::refused(
        "tools",
        message!("script-elsewhere", "a call from elsewhere"),
        message!("script-lent", "used only while `start` or `advance` runs"),
    )
}

/// What is said of code that threw something.
pub fn threw(error: &str) -> Message {
    message!("script-threw", "its code throws “{error}”", error)
}
