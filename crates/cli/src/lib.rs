//! The command line of Forage, for any registry: [`main_with`] is a whole program.
//!
//! `forage` itself is `forage_cli::main_with(Registry::standard())`. A program with a planner of its own adds a line:
//!
//! ```no_run
//! use forage::{Registry, describe::Entry, kernel::Error};
//!
//! /// What there is to know of the planner.
//! const ENTRY: Entry = Entry::new("mine", "My planner", "", "What it does.", |_| {
//!     Err(Error::refused("planner", "mine", "a planner that is finished"))
//! });
//!
//! fn main() -> std::process::ExitCode {
//!     forage_cli::main_with(Registry::standard().with(&ENTRY))
//! }
//! ```
//!
//! Exit codes: 0 a feasible result; 1 none was found; 2 the input was refused (message on standard error, nothing on standard
//! output); 3 a file cannot be read or written now (a full disk, another `forage` that writes it), so the same command may
//! succeed later; 130 an experiment was interrupted (finished runs are kept, except of a sample).
#![cfg(not(target_arch = "wasm32"))]

mod shell;

pub use shell::main_with;
