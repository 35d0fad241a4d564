//! The entry of the kind `function`.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    describe::SceneKind,
    geometry::Bounds,
    kernel::{Error, SceneBody, SceneKindId, Solution, Verdict, words},
};

use super::{
    body::{FunctionScene, ID},
    read,
};

/// The kind `function`: test functions to minimise.
pub const KIND: SceneKind = SceneKind {
    id: ID,
    title: words("test functions"),
    read: |fields| Ok(Arc::new(read::read(fields)?)),
    optimum: None,
    shipped: &[
        include_str!("../../../scenes/sphere.json"),
        include_str!("../../../scenes/sphere-2.json"),
        include_str!("../../../scenes/sphere-4.json"),
        include_str!("../../../scenes/rosenbrock.json"),
        include_str!("../../../scenes/rosenbrock-2.json"),
        include_str!("../../../scenes/ackley.json"),
        include_str!("../../../scenes/ackley-2.json"),
        include_str!("../../../scenes/rastrigin.json"),
        include_str!("../../../scenes/matyas.json"),
        include_str!("../../../scenes/egg-crate.json"),
    ],
};

impl SceneBody for FunctionScene {
    fn kind_id() -> SceneKindId {
        ID
    }

    fn kind(&self) -> SceneKindId {
        ID
    }

    fn check(&self, _stored: Option<&Value>) -> Result<(), Error> {
        self.check_fields()
    }

    fn judge(&self, _solution: &Solution) -> Verdict {
        Verdict::NO_PATH
    }

    fn view(&self) -> Bounds {
        self.search_box()
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        read::write(self, out);
    }

    fn minimum(&self) -> Option<f64> {
        Some(0.0)
    }
}
