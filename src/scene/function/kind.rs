//! The entry of the kind `function`.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    describe::SceneKind,
    geometry::Bounds,
    kernel::{Error, Minimum, SceneBody, SceneKindId, Solution, Verdict, words},
    scene::shipped::shipped,
};

use super::{
    bbob,
    body::{FunctionScene, ID, Source},
    formula, read,
};

/// The kind `function`: functions to minimise, by name, by formula, and those of the suite `bbob`.
pub const KIND: SceneKind = SceneKind {
    read: |fields| {
        Ok(Arc::new(if fields.has(read::EXPRESSION) {
            formula::read(fields)?
        } else if read::is_of_suite(fields) {
            bbob::read(fields)?
        } else {
            read::read(fields)?
        }))
    },
    ..NAMED
};

/// The same without functions by formula and those of suites, for a build that leaves them out or loads them later: a scene with one of
/// them is refused for the tool `formulas`.
pub const NAMED: SceneKind = SceneKind {
    id: ID,
    title: words("test functions"),
    read: |fields| Ok(Arc::new(read::read(fields)?)),
    optimum: None,
    shipped: &[
        shipped!("../../../scenes/sphere.json"),
        shipped!("../../../scenes/sphere-2.json"),
        shipped!("../../../scenes/sphere-4.json"),
        shipped!("../../../scenes/rosenbrock.json"),
        shipped!("../../../scenes/rosenbrock-2.json"),
        shipped!("../../../scenes/ackley.json"),
        shipped!("../../../scenes/ackley-2.json"),
        shipped!("../../../scenes/rastrigin.json"),
        shipped!("../../../scenes/matyas.json"),
        shipped!("../../../scenes/egg-crate.json"),
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
        FunctionScene::view(self)
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        match &self.source {
            Source::Named(named) => named.write(out),
            Source::Written { fields, .. } => out.extend(fields.iter().cloned()),
        }
    }

    fn is_code(&self) -> bool {
        matches!(self.source, Source::Written { code: true, .. })
    }

    fn minimum(&self) -> Option<Minimum> {
        FunctionScene::minimum(self)
    }
}
