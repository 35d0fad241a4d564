//! Scenes in other programs' formats: MovingAI's maps with their problems (`movingai`), the occupancy grids of ROS's map_server
//! (`ros`, with its picture in `pgm`), TSPLIB's instances and tours (`tsplib`), and tables of points (`csv`).
//!
//! [`import`] takes files as bytes and notes what it had to interpret; [`export`] notes what the format cannot hold. A file
//! that cannot be read is refused with its name, the line and the reason.

mod csv;
mod ends;
mod file;
pub mod movingai;
mod pgm;
mod report;
mod ros;
#[cfg(test)]
mod tests;
mod tsplib;

use forage::{
    describe::Registry,
    kernel::{Error, allowed::nothing, limits},
    message,
    scene::{GridScene, Scene},
};

pub use file::NamedFile;
pub use report::{Exported, Imported, Problem};
pub use tsplib::tour_file;

use file::stem;

/// A format that can be written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// MovingAI: a `.map`, and a `.scen` with one problem if there is a path from start to goal.
    MovingAi,
    /// ROS map_server: a `.yaml` and a `.pgm`.
    Ros,
    /// TSPLIB: a `.tsp`, and a `.opt.tour` if the shortest tour is known.
    Tsplib,
    /// The points of a tour's stops.
    Csv,
    /// The scene file.
    Json,
}

impl Format {
    /// Every format.
    pub const ALL: [Self; 5] = [Self::MovingAi, Self::Ros, Self::Tsplib, Self::Csv, Self::Json];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::MovingAi => "movingai",
            Self::Ros => "ros",
            Self::Tsplib => "tsplib",
            Self::Csv => "csv",
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
        Sort::by_name(name).map(Sort::format)
    }
}

/// The endings of the files that can be read and written, for messages.
pub const ENDINGS: &str = ".json, .map, .scen, .yaml, .yml, .pgm, .tsp, .tour or .csv";

/// What a file is. Files that belong together are read in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Sort {
    Map,
    Scen,
    Yaml,
    Pgm,
    Csv,
    Json,
    Tsp,
    Tour,
}

/// The endings of files, and how such a file begins.
const SORTS: [(&str, &[u8], Sort); 13] = [
    ("map", b"type ", Sort::Map),
    ("scen", b"version ", Sort::Scen),
    ("yaml", b"image:", Sort::Yaml),
    ("yml", b"image:", Sort::Yaml),
    ("pgm", b"P2", Sort::Pgm),
    ("pgm", b"P5", Sort::Pgm),
    ("json", b"{", Sort::Json),
    ("tsp", b"NAME", Sort::Tsp),
    ("tsp", b"TYPE", Sort::Tsp),
    ("tsp", b"COMMENT", Sort::Tsp),
    ("tour", b"TOUR_SECTION", Sort::Tour),
    ("csv", b"x,y", Sort::Csv),
    ("csv", b"X,Y", Sort::Csv),
];

impl Sort {
    fn by_name(name: &str) -> Option<Self> {
        let (_, ending) = name.rsplit_once('.')?;
        SORTS.iter().find(|(known, ..)| ending.eq_ignore_ascii_case(known)).map(|&(.., sort)| sort)
    }

    fn of(file: &NamedFile) -> Result<Self, Error> {
        let by_content = || {
            let bytes = file.bytes.strip_prefix("\u{feff}".as_bytes()).unwrap_or(&file.bytes).trim_ascii_start();
            let begins = |part: &[u8]| bytes.starts_with(part);
            let sort = SORTS.iter().find(|(_, begin, _)| begins(begin)).map(|&(.., sort)| sort)?;
            // A tour begins as its instance does.
            let tour = sort == Self::Tsp && file.text().is_ok_and(|text| text.contains("TOUR_SECTION"));
            Some(if tour { Self::Tour } else { sort })
        };
        Self::by_name(&file.name).or_else(by_content).ok_or_else(|| {
            file.wrong(
                1,
                &message!(
                    "files-unknown",
                    "neither a MovingAI .map or .scen, nor a .yaml with its .pgm from map_server, nor TSPLIB's .tsp or .tour, nor a .csv of points, nor a scene's .json"
                ),
            )
        })
    }

    const fn format(self) -> Format {
        match self {
            Self::Map | Self::Scen => Format::MovingAi,
            Self::Yaml | Self::Pgm => Format::Ros,
            Self::Tsp | Self::Tour => Format::Tsplib,
            Self::Csv => Format::Csv,
            Self::Json => Format::Json,
        }
    }
}

/// Files by what they are, in the order of the sorts; one of each sort at most.
fn sorted(files: &[NamedFile]) -> Result<Vec<(Sort, &NamedFile)>, Error> {
    let mut sorted: Vec<(Sort, &NamedFile)> = Vec::new();
    for file in files {
        let sort = Sort::of(file)?;
        let at = sorted.partition_point(|(other, _)| (*other as u8) < sort as u8);
        if let Some((_, other)) = sorted.get(at).filter(|(other, _)| *other == sort) {
            let problem = message!("files-same-sort", "of the same sort as {other}: one scene at a time", other = other.label());
            return Err(Error::malformed(file.label(), problem));
        }
        sorted.insert(at, (sort, file));
    }
    Ok(sorted)
}

