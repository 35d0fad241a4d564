//! Planners by their code in JavaScript, which runs in an interpreter of its own: without network, clock and files, with little memory
//! and little time for a step. The same code gives the same bits here, in a page and in Node.
//!
//! `js` has what runs in the interpreter before an author's code; the npm package takes it from here. `interpreter` holds the
//! interpreter, `host` calls it as a [`Script`].
//!
//! ```
//! use std::sync::Arc;
//!
//! use forage::{Overrides, Registry, Run, Setup, shipped};
//!
//! let code = "register({
//!   name: 'half-way', kinds: ['function'],
//!   start: ({ box, evaluate }) => ({ x: box.high, cost: evaluate(box.high) }),
//!   advance: ({ x }, { evaluate }) => ({ x: x.map((x) => x / 2), cost: evaluate(x.map((x) => x / 2)) }),
//!   best: ({ x, cost }) => ({ position: x, cost }),
//! })";
//! let registry = Arc::new(Registry::standard().with(forage_isolate::entry(code)?));
//! let setup = Setup { planner: "half-way".into(), scene: shipped("sphere-2")?, params: Overrides::new(), seed: 1 };
//! let mut run = Run::new(&registry, setup)?;
//! run.step(50);
//! assert!(run.best().unwrap().cost < 1e-20);
//! # Ok::<(), forage::Error>(())
//! ```
#![cfg(not(target_arch = "wasm32"))]

mod host;
mod interpreter;
mod link;

pub use interpreter::watch;
pub use link::{MOST_IN_LINK, carries_code, code_in, with_code};

use std::sync::{Arc, Mutex, PoisonError};

use forage::{
    Error,
    describe::{Entry, Start},
    kernel::{Message, Started},
    message,
};
use forage_script::Script;
use serde_json::Value;

use host::Hosted;

/// The longest code, in bytes.
const LONGEST: usize = 200_000;

static KNOWN: Mutex<Vec<(&'static Entry, Arc<Hosted>)>> = Mutex::new(Vec::new());

/// The entry of the planner that a code registers; it calls `register({ … })` once.
///
/// # Errors
/// [`Error::Refused`] for `code`, where it is too long, is no JavaScript, throws or is stopped; and for the field that is wrong in what
/// the planner says of itself.
pub fn entry(code: &str) -> Result<&'static Entry, Error> {
    if code.len() > LONGEST {
        let found = message!("error-bytes", "a size of {n} bytes", n = code.len());
        return Err(Error::refused("code", found, message!("error-most-bytes", "at most {most} bytes", most = LONGEST)));
    }
    let hosted = Hosted::new(code).map_err(|why| Error::malformed("code", why))?;
    let described: Value = serde_json::from_str(&hosted.described().map_err(|why| Error::malformed("code", why))?).unwrap_or_default();
    if let Some(why) = described["message"].as_str().filter(|_| described["code"] == "refused") {
        return Err(match (described["field"].as_str(), described["value"].as_str(), described["allowed"].as_str()) {
            (Some(field), Some(value), Some(allowed)) => Error::refused(field.to_owned(), value, Message::verbatim(allowed)),
            _ => Error::malformed("code", Message::verbatim(why)),
        });
    }
    let entry = forage_script::entry(&described, start)?;
    KNOWN.lock().unwrap_or_else(PoisonError::into_inner).push((entry, Arc::new(hosted)));
    Ok(entry)
}

/// Two codes may give their planners one name: the entry says which one it is.
fn start(start: &Start) -> Result<Started, Error> {
    let known = KNOWN.lock().unwrap_or_else(PoisonError::into_inner);
    let found = known.iter().find(|(entry, _)| std::ptr::eq(*entry, start.entry)).map(|(_, hosted)| Arc::clone(hosted));
    drop(known);
    let Some(found) = found else { return Err(Error::unknown("planner", start.entry.name, [])) };
    // Each run has an interpreter of its own: runs in many threads wait for nobody.
    let script: Arc<dyn Script> = Arc::new(found.again().map_err(|why| Error::malformed("code", why))?);
    forage_script::begin(&script, start.entry, start)
}
