//! Turning what was typed into a setup.

use std::{fs, path::Path, sync::Arc};

use forage::{
    Error, Given, Link, Scene, Setup, Value, arm,
    catalogue::Suggestion,
    drive, rng,
    scene::formats::{self, Format, NamedFile},
    shipped, shipped_names,
};

use super::{Failure, args::RunArgs};

/// A run to be carried out.
pub(super) struct Task {
    pub(super) setup: Setup,
    /// Where to stop before the limit: the iteration that a link shows.
    pub(super) stop_at: Option<u64>,
    /// The hash that the link promises there.
    pub(super) promised: Option<String>,
}

/// A scene file or a map, a shipped scene's name, or the scene of a link.
pub(super) fn scene(text: &str) -> Result<Arc<Scene>, Failure> {
    if Link::is_link(text) {
        return Ok(Link::parse(text)?.setup.scene);
    }
    if !Path::new(text).exists() && shipped_names().any(|scene| scene.name() == text) {
        return Ok(shipped(text)?);
    }
    match fs::read(text) {
        Ok(bytes) if Format::of_file(text).is_some_and(|format| format != Format::Json) => {
            import(&mut vec![NamedFile::new(text, bytes)], None).map(Arc::new)
        }
        Ok(bytes) => {
            let json = String::from_utf8(bytes).map_err(|problem| Error::malformed("scene", format!("not JSON: {problem}")))?;
            Ok(Arc::new(Scene::from_json(&json)?))
        }
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => {
            let names: Vec<_> = shipped_names().map(|scene| scene.name()).collect();
            Err(Error::refused("scene", text, format!("a file, a link, or one of {}", names.join(", "))).into())
        }
        Err(error) => Err(Failure::File(text.to_owned(), error)),
    }
}

/// The scene of some files; one that they name and that is not among them is looked for beside the first, under the
/// folders it is named with and without them, and added. What should be known about it goes to standard error.
pub(super) fn import(files: &mut Vec<NamedFile>, problem: Option<usize>) -> Result<Scene, Failure> {
    if let Some(wanted) = formats::wanted(files)? {
        let folder = files.first().and_then(|file| Path::new(&file.name).parent()).unwrap_or(Path::new(""));
        let beside = [Some(Path::new(&wanted).as_os_str()), Path::new(&wanted).file_name()];
        if let Some(path) = beside.into_iter().flatten().map(|name| folder.join(name)).find(|path| path.is_file()) {
            files.push(read(&path.display().to_string())?);
        }
    }
    let read = formats::import(files, problem)?;
    tell(&read.notes);
    Ok(read.scene)
}

/// A file with its name.
pub(super) fn read(path: &str) -> Result<NamedFile, Failure> {
    Ok(NamedFile::new(path, fs::read(path).map_err(|error| Failure::File(path.to_owned(), error))?))
}

/// Says what should be known.
pub(super) fn tell(notes: &[String]) {
    notes.iter().for_each(|note| eprintln!("forage: {note}"));
}

/// A seed as it is typed.
pub(super) fn seed(text: &str) -> Result<u64, Error> {
    match text {
        "random" => rng::fresh_seed(),
        number => number.parse().map_err(|_| Error::refused("seed", number, rng::SEED_RANGE)),
    }
}

/// Everything `forage run` needs, checked as far as it can be without the planner.
pub(super) fn task(args: &RunArgs) -> Result<Task, Failure> {
    let link = [&args.planner, &args.scene].into_iter().flatten().find(|text| Link::is_link(text));
    let link = link.map(|text| Link::parse(text)).transpose()?;
    let named = args.planner.as_deref().filter(|text| !Link::is_link(text));
    let mut task = match link {
        Some(link) => from_link(link, named),
        None => Task {
            setup: Setup {
                planner: named
                    .ok_or_else(|| Error::refused("PLANNER", "nothing", "a planner’s name; `forage list` shows them"))?
                    .to_owned(),
                scene: scene(
                    args.scene.as_deref().ok_or_else(|| Error::refused("--scene", "nothing", "a file, a shipped name or a link"))?,
                )?,
                params: Given::new(),
                seed: 1,
            },
            stop_at: None,
            promised: None,
        },
    };
    let changed = change(&mut task.setup, args)?;
    if changed {
        (task.stop_at, task.promised) = (None, None);
    }
    Ok(task)
}

