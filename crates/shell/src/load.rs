//! Turning arguments into scenes and setups.

use std::{
    fs,
    io::ErrorKind,
    path::{Path, PathBuf},
    sync::Arc,
};

use forage::{
    Error, Link, Overrides, Registry, Scene, Setup, Value,
    describe::{Entry, Follower, Suggestion},
    kernel::{Message, limits, message::in_english, rng},
    message,
};

use forage_formats::{self as formats, Format, NamedFile};

use super::{
    args::RunArgs,
    failure::Failure,
    failure::in_file,
    files::{self, LARGEST_SCENE, LONGEST_CODE, LONGEST_LINK},
    kinds,
    language::say,
    names::{self, Subject},
    output::{note, notes},
    registry::{self, registry},
    text::{all_of, quoted},
};

/// A run to be carried out.
pub(super) struct Task {
    pub(super) setup: Setup,
    /// Where to stop before the limit: the iteration that a link shows.
    pub(super) stop_at: Option<u64>,
    /// The hash that the link gives for that iteration.
    pub(super) expected_hash: Option<String>,
    /// The files that the scene was read from.
    pub(super) files: Vec<PathBuf>,
}

/// Reads a scene: a file, a shipped scene's name, or a link.
pub(super) fn scene(text: &str) -> Result<Arc<Scene>, Failure> {
    scene_and_files(text).map(|(scene, _)| scene)
}

/// Reads a scene, and names the files that were read.
pub(super) fn scene_and_files(text: &str) -> Result<(Arc<Scene>, Vec<PathBuf>), Failure> {
    if Link::is_link(text) {
        return Ok((link(text)?.setup.scene, Vec::new()));
    }
    let path = Path::new(text);
    let is_shipped = names::scenes().contains(&text);
    match fs::metadata(path) {
        Ok(metadata) if !(is_shipped && metadata.is_dir()) => {}
        _ if is_shipped => return Ok((registry().scene(text)?, Vec::new())),
        Err(error) if matches!(error.kind(), ErrorKind::NotFound | ErrorKind::NotADirectory | ErrorKind::InvalidFilename) => {
            return Err(no_scene(text));
        }
        _ => {}
    }
    if Format::of_file(text).is_some_and(|format| format != Format::Json) {
        let mut files = vec![read(text)?];
        let scene = import(&mut files, None).map(Arc::new)?;
        return Ok((scene, files.into_iter().map(|file| file.name.into()).collect()));
    }
    let bytes = files::read(path, LARGEST_SCENE)?;
    let json = String::from_utf8(bytes).map_err(|problem| {
        in_file(path, &Error::malformed("scene", message!("error-not-json", "not JSON: {problem}", problem = problem.to_string())))
    })?;
    let scene = registry().read_scene(&json).map_err(|error| in_file(path, &error))?;
    Ok((Arc::new(scene), vec![path.to_owned()]))
}

/// Neither a file nor a shipped scene.
pub(super) fn no_scene(text: &str) -> Failure {
    let near = names::nearest(text, &names::scenes());
    let name = quoted(text);
    Failure::Refused(if near.is_empty() {
        message!("shell-no-file-and-no-scene", "{name}: no such file (and not a shipped scene; `forage list` shows those)", name)
    } else {
        let said = message!("shell-no-file-or-scene", "{name}: no such file or shipped scene", name);
        names::meant(&said, &near).then(message!("shell-all-shipped-scenes", "`forage list` shows all scenes"))
    })
}

/// Reads a link.
fn link(text: &str) -> Result<Link, Failure> {
    LONGEST_LINK.check(&message!("shell-the-link", "the link").text(), text.len() as u64)?;
    Ok(Link::parse(registry(), text)?)
}

/// Reads the scene in some files. A file that they need and that is missing is looked for in the folder of the first one, with
/// and without the folders in its name. Notes go to standard error.
pub(super) fn import(files: &mut Vec<NamedFile>, problem: Option<usize>) -> Result<Scene, Failure> {
    if let Some(partner) = formats::wanted(files)? {
        let folder = files.first().and_then(|file| Path::new(&file.name).parent()).unwrap_or(Path::new(""));
        let names = [Some(Path::new(&partner).as_os_str()), Path::new(&partner).file_name()];
        if let Some(path) = names.into_iter().flatten().map(|name| folder.join(name)).find(|path| path.exists()) {
            files.push(read(&path.to_string_lossy())?);
        }
    }
    let read = || formats::import(registry(), files, problem);
    // The note of a scene is in English; why there is none is not.
    let imported = in_english(read).or_else(|_| read()).map_err(|error| match error {
        Error::Refused { field, value, allowed } if field == "problem" => Error::refused("--problem", value, allowed),
        other => other,
    })?;
    notes(&imported.notes);
    Ok(imported.scene)
}

