//! Scenes whose function is a formula: their fields, and what is minimised.

use std::sync::Arc;

use serde_json::Value;

use crate::{
    kernel::{
        Error, Fields, Message,
        objective::{Evaluation, Objective, Scratch, SearchBox},
    },
    message,
};

use super::{
    super::{
        body::FunctionScene,
        own::{self, Origin},
        read::{EXPRESSION, dimension},
    },
    Formula,
};

/// A formula over a box.
struct FormulaObjective {
    formula: Formula,
    search_box: SearchBox,
}

impl Objective for FormulaObjective {
    fn search_box(&self) -> &SearchBox {
        &self.search_box
    }

    fn evaluate(&self, x: &[f64], scratch: &mut Scratch) -> Evaluation {
        self.formula.value(x, &mut scratch.numbers).into()
    }

    fn evaluate_all(&self, xs: &[f64], scratch: &mut Scratch, out: &mut [Evaluation]) {
        let mut out = out.iter_mut();
        self.formula.each_value(xs, &mut scratch.numbers, |value| {
            if let Some(out) = out.next() {
                *out = value.into();
            }
        });
    }

    fn refuses(&self, cost: f64) -> Option<Message> {
        if cost.is_nan() {
            return Some(message!("function-nan", "the function’s value is not a number"));
        }
        cost.is_infinite().then(|| message!("function-infinite", "the function’s value is infinite"))
    }
}

impl Formula {
    /// A scene in which it is minimised over a box of as many sides as it has variables; with the minimum and where that is, as far as
    /// they are known.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong: more than [`MAX_DIMENSION`](super::super::MAX_DIMENSION) variables, a side without
    /// length or farther than 10¹⁵ from 0, a position outside of the box, or one where the formula has another value than the minimum.
    ///
    /// ```
    /// use forage::{scene::Formula, swarm::objective::SearchBox};
    ///
    /// let bowl = Formula::new("(x - 1)^2 + y^2", 2)?.over(SearchBox::cube(2, -5.0, 5.0)?, Some(0.0), Some(vec![1.0, 0.0]))?;
    /// assert_eq!(bowl.value(&[3.0, 1.0]), 5.0);
    /// # Ok::<(), forage::Error>(())
    /// ```
    pub fn over(self, search_box: SearchBox, minimum: Option<f64>, minimiser: Option<Vec<f64>>) -> Result<FunctionScene, Error> {
        own::check_dimension(self.dimension)?;
        if search_box.dimension() != self.dimension {
            let allowed = message!("scene-sides-of", "as many sides as there are variables, {n}", n = self.dimension);
            return Err(Error::refused("bounds", search_box.dimension(), allowed));
        }
        let text = Value::from(self.text.as_str());
        own::scene(Arc::new(FormulaObjective { formula: self, search_box }), Origin::Field(EXPRESSION, text), minimum, minimiser)
    }
}

/// Reads the fields of such a scene.
pub fn read(fields: &mut Fields) -> Result<FunctionScene, Error> {
    let text = fields.text(EXPRESSION)?;
    let n = dimension(fields)?;
    own::check_dimension(n)?;
    let formula = Formula::new(&text, n)?;
    let search_box = own::read_box(fields, n)?;
    let (value, position) = own::read_optimum(fields)?;
    formula.over(search_box, value, position)
}
