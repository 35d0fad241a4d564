//! Known names: which one was meant, and which ones shells can complete.

use clap::{
    Arg, Command,
    builder::{PossibleValue, StringValueParser, TypedValueParser},
    error::Error as ClapError,
};
use forage::{kernel::Message, message};
use forage_study::registry::{REPRODUCTIONS, STUDIES};

use crate::registry::registry;

use super::text::{self, cut_list, either, quoted};

/// Whose parameters a message is about.
#[derive(Clone, Copy)]
pub(super) enum Subject<'a> {
    /// It is not known.
    Unknown,
    /// A planner's, a generator's, those of `drive` or `motion`: what `forage list` shows a page about.
    Named(&'a str),
}

/// All planners.
pub(super) fn planners() -> Vec<&'static str> {
    registry().planners().iter().map(|entry| entry.name).collect()
}

/// All shipped scenes.
pub(super) fn scenes() -> Vec<&'static str> {
    registry().scenes().iter().map(|scene| scene.name()).collect()
}

/// The names of all generators.
pub(super) fn generators() -> Vec<&'static str> {
    registry().generators().iter().map(|generator| generator.name).collect()
}

/// The names of all followers of a path.
pub(super) fn followers() -> Vec<&'static str> {
    registry().followers().iter().map(|follower| follower.name).collect()
}

/// All reproductions.
pub(super) fn reproductions() -> Vec<&'static str> {
    REPRODUCTIONS.iter().map(|reproduction| reproduction.name).collect()
}

/// All studies of our own.
pub(super) fn studies() -> Vec<&'static str> {
    STUDIES.iter().map(|study| study.name).collect()
}

/// All names that `forage list NAME` shows a page about.
pub(super) fn pages() -> Vec<&'static str> {
    [planners(), scenes(), generators(), followers()].concat()
}

/// The message about a name that is not one of `known`.
pub(super) fn unknown(field: &str, value: &str, known: &[&str], subject: Subject<'_>) -> Message {
    // A name may be followed by where it was looked for: `c2 (pso on sphere)`.
    let (known, place) = match known.split_last() {
        Some((last, others)) => match last.split_once(" (") {
            Some((last, place)) => ([others, &[last]].concat(), place.trim_end_matches(')')),
            None => (known.to_vec(), ""),
        },
        None => (Vec::new(), ""),
    };
    let value = quoted(value.trim());
    let nearest = nearest(value.trim_matches('`'), &known);
    let (said, whole) = no_such_name(field, &value, subject);
    let said = if place.is_empty() { said } else { message!("shell-with-place", "{said} ({place})", said, place) };
    let said = if field.contains(['[', '.']) { text::at(field, &said) } else { said };
    if nearest.is_empty() {
        let list = cut_list(&known, 110);
        let said = message!("shell-must-be-one-of", "{said}; it must be one of {list}", said, list);
        return if list.contains('…') && !whole.is_empty() { hinted(&said, &whole) } else { said };
    }
    meant(&said, &nearest).then(whole)
}

/// What is wrong, and what may have been meant.
pub(super) fn meant(said: &Message, near: &[impl AsRef<str>]) -> Message {
    message!("shell-did-you-mean", "{said}; did you mean {names}?", said, names = either(near))
}

/// What is wrong, and what helps.
pub(super) fn hinted(said: &Message, hint: &Message) -> Message {
    message!("shell-hint", "{said}; {hint}", said, hint)
}

