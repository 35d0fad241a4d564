//! `forage convert`, and writing a scene in the format that a file's name asks for.

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use forage::{
    Error, Scene,
    arm::ArmScene,
    kernel::Message,
    scene::{DiscsScene, FunctionScene, GridScene, TourScene},
};

use forage_formats::{self as formats, ENDINGS, Format, NamedFile};

use super::{
    args::ConvertArgs,
    failure::{Failure, Outcome},
    files, load,
    output::{note, notes},
    text::{quoted, shorten},
};

pub(super) fn convert(args: &ConvertArgs) -> Outcome {
    let Some((to, from @ [one, ..])) = args.paths.split_last() else {
        return Err(Error::refused("OUT", "nothing", Message::verbatim("a file to write, after the files to read")).into());
    };
    let format = format("OUT", to)?;
    // A single name may be a shipped scene or a link; only a file has problems to choose from.
    if from.len() == 1 && args.problem.is_none() && Format::of_file(one).is_none_or(|format| format == Format::Json) {
        return write(&*load::scene(one)?, format, "OUT", to, from);
    }
    let mut files = from.iter().map(|path| load::read(path)).collect::<Result<_, _>>()?;
    let scene = load::import(&mut files, args.problem)?;
    let read: Vec<_> = files.into_iter().map(|file| file.name).collect();
    write(&scene, format, "OUT", to, &read)
}

/// The format of a file that is to be written.
pub(super) fn format(field: &str, path: &str) -> Result<Format, Error> {
    Format::of_file(path).ok_or_else(|| Error::refused(field, path, Message::verbatim(format!("a file that ends in {ENDINGS}"))))
}

/// Writes a scene's files in a format, named like `path`, the value of `field`, except for their endings. Files that were read are
/// never overwritten.
pub(super) fn write(scene: &Scene, format: Format, field: &str, path: &str, read: &[String]) -> Outcome {
    let path = Path::new(path);
    let name = path.to_string_lossy();
    let exported = formats::export(scene, format, formats::stem_of(&name))?;
    let is_asked_for = |file: &NamedFile| formats::same_sort(&file.name, &name);
    // Not every scene has a tour to write next to its stops, or a problem next to its map.
    if !exported.files.iter().any(is_asked_for) {
        let tour = format!("{field}: the shortest closed tour of this scene is not known, so there is no tour to write");
        let notes: Vec<_> = exported.notes.iter().map(ToString::to_string).collect();
        return Err(Failure::Refused(if format == Format::Tsplib { tour } else { format!("{field}: {}", notes.join(" ")) }));
    }
    let target = |file: &NamedFile| if is_asked_for(file) { path.to_owned() } else { path.with_file_name(&file.name) };
    let targets: Vec<PathBuf> = exported.files.iter().map(target).collect();
    let mut others: Vec<(&str, &Path)> = read.iter().map(|read| ("is read", Path::new(read))).collect();
    for target in &targets {
        files::check_apart(field, target, &others)?;
        files::check_target(target)?;
        others.push(("is written, too", target));
    }
    for (file, target) in exported.files.iter().zip(&targets) {
        files::write(target, &file.bytes)?;
    }
    notes(&exported.notes);
    let written: Vec<_> = targets.iter().map(|target| quoted(&target.to_string_lossy())).collect();
    note(&format!("wrote {} ({}) to {}", shorten(scene.name(), 70), describe(scene), written.join(" and ")));
    Ok(ExitCode::SUCCESS)
}

/// The kind and the size of a scene.
pub(super) fn describe(scene: &Scene) -> String {
    let sizes = if let Ok(function) = scene.get::<FunctionScene>() {
        vec![count(function.dimension(), "variable")]
    } else if let Ok(discs) = scene.get::<DiscsScene>() {
        vec![count(discs.discs.len(), "obstacle")]
    } else if let Ok(grid) = scene.get::<GridScene>() {
        let more = [(grid.stops.len(), "stop"), (grid.moving.len(), "moving obstacle")];
        let more = more.into_iter().filter(|(number, _)| *number > 0).map(|(number, what)| count(number, what));
        [format!("{} × {} cells", grid.columns, grid.rows())].into_iter().chain(more).collect()
    } else if let Ok(tour) = scene.get::<TourScene>() {
        vec![count(tour.len(), "stop")]
    } else if let Ok(arm) = scene.get::<ArmScene>() {
        vec![count(arm.cuboids.len(), "cuboid")]
    } else {
        Vec::new()
    };
    [scene.kind().name().to_owned()].into_iter().chain(sizes).collect::<Vec<_>>().join(", ")
}

fn count(number: usize, what: &str) -> String {
    if number == 1 { format!("1 {what}") } else { format!("{number} {what}s") }
}
