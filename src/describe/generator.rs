//! A generator's entry: what is known of it, and the function that draws random scenes of a kind.

use std::{fmt::Write, sync::Arc};

use crate::{
    kernel::{Error, Header, Scene, SceneBody, SceneKindId, limits},
    params::{Overrides, Parameter, Parameters},
};

use super::SceneKind;

/// What random scenes of a kind are made of.
#[derive(Debug, Clone, Copy)]
pub struct Generator {
    /// The name in commands.
    pub name: &'static str,
    /// The name for people.
    pub title: &'static str,
    /// A sentence or two.
    pub help: &'static str,
    /// The kind of its scenes.
    pub kind: SceneKindId,
    /// Its parameters, in lists.
    pub parameters: &'static [&'static [Parameter]],
    /// Draws a scene with these parameters and this seed: the same for the same.
    pub draw: fn(&Parameters, u64) -> Draft,
}

/// A scene without a header.
pub struct Draft {
    /// The content.
    pub body: Arc<dyn SceneBody>,
    /// What the name says of it, between the generator's name and the seed: `40x30`.
    pub size: String,
    /// The same in the title.
    pub size_in_title: String,
    /// What should be known about it.
    pub note: Option<String>,
    /// Parameters whose names begin like this had no part in it, and are left out of the source. Empty: all had one.
    pub unused: &'static str,
}

impl Draft {
    /// A scene of this size in whose making all parameters had a part.
    pub fn new(body: impl SceneBody, size: String) -> Self {
        Self { body: Arc::new(body), size_in_title: size.clone(), size, note: None, unused: "" }
    }
}

impl Generator {
    /// Makes a scene of the generator's kind, whose entry this must be. Its `source` is the command that makes it again.
    ///
    /// # Errors
    /// [`Error::Unknown`] for the name of a parameter that there is not, [`Error::Refused`] for a value that is not allowed.
    pub fn generate(&self, kind: &SceneKind, overrides: &Overrides, seed: u64) -> Result<Scene, Error> {
        let Self { name, title, .. } = self;
        let parameters = Parameters::new(self.parameters, self.kind, overrides)?;
        let Draft { body, size, size_in_title, note, unused } = (self.draw)(&parameters, limits::check_whole("seed", seed)?);
        let mut source = format!("forage generate {name}");
        for (name, value) in parameters.all().iter().filter(|(name, _)| unused.is_empty() || !name.starts_with(unused)) {
            // Writing to a string cannot fail.
            let _ = write!(source, " --set {name}={value}");
        }
        let _ = write!(source, " --seed {seed}");
        let header = Header {
            name: format!("{name}-{size}-{seed}"),
            title: format!("{title}, {size_in_title}, seed {seed}"),
            note,
            source: Some(source),
            units: None,
            exact: None,
            published: None,
        };
        Scene::new(header, body, kind.optimum)
    }
}