/// Reads a file of a scene.
pub(super) fn read(path: &str) -> Result<NamedFile, Failure> {
    Ok(NamedFile::new(path, files::read(Path::new(path), LARGEST_SCENE)?))
}

/// Reads a seed.
pub(super) fn seed(text: &str) -> Result<u64, Error> {
    match text {
        "random" => rng::fresh_seed(),
        number => limits::read_whole("seed", number),
    }
}

/// Everything `forage run` needs, checked as far as possible without starting the planner.
pub(super) fn task(args: &RunArgs) -> Result<Task, Failure> {
    let given_link = [&args.planner, &args.scene].into_iter().flatten().find(|text| Link::is_link(text));
    let own = match (&args.code, given_link) {
        (Some(path), _) => Some(register_code(path)?),
        (None, Some(link)) => {
            // It is the link's planner, not another one on its scene.
            if let Some(code) = forage_isolate::code_in(link)? {
                own_planner(&code, registry()).map(registry::register)?;
            }
            None
        }
        _ => None,
    };
    let given_link = given_link.map(|text| link(text)).transpose()?;
    let planner = args.planner.as_deref().filter(|text| !Link::is_link(text)).or(own);
    let mut task = match given_link {
        Some(link) => from_link(link, planner),
        None => from_names(planner, args.scene.as_deref())?,
    };
    if change(&mut task.setup, args)? {
        (task.stop_at, task.expected_hash) = (None, None);
    }
    Ok(task)
}

/// Adds the planner of a file's code to those that are known; returns its name.
pub(super) fn register_code(path: &Path) -> Result<&'static str, Failure> {
    let code = String::from_utf8(files::read(path, LONGEST_CODE)?).map_err(|_| Failure::no_text(path))?;
    let entry = own_planner(&code, registry()).map_err(|error| in_file(path, &error))?;
    registry::register(entry);
    Ok(entry.name)
}

/// The planner of a code, whose name must be another one than those that there are.
pub(super) fn own_planner(code: &str, known: &Registry) -> Result<&'static Entry, Error> {
    let entry = forage_isolate::entry(code)?;
    match known.planner(entry.name) {
        Ok(_) => Err(Error::refused("name", entry.name, message!("shell-name-of-its-own", "a name that no other planner has"))),
        Err(_) => Ok(entry),
    }
}

fn from_names(planner: Option<&str>, scene_name: Option<&str>) -> Result<Task, Failure> {
    let missing = |what: Message| {
        let example = "forage run wcpso --scene wcpso-discs";
        Failure::Refused(message!("shell-for-example", "{what}, e.g. `{example}`; `forage list` shows all", what, example))
    };
    let planner = planner.ok_or_else(|| missing(message!("shell-planner-missing", "a planner is missing")))?;
    registry().planner(planner)?;
    let no_scene = || message!("shell-scene-missing", "--scene is missing: a file, a shipped scene’s name or a link");
    let (scene, files) = scene_and_files(scene_name.ok_or_else(|| missing(no_scene()))?)?;
    let setup = Setup { planner: planner.to_owned(), scene, params: Overrides::new(), seed: 1 };
    Ok(Task { setup, stop_at: None, expected_hash: None, files })
}

/// The link's run up to the iteration that it shows; or a run of another planner with the link's scene and seed.
fn from_link(link: Link, planner: Option<&str>) -> Task {
    match planner.filter(|&name| name != link.setup.planner) {
        None => Task { stop_at: Some(link.iteration), expected_hash: link.hash, setup: link.setup, files: Vec::new() },
        Some(name) => {
            note(message!(
                "shell-link-for-another",
                "the link is for {planner}; running {name} on its scene with its seed and default parameters",
                planner = link.setup.planner,
                name = quoted(name)
            ));
            let setup = Setup { planner: name.to_owned(), params: Overrides::new(), ..link.setup };
            Task { setup, stop_at: None, expected_hash: None, files: Vec::new() }
        }
    }
}

/// Reads name=value pairs into parameters.
pub(super) fn read_pairs(option: &str, pairs: &[String], params: &mut Overrides) -> Result<(), Failure> {
    for pair in pairs {
        let (name, value) = pair.split_once('=').ok_or_else(|| Error::refused(option, pair, Message::verbatim("name=value")))?;
        params.insert(name.trim(), value_of(value));
    }
    Ok(())
}

