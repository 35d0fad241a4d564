//! What there is in each language.

use std::collections::BTreeMap;

use serde::Deserialize;

/// A file: the language's tag, its folder, its content.
type File = (&'static str, &'static str, &'static str);

/// Written by build.rs.
const FILES: &[File] = include!(concat!(env!("OUT_DIR"), "/files.rs"));

/// The tags of all languages besides English, in their order: `zh-CN`.
pub fn tags() -> Vec<&'static str> {
    let mut tags: Vec<_> = FILES.iter().map(|(tag, ..)| *tag).collect();
    tags.dedup();
    tags
}

/// What a language has.
#[derive(Debug, Default)]
pub struct Texts {
    /// Patterns of Fluent by the keys of messages.
    pub messages: BTreeMap<String, String>,
    texts: BTreeMap<String, Said>,
}

#[derive(Deserialize)]
struct Translated {
    says: String,
}

/// How a text is said, and how it is where that is another way.
#[derive(Debug, Deserialize)]
#[serde(untagged)]
enum Said {
    Everywhere(String),
    ByPlace(BTreeMap<String, String>),
}

impl Texts {
    /// The texts of a language; `None` if there is no such language.
    pub fn of(tag: &str) -> Option<Self> {
        if !tags().contains(&tag) {
            return None;
        }
        let messages: BTreeMap<String, Translated> = merged(tag, "messages");
        let messages = messages.into_iter().filter(|(_, entry)| !entry.says.is_empty());
        Some(Self { messages: messages.map(|(key, entry)| (key, entry.says)).collect(), texts: merged(tag, "texts") })
    }

    /// How a text of the catalogue is said. `place`: the names that lead to it, such as `planners.pso.parameters.w.help`.
    pub fn say(&self, text: &str, place: &str) -> Option<&str> {
        let said = match self.texts.get(text)? {
            Said::Everywhere(said) => said,
            Said::ByPlace(places) => {
                let leads = |begin: &str| place.strip_prefix(begin).is_some_and(|rest| rest.is_empty() || rest.starts_with('.'));
                let found = places.iter().filter(|(begin, _)| begin.is_empty() || leads(begin));
                found.max_by_key(|(begin, _)| begin.len()).map(|(_, said)| said)?
            }
        };
        (!said.is_empty()).then_some(said)
    }
}

/// The entries of all files of a language's folder. A test reads them: those that ship are well-formed.
fn merged<T: for<'de> Deserialize<'de>>(tag: &str, folder: &str) -> BTreeMap<String, T> {
    let files = FILES.iter().filter(|(of, within, _)| (*of, *within) == (tag, folder));
    files.flat_map(|(.., text)| serde_json::from_str::<BTreeMap<String, T>>(text).unwrap_or_default()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_language_has_messages_and_texts() {
        assert!(tags().contains(&"zh-CN"));
        for tag in tags() {
            for (_, folder, text) in FILES.iter().filter(|(of, ..)| *of == tag) {
                let parsed: Result<serde_json::Value, _> = serde_json::from_str(text);
                assert!(parsed.is_ok_and(|value| value.as_object().is_some_and(|entries| !entries.is_empty())), "{tag}/{folder}");
            }
            let texts = Texts::of(tag).unwrap();
            assert!(texts.messages.len() > 500 && texts.texts.len() > 1000, "{tag}: {} and {}", texts.messages.len(), texts.texts.len());
        }
        assert!(Texts::of("xx").is_none());
    }

    #[test]
    fn a_text_may_be_said_otherwise_at_a_place() {
        let texts = r#"{"Kept": {"": "keep", "planners.rrt.marks.kept": "kept", "planners.rrt": "stays"}, "One": "one", "Two": ""}"#;
        let texts = Texts { texts: serde_json::from_str(texts).unwrap(), ..Texts::default() };
        assert_eq!(texts.say("Kept", "planners.rrt.marks.kept.title"), Some("kept"));
        assert_eq!(texts.say("Kept", "planners.rrt.layers.tree.title"), Some("stays"));
        assert_eq!(texts.say("Kept", "planners.rrt-star.layers.tree.title"), Some("keep"));
        assert_eq!((texts.say("One", "a"), texts.say("Two", "a"), texts.say("Three", "a")), (Some("one"), None, None));
    }
}
