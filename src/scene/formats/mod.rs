//! Grids in other programs' formats: MovingAI's maps with their problems (`movingai`), and the occupancy grids of ROS's
//! map_server (`ros`, with its picture in `pgm`).
//!
//! [`import`] takes files as bytes and says what it read in some way that should be known; [`export`] says what the
//! format has no place for. A file that cannot be read is refused with its name, the line, and why.

mod ends;
mod movingai;
mod pgm;
mod ros;
#[cfg(test)]
mod tests;

use serde::Serialize;

use crate::error::Error;

use super::{Body, GridScene, Header, MAX_SIDE, Scene};

/// A file as bytes.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct NamedFile {
    /// Its name, with or without folders.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
}

impl NamedFile {
    /// A file of these bytes.
    pub fn new(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> Self {
        Self { name: name.into(), bytes: bytes.into() }
    }

    /// Its name without folders, as messages have it.
    fn label(&self) -> &str {
        Some(base(&self.name)).filter(|name| !name.is_empty()).unwrap_or("file")
    }

    /// Its content as text.
    fn text(&self) -> Result<&str, Error> {
        let text = str::from_utf8(&self.bytes).map_err(|error| {
            let line = self.bytes[..error.valid_up_to()].split(|&byte| byte == b'\n').count();
            self.wrong(line, "bytes that are no text (UTF-8)")
        })?;
        Ok(text.strip_prefix('\u{feff}').unwrap_or(text))
    }

    /// Its lines with their numbers, without spaces at their ends.
    fn lines(&self) -> Result<impl Iterator<Item = (usize, &str)>, Error> {
        Ok(self.text()?.lines().enumerate().map(|(i, line)| (i + 1, line.trim_end())))
    }

    /// What is wrong with it, and where.
    fn wrong(&self, line: usize, problem: &str) -> Error {
        Error::malformed(self.label(), format!("line {line}: {problem}"))
    }

    /// Refuses what was found at a place where something else is expected.
    fn unexpected(&self, line: usize, found: &str, expected: &str) -> Error {
        // The whole of a long line helps nobody.
        let shown: String = found.chars().take(40).collect();
        let more = if shown.len() < found.len() { "…" } else { "" };
        self.wrong(line, &format!("found `{shown}{more}`, expected {expected}"))
    }

    /// A number of rows or columns.
    fn side(&self, line: usize, name: &str, found: &str) -> Result<usize, Error> {
        let side = found.parse().ok().filter(|side| (1..=MAX_SIDE).contains(side));
        side.ok_or_else(|| self.unexpected(line, found, &format!("a {name} from 1 to {MAX_SIDE}")))
    }
}

/// A problem of a MovingAI `.scen` file.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Problem {
    /// The centre of the cell where it starts.
    pub start: [f64; 2],
    /// The centre of the cell where it ends.
    pub goal: [f64; 2],
    /// The length that the file gives, in cells.
    pub length: f64,
}

/// What came of files of another format.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Imported {
    /// The scene.
    pub scene: Scene,
    /// What was read in some way that should be known: unknown cells taken as blocked, ends chosen, …
    pub notes: Vec<String>,
    /// The problems of a `.scen` file, if one was among the files.
    pub problems: Vec<Problem>,
}

/// What a scene is in another format.
#[derive(Debug, Clone, PartialEq)]
pub struct Exported {
    /// The files; they name each other where they belong together.
    pub files: Vec<NamedFile>,
    /// What the format has no place for.
    pub notes: Vec<String>,
}

/// What can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// MovingAI: a `.map`, and a `.scen` with one problem where there are a start, a goal and a way between them.
    MovingAi,
    /// ROS map_server: a `.yaml` and a `.pgm`.
    Ros,
    /// The scene file.
    Json,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 3] = [Self::MovingAi, Self::Ros, Self::Json];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MovingAi => "movingai",
            Self::Ros => "ros",
            Self::Json => "json",
        }
    }

    /// The format of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn named(name: &str) -> Result<Self, Error> {
        Self::ALL.into_iter().find(|f| f.name() == name).ok_or_else(|| Error::unknown("format", name, Self::ALL.map(Self::name)))
    }

    /// The format that has files with this ending, if there is one.
    pub fn of_file(name: &str) -> Option<Self> {
        Some(match Sort::by_name(name)? {
            Sort::Map | Sort::Scen => Self::MovingAi,
            Sort::Yaml | Sort::Pgm => Self::Ros,
            Sort::Json => Self::Json,
        })
    }
}

