//! What a script is lent for the time of a call: the scene, its costs, and random numbers.

use std::sync::Arc;

use forage::{
    kernel::{
        Error, Message, Scene, Solution,
        error::list_of,
        objective::{Objective, Scratch},
        rng::Stream,
    },
    math, message,
    scene::{FunctionScene, TourScene},
};

use super::read::stops;

/// Random numbers, costs and geometry for the code of a planner.
#[derive(Clone)]
pub struct Tools {
    scene: Arc<Scene>,
    scratch: Scratch,
    rng: Stream,
    /// A random number was drawn: the run is one of many.
    drawn: bool,
    evaluations: u64,
}

impl Tools {
    /// Those of a run on this scene with this seed.
    pub fn new(scene: &Arc<Scene>, seed: u64) -> Self {
        let rng = Stream::new(seed, 0);
        Self { scene: Arc::clone(scene), scratch: Scratch::default(), rng, drawn: false, evaluations: 0 }
    }

    /// The scene.
    pub fn scene(&self) -> &Arc<Scene> {
        &self.scene
    }

    /// How many candidates were evaluated.
    pub fn evaluations(&self) -> u64 {
        self.evaluations
    }

    /// The stream of random numbers, if any were drawn.
    pub(super) fn drawn(&self) -> Option<&Stream> {
        self.drawn.then_some(&self.rng)
    }

    /// What is minimised, on a function.
    pub fn objective(&self) -> Option<&Arc<dyn Objective>> {
        self.scene.get::<FunctionScene>().ok().map(FunctionScene::objective)
    }

    /// A uniform number in [0, 1).
    pub fn random(&mut self) -> f64 {
        self.drawn = true;
        self.rng.unit()
    }

    /// A number from the standard normal distribution.
    pub fn normal(&mut self) -> f64 {
        self.drawn = true;
        self.rng.normal()
    }

    /// The value of the scene's function at a position; counts as an evaluation.
    ///
    /// # Errors
    /// [`Error::Refused`] for a position of another dimension, and on a scene without a function.
    pub fn evaluate(&mut self, x: &[f64]) -> Result<f64, Error> {
        let objective = self.scene.get::<FunctionScene>()?.objective();
        let n = objective.search_box().dimension();
        if x.len() != n {
            return Err(Error::refused(
                "evaluate",
                list_of(x.len()),
                message!("scene-numbers", "a list of {n} numbers, one for each variable", n),
            ));
        }
        self.evaluations += 1;
        let cost = objective.evaluate(x, &mut self.scratch).cost;
        match objective.refuses(cost) {
            Some(why) => Err(Error::refused(
                "evaluate",
                forage::kernel::digits::coordinates(x),
                message!("script-defined", "a position where {why} does not hold", why),
            )),
            None => Ok(cost),
        }
    }

    /// The length of a path, infinite if it is not free; counts as an evaluation.
    ///
    /// # Errors
    /// [`Error::Refused`] on a scene without paths.
    pub fn length(&mut self, path: &[[f64; 2]]) -> Result<f64, Error> {
        self.check_plane("length")?;
        self.evaluations += 1;
        let verdict = self.scene.judge(&Solution::Path(path.to_vec()));
        Ok(verdict.length.filter(|_| verdict.feasible).unwrap_or(f64::INFINITY))
    }

    /// Whether the robot can go straight from one point to another.
    ///
    /// # Errors
    /// [`Error::Refused`] on a scene without a plane.
    pub fn is_free(&self, a: [f64; 2], b: [f64; 2]) -> Result<bool, Error> {
        self.check_plane("isFree")?;
        Ok(self.scene.is_free(a, b))
    }

    /// The length of a tour that visits the stops in this order; counts as an evaluation.
    ///
    /// # Errors
    /// [`Error::Refused`] for another list than each stop once, and on a scene without stops.
    pub fn tour(&mut self, order: &[usize]) -> Result<f64, Error> {
        let tour = self.scene.get::<TourScene>()?;
        if !tour.ends().allows(order, tour.len()) {
            return Err(Error::refused("tour", list_of(order.len()), each_stop(tour.len())));
        }
        self.evaluations += 1;
        Ok(tour.distances().length(order, tour.ends().closes()))
    }

    /// The distance of two stops.
    ///
    /// # Errors
    /// [`Error::Refused`] for a stop that there is not, and on a scene without stops.
    pub fn distance(&self, from: usize, to: usize) -> Result<f64, Error> {
        let tour = self.scene.get::<TourScene>()?;
        let n = tour.len();
        match [from, to].into_iter().find(|stop| *stop >= n) {
            Some(stop) => Err(Error::refused(
                "distance",
                stop,
                message!("error-whole-from-to", "a whole number from {min} to {max}", min = 0, max = n - 1),
            )),
            None => Ok(tour.distances().between(from, to)),
        }
    }

    /// What is lent to code by number and takes up to two numbers: 0 a random number, 1 a normal one, 2 the distance of two stops.
    ///
    /// # Errors
    /// As [`Self::distance`].
    pub fn scalar(&mut self, what: u32, a: f64, b: f64) -> Result<f64, Error> {
        match what {
            0 => Ok(self.random()),
            1 => Ok(self.normal()),
            _ => self.distance(a as usize, b as usize),
        }
    }

    /// What is lent by number and takes a list: 0 the value at a position, 1 the length of a path of corners, 2 whether the way between
    /// two points is free, 3 the length of a tour.
    ///
    /// # Errors
    /// As [`Self::evaluate`], [`Self::length`], [`Self::is_free`] and [`Self::tour`].
    pub fn list(&mut self, what: u32, numbers: &[f64]) -> Result<f64, Error> {
        let points = numbers.as_chunks::<2>().0;
        match (what, points) {
            (0, _) => self.evaluate(numbers),
            (1, _) => self.length(points),
            (2, &[a, b]) => self.is_free(a, b).map(f64::from),
            _ => self.tour(&stops(numbers)),
        }
    }

    fn check_plane(&self, what: &'static str) -> Result<(), Error> {
        match self.scene.plane() {
            Some(_) => Ok(()),
            None => Err(Error::refused(what, self.scene.kind().name(), Message::verbatim("discs, grid"))),
        }
    }
}

/// Mathematics that is lent by number, to any call: the same bits everywhere. `None`: it needs [`Tools`].
pub fn mathematics(what: u32, a: f64, b: f64) -> Option<f64> {
    let one: fn(f64) -> f64 = match what {
        0..3 => return None,
        3 => math::sin,
        4 => math::cos,
        5 => math::exp,
        6 => math::ln,
        7 => return Some(math::pow(a, b)),
        8 => return Some(math::atan2(a, b)),
        9 => math::acos,
        10 => math::asin,
        _ => math::log10,
    };
    Some(one(a))
}

/// Of an order of stops.
pub(super) fn each_stop(n: usize) -> Message {
    message!("script-each-stop", "each of the {n} stops once", n)
}
