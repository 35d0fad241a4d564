//! What a tree grows through: a plane with discs or blocked cells, the workspace of an arm's tip, or an arm's joints.

use std::sync::Arc;

use crate::{
    arm,
    geometry::Cuboid,
    kernel::{Error, Solution},
    scene::{Body, Scene},
};

/// A box in N dimensions with obstacles. Points lie in it.
pub(super) trait Space<const N: usize>: Send + Sync {
    /// Smallest and largest coordinates.
    fn bounds(&self) -> ([f64; N], [f64; N]);
    /// In how many dimensions it has an extent.
    fn dimensions(&self) -> usize {
        N
    }
    /// Where the tree starts.
    fn start(&self) -> [f64; N];
    /// Where it must come to: any of these.
    fn goals(&self) -> &[[f64; N]];
    /// Whether one can go straight from one point to another.
    fn is_free(&self, a: &[f64; N], b: &[f64; N]) -> bool;
    /// Where a point is drawn.
    fn place(&self, point: &[f64; N]) -> [f64; 3];
    /// A path as it is judged.
    fn solution(&self, path: &[[f64; N]]) -> Solution;
    /// Whether straight pieces are curves where they are drawn.
    fn curves(&self) -> bool {
        false
    }
    /// Whether the coordinates of the nodes are told, in degrees.
    fn has_members(&self) -> bool {
        false
    }
    /// What a length of 1 among the parameters is in the space's unit.
    fn unit(&self) -> f64 {
        1.0
    }
}

/// The plane of a scene with discs or cells, without extent in z, and the workspace of an arm's tip.
pub(super) struct Ground {
    scene: Arc<Scene>,
    min: [f64; 3],
    max: [f64; 3],
    start: [f64; 3],
    goal: [[f64; 3]; 1],
    /// What a length of 1 is in the scene's unit for the planner's parameters: a cell's side on grids.
    unit: f64,
    /// What the tip of an arm must keep away from, and how far: each cuboid, grown by that, its own corners sharp.
    margin: f64,
    grown: Vec<Cuboid>,
}

/// How far a point is from an obstacle.
pub(super) fn room(point: [f64; 3], (axis, radius): (Cuboid, f64)) -> f64 {
    axis.distance_squared(point, point).sqrt() - radius
}

impl Ground {
    /// Of a scene with start and goal; an arm's tip keeps so much away from obstacles.
    ///
    /// # Errors
    /// [`Error::Refused`] for a scene without.
    pub(super) fn new(scene: &Arc<Scene>, margin: f64) -> Result<Self, Error> {
        let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
        let (min, max, start, goal, unit) = match scene.body() {
            Body::Discs(discs) => (flat(discs.bounds.min), flat(discs.bounds.max), flat(discs.start), flat(discs.goal), 1.0),
            Body::Grid(grid) => {
                let ((start, goal), bounds) = (grid.ends()?, grid.bounds());
                (flat(bounds.min), flat(bounds.max), flat(start), flat(goal), grid.cell)
            }
            Body::Arm(arm) => (arm.workspace.min, arm.workspace.max, arm.start, arm.goal, 1.0),
            Body::Function(_) | Body::Tour(_) => return Err(Error::refused("kind", scene.kind().name(), "discs, grid or arm")),
        };
        let (mut kept, mut grown) = (0.0, Vec::new());
        if let Ok(arm) = scene.arm() {
            // Start and goal are free, however near: half of their room is left.
            let rooms = [start, goal].into_iter().flat_map(|end| arm.obstacles().map(move |obstacle| room(end, obstacle)));
            kept = rooms.fold(margin, |margin, room| margin.min(room / 2.0));
            grown =
                arm.cuboids.iter().map(|cuboid| Cuboid { min: cuboid.min.map(|x| x - kept), max: cuboid.max.map(|x| x + kept) }).collect();
        }
        Ok(Self { scene: Arc::clone(scene), min, max, start, goal: [goal], unit, margin: kept, grown })
    }
}

impl Space<3> for Ground {
    fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        (self.min, self.max)
    }

    fn dimensions(&self) -> usize {
        if matches!(self.scene.body(), Body::Arm(_)) { 3 } else { 2 }
    }

    fn start(&self) -> [f64; 3] {
        self.start
    }

    fn goals(&self) -> &[[f64; 3]] {
        &self.goal
    }

    #[inline]
    fn is_free(&self, a: &[f64; 3], b: &[f64; 3]) -> bool {
        if !(0..3).all(|i| self.min[i] <= b[i] && b[i] <= self.max[i]) {
            return false;
        }
        match self.scene.body() {
            Body::Arm(arm) => {
                // Most pieces are nowhere near.
                let near = |(cuboid, grown): (&Cuboid, &Cuboid)| grown.meets(*a, *b) && cuboid.is_within(self.margin, *a, *b);
                let touches = arm.cuboids.iter().zip(&self.grown).any(near);
                !touches && arm::column(arm).is_none_or(|column| !column.axis.is_within(column.radius + self.margin, *a, *b))
            }
            _ => self.scene.is_free([a[0], a[1]], [b[0], b[1]]),
        }
    }

    fn place(&self, point: &[f64; 3]) -> [f64; 3] {
        *point
    }

    fn solution(&self, path: &[[f64; 3]]) -> Solution {
        match self.scene.body() {
            Body::Arm(_) => Solution::Reach { path: path.to_vec(), postures: Vec::new() },
            _ => Solution::Path(path.iter().map(|&[x, y, _]| [x, y]).collect()),
        }
    }

    fn unit(&self) -> f64 {
        self.unit
    }
}