/// A value as it is typed. A number that is too large stays the text that it is, so that a message shows it.
fn value_of(text: &str) -> Value {
    match Value::from(text) {
        Value::Number(number) if !number.is_finite() => Value::Text(text.trim().to_owned()),
        value => value,
    }
}

/// What is asked of a follower of the path.
pub(super) struct Following<'a> {
    pub(super) follower: &'static Follower,
    pub(super) overrides: Overrides,
    /// Where its rows are to go.
    pub(super) out: Option<&'a Path>,
}

impl Following<'_> {
    /// Whether anything is asked.
    pub(super) fn is_asked(&self) -> bool {
        self.out.is_some() || !self.overrides.is_empty()
    }
}

/// What is asked of the followers, checked before the run; refused in scenes that they are not for.
pub(super) fn following<'a>(args: &'a RunArgs, scene: &Scene) -> Result<Vec<Following<'a>>, Failure> {
    let asked = [("drive", &args.drive, &args.drive_set), ("motion", &args.motion, &args.motion_set)];
    asked.into_iter().map(|(name, out, pairs)| follow_checked(registry().follower(name)?, out.as_deref(), pairs, scene)).collect()
}

fn follow_checked<'a>(
    follower: &'static Follower,
    out: Option<&'a Path>,
    pairs: &[String],
    scene: &Scene,
) -> Result<Following<'a>, Failure> {
    let name = follower.name;
    let mut overrides = Overrides::new();
    read_pairs(&format!("--{name}-set"), pairs, &mut overrides)?;
    let following = Following { follower, overrides, out };
    if following.is_asked() && !(follower.applies)(scene) {
        let option = if out.is_some() { format!("--{name}") } else { format!("--{name}-set") };
        return Err(not_for(&option, scene, follower.needs));
    }
    (follower.follow)(scene, None, &following.overrides).map_err(|error| Failure::about(Subject::Named(name), &error))?;
    Ok(following)
}

fn not_for(option: &str, scene: &Scene, needed: &str) -> Failure {
    let (scene, kind) = (quoted(scene.name()), kinds::name(scene.kind().name()));
    let needed = say(needed, "");
    Failure::Refused(message!("shell-option-needs", "{option} needs {needed}; {scene} is of kind {kind}", option, needed, scene, kind))
}

/// Puts --seed, --preset, --iterations and --set into the setup; returns whether anything was given.
fn change(setup: &mut Setup, args: &RunArgs) -> Result<bool, Failure> {
    if let Some(text) = args.seed.as_deref() {
        setup.seed = seed(text)?;
    }
    if let Some(name) = &args.preset {
        let entry = registry().planner(&setup.planner)?;
        let preset = entry.preset(name, setup.scene.kind()).map_err(|error| Failure::about(Subject::Named(entry.name), &error))?;
        preset.iter().for_each(|(name, value)| setup.params.insert(name, value.clone()));
    }
    if let Some(iterations) = &args.iterations {
        setup.params.insert("iterations", value_of(iterations));
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
    Ok(args.seed.is_some() || args.iterations.is_some() || args.preset.is_some() || args.suggested || !args.set.is_empty())
}

/// What the planner's paper recommends for a setup, and the planner's title.
pub(super) fn suggestion(setup: &Setup) -> Result<(Suggestion, &'static str), Failure> {
    let entry = registry().planner(&setup.planner)?;
    let suggested = setup.suggest(registry()).map_err(|error| in_setup(setup, &error))?;
    let none = || {
        let (planner, scene) = (entry.name, quoted(setup.scene.name()));
        message!("shell-not-recommended", "no paper recommends sizes for `{planner}` on {scene} with these parameters", planner, scene)
    };
    Ok((suggested.ok_or_else(|| Failure::Refused(none()))?, entry.title))
}

/// An error about a setup, with what its parameters belong to.
pub(super) fn in_setup(setup: &Setup, error: &Error) -> Failure {
    let Ok(entry) = registry().planner(&setup.planner) else {
        return Failure::about(Subject::Unknown, error);
    };
    if let Error::Unknown { field, value, .. } = error
        && field == "parameter"
        && let Some(parameter) = entry.parameter(value)
    {
        let (kinds, found) = (all_of(&kinds::names(parameter.kinds)), kinds::name(setup.scene.kind().name()));
        return Failure::Refused(message!(
            "shell-not-of-this-kind",
            "`{value}` applies to scenes of kind {kinds}; this one is of kind {found}",
            value,
            kinds,
            found
        ));
    }
    Failure::about(Subject::Named(entry.name), error)
}
