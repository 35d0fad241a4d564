//! `forage suggest`.

use std::process::ExitCode;

use forage::{Given, Setup};

use super::{load, print, print_json};

pub(super) fn suggest(planner: String, scene: &str, set: &[String], json: bool) -> super::Outcome {
    let mut setup = Setup { planner, scene: load::scene(scene)?, params: Given::new(), seed: 1 };
    load::read_pairs("--set", set, &mut setup.params)?;
    let (suggested, title) = load::suggestion(&setup)?;
    if json {
        print_json(&suggested);
    } else {
        let forage::catalogue::Suggestion { population, iterations, source } = suggested;
        print(&format!(
            "{title} on {}: population {population}, iterations {iterations} by {source}\n`forage run … --suggested` takes them",
            setup.scene.name()
        ));
    }
    Ok(ExitCode::SUCCESS)
}
