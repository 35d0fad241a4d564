//! The entry of the kind `discs`.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    describe::SceneKind,
    geometry::Bounds,
    kernel::{Backdrop, Error, Plane, SceneBody, SceneKindId, Solution, Verdict, words},
    scene::shipped::shipped,
};

use super::{
    body::{DiscsScene, ID},
    read,
};

/// The kind `discs`: planes with disc obstacles.
pub const KIND: SceneKind = SceneKind {
    id: ID,
    title: words("disc obstacles"),
    read: |fields| Ok(Arc::new(read::read(fields)?)),
    optimum: Some(|scene, _, ends| if ends.is_none() { scene.get::<DiscsScene>().ok()?.shortest() } else { None }),
    shipped: &[
        shipped!("../../../scenes/wcpso-discs.json"),
        shipped!("../../../scenes/discs-gate.json"),
        shipped!("../../../scenes/discs-slalom.json"),
    ],
};

impl SceneBody for DiscsScene {
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
        match solution {
            Solution::Path(path) => self.judge_path(path),
            _ => Verdict::NO_PATH,
        }
    }

    fn view(&self) -> Bounds {
        self.whole()
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        read::write(self, out);
    }

    fn backdrop(&self, draw: &mut dyn FnMut(Backdrop)) {
        draw(Backdrop::Border(self.bounds));
        self.discs.iter().for_each(|&disc| draw(Backdrop::Disc(disc)));
    }

    fn plane(&self) -> Option<&dyn Plane> {
        Some(self)
    }
}

impl Plane for DiscsScene {
    fn ends(&self) -> Result<([f64; 2], [f64; 2]), Error> {
        Ok((self.start, self.goal))
    }

    fn bounds(&self) -> Bounds {
        self.bounds
    }

    #[inline]
    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        self.discs.iter().all(|disc| disc.clearance_of_segment(a, b) >= 0.0)
    }
}
