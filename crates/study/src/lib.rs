//! Experiments: many runs, kept as they finish, and what they say of published figures. Native only.
//!
//! [`runner`] carries out keyed jobs on all cores and appends each finished one to [`rows`], so that an interruption
//! loses nothing. [`forage::statistics`] and [`fit`] sum the rows up, [`table`] and [`chart`] show them, and [`report`] holds a
//! reproduction's tables, claims and commands together. A reproduction is one file ([`wcpso`], [`ltqpso`],
//! [`regression`], [`antbat`], [`antbat_tours`], [`antbat_time`], [`wolf`],
//! [`wolf_dynamic`], [`arm_rrt`]) and one line in [`REPRODUCTIONS`](registry::REPRODUCTIONS); nothing else lists them. What
//! papers say in words is in [`claims`]. Studies of our own are made
//! the same way and listed in [`STUDIES`](registry::STUDIES). Sweeps are in [`sweep`], the suites of the field in [`bench`](mod@bench).
//!
//! Files import one way. On top lies [`registry`], the list of all studies.
#![cfg(not(target_arch = "wasm32"))]

pub mod antbat;
pub mod antbat_time;
pub mod antbat_tours;
pub mod arm_rrt;
pub mod bench;
pub mod chart;
pub mod claims;
mod colonies;
pub mod compared;
mod digest;
pub mod disk;
pub mod document;
pub mod escape;
pub mod failure;
pub mod figure;
pub mod files;
pub mod findings;
pub mod fingerprints;
pub mod fit;
pub mod forensics;
pub mod inference;
pub mod ltqpso;
pub mod marking;
pub mod marks;
pub mod options;
pub mod papers;
mod plot;
pub mod published;
mod quantities;
mod ranking;
pub mod registry;
pub mod regression;
pub mod report;
pub mod robustness;
pub mod rows;
pub mod runner;
pub mod search;
pub mod spreadsheet;
pub mod study;
mod svg;
pub mod sweep;
pub mod table;
mod tours;
mod tuned;
pub mod wcpso;
mod within;
pub mod wolf;
pub mod wolf_dynamic;
pub mod words;
