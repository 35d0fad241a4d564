//! What a build knows: planners, kinds of scenes, generators and followers.

use std::sync::{Arc, OnceLock};

use serde_json::Value;

use crate::{
    kernel::{Error, LayerKey, Scene, SceneKindId},
    params::Overrides,
};

use super::{Entries, Entry, Follower, Generator, SceneKind, layers};

/// What a build knows, each by its entry. A run holds one; nothing else lists planners or scenes.
///
/// ```
/// use forage::{Registry, scene::grid, search::a_star};
/// let registry = Registry::new().with(&grid::KIND).with(&a_star::ENTRY);
/// assert_eq!(registry.planner("a-star")?.title, a_star::ENTRY.title);
/// assert_eq!(registry.planner("pso").unwrap_err().allowed(), "a-star");
/// # Ok::<(), forage::Error>(())
/// ```
#[derive(Debug, Clone, Default)]
pub struct Registry {
    planners: Vec<&'static Entry>,
    kinds: Vec<&'static SceneKind>,
    generators: Vec<&'static Generator>,
    followers: Vec<&'static Follower>,
    /// Texts of scenes besides those that ship with the kinds.
    texts: Vec<&'static str>,
    /// All of these scenes, read when one is asked for first.
    scenes: OnceLock<Vec<Arc<Scene>>>,
}

/// What a registry can list: entries of planners, of kinds of scenes, of generators and of followers.
pub trait Listed {
    /// Puts it at the end of its list, or in the place of the one with its name.
    fn list(&'static self, registry: &mut Registry);
}

fn put<T>(list: &mut Vec<&'static T>, entry: &'static T, name: fn(&T) -> &str) {
    match list.iter_mut().find(|known| name(known) == name(entry)) {
        Some(known) => *known = entry,
        None => list.push(entry),
    }
}

impl Listed for Entry {
    fn list(&'static self, registry: &mut Registry) {
        put(&mut registry.planners, self, |entry| entry.name);
    }
}

impl Listed for SceneKind {
    fn list(&'static self, registry: &mut Registry) {
        put(&mut registry.kinds, self, |kind| kind.id.name());
        registry.scenes = OnceLock::new();
    }
}

impl Listed for Generator {
    fn list(&'static self, registry: &mut Registry) {
        put(&mut registry.generators, self, |generator| generator.name);
    }
}

impl Listed for Follower {
    fn list(&'static self, registry: &mut Registry) {
        put(&mut registry.followers, self, |follower| follower.name);
    }
}

impl Registry {
    /// One that lists nothing.
    pub fn new() -> Self {
        Self::default()
    }

    /// Lists scenes by the texts of their files, besides those that ship with the kinds: for a build that leaves those out
    /// (`SceneKind { shipped: &[], ..grid::KIND }`) and loads them when they are needed. A text that is no scene is left out.
    #[must_use]
    pub fn with_scenes(mut self, texts: &[&'static str]) -> Self {
        self.texts.extend(texts);
        self.scenes = OnceLock::new();
        self
    }

    /// With one more entry: at the end of its list, or in the place of the one with the same name.
    #[must_use]
    pub fn with(mut self, entry: &'static impl Listed) -> Self {
        entry.list(&mut self);
        self
    }

    /// With more entries, see [`Registry::with`].
    #[must_use]
    pub fn with_all(mut self, entries: &[&'static impl Listed]) -> Self {
        entries.iter().for_each(|entry| entry.list(&mut self));
        self
    }

    /// All planners, in the order in which they are offered.
    pub fn planners(&self) -> &[&'static Entry] {
        &self.planners
    }

    /// The planner of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn planner(&self, name: &str) -> Result<&'static Entry, Error> {
        find(&self.planners, "planner", name, |entry| entry.name)
    }

    /// All kinds of scenes.
    pub fn kinds(&self) -> &[&'static SceneKind] {
        &self.kinds
    }

    /// The kind of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn kind(&self, name: &str) -> Result<&'static SceneKind, Error> {
        find(&self.kinds, "kind", name, |kind| kind.id.name())
    }

    /// All generators of random scenes, in the order in which they are offered.
    pub fn generators(&self) -> &[&'static Generator] {
        &self.generators
    }

    /// The generator of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn generator(&self, name: &str) -> Result<&'static Generator, Error> {
        find(&self.generators, "generator", name, |generator| generator.name)
    }

