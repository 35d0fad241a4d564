//! The instances of a folder, and the published optima.

use std::{path::Path, sync::Arc};

use forage::{Error, Registry, kernel::Message, message, scene::TourScene};

use super::super::{
    super::failure::Failure,
    suite::{files_in, read_named},
};

/// The lengths of the shortest tours as TSPLIB publishes them; all are proved.
const PUBLISHED: &str = include_str!("optima.csv");

/// An instance.
pub(super) struct Instance {
    pub name: String,
    pub tour: TourScene,
    /// The published length of the shortest tour; of others, that of the tour in `NAME.opt.tour`.
    pub optimum: Option<f64>,
}

fn published(name: &str) -> Option<f64> {
    PUBLISHED.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(',')?.parse().ok())
}

/// The instances in a folder with at most `largest` stops, by their number of stops, and what there is to say of them.
pub(super) fn instances(registry: &Registry, folder: &Path, largest: Option<usize>) -> Result<(Vec<Arc<Instance>>, Vec<Message>), Failure> {
    let (mut all, mut notes) = (Vec::new(), Vec::new());
    let (mut larger, mut unknown) = (0, Vec::new());
    for path in files_in(folder, "tsp")? {
        let stem = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        // In a folder within the folder by that, too: there may be two of the same name.
        let name = path.strip_prefix(folder).unwrap_or(&path).with_extension("").to_string_lossy().replace('\\', "/");
        let mut files = vec![read_named(&path)?];
        let tour = path.with_extension("opt.tour");
        if tour.exists() {
            files.push(read_named(&tour)?);
        }
        let imported = forage_formats::import(registry, &files, None)?;
        let given = imported.scene.header().exact.as_ref().and_then(|exact| exact.get("length")?.as_f64());
        let tour = imported.scene.get::<TourScene>()?.clone();
        if largest.is_some_and(|most| tour.len() > most) {
            larger += 1;
            continue;
        }
        let optimum = published(&stem).or(given);
        if optimum.is_none() {
            unknown.push(name.clone());
        }
        all.push(Arc::new(Instance { name, tour, optimum }));
    }
    if all.is_empty() {
        let problem = if larger > 0 {
            message!("study-all-larger", "all {larger} instances have more stops", larger)
        } else {
            message!("study-no-tsp", "no .tsp file is in the folder")
        };
        return Err(Error::malformed(&folder.display().to_string(), problem).into());
    }
    if larger > 0 {
        notes.push(message!("study-larger", "{larger} instances with more stops are not run", larger));
    }
    if !unknown.is_empty() {
        notes.push(message!("study-no-optimum", "no optimum is published of {names}", names = unknown.join(", ")));
    }
    all.sort_by(|a, b| a.tour.len().cmp(&b.tour.len()).then_with(|| a.name.cmp(&b.name)));
    Ok((all, notes))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn there_is_an_optimum_of_each_of_the_111_instances() {
        assert_eq!(
            PUBLISHED.lines().skip(1).filter(|line| line.split_once(',').is_some_and(|(_, n)| n.parse::<u64>().is_ok())).count(),
            111
        );
        assert_eq!([published("berlin52"), published("pla85900"), published("berlin5")], [Some(7542.0), Some(142_382_641.0), None]);
    }
}
