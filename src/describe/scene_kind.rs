//! The entry of a kind of scene: what is known of it without a scene, and the function that reads one.

use std::sync::Arc;

use serde_json::Value;

use crate::kernel::{Error, Fields, Header, Optimum, Scene, SceneBody, SceneKindId, error::one_of, json, scene_file};

/// Reads the fields of a scene that only its kind has. Fields that it does not read are refused afterwards.
pub type ReadScene = fn(&mut Fields) -> Result<Arc<dyn SceneBody>, Error>;

/// The entry of a kind of scene.
#[derive(Debug, Clone, Copy)]
pub struct SceneKind {
    /// The id that scene files use.
    pub id: SceneKindId,
    /// The title, in the plural, for a heading.
    pub title: &'static str,
    /// Reads a scene's content.
    pub read: ReadScene,
    /// Computes exact optima; `None` where there are none, or to leave them out of a build.
    pub optimum: Option<Optimum>,
    /// The texts of the scenes that ship with it, in the order in which they are offered.
    pub shipped: &'static [&'static str],
}

impl SceneKind {
    /// A valid scene of this kind.
    ///
    /// # Errors
    /// [`Error::Refused`] with the field that is wrong.
    pub fn scene(&self, header: Header, body: impl SceneBody) -> Result<Scene, Error> {
        Scene::new(header, Arc::new(body), self.optimum)
    }
}

impl Scene {
    /// Reads a scene file's text; it may be of one of these kinds.
    ///
    /// # Errors
    /// [`Error::Malformed`] if it is not JSON, [`Error::Refused`] if it is too large (see [`crate::kernel::limits`]), otherwise the field, its value and what is allowed.
    pub fn read(kinds: &[&SceneKind], text: &str) -> Result<Self, Error> {
        Self::read_value(kinds, json::parse("scene", text)?)
    }

    /// Reads a scene from an object in memory; it may be of one of these kinds.
    ///
    /// # Errors
    /// The field, its value and what is allowed.
    pub fn read_value(kinds: &[&SceneKind], value: Value) -> Result<Self, Error> {
        let mut fields = scene_file::open(value)?;
        let found = fields.take("kind");
        let kind = kinds.iter().find(|kind| found == kind.id.name());
        let kind = kind.ok_or_else(|| {
            let names: Vec<_> = kinds.iter().map(|kind| kind.id.name()).collect();
            fields.refuse("kind", &found, one_of(&names))
        })?;
        let header = Header::read(&mut fields)?;
        let body = (kind.read)(&mut fields)?;
        fields.end()?;
        Self::new(header, body, kind.optimum)
    }
}
