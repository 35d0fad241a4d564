//! How a position stands for a path, and how a swarm starts on a scene.

use std::sync::Arc;

use crate::{
    describe::Start,
    kernel::{Error, Message, Started},
    params::Parameters,
    scene::{DiscsScene, FunctionScene, Scene},
};

use super::{
    objective::Objective,
    paths::{ENCODING, Encoding},
    polar::Polar,
    terrain::Terrain,
    waypoints::Waypoints,
};

/// Starts a swarm on whatever kind of scene it is given: `on` starts it on an objective.
///
/// # Errors
/// As [`objective`].
pub(super) fn start(start: &Start, on: fn(Arc<dyn Objective>, &Parameters, u64) -> Started) -> Result<Started, Error> {
    Ok(on(objective(start.scene, start.parameters)?, start.parameters, start.seed))
}

/// What a swarm minimises on this scene. This is where a position's meaning is chosen; what moves the particles does
/// not know it.
///
/// # Errors
/// A grid without start and goal.
pub(super) fn objective(scene: &Scene, settings: &Parameters) -> Result<Arc<dyn Objective>, Error> {
    if let Ok(function) = scene.get::<FunctionScene>() {
        return Ok(Arc::clone(function.objective()));
    }
    let terrain = if let Ok(discs) = scene.get::<DiscsScene>() {
        Terrain::among_discs(discs, settings)
    } else if let Some((field, plane)) = scene.plane().and_then(|plane| plane.obstacle_field().zip(Some(plane))) {
        Terrain::among(field, plane, settings)?
    } else {
        // The entries say that swarms do not run there.
        return Err(Error::refused("kind", scene.kind().name(), Message::verbatim("function, discs, grid")));
    };
    Ok(match settings[ENCODING] {
        Encoding::Waypoints => Arc::new(Waypoints::new(terrain, settings)),
        Encoding::Polar => Arc::new(Polar::new(terrain, settings)),
    })
}
