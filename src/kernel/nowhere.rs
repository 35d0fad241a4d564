//! A scene without anything in it.

use std::sync::Arc;

use serde_json::Value;

use crate::geometry::{Bounds, length};

use super::{Error, Header, Scene, SceneBody, SceneKindId, Solution, Verdict};

/// The kind of [`Scene::nowhere`]; no file has it.
const ID: SceneKindId = SceneKindId("nowhere");

/// Nothing is in the way.
struct Nowhere;

impl SceneBody for Nowhere {
    fn kind_id() -> SceneKindId {
        ID
    }

    fn kind(&self) -> SceneKindId {
        ID
    }

    fn check(&self, _stored: Option<&Value>) -> Result<(), Error> {
        Ok(())
    }

    fn judge(&self, solution: &Solution) -> Verdict {
        Verdict { length: solution.path().map(length), ..Verdict::NO_PATH }
    }

    fn view(&self) -> Bounds {
        Bounds { min: [0.0; 2], max: [1.0; 2] }
    }

    fn write(&self, _out: &mut Vec<(&'static str, Value)>) {}
}

impl Scene {
    /// A scene without anything in it, for planners that know by themselves where they plan: paths are as long as they are,
    /// and every result is feasible.
    pub fn nowhere() -> Self {
        let header = Header {
            name: ID.name().to_owned(),
            title: "Nothing".to_owned(),
            note: None,
            source: None,
            units: None,
            exact: None,
            published: None,
        };
        Self::unchecked(header, Arc::new(Nowhere), None)
    }
}
