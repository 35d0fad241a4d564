//! First paths for planners that improve some: each by a basic tree of its own, without its redundant nodes.

use std::{cell::Cell, sync::Arc};

use crate::{
    geometry::shortcut,
    kernel::{Error, rng::Stream},
    scene::Scene,
};

use super::{finish::Finish, grow::Forest, method::Method, rrt::Rrt, space, task::Task};

/// A plane in which trees grow from the start to the goal.
pub struct Paths {
    task: Task<3>,
    method: Rrt,
}

/// What became of a tree.
#[derive(Debug, Clone, PartialEq)]
pub struct Attempt {
    /// From start to goal, without redundant nodes; `None` if the tree did not come to the goal.
    pub path: Option<Vec<[f64; 2]>>,
    /// How often the tree was extended.
    pub extensions: u64,
    /// How many straight pieces were tested, in extensions and to remove redundant nodes.
    pub tested: u64,
}

impl Paths {
    /// Of a scene with discs or cells. `step_size` is in the scene's unit, on grids in cells.
    ///
    /// # Errors
    /// A scene without start and goal.
    pub fn new(scene: &Arc<Scene>, step_size: f64, goal_bias: f64) -> Result<Self, Error> {
        let space = space::of_scene(scene, 0.0, false)?;
        let step = step_size * space.unit();
        Ok(Self { task: Task::with(space, step, u64::MAX, Finish::raw(step)), method: Rrt { goal_bias } })
    }

    /// Grows a tree by so many extensions at most.
    pub fn grow(&self, most: u64, rng: &mut Stream) -> Attempt {
        let (task, mut method) = (&self.task, self.method);
        let mut forest = Forest::new(task);
        while forest.found.is_none() && forest.iteration < most {
            forest.iteration += 1;
            method.grow(&mut forest, task, rng);
        }
        let tested = Cell::new(forest.tested);
        let is_free = |a: [f64; 2], b: [f64; 2]| {
            tested.set(tested.get() + 1);
            task.space.is_free(&[a[0], a[1], 0.0], &[b[0], b[1], 0.0])
        };
        let flat = |found: &super::found::Found<3>| found.raw.iter().map(|&[x, y, _]| [x, y]).collect::<Vec<_>>();
        let path = forest.found.as_deref().map(|found| shortcut(&flat(found), is_free));
        Attempt { path, extensions: forest.iteration, tested: tested.get() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shipped;

    #[test]
    fn a_tree_gives_a_free_path_from_start_to_goal_or_none() {
        for name in ["ant-bat-30", "wolf-ant-20", "wcpso-discs", "qpso-10m"] {
            let scene = shipped(name).unwrap();
            let paths = Paths::new(&scene, 0.5, 0.05).unwrap();
            let mut rng = Stream::new(1, 0);
            let attempt = paths.grow(20_000, &mut rng);
            let path = attempt.path.unwrap();
            assert_eq!(Some((path[0], path[path.len() - 1])), scene.ends(), "{name}");
            assert!(path.windows(2).all(|w| scene.is_free(w[0], w[1])), "{name}");
            assert!(path.windows(3).all(|w| !scene.is_free(w[0], w[2])), "{name}: no node is redundant");
            assert!(attempt.extensions <= 20_000 && attempt.tested > path.len() as u64);
            let none = paths.grow(3, &mut rng);
            assert_eq!((none.path, none.extensions), (None, 3), "{name}: too few extensions to come to the goal");
        }
    }
}
