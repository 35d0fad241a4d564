//! `forage generate`, and the part of its help that follows from the table of generators.

use std::{fmt::Write, process::ExitCode};

use forage::{
    Given,
    scene::generate::{self, GENERATORS, TOURS},
};

use super::{args::GenerateArgs, convert, load, print};

pub(super) fn generate(args: &GenerateArgs) -> super::Outcome {
    let format = args.out.as_deref().map(|path| convert::format("--out", path)).transpose()?;
    let mut given = Given::new();
    load::read_pairs("--set", &args.set, &mut given)?;
    let scene = generate::generate(&args.generator, &given, load::seed(&args.seed)?)?;
    load::tell(scene.header().note.as_slice());
    if let (Some(format), Some(path)) = (format, &args.out) {
        return convert::write(&scene, format, path, &[]);
    }
    print(&scene.to_json());
    Ok(ExitCode::SUCCESS)
}

/// The generators with their parameters.
pub(super) fn generators() -> String {
    let mut text = String::new();
    for generator in GENERATORS.iter().chain(TOURS) {
        // Writing to a string cannot fail.
        let _ = writeln!(text, "\n{}  {}\n  {}", generator.name, generator.title, generator.help);
        for parameter in generator.parameters {
            let default = parameter.default_on(generator.kind());
            let _ = writeln!(text, "    {:<16} {}; default {default}", parameter.name, parameter.allowed());
            let _ = writeln!(text, "    {:<16} {}", "", parameter.help);
        }
    }
    text
}

/// Generators and examples, below the options of `forage generate --help`.
pub(super) fn after_help() -> String {
    format!(
        "Generators:\n{}\nExamples:\n  forage generate maze --set columns=61 --set rows=41 --seed 7 --out maze.json\n  forage generate random --set share=0.35 --out random.map\n  forage generate rooms --set stops=20 --out delivery.json\n  forage generate stops --set stops=100 --out stops.tsp",
        generators()
    )
}
