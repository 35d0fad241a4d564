//! Numbers and languages as options take them: what is refused says what is allowed.

use std::num::NonZeroUsize;

use forage::{kernel::Message, message};

pub(super) fn threads(text: &str) -> Result<NonZeroUsize, String> {
    let threads = whole_number(text, 1, 1024)?;
    // It is at least 1.
    Ok(usize::try_from(threads).ok().and_then(NonZeroUsize::new).unwrap_or(NonZeroUsize::MIN))
}

pub(super) fn many(text: &str) -> Result<NonZeroUsize, String> {
    let number = whole_number(text, 1, 1_000_000)?;
    Ok(usize::try_from(number).ok().and_then(NonZeroUsize::new).unwrap_or(NonZeroUsize::MIN))
}

pub(super) fn runs(text: &str) -> Result<u64, String> {
    whole_number(text, 2, 1_000_000)
}

pub(super) fn share(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|number| (0.0..=1.0).contains(number));
    let allowed = || message!("error-number-from-to", "a number from {low} to {high}", low = 0.0, high = 1.0);
    number.ok_or_else(|| must_be(&allowed()))
}

pub(super) fn seconds(text: &str) -> Result<u64, String> {
    whole_number(text, 1, 86_400)
}

pub(super) fn problem(text: &str) -> Result<usize, String> {
    // No file of problems can hold more.
    whole_number(text, 0, u64::from(u32::MAX)).map(|number| number as usize)
}

pub(super) fn whole<const LEAST: u64, const MOST: u64>(text: &str) -> Result<u64, String> {
    whole_number(text, LEAST, MOST)
}

pub(super) fn whole_number(text: &str, least: u64, most: u64) -> Result<u64, String> {
    let number = text.parse().ok().filter(|number| (least..=most).contains(number));
    let allowed = || message!("error-whole-from-to", "a whole number from {min} to {max}", min = least.to_string(), max = most.to_string());
    number.ok_or_else(|| must_be(&allowed()))
}

/// A language, or what asks for one: `zh`, `zh_CN.UTF-8`.
pub(super) fn language(text: &str) -> Result<String, String> {
    let known = || [vec!["en"], forage_languages::tags()].concat().join(", ");
    let found = forage_languages::closest(text).map(str::to_owned);
    found.ok_or_else(|| must_be(&message!("error-one-of", "one of {names}", names = known())))
}

/// What an option's value must be.
pub(super) fn must_be(allowed: &Message) -> String {
    message!("shell-must-be", "it must be {allowed}", allowed).to_string()
}
