//! Finding the files of a folder, and reading maps when they are needed.

use std::{
    collections::{BTreeMap, VecDeque},
    path::{Path, PathBuf},
    sync::{Arc, Mutex, PoisonError},
};

use forage::{Error, kernel::Message, message, scene::GridScene};
use forage_formats::{
    NamedFile,
    movingai::{self, Problem},
};

use super::super::{
    super::failure::Failure,
    suite::{files_in, read_named},
};

/// So many maps are in memory at once: problems of one map are run one after the other.
const KEPT: usize = 4;

/// The problems of a `.scen` file that can be run.
pub(super) struct Scenario {
    /// The file's name within the folder.
    pub name: String,
    /// Its map, by the place in the list.
    pub map: usize,
    /// How many cells the map has.
    pub cells: u64,
    /// Their numbers in the file, from 0.
    pub problems: Vec<(usize, Problem)>,
}

/// All that is in a folder.
pub(super) struct ScenarioFolder {
    pub scenarios: Vec<Scenario>,
    /// What is not run, and why.
    pub notes: Vec<Message>,
    maps: Vec<PathBuf>,
    /// Those that were needed last.
    recent: Mutex<VecDeque<(usize, Arc<GridScene>)>>,
}

fn map(path: &Path) -> Result<GridScene, Failure> {
    Ok(movingai::read_map(&read_named(path)?, &mut Vec::new())?)
}

/// The map of this name: next to the file, or wherever it is in the folder.
fn find<'a>(name: &str, scen: &Path, maps: &'a [PathBuf]) -> Option<&'a PathBuf> {
    let name = &name.replace('\\', "/");
    let file = Path::new(name).file_name()?;
    let mut same = maps.iter().filter(|path| path.file_name() == Some(file));
    let beside = same.clone().find(|path| path.parent() == scen.parent());
    // Of several the one whose folders have the name's last ones.
    beside.or_else(|| same.clone().find(|path| path.ends_with(name))).or_else(|| same.next())
}

impl ScenarioFolder {
    pub(super) fn read(folder: &Path) -> Result<Self, Failure> {
        let (scens, maps) = (files_in(folder, "scen")?, files_in(folder, "map")?);
        let mut found = Self { scenarios: Vec::new(), notes: Vec::new(), maps, recent: Mutex::default() };
        let mut by_map: BTreeMap<usize, Vec<(String, NamedFile)>> = BTreeMap::new();
        for path in &scens {
            let file = read_named(path)?;
            let name = path.strip_prefix(folder).unwrap_or(path).to_string_lossy().replace('\\', "/");
            let named = movingai::map_of(&file)?.to_owned();
            match find(&named, path, &found.maps).and_then(|map| found.maps.iter().position(|one| one == map)) {
                Some(map) => by_map.entry(map).or_default().push((name, file)),
                None => {
                    found.notes.push(message!("study-map-missing", "{name} is not run: its map {named} is not in the folder", name, named));
                }
            }
        }
        for (index, files) in by_map {
            let map = map(&found.maps[index])?;
            for (name, file) in files {
                let scenario = found.scenario(&map, index, name, &file)?;
                found.scenarios.push(scenario);
            }
        }
        found.scenarios.sort_by(|a, b| a.name.cmp(&b.name));
        if found.scenarios.iter().all(|scenario| scenario.problems.is_empty()) {
            let problem = match found.notes.first() {
                None => message!("study-no-scen", "no .scen file is in the folder"),
                Some(first) => message!("study-no-problem", "no problem can be run: {first}", first),
            };
            return Err(Error::malformed(&folder.display().to_string(), problem).into());
        }
        Ok(found)
    }

    /// The problems of a file. Those that begin or end in a blocked cell, or where they begin, are noted.
    fn scenario(&mut self, map: &GridScene, index: usize, name: String, file: &NamedFile) -> Result<Scenario, Failure> {
        let (lines, _) = movingai::read_scen(file, [map.columns, map.rows()])?;
        let all = lines.len();
        let is_blocked = |[x, y]: [f64; 2]| map.blocked[y as usize * map.columns + x as usize];
        let can_be_run = |problem: &Problem| !is_blocked(problem.start) && !is_blocked(problem.goal) && problem.start != problem.goal;
        let problems: Vec<_> = lines.into_iter().map(|(_, problem)| problem).enumerate().filter(|(_, p)| can_be_run(p)).collect();
        let left = all - problems.len();
        if left > 0 {
            self.notes.push(message!(
                "study-problems-not-run",
                "{left} of {all} problems of {name} are not run: they begin or end in blocked cells (W is one), or start and goal are the same cell",
                left,
                all,
                name
            ));
        }
        Ok(Scenario { name, map: index, cells: map.blocked.len() as u64, problems })
    }

    /// A map.
    pub(super) fn map(&self, index: usize) -> Result<Arc<GridScene>, Error> {
        let known = |recent: &VecDeque<(usize, Arc<GridScene>)>| recent.iter().find(|(at, _)| *at == index).map(|(_, map)| Arc::clone(map));
        if let Some(map) = known(&self.recent.lock().unwrap_or_else(PoisonError::into_inner)) {
            return Ok(map);
        }
        let path = &self.maps[index];
        let refused = |failure: Failure| match failure {
            Failure::Refused(error) => error,
            other => Error::malformed(&path.display().to_string(), other.message()),
        };
        let map = Arc::new(map(path).map_err(refused)?);
        // What follows from the cells is made here, and not in the time of the run that needs it first.
        let _ = (map.field(), map.cells());
        let mut recent = self.recent.lock().unwrap_or_else(PoisonError::into_inner);
        recent.push_back((index, Arc::clone(&map)));
        if recent.len() > KEPT {
            recent.pop_front();
        }
        Ok(map)
    }
}