/// The scene in some files: a `.map`, alone or with a `.scen`; a `.yaml` with its `.pgm`; a `.tsp` or a scene's `.json`,
/// alone or with a `.tour`; or a `.csv` of points.
///
/// Of a `.scen` file's problems the scene takes the one with number `problem`, counted from 0; the last one if none is
/// asked for. A map without ends gets two, in free cells that are far apart. A tour is measured, and kept as the scene's
/// optimum if its file's name ends in `.opt.tour`.
///
/// # Errors
/// [`Error::Malformed`] with the file, the line and what is wrong there, or the file that is missing;
/// [`Error::Refused`] for a file that is too large, for a problem that there is not, and whatever [`Registry::read_scene`] refuses.
pub fn import(registry: &Registry, files: &[NamedFile], problem: Option<usize>) -> Result<Imported, Error> {
    files.iter().try_for_each(|file| limits::check_bytes(file.label(), file.bytes.len(), limits::FILE_BYTES))?;
    let sorted = sorted(files)?;
    if let Some(problem) = problem.filter(|_| sorted.iter().all(|(sort, _)| *sort != Sort::Scen)) {
        return Err(Error::refused("problem", problem, message!("files-no-scen", "left out: there is no .scen file")));
    }
    let json = |file: &NamedFile| Ok::<_, Error>(Imported::new(registry.read_scene(file.text()?)?, Vec::new()));
    match *sorted.as_slice() {
        [(Sort::Map, map)] => movingai::import(map, None, problem),
        [(Sort::Map, map), (Sort::Scen, scen)] => movingai::import(map, Some(scen), problem),
        [(Sort::Yaml, yaml), (Sort::Pgm, pgm)] => ros::import(yaml, pgm),
        [(Sort::Csv, csv)] => csv::import(csv),
        [(Sort::Json, file)] => json(file),
        [(Sort::Json, file), (Sort::Tour, tour)] => tsplib::with_tour(json(file)?, tour),
        [(Sort::Tsp, tsp)] => tsplib::import(tsp),
        [(Sort::Tsp, tsp), (Sort::Tour, tour)] => tsplib::with_tour(tsplib::import(tsp)?, tour),
        _ => match (wanted(files)?, files) {
            (Some(name), [file, ..]) => {
                let problem = message!("files-missing", "the file `{name}` that belongs to it is missing", name);
                Err(Error::malformed(file.label(), problem))
            }
            (None, [file, ..]) => {
                let problem = message!("files-other-format", "it belongs to another format than the other files: one scene at a time");
                Err(Error::malformed(file.label(), problem))
            }
            (_, []) => Err(Error::refused(
                "files",
                nothing(),
                message!(
                    "files-none",
                    "a .map, a .scen and its .map, a .yaml and its .pgm, a .tsp, a .tour and its .tsp, a .csv, or a .json"
                ),
            )),
        },
    }
}

/// The file that is missing before [`import`] can read the others: the map of a `.scen`, the picture of a `.yaml`, the
/// `.yaml` of a picture, the `.tsp` of a `.tour`. With the folders that it has in the file that names it.
///
/// # Errors
/// As [`import`].
pub fn wanted(files: &[NamedFile]) -> Result<Option<String>, Error> {
    let sorted = sorted(files)?;
    let find = |wanted: Sort| sorted.iter().find(|(sort, _)| *sort == wanted).map(|&(_, file)| file);
    let without = |there: Sort, partner: Sort| find(there).filter(|_| find(partner).is_none());
    if let Some(scen) = without(Sort::Scen, Sort::Map) {
        return movingai::map_of(scen).map(|name| Some(name.to_owned()));
    }
    if let Some(yaml) = without(Sort::Yaml, Sort::Pgm) {
        return ros::image_of(yaml).map(Some);
    }
    Ok(match *sorted.as_slice() {
        [(Sort::Pgm, pgm)] => Some(format!("{}.yaml", stem(&pgm.name))),
        [(Sort::Tour, tour)] => Some(format!("{}.tsp", stem(&tour.name))),
        _ => None,
    })
}

/// A scene's files in a format, called `stem`; a scene's name will do.
///
/// # Errors
/// [`Error::Refused`] for a scene of a kind that the format does not hold; the scene file holds all.
pub fn export(scene: &Scene, format: Format, stem: &str) -> Result<Exported, Error> {
    // Names stand in tab-separated lines and between quotes.
    let stem: String = stem.chars().map(|c| if c.is_control() || "/\\\"'`".contains(c) { '-' } else { c }).collect();
    match format {
        Format::MovingAi => movingai::export(scene.get::<GridScene>()?, &stem),
        Format::Ros => Ok(ros::export(scene.get::<GridScene>()?, &stem)),
        Format::Tsplib => tsplib::export(scene, &stem),
        Format::Csv => csv::export(scene, &stem),
        Format::Json => Ok(Exported { files: vec![NamedFile::new(stem + ".json", scene.to_json() + "\n")], notes: Vec::new() }),
    }
}

/// Whether two files are of the same sort by their endings, `.yaml` and `.yml`, say.
pub fn same_sort(a: &str, b: &str) -> bool {
    Sort::by_name(a).is_some_and(|sort| Sort::by_name(b) == Some(sort))
}

/// The name of a file without folders and ending; `.opt.tour` is one ending.
pub fn stem_of(path: &str) -> &str {
    stem(path)
}