    /// Makes a random scene: the same for the same parameters and seed. Its `source` is the command that makes it again.
    ///
    /// ```
    /// use forage::{Overrides, Value, scene::GridScene, standard};
    ///
    /// let scene = standard().generate("maze", &Overrides::from_iter([("columns", Value::from(21.0))]), 7)?;
    /// assert_eq!(scene.get::<GridScene>()?.columns, 21);
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::Unknown`] for a name that means nothing, [`Error::Refused`] for a value that is not allowed.
    pub fn generate(&self, generator: &str, overrides: &Overrides, seed: u64) -> Result<Scene, Error> {
        let generator = self.generator(generator)?;
        generator.generate(self.kind(generator.kind.name())?, overrides, seed)
    }

    /// All followers of a path.
    pub fn followers(&self) -> &[&'static Follower] {
        &self.followers
    }

    /// The follower of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn follower(&self, name: &str) -> Result<&'static Follower, Error> {
        find(&self.followers, "follower", name, |follower| follower.name)
    }

    /// Reads a scene file's text.
    ///
    /// ```
    /// use forage::standard;
    /// let text = r#"{"format": "forage-scene", "version": 1, "kind": "function", "name": "s", "title": "Sphere",
    ///                "function": "sphere", "dimension": 3}"#;
    /// assert_eq!(standard().read_scene(text)?.name(), "s");
    /// let wrong = text.replace("3", "-3");
    /// assert_eq!(standard().read_scene(&wrong).unwrap_err().field(), "dimension");
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Scene::read`].
    pub fn read_scene(&self, text: &str) -> Result<Scene, Error> {
        Scene::read(&self.kinds, text)
    }

    /// Reads a scene from an object in memory.
    ///
    /// # Errors
    /// As [`Scene::read_value`].
    pub fn read_scene_value(&self, value: Value) -> Result<Scene, Error> {
        Scene::read_value(&self.kinds, value)
    }

    /// The scenes that ship with the kinds, kind by kind in the order in which they are offered, and those that came besides.
    pub fn scenes(&self) -> &[Arc<Scene>] {
        self.scenes.get_or_init(|| {
            let texts = self.kinds.iter().flat_map(|kind| kind.shipped).chain(&self.texts);
            // A test reads all of ours, so that none is left out in silence.
            let rank = |scene: &Scene| self.kinds.iter().position(|kind| kind.id == scene.kind());
            let mut all = Vec::new();
            for scene in texts.filter_map(|text| self.read_scene(text).ok()) {
                all.insert(all.partition_point(|other: &Arc<Scene>| rank(other) <= rank(&scene)), Arc::new(scene));
            }
            all
        })
    }

    /// The shipped scene of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn scene(&self, name: &str) -> Result<Arc<Scene>, Error> {
        let known = self.scenes().iter().find(|scene| scene.name() == name).cloned();
        known.ok_or_else(|| Error::unknown("scene", name, self.scenes().iter().map(|scene| scene.name())))
    }

    /// The keys of all layers: those that planners draw or mark, and the scenes' own.
    pub fn layer_keys(&self) -> Vec<LayerKey> {
        let mut keys = Vec::new();
        for layer in self.planners.iter().flat_map(|entry| entry.layers).chain(layers::SCENE) {
            if !keys.contains(&layer.key) {
                keys.push(layer.key);
            }
        }
        keys
    }

    /// The key of the layers of this name.
    ///
    /// # Errors
    /// [`Error::Unknown`] with the names that exist.
    pub fn layer_key(&self, name: &str) -> Result<LayerKey, Error> {
        let keys = self.layer_keys();
        let known = keys.iter().copied().find(|key| key.0 == name);
        known.ok_or_else(|| Error::unknown("role", name, keys.iter().map(|key| key.0)))
    }

    /// The planners that can run on a scene.
    pub fn suited(&self, scene: &Scene) -> impl Iterator<Item = &'static Entry> {
        self.planners.iter().copied().filter(|entry| entry.check_scene(scene).is_ok())
    }

    /// The generators of scenes of this kind.
    pub fn generators_of(&self, kind: SceneKindId) -> impl Iterator<Item = &'static Generator> {
        self.generators.iter().copied().filter(move |generator| generator.kind == kind)
    }
}

impl Entries for Registry {
    fn planner(&self, name: &str) -> Result<&'static Entry, Error> {
        self.planner(name)
    }
}

fn find<T>(list: &[&'static T], field: &str, name: &str, name_of: fn(&T) -> &'static str) -> Result<&'static T, Error> {
    let known = list.iter().copied().find(|entry| name_of(entry) == name);
    known.ok_or_else(|| Error::unknown(field, name, list.iter().map(|entry| name_of(entry))))
}
