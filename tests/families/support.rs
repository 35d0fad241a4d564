//! What the families' tests share.

use std::sync::Arc;

use forage::{
    Error, Overrides, Scene,
    describe::{Entries, Entry, Start},
    kernel::{Started, Stepper},
    scene::{grid, tour},
};

/// Nobody: what is tested needs no other planner.
struct Nobody;

impl Entries for Nobody {
    fn planner(&self, name: &str) -> Result<&'static Entry, Error> {
        Err(Error::unknown("planner", name, []))
    }
}

/// A scene of a kind that ships.
pub fn scene(text: &str) -> Arc<Scene> {
    Arc::new(Scene::read(&[&grid::KIND, &tour::KIND], text).unwrap())
}

/// A planner at its start.
pub fn start(entry: &'static Entry, scene: &Arc<Scene>, given: &[(&str, &str)], seed: u64) -> Result<Started, Error> {
    let given: Overrides = given.iter().map(|&(name, value)| (name, value.into())).collect();
    entry.check_scene(scene)?;
    let parameters = entry.configure(scene.kind(), &given)?;
    (entry.start)(&Start { entry, scene, parameters: &parameters, seed, entries: &Nobody })
}

pub fn run_to_end(started: Started) -> Stepper {
    let mut run = Stepper::from(started);
    while run.step(|_| Vec::new()) {}
    run
}
