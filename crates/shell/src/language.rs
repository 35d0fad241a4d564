//! The language that is printed: that of `--lang`, or else the environment's.

use forage_languages::{closest, speak, speaker, tags};

/// The languages that `--lang` takes.
pub(super) fn offered() -> Vec<&'static str> {
    [vec!["en"], tags()].concat()
}

/// Speaks the language that the command line or the environment asks for. An option that names no language is refused later, in
/// English.
pub(super) fn choose() {
    let asked = option(std::env::args_os().skip(1).map(|word| word.to_string_lossy().into_owned()));
    let wanted = asked.map_or_else(environment, |asked| closest(&asked));
    if let Some(tag) = wanted.filter(|&tag| tag != "en") {
        speak(tag);
    }
}

/// The value of `--lang`, which may be anywhere.
fn option(words: impl Iterator<Item = String>) -> Option<String> {
    let mut words = words.take_while(|word| word != "--");
    while let Some(word) = words.next() {
        if word == "--lang" {
            return words.next();
        }
        if let Some(value) = word.strip_prefix("--lang=") {
            return Some(value.to_owned());
        }
    }
    None
}

/// That of the first variable that says one, as POSIX orders them.
fn environment() -> Option<&'static str> {
    let set = |name: &&str| std::env::var(name).ok().filter(|value| !value.is_empty());
    ["LC_ALL", "LC_MESSAGES", "LANG"].iter().find_map(set).and_then(|locale| closest(&locale))
}

/// A text of the catalogue. `place`: the names that lead to it.
pub(super) fn say<'a>(text: &'a str, place: &str) -> &'a str {
    speaker().map_or(text, |speaker| speaker.text(text, place))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_option_may_be_anywhere_before_the_end_of_options() {
        let found = |line: &str| option(line.split(' ').map(str::to_owned));
        assert_eq!(found("--lang zh-CN run pso"), Some("zh-CN".to_owned()));
        assert_eq!(found("run pso --lang=de"), Some("de".to_owned()));
        assert_eq!(found("run -- --lang zh-CN"), None);
        assert_eq!(found("run --lang"), None);
    }
}
