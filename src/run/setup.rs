//! What a run is made of.

use std::sync::Arc;

use crate::{
    describe::{Entry, Registry, Suggestion},
    kernel::{Error, limits},
    params::{Overrides, Parameters},
    scene::Scene,
};

/// What a run is made of. Two runs of the same setup give the same bits.
#[derive(Debug, Clone)]
pub struct Setup {
    /// The planner's name.
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
    pub fn check(&self, registry: &Registry) -> Result<(&'static Entry, Parameters), Error> {
        let entry = registry.planner(&self.planner)?;
        entry.check_scene(&self.scene)?;
        limits::check_whole("seed", self.seed)?;
        Ok((entry, Parameters::new(entry.parameters, self.scene.kind(), &self.params)?))
    }

    /// The sizes that the planner's paper recommends for this setup, if it says anything.
    ///
    /// ```
    /// use forage::{Setup, shipped, standard};
    /// let setup = Setup { planner: "ltqpso".into(), scene: shipped("qpso-10m")?, params: Default::default(), seed: 1 };
    /// let suggested = setup.suggest(standard())?.unwrap();
    /// assert_eq!((suggested.population, suggested.iterations), (16, 29));
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Setup::check`].
    pub fn suggest(&self, registry: &Registry) -> Result<Option<Suggestion>, Error> {
        let (entry, parameters) = self.check(registry)?;
        Ok((entry.suggest)(&parameters))
    }
}
