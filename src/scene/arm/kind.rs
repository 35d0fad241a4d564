//! The entry of the kind `arm`.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    arm::ArmScene,
    describe::SceneKind,
    geometry::Bounds,
    kernel::{Backdrop, Error, SceneBody, SceneKindId, Solution, Verdict, words},
    scene::shipped::shipped,
};

use super::{body::ID, read};

/// The kind `arm`: six-axis arms among cuboids.
pub const KIND: SceneKind = SceneKind {
    id: ID,
    title: words("arms"),
    read: |fields| Ok(Arc::new(read::read(fields)?)),
    optimum: Some(|scene, _, ends| match ends {
        None => scene.get::<ArmScene>().ok()?.shortest(scene.header().exact.as_ref()),
        Some(_) => None,
    }),
    shipped: &[
        shipped!("../../../scenes/arm-cuboid.json"),
        shipped!("../../../scenes/arm-free.json"),
        shipped!("../../../scenes/arm-bench.json"),
        shipped!("../../../scenes/arm-puma.json"),
    ],
};

impl SceneBody for ArmScene {
    fn kind_id() -> SceneKindId {
        ID
    }

    fn kind(&self) -> SceneKindId {
        ID
    }

    fn check(&self, _stored: Option<&Value>) -> Result<(), Error> {
        self.check_fields()
    }

    fn judge(&self, solution: &Solution) -> Verdict {
        self.judge_solution(solution)
    }

    fn view(&self) -> Bounds {
        flat(self.workspace.min, self.workspace.max)
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        read::write(self, out);
    }

    fn backdrop(&self, draw: &mut dyn FnMut(Backdrop)) {
        self.cuboids.iter().for_each(|cuboid| draw(Backdrop::Block(flat(cuboid.min, cuboid.max))));
        draw(Backdrop::Border(self.view()));
    }
}

/// Seen from above.
fn flat([min_x, min_y, _]: [f64; 3], [max_x, max_y, _]: [f64; 3]) -> Bounds {
    Bounds { min: [min_x, min_y], max: [max_x, max_y] }
}
