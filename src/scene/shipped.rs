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
    use super::*;

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
