//! `forage convert`, and writing a scene in the format that a file's name asks for.

use std::{fs, path::Path, process::ExitCode};

use forage::{
    Error, Scene,
    scene::formats::{self, ENDINGS, Format, NamedFile},
};

use super::{Failure, args::ConvertArgs, load};

/// Examples, below the options of `forage convert --help`.
pub(super) const AFTER_HELP: &str = "Examples:
  forage convert arena.map arena.json
  forage convert arena.scen --problem 12 arena.json
  forage convert office.yaml office.map
  forage convert wolf-ant-20 wolf.yaml
  forage convert berlin52.tsp berlin52.opt.tour berlin52.json
  forage convert places.csv places.tsp";

const NO_TOUR: &str = "the scene’s shortest closed tour is not known, and there is no other one to write";

pub(super) fn convert(args: &ConvertArgs) -> super::Outcome {
    let Some((to, from @ [one, ..])) = args.paths.split_last() else {
        return Err(Error::refused("OUT", "nothing", "a file to write, after the files to read").into());
    };
    let format = format("OUT", to)?;
    // A single name may be a shipped scene or a link; only a file has problems to choose from.
    if from.len() == 1 && args.problem.is_none() && Format::of_file(one).is_none_or(|format| format == Format::Json) {
        return write(&*load::scene(one)?, format, to, from);
    }
    let mut files = from.iter().map(|path| load::read(path)).collect::<Result<_, _>>()?;
    let scene = load::import(&mut files, args.problem)?;
    let read: Vec<_> = files.into_iter().map(|file| file.name).collect();
    write(&scene, format, to, &read)
}

/// The format of a file that is to be written.
pub(super) fn format(field: &str, path: &str) -> Result<Format, Error> {
    Format::of_file(path).ok_or_else(|| Error::refused(field, path, format!("a file that ends in {ENDINGS}")))
}

/// Writes a scene's files in a format, called as `path` but for their endings. Files that were read stay as they are: one
/// problem must not take the place of a thousand because OUT was forgotten.
pub(super) fn write(scene: &Scene, format: Format, path: &str, read: &[String]) -> super::Outcome {
    let path = Path::new(path);
    let name = path.to_string_lossy();
    let made = formats::export(scene, format, formats::stem_of(&name))?;
    // What belongs to a map or to an instance is not there for every scene.
    if !made.files.iter().any(|file| formats::same_sort(&file.name, &name)) {
        let reason = if format == Format::Tsplib { vec![NO_TOUR.to_owned()] } else { made.notes };
        return Err(Error::malformed("OUT", reason.join(" ")).into());
    }
    // The file that was asked for is called as it was asked for, `.yml` and all.
    let asked = |file: &NamedFile| formats::same_sort(&file.name, &name);
    let to = |file: &NamedFile| if asked(file) { path.to_owned() } else { path.with_file_name(&file.name) };
    for to in made.files.iter().map(to) {
        // What is not there yet has no place to compare.
        if to.canonicalize().is_ok_and(|to| read.iter().any(|read| fs::canonicalize(read).is_ok_and(|read| read == to))) {
            return Err(Error::refused("OUT", to.display(), "another file than those that are read").into());
        }
    }
    for file in &made.files {
        let to = to(file);
        fs::write(&to, &file.bytes).map_err(|error| Failure::File(to.display().to_string(), error))?;
    }
    load::tell(&made.notes);
    Ok(ExitCode::SUCCESS)
}
