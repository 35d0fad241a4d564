//! What a tree grows through: a plane with discs or blocked cells, the workspace of an arm's tip, or an arm's joints.

use std::sync::Arc;

use crate::{
    arm::{self, ArmScene},
    geometry::Cuboid,
    kernel::{Error, Plane, Scene, Solution},
    scene::{ARM, DISCS, DiscsScene, GRID, GridScene},
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

/// The space of a scene with start and goal; an arm's tip keeps so much away from obstacles.
///
/// # Errors
/// [`Error::Refused`] for a scene without.
pub(super) fn of_scene(scene: &Scene, margin: f64) -> Result<Arc<dyn Space<3>>, Error> {
    Ok(match scene.kind() {
        DISCS => {
            let plane = scene.share::<DiscsScene>()?;
            Arc::new(Flat { extent: Extent::of(&*plane, 1.0)?, plane })
        }
        GRID => {
            let plane = scene.share::<GridScene>()?;
            Arc::new(Flat { extent: Extent::of(&*plane, plane.cell)?, plane })
        }
        ARM => Arc::new(Workspace::new(scene.share()?, margin)),
        other => return Err(Error::refused("kind", other.name(), "discs, grid or arm")),
    })
}

/// A plane with obstacles, without extent in z.
struct Flat<P> {
    plane: Arc<P>,
    extent: Extent,
}

/// Where paths through a plane lead, apart from its obstacles.
struct Extent {
    min: [f64; 3],
    max: [f64; 3],
    start: [f64; 3],
    goal: [[f64; 3]; 1],
    /// What a length of 1 is in the scene's unit for the planner's parameters: a cell's side on grids.
    unit: f64,
}

impl Extent {
    fn of(plane: &dyn Plane, unit: f64) -> Result<Self, Error> {
        let flat = |[x, y]: [f64; 2]| [x, y, 0.0];
        let ((start, goal), bounds) = (plane.ends()?, plane.bounds());
        Ok(Self { min: flat(bounds.min), max: flat(bounds.max), start: flat(start), goal: [flat(goal)], unit })
    }
}

impl<P: Plane> Space<3> for Flat<P> {
    fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        (self.extent.min, self.extent.max)
    }

    fn dimensions(&self) -> usize {
        2
    }

    fn start(&self) -> [f64; 3] {
        self.extent.start
    }

    fn goals(&self) -> &[[f64; 3]] {
        &self.extent.goal
    }

    #[inline]
    fn is_free(&self, a: &[f64; 3], b: &[f64; 3]) -> bool {
        let Extent { min, max, .. } = &self.extent;
        (0..3).all(|i| min[i] <= b[i] && b[i] <= max[i]) && self.plane.is_free([a[0], a[1]], [b[0], b[1]])
    }

    fn place(&self, point: &[f64; 3]) -> [f64; 3] {
        *point
    }

    fn solution(&self, path: &[[f64; 3]]) -> Solution {
        Solution::Path(path.iter().map(|&[x, y, _]| [x, y]).collect())
    }

    fn unit(&self) -> f64 {
        self.extent.unit
    }
}

/// The workspace of an arm's tip.
struct Workspace {
    arm: Arc<ArmScene>,
    goal: [[f64; 3]; 1],
    /// What the tip keeps away from, and how far: each cuboid, grown by that, its own corners sharp.
    margin: f64,
    grown: Vec<Cuboid>,
}

/// How far a point is from an obstacle.
pub(super) fn room(point: [f64; 3], (axis, radius): (Cuboid, f64)) -> f64 {
    axis.distance_squared(point, point).sqrt() - radius
}

impl Workspace {
    fn new(arm: Arc<ArmScene>, margin: f64) -> Self {
        // Start and goal are free, however near: half of their room is left.
        let rooms = [arm.start, arm.goal].into_iter().flat_map(|end| arm.obstacles().map(move |obstacle| room(end, obstacle)));
        let margin = rooms.fold(margin, |margin, room| margin.min(room / 2.0));
        let grown = |cuboid: &Cuboid| Cuboid { min: cuboid.min.map(|x| x - margin), max: cuboid.max.map(|x| x + margin) };
        Self { goal: [arm.goal], margin, grown: arm.cuboids.iter().map(grown).collect(), arm }
    }
}

impl Space<3> for Workspace {
    fn bounds(&self) -> ([f64; 3], [f64; 3]) {
        (self.arm.workspace.min, self.arm.workspace.max)
    }

    fn start(&self) -> [f64; 3] {
        self.arm.start
    }

    fn goals(&self) -> &[[f64; 3]] {
        &self.goal
    }

    #[inline]
    fn is_free(&self, a: &[f64; 3], b: &[f64; 3]) -> bool {
        let arm = &*self.arm;
        if !arm.workspace.contains(*b) {
            return false;
        }
        // Most pieces are nowhere near.
        let near = |(cuboid, grown): (&Cuboid, &Cuboid)| grown.meets(*a, *b) && cuboid.is_within(self.margin, *a, *b);
        let touches = arm.cuboids.iter().zip(&self.grown).any(near);
        !touches && arm::column(arm).is_none_or(|column| !column.axis.is_within(column.radius + self.margin, *a, *b))
    }

    fn place(&self, point: &[f64; 3]) -> [f64; 3] {
        *point
    }

    fn solution(&self, path: &[[f64; 3]]) -> Solution {
        Solution::Reach { path: path.to_vec(), postures: Vec::new() }
    }
}