/// What a file is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sort {
    Map,
    Scen,
    Yaml,
    Pgm,
    Json,
}

/// The endings of files, and how such a file begins.
const SORTS: [(&str, &[u8], Sort); 7] = [
    ("map", b"type ", Sort::Map),
    ("scen", b"version ", Sort::Scen),
    ("yaml", b"image:", Sort::Yaml),
    ("yml", b"image:", Sort::Yaml),
    ("pgm", b"P2", Sort::Pgm),
    ("pgm", b"P5", Sort::Pgm),
    ("json", b"{", Sort::Json),
];

impl Sort {
    fn by_name(name: &str) -> Option<Self> {
        let (_, ending) = name.rsplit_once('.')?;
        SORTS.iter().find(|(known, ..)| ending.eq_ignore_ascii_case(known)).map(|&(.., sort)| sort)
    }

    fn of(file: &NamedFile) -> Result<Self, Error> {
        let by_content = || SORTS.iter().find(|(_, begin, _)| file.bytes.trim_ascii_start().starts_with(begin)).map(|&(.., sort)| sort);
        Self::by_name(&file.name).or_else(by_content).ok_or_else(|| {
            file.wrong(1, "neither a MovingAI .map or .scen, nor a .yaml with its .pgm from map_server, nor a scene's .json")
        })
    }
}

/// Files by what they are.
#[derive(Default)]
struct Files<'a> {
    map: Option<&'a NamedFile>,
    scen: Option<&'a NamedFile>,
    yaml: Option<&'a NamedFile>,
    pgm: Option<&'a NamedFile>,
    json: Option<&'a NamedFile>,
}

impl<'a> Files<'a> {
    fn of(files: &'a [NamedFile]) -> Result<Self, Error> {
        let mut sorted = Self::default();
        for file in files {
            let place = match Sort::of(file)? {
                Sort::Map => &mut sorted.map,
                Sort::Scen => &mut sorted.scen,
                Sort::Yaml => &mut sorted.yaml,
                Sort::Pgm => &mut sorted.pgm,
                Sort::Json => &mut sorted.json,
            };
            if let Some(other) = place.replace(file) {
                return Err(Error::malformed(file.label(), format!("of the same sort as {}: one scene at a time", other.label())));
            }
        }
        Ok(sorted)
    }
}

/// The scene in some files: a `.map`, alone or with a `.scen`; a `.yaml` with its `.pgm`; or a scene's `.json`.
///
/// Of a `.scen` file's problems the scene takes the one with number `problem`, counted from 0; the last one if none is
/// asked for. A map without ends gets two, in free cells that are far apart.
///
/// # Errors
/// [`Error::Malformed`] with the file, the line and what is wrong there, or the file that is missing;
/// [`Error::Refused`] for a problem that there is not, and whatever [`Scene::from_json`] refuses.
pub fn import(files: &[NamedFile], problem: Option<usize>) -> Result<Imported, Error> {
    let sorted = Files::of(files)?;
    if problem.is_some() && sorted.scen.is_none() {
        return Err(Error::refused("problem", problem.unwrap_or_default(), "left out: there is no .scen file"));
    }
    match sorted {
        Files { map: Some(map), scen, yaml: None, pgm: None, json: None } => movingai::import(map, scen, problem),
        Files { yaml: Some(yaml), pgm: Some(pgm), map: None, scen: None, json: None } => ros::import(yaml, pgm),
        Files { json: Some(json), map: None, scen: None, yaml: None, pgm: None } => {
            Ok(Imported { scene: Scene::from_json(json.text()?)?, notes: Vec::new(), problems: Vec::new() })
        }
        _ => match (wanted(files)?, files) {
            (Some(name), [file, ..]) => Err(Error::malformed(file.label(), format!("the file `{name}` that belongs to it is missing"))),
            (None, [file, ..]) => {
                Err(Error::malformed(file.label(), "it belongs to another format than the other files: one scene at a time"))
            }
            (_, []) => Err(Error::refused("files", "nothing", "a .map, a .scen and its .map, a .yaml and its .pgm, or a .json")),
        },
    }
}

