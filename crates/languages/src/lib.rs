//! Messages and texts of Forage in other languages than English, for native programs.
//!
//! ```
//! assert!(forage_languages::speak("zh-CN"));
//! let said = forage::kernel::Error::refused("population", 0_usize, forage::message!("demo-allowed", "more"));
//! assert!(said.to_string().contains("population"));
//! ```
//!
//! The files are those of `locales/`, a folder for each language.

mod speaker;
mod texts;

use std::sync::OnceLock;

use forage::kernel::message::speak_by;

pub use speaker::Speaker;
pub use texts::{Texts, tags};

static SPEAKER: OnceLock<Speaker> = OnceLock::new();

/// Has messages said in a language from now on; only the first call counts. Whether they are: false if there is no such
/// language, or if another one is spoken already.
pub fn speak(tag: &str) -> bool {
    let Some(speaker) = Speaker::of(tag) else { return false };
    SPEAKER.get_or_init(|| speak_in(speaker)).tag() == tag
}

fn speak_in(speaker: Speaker) -> Speaker {
    speak_by(|message| SPEAKER.get()?.message(message));
    speaker
}

/// What messages are said by; `None`: English.
pub fn speaker() -> Option<&'static Speaker> {
    SPEAKER.get()
}

/// The language among those that there are which a tag or a locale asks for: `zh`, `zh-Hans`, `zh_CN.UTF-8`; `en` for English.
pub fn closest(wanted: &str) -> Option<&'static str> {
    let plain = wanted.split(['.', '@']).next().unwrap_or_default().replace('_', "-").to_lowercase();
    let base = |tag: &str| tag.split('-').next().unwrap_or_default().to_lowercase();
    let all = || tags().into_iter().chain(["en"]);
    all().find(|tag| tag.to_lowercase() == plain).or_else(|| all().find(|tag| base(tag) == base(&plain)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_locale_asks_for_the_closest_language() {
        for (wanted, found) in [
            ("zh-CN", Some("zh-CN")),
            ("zh_CN.UTF-8", Some("zh-CN")),
            ("zh", Some("zh-CN")),
            ("zh-Hans-SG", Some("zh-CN")),
            ("en_GB.UTF-8", Some("en")),
            ("C", None),
            ("C.UTF-8", None),
            ("POSIX", None),
            ("", None),
            ("xx", None),
        ] {
            assert_eq!(closest(wanted), found, "{wanted}");
        }
    }
}
