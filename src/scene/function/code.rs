//! Scenes whose function is code: an [`Objective`] that no file can hold.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    kernel::{
        Error, Header, Message, Scene, allowed,
        fields::shown,
        objective::{Objective, Scratch, SearchBox},
        scene_file,
    },
    message,
};

use super::{
    body::{FunctionScene, ID},
    own::{self, Origin},
    read::dimension,
};

impl FunctionScene {
    /// A scene in which an objective of your own is minimised; with the minimum and where that is, as far as they are known. Runs on it
    /// have results, traces and records like others, and no link.
    ///
    /// ```
    /// use std::sync::Arc;
    /// use forage::{
    ///     Run, Setup, Status, kernel::Header, scene::{FunctionScene, function}, standard,
    ///     swarm::objective::{Evaluation, Objective, Scratch, SearchBox},
    /// };
    ///
    /// /// (x − 1)² + (y − 2)²
    /// struct Bowl(SearchBox);
    ///
    /// impl Objective for Bowl {
    ///     fn search_box(&self) -> &SearchBox {
    ///         &self.0
    ///     }
    ///     fn evaluate(&self, x: &[f64], _: &mut Scratch) -> Evaluation {
    ///         let [dx, dy] = [x[0] - 1.0, x[1] - 2.0];
    ///         (dx * dx + dy * dy).into()
    ///     }
    /// }
    ///
    /// let bowl = FunctionScene::of(Arc::new(Bowl(SearchBox::cube(2, -5.0, 5.0)?)), Some(0.0), Some(vec![1.0, 2.0]))?;
    /// let scene = function::KIND.scene(Header::named("bowl", "A bowl"), bowl)?;
    /// let mut run = Run::new(standard(), Setup { planner: "pso".into(), scene: scene.into(), params: Default::default(), seed: 1 })?;
    /// while run.step(100) == Status::Running {}
    /// assert!(run.outcome().cost.unwrap() < 1e-9);
    /// assert_eq!(run.link(), None);
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong, as of [`Formula::over`](super::Formula::over).
    pub fn of(objective: Arc<dyn Objective>, minimum: Option<f64>, minimiser: Option<Vec<f64>>) -> Result<Self, Error> {
        own::scene(objective, Origin::Code, minimum, minimiser)
    }
}

/// A scene of the fields `dimension`, `bounds`, `optimum` and, if there are any, those that every scene has; `objective` makes what is
/// minimised over the box.
///
/// # Errors
/// The field, its value and what is allowed.
pub fn from_code(value: Value, objective: impl FnOnce(SearchBox) -> Result<Arc<dyn Objective>, Error>) -> Result<Scene, Error> {
    let Value::Object(mut given) = value else {
        return Err(Error::refused("scene", shown(&value), allowed::object()));
    };
    let usual = [
        ("format", Value::from("forage-scene")),
        ("version", Value::from(1)),
        ("kind", Value::from(ID.name())),
        ("name", Value::from("own-function")),
        ("title", Value::from("A function from code")),
    ];
    for (name, value) in usual {
        if !given.contains_key(name) {
            given.insert(name.to_owned(), value);
        }
    }
    let mut fields = scene_file::open(Value::Object(given))?;
    fields.expect("kind", |kind| kind == ID.name(), message!("scene-code-kind", "function: its objective is a function"))?;
    let header = Header::read(&mut fields)?;
    let n = dimension(&mut fields)?;
    own::check_dimension(n)?;
    let search_box = own::read_box(&mut fields, n)?;
    let (minimum, minimiser) = own::read_optimum(&mut fields)?;
    fields.end()?;
    let scene = FunctionScene::of(objective(search_box)?, minimum, minimiser)?;
    Scene::new(header, Arc::new(scene), None)
}

/// What a function of another language did instead of giving a number.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum CodeFault {
    /// It gave this.
    NoNumber(String),
    /// It was asked for so many numbers, and gave this.
    NoList(String, usize),
    /// It threw this.
    Threw(String),
}

impl CodeFault {
    /// In words.
    pub fn message(self) -> Message {
        match self {
            Self::NoNumber(found) => message!("function-no-number", "the function gives {found} instead of a number", found),
            Self::NoList(found, n) => message!("function-no-list", "the function gives {found} instead of a list of {n} numbers", found, n),
            Self::Threw(error) => message!("function-threw", "the function throws “{error}”", error),
        }
    }
}

/// Why a run with a cost ends, whose function is code: it is not a number, by this fault. An infinite cost is one that never becomes the best,
/// so that a position can be forbidden.
pub fn refused_cost(cost: f64, fault: Option<CodeFault>) -> Option<Message> {
    let nan = || message!("function-nan", "the function’s value is not a number");
    cost.is_nan().then(|| fault.map_or_else(nan, CodeFault::message))
}

/// Refuses a function, the value of `field`, that gives two values at one position: each run would be another one.
///
/// # Errors
/// [`Error::Refused`] for `field`.
pub fn check_repeatable(field: &'static str, objective: &dyn Objective) -> Result<(), Error> {
    let search_box = objective.search_box();
    let middle: Vec<_> = search_box.low().iter().zip(search_box.high()).map(|(low, high)| f64::midpoint(*low, *high)).collect();
    let [first, second] = [(); 2].map(|()| objective.evaluate(&middle, &mut Scratch::default()).cost);
    if first.to_bits() == second.to_bits() || (first.is_nan() && second.is_nan()) {
        return Ok(());
    }
    let found = message!("function-changes", "one that gives {first} and then {second} at the same position", first, second);
    Err(Error::refused(field, found, message!("function-same", "a function that always gives the same number at the same position")))
}
