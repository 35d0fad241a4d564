//! The kinds that ship, and scene files of any of them.

use serde_json::Value;

use crate::{
    describe::SceneKind,
    kernel::{Error, Scene},
};

use super::{arm, discs, function, grid, tour};

/// The kinds of scene that ship, one line each; nothing else lists them.
pub const KINDS: &[&SceneKind] = &[&function::KIND, &discs::KIND, &grid::KIND, &tour::KIND, &arm::KIND];

impl Scene {
    /// Reads a scene file's text, of any kind that ships.
    ///
    /// ```
    /// let text = r#"{"format": "forage-scene", "version": 1, "kind": "function", "name": "s", "title": "Sphere",
    ///                "function": "sphere", "dimension": 3}"#;
    /// assert_eq!(forage::Scene::from_json(text)?.name(), "s");
    /// let wrong = text.replace("3", "-3");
    /// assert_eq!(forage::Scene::from_json(&wrong).unwrap_err().field(), "dimension");
    /// # Ok::<(), forage::Error>(())
    /// ```
    ///
    /// # Errors
    /// As [`Scene::read`].
    pub fn from_json(text: &str) -> Result<Self, Error> {
        Self::read(KINDS, text)
    }

    /// Reads a scene from an object in memory, of any kind that ships.
    ///
    /// # Errors
    /// As [`Scene::read_value`].
    pub fn from_value(value: Value) -> Result<Self, Error> {
        Self::read_value(KINDS, value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"{"format": "forage-scene", "version": 1, "kind": "discs", "name": "a", "title": "A",
        "bounds": {"min": [0, 0], "max": [8, 8.5]}, "start": [0, -0.0], "goal": [8, 8], "discs": [{"center": [4, 4], "radius": 1}]}"#;

    fn refused(from: &str, to: &str) -> [String; 3] {
        assert!(TEXT.contains(from));
        let error = Scene::from_json(&TEXT.replacen(from, to, 1)).unwrap_err();
        [error.field(), error.value(), error.allowed()].map(str::to_owned)
    }

    #[test]
    fn every_refusal_names_the_field_what_it_holds_and_what_is_allowed() {
        for (from, to, expected) in [
            ("forage-scene", "other", ["format", "\"other\"", "\"forage-scene\""]),
            (": 1,", ": 2,", ["version", "2", "1"]),
            ("\"discs\",", "3,", ["kind", "3", "one of function, discs, grid, tour, arm"]),
            ("\"title\": \"A\",", "", ["title", "nothing", "a text"]),
            ("\"A\"", "true", ["title", "true", "a text"]),
            ("[8, 8]", "[8]", ["goal", "a list of 1", "a point, [x, y]"]),
            ("[8, 8]", "[8, \"8\"]", ["goal[1]", "\"8\"", "a finite number"]),
            ("{\"min\": [0, 0], \"max\": [8, 8.5]}", "7", ["bounds", "7", "an object with min and max"]),
            ("\"max\": [8, 8.5]", "\"max\": {}", ["bounds.max", "an object", "a point, [x, y]"]),
            ("\"radius\": 1", "\"radius\": null", ["discs[0].radius", "nothing", "a finite number"]),
            (", \"radius\": 1", "", ["discs[0].radius", "nothing", "a finite number"]),
            ("\"radius\"", "\"r\": 1, \"radius\"", ["discs[0].r", "this field", "left out, or one of center, radius"]),
        ] {
            assert_eq!(refused(from, to), expected);
        }
        let [field, _, allowed] = refused("\"start\"", "\"walls\": 3, \"start\"");
        assert!(field == "walls" && allowed.contains("bounds") && allowed.contains("note"), "{allowed}");
    }

    #[test]
    fn the_compact_text_is_read_back_as_the_same_scene() {
        let scene = Scene::from_json(TEXT).unwrap();
        let text = scene.to_compact_json();
        assert!(text.contains(r#""start":[0,0],"goal":[8,8]"#) && text.contains("8.5"), "{text}");
        assert_eq!(Scene::from_json(&text).unwrap(), scene);
    }
}
