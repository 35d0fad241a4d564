//! The entry of the kind `tour`.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    describe::SceneKind,
    geometry::Bounds,
    kernel::{Error, SceneBody, SceneKindId, Solution, Stops, Verdict, words},
    scene::shipped::shipped,
};

use super::{
    body::{ID, TourScene},
    read,
};

/// The kind `tour`: stops with their distances.
pub const KIND: SceneKind = SceneKind {
    id: ID,
    title: words("stops of a tour"),
    read: |fields| Ok(Arc::new(read::read(fields)?)),
    optimum: Some(|scene, _, ends| scene.get::<TourScene>().ok()?.shortest_tour(ends?, scene.header().exact.as_ref())),
    shipped: &[
        shipped!("../../../scenes/open-12.json"),
        shipped!("../../../scenes/random-52.json"),
        shipped!("../../../scenes/clustered-100.json"),
        shipped!("../../../scenes/random-280.json"),
    ],
};

impl SceneBody for TourScene {
    fn kind_id() -> SceneKindId {
        ID
    }

    fn kind(&self) -> SceneKindId {
        ID
    }

    fn check(&self, stored: Option<&Value>) -> Result<(), Error> {
        self.check_fields(stored)
    }

    fn judge(&self, solution: &Solution) -> Verdict {
        self.judge_solution(solution)
    }

    fn view(&self) -> Bounds {
        self.surroundings()
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        read::write(self, out);
    }

    fn stops(&self) -> Stops {
        Stops { field: if self.matrix.is_some() { "matrix" } else { "points" }, places: self.places() }
    }
}
