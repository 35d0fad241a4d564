//! The scenes that ship, by name.

use std::sync::{Arc, OnceLock};

use crate::error::Error;

use super::Scene;

/// File texts in the order in which the page offers them.
const FILES: &[&str] = &[
    include_str!("../../scenes/wcpso-discs.json"),
    include_str!("../../scenes/discs-gate.json"),
    include_str!("../../scenes/discs-slalom.json"),
    include_str!("../../scenes/qpso-10m.json"),
    include_str!("../../scenes/qpso-10m-empty.json"),
    include_str!("../../scenes/ant-bat-30.json"),
    include_str!("../../scenes/wolf-ant-20.json"),
    include_str!("../../scenes/open-12.json"),
    include_str!("../../scenes/random-52.json"),
    include_str!("../../scenes/clustered-100.json"),
    include_str!("../../scenes/random-280.json"),
    include_str!("../../scenes/sphere.json"),
    include_str!("../../scenes/sphere-4.json"),
    include_str!("../../scenes/rosenbrock.json"),
    include_str!("../../scenes/ackley.json"),
    include_str!("../../scenes/rastrigin.json"),
    include_str!("../../scenes/matyas.json"),
    include_str!("../../scenes/egg-crate.json"),
];

fn all() -> &'static [Arc<Scene>] {
    static SCENES: OnceLock<Vec<Arc<Scene>>> = OnceLock::new();
    // A shipped file that does not parse is caught by the test below, not left out in silence.
    SCENES.get_or_init(|| FILES.iter().filter_map(|text| Scene::from_json(text).ok()).map(Arc::new).collect())
}

/// Every shipped scene, in the order in which they are offered.
pub fn shipped_names() -> impl Iterator<Item = &'static Arc<Scene>> {
    all().iter()
}

/// The shipped scene of this name.
///
/// # Errors
/// [`Error::Unknown`] with the names that exist.
pub fn shipped(name: &str) -> Result<Arc<Scene>, Error> {
    all().iter().find(|scene| scene.name() == name).cloned().ok_or_else(|| Error::unknown("scene", name, all().iter().map(|s| s.name())))
}

#[cfg(test)]
mod tests {
    use crate::{Given, Value, planner::Round, scene::generate::generate};

    use super::*;

    /// Stops are what the command in their source makes, and their optimum is the length of its order.
    #[test]
    fn random_stops_are_made_again_by_their_source_and_their_optimum_is_a_tour() {
        let tours: Vec<_> = all().iter().filter_map(|scene| Some((scene, scene.tour().ok()?))).collect();
        assert_eq!(tours.iter().map(|(_, tour)| tour.len()).collect::<Vec<_>>(), [12, 52, 100, 280]);
        for (scene, tour) in tours {
            let source = scene.header().source.as_deref().unwrap().split(';').next().unwrap();
            let words: Vec<_> = source.strip_prefix("forage generate stops ").unwrap().split(' ').collect();
            let (mut given, mut seed) = (Given::new(), 0);
            for pair in words.chunks(2) {
                match (pair[0], pair[1].split_once('=')) {
                    ("--seed", _) => seed = pair[1].parse().unwrap(),
                    (_, Some((name, value))) => given.insert(name, Value::from(value)),
                    _ => panic!("{source}"),
                }
            }
            let made = generate("stops", &given, seed).unwrap();
            let made = made.tour().unwrap();
            assert_eq!((&made.points, made.metric), (&tour.points, tour.metric), "{}", scene.name());
            if let Some(exact) = &scene.header().exact {
                let found = scene.exact_tour(crate::planner::Yardstick::default(), Round::Closed).unwrap();
                assert_eq!((found.order.len(), Some(found.length)), (tour.len(), exact["length"].as_f64()), "{}", scene.name());
            }
        }
    }

    #[test]
    fn every_file_parses_survives_a_round_trip_and_has_a_name_of_its_own() {
        for text in FILES {
            let scene = Scene::from_json(text).unwrap();
            assert_eq!(Scene::from_json(&scene.to_json()).unwrap(), scene);
        }
        let mut names: Vec<_> = all().iter().map(|s| s.name()).collect();
        names.sort_unstable();
        names.dedup();
        assert_eq!(names.len(), FILES.len());
    }
}