/// The file that is missing before [`import`] can read the others: the map of a `.scen`, the picture of a `.yaml`, the
/// `.yaml` of a picture. With the folders that it has in the file that names it.
///
/// # Errors
/// As [`import`].
pub fn wanted(files: &[NamedFile]) -> Result<Option<String>, Error> {
    Ok(match Files::of(files)? {
        Files { scen: Some(scen), map: None, .. } => Some(movingai::map_of(scen)?.to_owned()),
        Files { yaml: Some(yaml), pgm: None, .. } => Some(ros::image_of(yaml)?),
        Files { pgm: Some(pgm), yaml: None, .. } => Some(format!("{}.yaml", stem(&pgm.name))),
        _ => None,
    })
}

/// A scene's files in a format, called `stem`; a scene's name will do.
///
/// # Errors
/// [`Error::Refused`] for a scene that is no grid, but for the scene file.
pub fn export(scene: &Scene, format: Format, stem: &str) -> Result<Exported, Error> {
    // Names stand in tab-separated lines and between quotes.
    let stem: String = stem.chars().map(|c| if c.is_control() || "/\\\"'`".contains(c) { '-' } else { c }).collect();
    match format {
        Format::MovingAi => movingai::export(scene.grid()?, &stem),
        Format::Ros => Ok(ros::export(scene.grid()?, &stem)),
        Format::Json => Ok(Exported { files: vec![NamedFile::new(stem + ".json", scene.to_json() + "\n")], notes: Vec::new() }),
    }
}

/// Whether two files are of the same sort by their endings, `.yaml` and `.yml`, say.
pub fn same_sort(a: &str, b: &str) -> bool {
    Sort::by_name(a).is_some_and(|sort| Sort::by_name(b) == Some(sort))
}

/// What neither format has a place for.
fn lost(grid: &GridScene, notes: &mut Vec<String>) {
    for (there, what) in [
        (grid.robot.is_some(), "the robot"),
        (!grid.stops.is_empty(), "the stops"),
        (!grid.moving.is_empty(), "the moving discs"),
        (grid.corner_cutting, "that steps may cut corners"),
    ] {
        if there {
            notes.push(format!("Not kept, as the format has no place for it: {what}."));
        }
    }
}

/// A scene of a grid that was read; `file` gives its name.
fn scene(file: &NamedFile, source: &str, units: Option<&str>, grid: GridScene, notes: &[String]) -> Result<Scene, Error> {
    let stem = stem(&file.name);
    // A scene's name has 1 to 100 bytes.
    let name = if stem.is_empty() { "map" } else { &stem[..stem.floor_char_boundary(100)] };
    let header = Header {
        name: name.to_owned(),
        title: name.to_owned(),
        note: (!notes.is_empty()).then(|| notes.join(" ")),
        source: Some(format!("{source} {}", file.label())),
        units: units.map(str::to_owned),
        exact: None,
        published: None,
    };
    Scene::new(header, Body::Grid(grid)).map_err(|error| Error::malformed(file.label(), error))
}

/// Notes that the file named is not the one that was given.
fn note_other_name(file: &NamedFile, named: &str, given: &NamedFile, notes: &mut Vec<String>) {
    let (named, given) = (base(named), given.label());
    if named != given {
        notes.push(format!("{} belongs to {named}; {given} was taken.", file.label()));
    }
}

/// A path without its folders.
fn base(name: &str) -> &str {
    name.rsplit(['/', '\\']).next().unwrap_or(name)
}

/// A path without folders and ending.
fn stem(name: &str) -> &str {
    let base = base(name);
    base.rsplit_once('.').map_or(base, |(stem, _)| stem)
}