/// The link's run up to the iteration it shows; or, for another planner, a run of that one on the link's scene and seed.
fn from_link(link: Link, planner: Option<&str>) -> Task {
    match planner.filter(|&name| name != link.setup.planner) {
        None => Task { stop_at: Some(link.iteration), promised: link.hash, setup: link.setup },
        Some(name) => {
            eprintln!(
                "forage: the link is for {}; running {name} on its scene and seed, with {name}’s default parameters",
                link.setup.planner
            );
            let setup = Setup { planner: name.to_owned(), params: Given::new(), ..link.setup };
            Task { setup, stop_at: None, promised: None }
        }
    }
}

/// Puts what was typed as name=value into parameters.
pub(super) fn read_pairs(option: &str, pairs: &[String], params: &mut Given) -> Result<(), Failure> {
    for pair in pairs {
        let (name, value) = pair.split_once('=').ok_or_else(|| Error::refused(option, pair, "name=value"))?;
        params.insert(name.trim(), Value::from(value));
    }
    Ok(())
}

/// The drive's parameters, checked before the run; refused where no robot could drive.
pub(super) fn drive(args: &RunArgs, scene: &Scene) -> Result<Given, Failure> {
    let mut given = Given::new();
    read_pairs("--drive-set", &args.drive_set, &mut given)?;
    let robot = drive::robot(scene).and_then(|(grid, _)| grid.robot);
    if robot.is_none() && (args.drive.is_some() || !given.is_empty()) {
        let option = if args.drive.is_some() { "--drive" } else { "--drive-set" };
        let allowed = "left out unless the scene is a grid whose robot has length and width";
        return Err(Error::refused(option, scene.name(), allowed).into());
    }
    drive::settings(robot, &given)?;
    Ok(given)
}

/// The motion's parameters, checked before the run; refused where there is no arm.
pub(super) fn motion(args: &RunArgs, scene: &Scene) -> Result<Given, Failure> {
    let mut given = Given::new();
    read_pairs("--motion-set", &args.motion_set, &mut given)?;
    if scene.arm().is_err() && (args.motion.is_some() || !given.is_empty()) {
        let option = if args.motion.is_some() { "--motion" } else { "--motion-set" };
        return Err(Error::refused(option, scene.name(), "left out unless the scene is an arm’s").into());
    }
    arm::along(scene, None, &given)?;
    Ok(given)
}

/// Puts --seed, --iterations and --set into the setup; says whether there was anything to put in.
fn change(setup: &mut Setup, args: &RunArgs) -> Result<bool, Failure> {
    if let Some(text) = args.seed.as_deref() {
        setup.seed = seed(text)?;
    }
    if let Some(iterations) = &args.iterations {
        setup.params.insert("iterations", Value::from(iterations.as_str()));
    }
    read_pairs("--set", &args.set, &mut setup.params)?;
    if args.suggested {
        let (suggested, _) = suggestion(setup)?;
        for (name, value) in [("population", suggested.population), ("iterations", suggested.iterations)] {
            if setup.params.get(name).is_none() {
                setup.params.insert(name, Value::from(value as f64));
            }
        }
    }
    Ok(args.seed.is_some() || args.iterations.is_some() || args.suggested || !args.set.is_empty())
}

/// What the planner's paper recommends for a setup, and the planner's title.
pub(super) fn suggestion(setup: &Setup) -> Result<(Suggestion, &'static str), Error> {
    let (entry, _) = setup.check()?;
    let allowed = "one whose paper recommends sizes for this scene and these parameters";
    let suggested = setup.suggest()?.ok_or_else(|| Error::refused("planner", entry.name, allowed))?;
    Ok((suggested, entry.title))
}
