//! `forage convert`, and writing a scene in the format that a file's name asks for.

use std::{
    path::{Path, PathBuf},
    process::ExitCode,
};

use forage::{
    Error, Scene,
    arm::ArmScene,
    kernel::Message,
    message,
    scene::{DiscsScene, FunctionScene, GridScene, TourScene},
};

use forage_formats::{self as formats, ENDINGS, Format, NamedFile};

use super::{
    args::ConvertArgs,
    failure::{Failure, Outcome},
    files::{self, Role},
    kinds, load,
    output::{note, notes},
    text::{self, listed, shorten, together},
};

pub(super) fn convert(args: &ConvertArgs) -> Outcome {
    let Some((to, from @ [one, ..])) = args.paths.split_last() else {
        return Err(Error::refused(
            "OUT",
            message!("error-nothing", "nothing"),
            message!("shell-file-to-write", "a file to write, after the files to read"),
        )
        .into());
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
    let refused = || {
        let endings: Vec<&str> = ENDINGS.split(", ").flat_map(|ending| ending.split(" or ")).collect();
        let endings = endings.split_last().map_or(String::new(), |(last, others)| {
            message!("shell-or", "{first} or {second}", first = listed(others), second = *last).to_string()
        });
        Error::refused(field, path, message!("shell-file-that-ends", "a file that ends in {endings}", endings))
    };
    Format::of_file(path).ok_or_else(refused)
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
        let tour =
            || message!("shell-no-tour-to-write", "the shortest closed tour of this scene is not known, so there is no tour to write");
        let notes = || exported.notes.iter().cloned().fold(Message::default(), Message::then);
        return Err(Failure::Refused(text::at(field, &if format == Format::Tsplib { tour() } else { notes() })));
    }
    let target = |file: &NamedFile| if is_asked_for(file) { path.to_owned() } else { path.with_file_name(&file.name) };
    let targets: Vec<PathBuf> = exported.files.iter().map(target).collect();
    let mut others: Vec<(Role, &Path)> = read.iter().map(|read| (Role::Read, Path::new(read))).collect();
    for target in &targets {
        files::check_apart(field, target, &others)?;
        files::check_target(target)?;
        others.push((Role::Written, target));
    }
    for (file, target) in exported.files.iter().zip(&targets) {
        files::write(target, &file.bytes)?;
    }
    notes(&exported.notes);
    let written: Vec<_> = targets.iter().map(|target| target.to_string_lossy().into_owned()).collect();
    let (name, files) = (shorten(scene.name(), 70), together(&written));
    note(message!("shell-wrote-scene", "wrote {name} ({described}) to {files}", name, described = describe(scene), files));
    Ok(ExitCode::SUCCESS)
}

/// The kind and the size of a scene.
pub(super) fn describe(scene: &Scene) -> String {
    let (kind, size) = (kinds::name(scene.kind().name()), size(scene));
    if size.is_empty() { kind } else { message!("shell-kind-and-size", "{kind}, {size}", kind, size).to_string() }
}

/// The size of a scene; empty for kinds that are not known here.
pub(super) fn size(scene: &Scene) -> String {
    let sizes = if let Ok(function) = scene.get::<FunctionScene>() {
        let n = function.dimension();
        vec![message!("shell-variables", "{n} {variables}", n, variables = n => "variable" | "variables")]
    } else if let Ok(discs) = scene.get::<DiscsScene>() {
        let n = discs.discs.len();
        vec![message!("shell-obstacles", "{n} {obstacles}", n, obstacles = n => "obstacle" | "obstacles")]
    } else if let Ok(grid) = scene.get::<GridScene>() {
        let cells = message!("shell-cells", "{columns} × {rows} cells", columns = grid.columns, rows = grid.rows());
        let moving = (!grid.moving.is_empty()).then(|| moving_obstacles(grid.moving.len()));
        [Some(cells), (!grid.stops.is_empty()).then(|| stops(grid.stops.len())), moving].into_iter().flatten().collect()
    } else if let Ok(tour) = scene.get::<TourScene>() {
        vec![stops(tour.len())]
    } else if let Ok(arm) = scene.get::<ArmScene>() {
        let n = arm.cuboids.len();
        vec![message!("shell-cuboids", "{n} {cuboids}", n, cuboids = n => "cuboid" | "cuboids")]
    } else {
        Vec::new()
    };
    listed(&sizes.iter().map(ToString::to_string).collect::<Vec<_>>())
}

fn stops(n: usize) -> Message {
    message!("shell-stops", "{n} {stops}", n, stops = n => "stop" | "stops")
}

fn moving_obstacles(n: usize) -> Message {
    message!("shell-moving-obstacles", "{n} {obstacles}", n, obstacles = n => "moving obstacle" | "moving obstacles")
}
