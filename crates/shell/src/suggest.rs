//! `forage suggest`.

use std::process::ExitCode;

use forage::{Overrides, Setup, describe::Suggestion, message};

use super::{
    args::SuggestArgs,
    failure::Outcome,
    language::{say, say_numbered},
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
        let title = say(title, &format!("planners.{}.title", setup.planner));
        let recommended = message!(
            "shell-recommended",
            "{title} on {scene}: population {population}, iterations {iterations}; recommended by {source}",
            title,
            scene = escape(setup.scene.name()),
            population,
            iterations,
            source = say_numbered(source)
        );
        let uses = message!("shell-uses-them", "`forage run {planner} … --suggested` uses them", planner = setup.planner);
        print(&format!("{recommended}\n{uses}"))?;
    }
    Ok(ExitCode::SUCCESS)
}
