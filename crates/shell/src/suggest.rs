//! `forage suggest`.

use std::process::ExitCode;

use forage::{Overrides, Setup, describe::Suggestion};

use super::{
    args::SuggestArgs,
    failure::Outcome,
    load,
    output::{print, print_json},
    registry::registry,
    text::escape,
};

pub(super) fn suggest(args: SuggestArgs) -> Outcome {
    registry().planner(&args.planner)?;
    let mut setup = Setup { planner: args.planner, scene: load::scene(&args.scene)?, params: Overrides::new(), seed: 1 };
    load::read_pairs("--set", &args.set, &mut setup.params)?;
    let (suggested, title) = load::suggestion(&setup)?;
    if args.json {
        print_json(&suggested)?;
    } else {
        let Suggestion { population, iterations, source } = suggested;
        print(&format!(
            "{title} on {}: population {population}, iterations {iterations}; recommended by {source}\n`forage run {} … --suggested` uses them",
            escape(setup.scene.name()),
            setup.planner
        ))?;
    }
    Ok(ExitCode::SUCCESS)
}
