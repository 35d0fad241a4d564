//! What a run is made of.

use std::sync::Arc;

use crate::{
    catalogue::find,
    describe::{Entry, Suggestion},
    kernel::{Error, rng::check_seed},
    params::{Overrides, Parameters},
    scene::Scene,
};

/// What a run is made of. Two runs of the same setup give the same bits.
#[derive(Debug, Clone)]
pub struct Setup {
    /// The planner's name in the catalogue.
    pub planner: String,
    /// What is planned in.
    pub scene: Arc<Scene>,
    /// Parameters that differ from the defaults.
    pub params: Overrides,
    /// 0 to 2^53 − 1.
    pub seed: u64,
}

impl Setup {
    /// Checks everything that can be refused without running it.
    ///
    /// # Errors
    /// The planner's name, a scene it does not run on, a parameter, the seed.
    pub fn check(&self) -> Result<(&'static Entry, Parameters), Error> {
        let entry = find(&self.planner)?;
        entry.check_scene(&self.scene)?;
        check_seed(self.seed)?;
        Ok((entry, Parameters::new(entry.parameters, self.scene.kind(), &self.params)?))
    }

    /// The sizes that the planner's paper recommends for this setup, if it says anything.
    ///
    /// ```
    /// let scene = forage::shipped("qpso-10m")?;
    /// let setup = forage::Setup { planner: "ltqpso".into(), scene, params: Default::default(), seed: 1 };
    /// let suggested = setup.suggest()?.unwrap();
    /// assert_eq!((suggested.population, suggested.iterations), (16, 29));
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Setup::check`].
    pub fn suggest(&self) -> Result<Option<Suggestion>, Error> {
        let (entry, settings) = self.check()?;
        Ok((entry.suggest)(&settings))
    }
}
