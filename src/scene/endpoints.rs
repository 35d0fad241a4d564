//! The cells of a grid, and those of its ends, for planners that go from cell to cell.

use crate::{
    geometry::{Cells, Endpoints, Plan},
    kernel::{Error, digits::coordinates},
    message,
};

use super::GridScene;

impl GridScene {
    /// The cells with the steps between them, as its robot can take them.
    pub(super) fn new_cells(&self) -> Cells {
        let Self { cell, columns, blocked, corner_cutting, y_axis, .. } = self;
        let plan = Plan { side: *cell, columns: *columns, blocked, corner_cutting: *corner_cutting, y_axis: *y_axis };
        Cells::new(&plan, (self.radius() > 0.0).then(|| &**self.field()))
    }

    /// The cells of start and goal.
    ///
    /// # Errors
    /// [`Error::Refused`] if the grid has no start or goal, or if the robot cannot go from one of them to the centre of its
    /// cell.
    pub fn endpoints(&self) -> Result<Endpoints, Error> {
        let (start, goal) = self.ends()?;
        self.endpoints_between(["start", "goal"], [start, goal])
    }

    /// The cells of two points.
    ///
    /// # Errors
    /// [`Error::Refused`] with the point's name if the robot cannot go from it to the centre of its cell.
    pub fn endpoints_between(&self, names: [&str; 2], [start, goal]: [[f64; 2]; 2]) -> Result<Endpoints, Error> {
        let cells = self.cells();
        let stub = |point: [f64; 2], cell: usize| {
            let [x, y] = cells.centre(cell);
            ((x - point[0]) * (x - point[0]) + (y - point[1]) * (y - point[1])).sqrt()
        };
        let (from, to) = (entrance(self, names[0], start)?, entrance(self, names[1], goal)?);
        Ok(Endpoints { start: from, goal: to, ends: [start, goal], stubs: stub(start, from) + stub(goal, to) })
    }
}

/// The cell through whose centre a path leaves or reaches a point: the one that contains it; for a point on a border
/// between cells, the first that will do.
fn entrance(grid: &GridScene, name: &str, point: [f64; 2]) -> Result<usize, Error> {
    let cells = grid.cells();
    let place = cells.place(cells.at(point));
    let near = |axis: usize, n: usize| {
        let i = place[axis];
        let before = (point[axis] <= i as f64 * grid.cell).then(|| i.checked_sub(1)).flatten();
        [Some(i), before].into_iter().flatten().filter(move |&i| i < n)
    };
    let mut all = near(1, cells.rows).flat_map(|row| near(0, cells.columns).map(move |column| row * cells.columns + column));
    let fits = |cell: usize| {
        let centre = cells.centre(cell);
        cells.is_free(cell) && (point == centre || grid.field().is_free(point, centre))
    };
    all.find(|&cell| fits(cell)).ok_or_else(|| {
        Error::refused(
            name,
            coordinates(&point),
            message!("scene-entrance", "in a cell to whose centre the robot can go: this planner goes from cell to cell"),
        )
    })
}

#[cfg(test)]
mod tests {
    use crate::geometry::{DIRECTIONS, Steps};

    use super::*;

    fn grid(rows: &[&str], cutting: bool) -> GridScene {
        let blocked = rows.iter().flat_map(|row| row.chars().map(|c| c == '#')).collect();
        GridScene {
            corner_cutting: cutting,
            start: Some([0.5, 0.5]),
            goal: Some([2.5, 2.5]),
            ..GridScene::new(1.0, rows[0].len(), blocked)
        }
    }

