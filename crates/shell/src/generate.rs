//! `forage generate`.

use std::process::ExitCode;

use forage::{Overrides, kernel::Message};

use super::{
    args::GenerateArgs,
    convert,
    failure::{Failure, Outcome},
    language::say_numbered,
    load,
    names::Subject,
    output::{note, print_raw},
    registry::registry,
};

pub(super) fn generate(args: &GenerateArgs) -> Outcome {
    let generator = registry().generator(&args.generator)?;
    let format = args.out.as_deref().map(|path| convert::format("--out", path)).transpose()?;
    let mut overrides = Overrides::new();
    load::read_pairs("--set", &args.set, &mut overrides)?;
    let scene = registry()
        .generate(generator.name, &overrides, load::seed(&args.seed)?)
        .map_err(|error| Failure::about(Subject::Named(generator.name), &error))?;
    if let Some(said) = &scene.header().note {
        note(sentences(said));
    }
    if let (Some(format), Some(path)) = (format, &args.out) {
        return convert::write(&scene, format, "--out", path, &[]);
    }
    print_raw(scene.to_json().as_bytes())?;
    Ok(ExitCode::SUCCESS)
}

/// A note of a generator, which says one thing or several.
fn sentences(said: &str) -> Message {
    let ends = said.match_indices(". ").map(|(at, _)| at + 1).chain([said.len()]);
    let mut from = 0;
    ends.fold(Message::default(), |before, end| {
        let sentence = said[from..end].trim();
        from = end;
        before.then(Message::verbatim(say_numbered(sentence)))
    })
}
