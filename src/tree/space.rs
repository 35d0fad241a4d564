//! What a tree grows through: a plane with discs or blocked cells, the workspace of an arm's tip, or what somebody brings.

use std::sync::Arc;

use crate::{
    arm::{self, ArmScene, Posture},
    describe::Start,
    geometry::Cuboid,
    kernel::{Digest, Error, Plane, Scene, Solution, Started, State},
    message,
    params::Parameters,
    scene::{ARM, DISCS, DiscsScene, GRID, GridScene},
};

use super::{
    parameters::{MARGIN, REACHABLE},
    postures::ArmMotion,
};

/// The posture at each of several points, or none at all: that adds nothing to a run's hash.
#[derive(Debug, Clone, Default)]
pub(super) struct Postures(pub(super) Vec<Posture>);

impl State for Postures {
    fn digest(&self, out: &mut Digest) {
        if !self.0.is_empty() {
            self.0.digest(out);
        }
    }

    fn heap_size(&self) -> usize {
        self.0.heap_size()
    }
}

/// A box in N dimensions with obstacles, a start and goals. All of it stays the same while a tree grows.
pub trait Space<const N: usize>: Send + Sync {
    /// Smallest and largest coordinates. Nodes lie between them.
    fn bounds(&self) -> ([f64; N], [f64; N]);
    /// Where the tree starts.
    fn start(&self) -> [f64; N];
    /// Where it must come to: one at least. `rrt-connect` goes to any of them, the others to the first.
    fn goals(&self) -> &[[f64; N]];
    /// Whether one can go straight from `a`, which is free, to `b`. Called in the inner loop.
    fn is_free(&self, a: &[f64; N], b: &[f64; N]) -> bool;
    /// The postures at the start and at the goals; `None` where nodes have none: not for an arm, or only for its tip.
    fn end_postures(&self) -> Option<[Posture; 2]> {
        None
    }
    /// The posture at `b` of an arm that goes straight there from `a`, where it is `from`; `None` where it cannot. With `to` it is that
    /// at `b`, and both may be means of other points' postures: then they count as what is nearest to them. Called where
    /// [`is_free`](Self::is_free), if nodes have postures.
    fn posture_at(&self, a: &[f64; N], from: &Posture, b: &[f64; N], to: Option<&Posture>) -> Option<Posture> {
        let _ = (a, b, to);
        Some(*from)
    }
    /// In how many of the first dimensions it has an extent: 1 to N. In the others all coordinates are the same.
    fn dimensions(&self) -> usize {
        N
    }
    /// Where a point is drawn: its first three coordinates.
    fn place(&self, point: &[f64; N]) -> [f64; 3] {
        std::array::from_fn(|i| if i < N { point[i] } else { 0.0 })
    }
    /// A path as it is judged: in the plane for up to two dimensions, otherwise the places in space.
    fn solution(&self, path: &[[f64; N]]) -> Solution {
        let places = path.iter().map(|point| self.place(point));
        if N <= 2 {
            Solution::Path(places.map(|[x, y, _]| [x, y]).collect())
        } else {
            Solution::Reach { path: places.collect(), postures: Vec::new() }
        }
    }
    /// Whether straight pieces are curves where they are drawn.
    fn curves(&self) -> bool {
        false
    }
    /// Whether explanations list the coordinates of the nodes, in degrees.
    fn has_members(&self) -> bool {
        false
    }
    /// What a length of 1 among the parameters is in the space's unit; above 0.
    fn unit(&self) -> f64 {
        1.0
    }
}

/// What starts a planner in a space.
type On = fn(Arc<dyn Space<3>>, &Parameters, u64) -> Result<Started, Error>;

/// Starts a planner in whatever kind of scene it is given.
///
/// # Errors
/// As [`of_scene`].
pub(super) fn start(start: &Start, on: On) -> Result<Started, Error> {
    on(of_scene(start.scene, start.parameters[MARGIN], start.parameters[REACHABLE])?, start.parameters, start.seed)
}

/// The space of a scene with start and goal; an arm's tip keeps so much away from obstacles, and `reachable` asks whether the arm can go
/// along.
///
/// # Errors
/// [`Error::Refused`] for a scene without.
pub(super) fn of_scene(scene: &Scene, margin: f64, reachable: bool) -> Result<Arc<dyn Space<3>>, Error> {
    Ok(match scene.kind() {
        DISCS => {
            let plane = scene.share::<DiscsScene>()?;
            Arc::new(Flat { extent: Extent::of(&*plane, 1.0)?, plane })
        }
        GRID => {
            let plane = scene.share::<GridScene>()?;
            Arc::new(Flat { extent: Extent::of(&*plane, plane.cell)?, plane })
        }
        ARM => Arc::new(Workspace::new(scene.share()?, margin, reachable)?),
        other => return Err(Error::refused("kind", other.name(), message!("tree-kinds", "discs, grid or arm"))),
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
    /// The arm that goes along.
    motion: Option<ArmMotion>,
}

/// How far a point is from an obstacle.
pub(super) fn room(point: [f64; 3], (axis, radius): (Cuboid, f64)) -> f64 {
    axis.distance_squared(point, point).sqrt() - radius
}

impl Workspace {
    fn new(arm: Arc<ArmScene>, margin: f64, reachable: bool) -> Result<Self, Error> {
        // Start and goal are free, however near: half of their room is left.
        let rooms = [arm.start, arm.goal].into_iter().flat_map(|end| arm.obstacles().map(move |obstacle| room(end, obstacle)));
        let margin = rooms.fold(margin, |margin, room| margin.min(room / 2.0));
        let grown = |cuboid: &Cuboid| Cuboid { min: cuboid.min.map(|x| x - margin), max: cuboid.max.map(|x| x + margin) };
        Ok(Self {
            goal: [arm.goal],
            margin,
            grown: arm.cuboids.iter().map(grown).collect(),
            motion: if reachable { Some(ArmMotion::new(&arm)?) } else { None },
            arm,
        })
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

    fn end_postures(&self) -> Option<[Posture; 2]> {
        self.motion.as_ref().map(ArmMotion::ends)
    }

    fn posture_at(&self, a: &[f64; 3], from: &Posture, b: &[f64; 3], to: Option<&Posture>) -> Option<Posture> {
        self.motion.as_ref()?.posture_at(a, from, b, to)
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
}
