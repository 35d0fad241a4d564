//! The command line as users call it: what it prints, writes, refuses and keeps, and its exit codes.
#![cfg(not(target_arch = "wasm32"))]

mod bench;
mod code;
mod convert;
mod experiment;
mod files;
mod grade;
mod help;
mod install;
mod languages;
mod list;
mod outputs;
mod refusals;
mod reproduce;
mod run;
mod support;