    #[test]
    fn a_diagonal_step_needs_both_cells_beside_it_free_unless_corners_may_be_cut() {
        let bits = |directions: &[usize]| directions.iter().fold(0_u8, |mask, d| mask | 1 << d);
        let strict = grid(&["...", ".#.", "..."], false).new_cells();
        assert_eq!(strict.moves(0), bits(&[0, 2]), "no step through the block, none past its corner");
        assert_eq!(strict.moves(1), bits(&[0, 4]));
        assert_eq!(strict.moves(4), 0, "nothing leaves a blocked cell");
        let cutting = grid(&["...", ".#.", "..."], true).new_cells();
        assert_eq!(cutting.moves(1), bits(&[0, 1, 3, 4]), "past its corners to the cells beside it");
        let open = grid(&["...", "...", "..."], false).new_cells();
        assert_eq!(open.moves(4), 0xff);
        assert_eq!(open.moves(8), bits(&[4, 5, 6]));
        for d in 0..8 {
            assert_eq!(open.next(open.next(4, d), (d + 4) % 8), 4);
        }
    }

    #[test]
    fn the_steps_of_every_cell_are_those_of_the_definition() {
        let mut rng = crate::kernel::rng::Stream::new(2, 0);
        for (columns, rows) in [(1, 1), (1, 7), (7, 1), (5, 9), (40, 17)] {
            for cutting in [false, true] {
                let blocked: Vec<_> = (0..columns * rows).map(|_| rng.unit() < 0.4).collect();
                let cells = GridScene { corner_cutting: cutting, ..GridScene::new(1.0, columns as usize, blocked.clone()) }.new_cells();
                let free = |x: i32, y: i32| (0..columns).contains(&x) && (0..rows).contains(&y) && !blocked[(y * columns + x) as usize];
                for (d, [dx, dy]) in DIRECTIONS.into_iter().enumerate() {
                    for (x, y) in (0..rows).flat_map(|y| (0..columns).map(move |x| (x, y))) {
                        let beside = cutting || d % 2 == 0 || (free(x + dx, y) && free(x, y + dy));
                        let allowed = free(x, y) && free(x + dx, y + dy) && beside;
                        assert_eq!(cells.moves((y * columns + x) as usize) >> d & 1 == 1, allowed);
                    }
                }
            }
        }
    }

    #[test]
    fn a_wide_robot_needs_room_all_along_a_step() {
        use crate::scene::Robot;
        let robot = |side: f64| Some(Robot { length: Some(side), width: Some(side), ..Robot::default() });
        let narrow = GridScene { robot: robot(0.7), ..grid(&["...", ".#.", "..."], true) };
        let cells = narrow.cells();
        assert!(cells.is_free(1), "radius 0.495: it just fits beside the block");
        assert_eq!(cells.moves(1), 0b0001_0001, "but not past its corner");
        assert!(!GridScene { robot: robot(0.8), ..narrow.clone() }.cells().is_free(1), "radius 0.566");
    }

    #[test]
    fn a_way_over_cells_begins_and_ends_at_the_points_themselves() {
        let mut scene = grid(&["...", "...", "..."], false);
        let endpoints = scene.endpoints().unwrap();
        assert_eq!((endpoints.start, endpoints.goal, endpoints.stubs), (0, 8, 0.0));
        let cells = scene.cells();
        assert_eq!(cells.steps(&[0, 4, 5, 8]), Steps { straight: 2, diagonal: 1 });
        assert_eq!(endpoints.path(cells, [0, 4, 8]), [[0.5, 0.5], [1.5, 1.5], [2.5, 2.5]]);
        scene.start = Some([0.5, 0.0]);
        let endpoints = scene.endpoints().unwrap();
        assert_eq!((endpoints.start, endpoints.stubs), (0, 0.5));
        assert_eq!(endpoints.path(scene.cells(), [0, 4, 8])[..2], [[0.5, 0.0], [0.5, 0.5]]);
        // A point on the border of a blocked cell belongs to its free neighbour.
        let mut scene = grid(&["#..", "...", "..."], false);
        scene.start = Some([1.0, 1.0]);
        assert_eq!(scene.endpoints().unwrap().start, 4);
        scene.goal = Some([1.0, 0.5]);
        assert_eq!(scene.endpoints().unwrap().goal, 1);
    }
}
