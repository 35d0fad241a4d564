//! One run of many.

use js_sys::Float64Array;
use wasm_bindgen::prelude::*;

use forage::{
    Error,
    kernel::allowed,
    run::{
        self,
        trial::{self, WITHIN},
    },
};

use crate::{
    advance, advanced, js_error, object, plain,
    read::{count_or, read_number, read_setup},
    registry::ask,
    status,
    types::{JsAdvanced, JsNumber, JsSetup, JsStatus, JsTrialCurve, JsTrialRecord},
};

/// One run of many: stepped to its end and summed up in a record, the same as in a row of `forage experiment`.
#[wasm_bindgen]
pub struct Trial(pub(crate) trial::Trial);

#[wasm_bindgen]
impl Trial {
    /// Starts a run at iteration 0. `within`: how near to the exact optimum counts as reached, a share of it or on functions a
    /// difference; 0.01 unless given.
    ///
    /// # Errors
    /// As the constructor of `Session`, and for a `within` that is no number from 0 to 1,000,000.
    #[wasm_bindgen(constructor)]
    pub fn new(setup: &JsSetup, within: Option<JsNumber>) -> Result<Trial, JsValue> {
        let within = within.map_or(Ok(WITHIN), |within| read_number("within", &within))?;
        let setup = read_setup(setup)?;
        ask(|registry| trial::Trial::new(registry, setup.clone(), within)).map(Trial)
    }

    /// Takes up to `n` steps, all there are unless given; stops where the planner does.
    ///
    /// # Errors
    /// For an `n` that is no whole number, and for 0, which would never come to an end.
    pub fn step(&mut self, n: Option<JsNumber>) -> Result<JsStatus, JsValue> {
        match count_or("n", n, u64::MAX)? {
            0 => Err(js_error(Error::refused("n", 0_u64, allowed::steps()))),
            n => status(self.0.step(n)),
        }
    }

    /// Takes up to `n` steps, one unless given, but leaves off within one that is long, as `advance` of a session does.
    ///
    /// # Errors
    /// For an `n` that is no whole number from 1 on.
    pub fn advance(&mut self, n: Option<JsNumber>) -> Result<JsAdvanced, JsValue> {
        let stepped = advance(n, || self.0.part())?;
        advanced(stepped, self.0.run().status())
    }

    /// How many iterations were taken to come here.
    #[wasm_bindgen(getter)]
    pub fn iteration(&mut self) -> f64 {
        self.0.run().iteration() as f64
    }

    /// How many candidates were evaluated so far.
    #[wasm_bindgen(getter)]
    pub fn evaluations(&mut self) -> f64 {
        self.0.run().evaluations() as f64
    }

    /// The iteration at which the run ends at the latest.
    #[wasm_bindgen(getter)]
    pub fn limit(&mut self) -> f64 {
        self.0.run().limit() as f64
    }

    /// What the run came to so far.
    ///
    /// # Errors
    /// Where a number of it is more than JavaScript can hold.
    pub fn record(&mut self) -> Result<JsTrialRecord, JsValue> {
        plain(&self.0.record())
    }

    /// The values of the feasible best, whenever it changed.
    pub fn curve(&mut self) -> JsTrialCurve {
        curve_of(self.0.run())
    }
}

/// The columns of a run's curve.
pub(crate) fn curve_of(run: &mut run::Run) -> JsTrialCurve {
    let curve = run.curve();
    let column = |of: fn(&run::Improvement) -> f64| Float64Array::from(curve.iter().map(of).collect::<Vec<_>>().as_slice()).into();
    object(&[
        ("iterations", column(|point| point.iteration as f64)),
        ("evaluations", column(|point| point.evaluations as f64)),
        ("values", column(|point| point.value)),
    ])
}
