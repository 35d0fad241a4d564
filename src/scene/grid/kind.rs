//! The entry of the kind `grid`.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    describe::SceneKind,
    geometry::{Bounds, Field, ObstacleField, YAxis},
    kernel::{Backdrop, Error, Exact, Plane, ReferenceOptimum, Scene, SceneBody, SceneKindId, Solution, Stops, TourEnds, Verdict, words},
    math::clamp,
    scene::shipped::shipped,
};

use super::{
    body::{GridScene, ID},
    read,
};

/// The kind `grid`: free and blocked cells.
pub const KIND: SceneKind = SceneKind {
    id: ID,
    title: words("grids"),
    read: |fields| Ok(Arc::new(read::read(fields)?)),
    optimum: Some(optimum),
    shipped: &[
        shipped!("../../../scenes/qpso-10m.json"),
        shipped!("../../../scenes/qpso-10m-empty.json"),
        shipped!("../../../scenes/ant-bat-30.json"),
        shipped!("../../../scenes/wolf-ant-20.json"),
        shipped!("../../../scenes/rooms-20.json"),
        shipped!("../../../scenes/crossing.json"),
        shipped!("../../../scenes/patrol.json"),
        shipped!("../../../scenes/corridor.json"),
    ],
};

fn optimum(scene: &Scene, reference: ReferenceOptimum, ends: Option<TourEnds>) -> Option<Exact> {
    let grid = scene.get::<GridScene>().ok()?;
    match (ends, reference) {
        (Some(ends), _) => grid.shortest_tour(reference, ends),
        (None, ReferenceOptimum::Cells) => grid.shortest_over_cells(),
        (None, _) => grid.shortest(),
    }
}

impl SceneBody for GridScene {
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
            Solution::Tour { order, ends, path } => self.judge_tour(order, *ends, path),
            Solution::Drive(track) => self.judge_drive(track),
            _ => Verdict::NO_PATH,
        }
    }

    fn view(&self) -> Bounds {
        self.bounds()
    }

    fn write(&self, out: &mut Vec<(&'static str, Value)>) {
        read::write(self, out);
    }

    fn backdrop(&self, draw: &mut dyn FnMut(Backdrop)) {
        let (blocks, bounds) = (self.field().blocks(), self.bounds());
        if self.radius() > 0.0 {
            blocks.iter().for_each(|block| draw(Backdrop::Margin(Bounds { min: block.min, max: block.max }, self.radius())));
        }
        for block in blocks {
            let inside = |corner: [f64; 2]| [0, 1].map(|axis| clamp(corner[axis], 0.0, bounds.max[axis]));
            draw(Backdrop::Cells(Bounds { min: inside(block.min), max: inside(block.max) }));
        }
        draw(Backdrop::Border(bounds));
    }

    fn plane(&self) -> Option<&dyn Plane> {
        Some(self)
    }

    fn stops(&self) -> Stops {
        Stops { field: "stops", places: self.stops.clone() }
    }

    fn between(&self, ends: [[f64; 2]; 2]) -> Result<Arc<dyn SceneBody>, Error> {
        Ok(Arc::new(self.with_ends(ends)))
    }
}

impl Plane for GridScene {
    fn ends(&self) -> Result<([f64; 2], [f64; 2]), Error> {
        Self::ends(self)
    }

    fn bounds(&self) -> Bounds {
        Self::bounds(self)
    }

    #[inline]
    fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> bool {
        self.field().is_free(a, b)
    }

    fn obstacle_field(&self) -> Option<Arc<dyn ObstacleField>> {
        Some(Arc::<Field>::clone(self.field()))
    }

    fn y_axis(&self) -> YAxis {
        self.y_axis
    }
}
