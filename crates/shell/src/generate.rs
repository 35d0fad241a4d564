//! `forage generate`.

use std::process::ExitCode;

use forage::Overrides;

use super::{
    args::GenerateArgs,
    convert,
    failure::{Failure, Outcome},
    load,
    names::Subject,
    output::{notes, print_raw},
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
    notes(scene.header().note.as_slice());
    if let (Some(format), Some(path)) = (format, &args.out) {
        return convert::write(&scene, format, "--out", path, &[]);
    }
    print_raw(scene.to_json().as_bytes())?;
    Ok(ExitCode::SUCCESS)
}