/// That a field's name is none of those that there are, and which command shows all of them.
fn no_such_name(field: &str, value: &str, subject: Subject<'_>) -> (Message, Message) {
    let last = field.rsplit('.').next().unwrap_or(field);
    if field == "planner" || field.starts_with("planner[") && last == "name" {
        let all = message!("shell-all-planners", "`forage list` shows all planners");
        return (message!("shell-no-planner", "{value} is not a planner", value), all);
    }
    match (last, subject) {
        ("scene", _) => (
            message!("shell-no-shipped-scene", "{value} is not a shipped scene", value),
            message!("shell-all-shipped-scenes", "`forage list` shows all scenes"),
        ),
        ("generator", _) => (
            message!("shell-no-generator", "{value} is not a generator", value),
            message!("shell-all-generators", "`forage list` shows all generators"),
        ),
        ("STUDY", _) => (
            message!("shell-no-study", "{value} is not a study", value),
            message!("shell-all-studies", "`forage study --help` shows all names"),
        ),
        ("NAME", _) => (
            message!("shell-no-reproduction", "{value} is not a reproduction", value),
            message!("shell-all-reproductions", "`forage reproduce --help` shows all names"),
        ),
        ("parameter" | "params", Subject::Named(name)) => (
            message!("shell-no-parameter-of", "{value} is not a parameter of {name}", value, name),
            message!("shell-all-parameters", "`forage list {name}` shows its parameters", name),
        ),
        ("preset", Subject::Named(name)) => (
            message!("shell-no-preset-of", "{value} is not a preset of {name}", value, name),
            message!("shell-all-presets", "`forage list {name}` shows its presets", name),
        ),
        ("parameter" | "params", Subject::Unknown) => {
            (message!("shell-no-parameter", "{value} is not a parameter", value), Message::default())
        }
        _ => (message!("shell-no-field-of", "{value} is not a field of `{last}`", value, last), Message::default()),
    }
}

/// The known names that are nearest to what was typed, three at most; none if all are far away.
pub(super) fn nearest<'a>(typed: &str, known: &[&'a str]) -> Vec<&'a str> {
    const LONGEST: usize = 60;
    let plain = |name: &str| name.to_lowercase().replace(['_', ' '], "-");
    let typed = plain(typed);
    let length = typed.chars().count();
    // One letter is near to every other one.
    if !(2..=LONGEST).contains(&length) {
        return Vec::new();
    }
    let mut close: Vec<(usize, &str)> = known.iter().map(|&name| (strsim::damerau_levenshtein(&typed, &plain(name)), name)).collect();
    close.retain(|&(distance, name)| distance <= (length.max(name.chars().count()) / 3).max(1));
    close.sort_by_key(|&(distance, _)| distance);
    let least = close.first().map_or(0, |&(distance, _)| distance);
    let mut names: Vec<&str> = close.into_iter().take_while(|&(distance, _)| distance == least).map(|(_, name)| name).collect();
    if names.is_empty() && length > 2 {
        // A part of a name, as `rrt-con` of `rrt-connect`.
        names =
            known.iter().copied().filter(|name| plain(name).contains(&typed) || name.len() > 2 && typed.contains(&plain(name))).collect();
    }
    names.truncate(3);
    names
}

/// Takes any text, and offers names to a shell's completion.
#[derive(Clone)]
pub(super) struct Offered(pub(super) fn() -> Vec<&'static str>);

impl TypedValueParser for Offered {
    type Value = String;

    fn parse_ref(&self, command: &Command, arg: Option<&Arg>, value: &std::ffi::OsStr) -> Result<String, ClapError> {
        StringValueParser::new().parse_ref(command, arg, value)
    }

    fn possible_values(&self) -> Option<Box<dyn Iterator<Item = PossibleValue> + '_>> {
        Some(Box::new(self.0().into_iter().map(PossibleValue::new)))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_names_are_found() {
        let near = |typed: &str| nearest(typed, &planners());
        assert_eq!(near("wcspo"), ["wcpso"]);
        assert_eq!(near("WCPSO"), ["wcpso"]);
        assert_eq!(near("rrt_star"), ["rrt-star"]);
        assert_eq!(near("held"), ["held-karp"]);
        assert_eq!(near("waldo-and-his-friends"), [""; 0]);
        assert_eq!(near(&"w".repeat(10_000)), [""; 0]);
        assert_eq!(near(""), [""; 0]);
        assert_eq!(nearest("spere", &scenes()), ["sphere"]);
    }

    #[test]
    fn a_page_has_one_name() {
        let mut names = pages();
        names.sort_unstable();
        assert!(names.windows(2).all(|pair| pair[0] != pair[1]), "{names:?}");
    }
}
