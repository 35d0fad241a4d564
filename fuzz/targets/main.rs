//! What is fuzzed, a test for each target: `scripts/fuzz` feeds them what covers more and more of the code, `cargo test` what it has
//! kept of that so far (`__fuzz__/TARGET/corpus`) and some random bytes.
#![cfg(not(target_arch = "wasm32"))]
#![allow(unexpected_cfgs, reason = "the macro of the fuzzer asks which engine there is")]

mod geometry;
mod readers;
mod runs;

use std::env;

use arbitrary::Unstructured;
use bolero::check;
use forage::Error;

/// A test of each target. The fuzzer starts this program again to make a corpus small, and says in `FORAGE_FUZZ_TARGET` for which.
macro_rules! targets {
    ($($name:literal $test:ident $of:expr;)+) => {
        $(
            #[test]
            fn $test() {
                if env::var("FORAGE_FUZZ_TARGET").is_ok_and(|target| target != $name) {
                    return;
                }
                check!(name = $name).for_each($of);
            }
        )+
    };
}

/// A target that draws what it tries from the bytes: where they end, so does it.
fn drawing(try_out: fn(&mut Unstructured) -> arbitrary::Result<()>) -> impl Fn(&[u8]) {
    move |bytes| try_out(&mut Unstructured::new(bytes)).unwrap_or_default()
}

targets! {
    "scene" scene readers::scene;
    "link" link readers::link;
    "map" map readers::map;
    "scen" scen readers::scen;
    "yaml" yaml readers::yaml;
    "pgm" pgm readers::pgm;
    "tsp" tsp readers::tsp;
    "tour" tour readers::tour;
    "csv" csv readers::csv;
    "plan" plan readers::plan;
    "task" task readers::task;
    "grading-list" grading_list readers::grading_list;
    "expression" expression readers::expression;
    "run" run drawing(runs::operate);
    "segments-and-discs" segments_and_discs drawing(geometry::segment);
    "blocks" blocks drawing(geometry::block);
    "cuboids" cuboids drawing(geometry::cuboid);
    "outlines" outlines drawing(geometry::outline);
    "approaches" approaches drawing(geometry::approach);
    "grids" grids drawing(geometry::grid);
}

/// More is in no input; a refusal says less besides.
const MOST_BYTES: usize = 1 << 14;

/// A refusal is a sentence that says what is wrong. It has what was given, which others shorten, once or twice.
fn check_refusal(error: &Error) {
    let said = error.to_string();
    assert!((10..2 * MOST_BYTES + 4000).contains(&said.len()), "a refusal of {} bytes: {said:.200}", said.len());
}
