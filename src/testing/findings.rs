//! What is found, run by run: faults become findings, and so do panics.

use std::{
    any::Any,
    fmt::Write,
    panic::{AssertUnwindSafe, catch_unwind},
};

use crate::{
    describe::Registry,
    kernel::{Error, rng::Stream},
    params::UNLISTED,
    run::{Link, OTHER_READINGS, Setup},
};

use super::{
    fault::{Checked, Fault, refusal},
    report::Finding,
    subject::{SEED, Subject},
};

/// So often a random setup is drawn anew that `start` refuses.
const ATTEMPTS: usize = 20;

const NEVER_PANIC: &str = "Refuse in `start` what cannot run, with an `Error`, and let no step panic.";
const LIST_PARAMETERS: &str = "List every parameter that is read in the entry's `.parameters(…)`.";
const SAME_READINGS: &str = "Push the same readings in the same order after each iteration; NaN for a number that is not there yet.";

/// What the checks found so far.
pub struct Findings<'a> {
    pub list: Vec<Finding>,
    /// The check that is made, and its number.
    pub check: &'static str,
    pub number: u64,
    registry: &'a Registry,
    planner: &'a str,
}

impl<'a> Findings<'a> {
    pub fn new(registry: &'a Registry, planner: &'a str) -> Self {
        Self { list: Vec::new(), check: "it_is_listed", number: 0, registry, planner }
    }

    /// The registry does not list the planner.
    pub fn unlisted(&mut self, error: &Error) {
        self.add(None, Fault::new("Add its entry to the registry: `Registry::standard().with(&ENTRY)`.", error.to_string()));
    }

    /// Checks what no run is needed for.
    pub fn look(&mut self, checked: Checked) {
        if let Err(fault) = checked {
            self.add(None, fault);
        }
    }

    /// Checks a run. A panic is a finding, too.
    pub fn watch(&mut self, setup: &Setup, check: impl FnOnce() -> Checked) {
        let checked = catch_unwind(AssertUnwindSafe(check)).unwrap_or_else(|panic| Err(panicked(&*panic)));
        if let Err(fault) = checked {
            self.add(Some(setup), fault);
        }
    }

    /// Checks random runs with so many iterations.
    pub fn watch_random(&mut self, subject: &Subject, iterations: u64, check: impl Fn(&Setup, &mut Stream) -> Checked) {
        let mut stream = Stream::new(SEED, 1 + self.number);
        for _ in 0..subject.random_runs {
            for attempt in 1..=ATTEMPTS {
                let Some(setup) = subject.draw(&mut stream, iterations) else { return };
                let mut refused = false;
                self.watch(&setup, || match subject.refusal(&setup) {
                    Some(error) if attempt == ATTEMPTS => Err(refusal(&error)),
                    Some(_) => {
                        refused = true;
                        Ok(())
                    }
                    None => check(&setup, &mut stream),
                });
                if !refused {
                    break;
                }
            }
        }
    }

    /// Each fault once: many runs show the same.
    fn add(&mut self, setup: Option<&Setup>, Fault { found, remedy, iteration }: Fault) {
        let known = |finding: &Finding| finding.remedy == remedy && (finding.check == self.check || finding.found == found);
        if self.list.iter().any(known) {
            return;
        }
        let (setup, link) = setup.map_or_else(Default::default, |setup| (in_words(setup, iteration), self.link(setup, iteration)));
        self.list.push(Finding { planner: self.planner.to_owned(), check: self.check, setup, link, found, remedy });
    }

    fn link(&self, setup: &Setup, iteration: u64) -> String {
        let scene_ships = self.registry.scene(setup.scene.name()).is_ok_and(|known| known == setup.scene);
        Link { setup: setup.clone(), scene_ships, iteration, hash: None }.to_string()
    }
}

fn in_words(setup: &Setup, iteration: u64) -> String {
    let mut text = format!("scene {}, seed {}", setup.scene.name(), setup.seed);
    for (name, value) in setup.params.iter() {
        // Writing to a string cannot fail.
        let _ = write!(text, ", {name}={value}");
    }
    let _ = write!(text, ", at iteration {iteration}");
    text
}

/// The fault of a panic, by its message.
fn panicked(panic: &(dyn Any + Send)) -> Fault {
    let message = panic.downcast_ref::<String>().map(String::as_str).or_else(|| panic.downcast_ref::<&str>().copied());
    let message = message.unwrap_or("without a message");
    let remedy = match message {
        text if text.contains(UNLISTED) => LIST_PARAMETERS,
        text if text.contains(OTHER_READINGS) => SAME_READINGS,
        _ => NEVER_PANIC,
    };
    Fault::new(remedy, format!("it panics: {message}"))
}
