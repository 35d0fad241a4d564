//! Texts for people: a key and arguments.
//!
//! The English of a message is written where the message is made, and is printed natively. A WebAssembly module carries keys and
//! arguments only, and its host brings the words (see [`speak_by`]), in any language. A module with the feature `english` has
//! the English instead, for a host without words.

#[cfg(not(target_arch = "wasm32"))]
use std::cell::Cell;
use std::{borrow::Cow, fmt, sync::OnceLock};

use serde::{Serialize, Serializer};

use crate::message;

use super::{Digest, State};

/// Whether this build has the English of messages and descriptions.
pub const ENGLISH: bool = cfg!(any(not(target_arch = "wasm32"), feature = "english"));

/// The words of a description: empty in a build without English, whose host has the catalogue.
pub const fn words(text: &'static str) -> &'static str {
    if ENGLISH { text } else { "" }
}

/// A text for people: a key and arguments, and how it sounds in English. Made by [`message!`](crate::message!).
#[derive(Debug, Clone, PartialEq, Default)]
#[cfg_attr(feature = "types", derive(ts_rs::TS), ts(as = "String"))]
pub struct Message {
    key: &'static str,
    english: Cow<'static, str>,
    arguments: Vec<(&'static str, Argument)>,
}

/// What goes into a message.
#[derive(Debug, Clone, PartialEq)]
pub enum Argument {
    /// A number; the message says how many digits are shown.
    Number(f64),
    /// A name, or a text that is not ours, as it is.
    Text(String),
    /// Another message.
    Message(Message),
}

/// A message that exists somewhere in the program, for lists of what there is to translate.
#[derive(Debug, PartialEq, Eq, Serialize)]
pub struct Sentence {
    /// Its key.
    pub key: &'static str,
    /// Its English, with the placeholders of Rust's `format!`.
    pub english: &'static str,
    /// Arguments whose word depends on a number: the name, the word for one, and that for any other number.
    #[serde(skip_serializing_if = "<[_]>::is_empty")]
    pub plurals: &'static [(&'static str, &'static str, &'static str)],
    /// The symbol in TeX that it is the title of; empty for most.
    #[serde(skip_serializing_if = "str::is_empty")]
    pub symbol: &'static str,
}

/// How a host says a message: `None` if it has no words for it.
pub type Speak = fn(&Message) -> Option<String>;

static SPEAK: OnceLock<Speak> = OnceLock::new();

#[cfg(not(target_arch = "wasm32"))]
thread_local! {
    static IN_ENGLISH: Cell<bool> = const { Cell::new(false) };
}

/// Sets how messages are said from now on; without it they are said in English. Only the first call counts.
pub fn speak_by(speak: Speak) {
    SPEAK.get_or_init(|| speak);
}

/// What a function says on this thread is English: files are the same in every language.
#[cfg(not(target_arch = "wasm32"))]
pub fn in_english<T>(say: impl FnOnce() -> T) -> T {
    let before = IN_ENGLISH.replace(true);
    let said = say();
    IN_ENGLISH.set(before);
    said
}

/// How a message is said by the host; `None`: in English.
fn spoken(message: &Message) -> Option<String> {
    #[cfg(not(target_arch = "wasm32"))]
    if IN_ENGLISH.get() {
        return None;
    }
    if message.key.is_empty() { None } else { SPEAK.get().and_then(|speak| speak(message)) }
}

impl Message {
    /// For [`message!`](crate::message!).
    #[doc(hidden)]
    pub const fn new(key: &'static str, english: Cow<'static, str>, arguments: Vec<(&'static str, Argument)>) -> Self {
        Self { key, english, arguments }
    }

    /// For [`message!`](crate::message!): where the English is not inside.
    // There are hundreds: each is a call and no more.
    #[doc(hidden)]
    #[cfg(all(target_arch = "wasm32", not(feature = "english")))]
    #[inline(never)]
    pub fn keyed(key: &'static str, arguments: &[(&'static str, &dyn ToArgument)]) -> Self {
        Self::new(key, Cow::Borrowed(""), arguments.iter().map(|&(name, value)| (name, value.to_argument())).collect())
    }

    /// A text that is said as it is in every language: what is not ours, e.g. the words of a parser.
    pub fn verbatim(text: impl Into<String>) -> Self {
        Self { key: "", english: Cow::Owned(text.into()), arguments: Vec::new() }
    }

    /// The key; empty for a text that is said as it is.
    pub fn key(&self) -> &'static str {
        self.key
    }

    /// What goes into it, by name.
    pub fn arguments(&self) -> &[(&'static str, Argument)] {
        &self.arguments
    }

    /// This sentence, and another one after it.
    #[must_use]
    pub fn then(self, next: Message) -> Self {
        match (self.is_empty(), next.is_empty()) {
            (true, _) => next,
            (_, true) => self,
            _ => message!("sentences", "{first} {second}", first = self, second = next),
        }
    }

    /// Whether there is nothing to say.
    pub fn is_empty(&self) -> bool {
        self.key.is_empty() && self.english.is_empty()
    }

    /// The text, as the host says it, or else in English, or else the key.
    pub fn text(&self) -> Cow<'_, str> {
        match spoken(self) {
            Some(text) => Cow::Owned(text),
            None if ENGLISH || self.key.is_empty() => Cow::Borrowed(&self.english),
            None => Cow::Borrowed(self.key),
        }
    }
}

impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())
    }
}

/// Natively English: what programs write is the same wherever they run. A page's messages cross as they are said.
impl Serialize for Message {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let said = if ENGLISH { Cow::Borrowed(&*self.english) } else { self.text() };
        serializer.serialize_str(&said)
    }
}

/// The hash is over key and arguments: the same in every language.
impl State for Message {
    fn digest(&self, out: &mut Digest) {
        if self.key.is_empty() {
            out.bytes(self.english.as_bytes());
        }
        out.bytes(self.key.as_bytes());
        for (_, argument) in &self.arguments {
            match argument {
                Argument::Number(number) => out.word(number.to_bits()),
                Argument::Text(text) => out.bytes(text.as_bytes()),
                Argument::Message(message) => message.digest(out),
            }
        }
    }

    fn heap_size(&self) -> usize {
        let arguments = self.arguments.iter().map(|(_, argument)| match argument {
            Argument::Number(_) => 0,
            Argument::Text(text) => text.len(),
            Argument::Message(message) => message.heap_size(),
        });
        self.arguments.len() * size_of::<(&str, Argument)>() + arguments.sum::<usize>()
    }
}

/// What can go into a message.
pub trait ToArgument {
    /// It as an argument.
    fn to_argument(&self) -> Argument;
}

impl<T: ToArgument + ?Sized> ToArgument for &T {
    fn to_argument(&self) -> Argument {
        (**self).to_argument()
    }
}

macro_rules! numbers {
    ($($type:ty: $convert:expr,)*) => {
        $(impl ToArgument for $type {
            fn to_argument(&self) -> Argument {
                Argument::Number($convert(*self))
            }
        })*
    };
}

numbers! {
    f64: std::convert::identity,
    u64: |whole| whole as f64,
    usize: |whole| whole as f64,
    u32: f64::from,
    u8: f64::from,
    i32: f64::from,
}

impl ToArgument for Message {
    fn to_argument(&self) -> Argument {
        Argument::Message(self.clone())
    }
}

impl ToArgument for str {
    fn to_argument(&self) -> Argument {
        Argument::Text(self.to_owned())
    }
}

impl ToArgument for String {
    fn to_argument(&self) -> Argument {
        Argument::Text(self.clone())
    }
}

impl ToArgument for Cow<'_, str> {
    fn to_argument(&self) -> Argument {
        Argument::Text(self.clone().into_owned())
    }
}

/// All messages that this program can make, by key; one that is made in several places is there once.
#[cfg(not(target_arch = "wasm32"))]
pub fn sentences() -> Vec<&'static Sentence> {
    let mut sentences: Vec<_> = inventory::iter::<Sentence>().collect();
    sentences.sort_by_key(|sentence| (sentence.key, sentence.english, sentence.symbol));
    sentences.dedup();
    sentences
}

#[cfg(not(target_arch = "wasm32"))]
inventory::collect!(Sentence);

#[cfg(not(target_arch = "wasm32"))]
#[doc(hidden)]
pub use inventory;

/// A message: its key, its English with the placeholders of `format!`, and what goes into it, as `name = value`, or only the name
/// of a variable. A word that depends on a number is written `name = number => "word" | "words"`.
///
/// ```
/// use forage::message;
/// let (left, near) = (2_u64, 0.25);
/// let said = message!("demo-left", "{left} {stops} left, {near:.1} m away", left, stops = left => "stop" | "stops", near);
/// assert_eq!(said.to_string(), "2 stops left, 0.2 m away");
/// assert_eq!(said.key(), "demo-left");
/// ```
#[cfg(not(target_arch = "wasm32"))]
#[macro_export]
macro_rules! message {
    ($key:literal, $english:literal $(, $name:ident $(= $value:expr)? $(=> $one:literal | $other:literal)?)* $(,)?) => {{
        $crate::kernel::inventory::submit! {
            $crate::kernel::Sentence { key: $key, english: $english, plurals: &[$($((stringify!($name), $one, $other),)?)*], symbol: "" }
        }
        $crate::said!($key, $english $(, $name = $crate::argument!($name $($value)?) $(=> $one | $other)?)*)
    }};
}

/// A message: its key, its English and what goes into it.
#[cfg(target_arch = "wasm32")]
#[macro_export]
macro_rules! message {
    ($key:literal, $english:literal $(, $name:ident $(= $value:expr)? $(=> $one:literal | $other:literal)?)* $(,)?) => {
        $crate::said!($key, $english $(, $name = $crate::argument!($name $($value)?) $(=> $one | $other)?)*)
    };
}

/// What goes into a message: a variable of the argument's name where no value is given.
#[doc(hidden)]
#[macro_export]
macro_rules! argument {
    ($name:ident) => {
        $name
    };
    ($name:ident $value:expr) => {
        $value
    };
}

/// The value of [`message!`].
#[cfg(not(target_arch = "wasm32"))]
#[doc(hidden)]
#[macro_export]
macro_rules! said {
    ($key:literal, $english:literal) => {
        $crate::kernel::Message::new($key, ::std::borrow::Cow::Borrowed($english), ::std::vec::Vec::new())
    };
    ($key:literal, $english:literal $(, $name:ident = $value:expr $(=> $one:literal | $other:literal)?)+ $(,)?) => {
        match ($(&$value,)+) {
            ($($name,)+) => $crate::kernel::Message::new(
                $key,
                ::std::borrow::Cow::Owned($crate::kernel::message::in_english(|| {
                    ::std::format!($english, $($name = $crate::said!(@shown $name $($one $other)?)),+)
                })),
                ::std::vec![$((stringify!($name), $crate::kernel::message::ToArgument::to_argument($name))),+],
            ),
        }
    };
    (@shown $name:ident) => { $name };
    (@shown $name:ident $one:literal $other:literal) => { if *$name == 1 { $one } else { $other } };
}

/// Only its English: there is nobody to say it in other words.
#[cfg(all(target_arch = "wasm32", feature = "english"))]
#[doc(hidden)]
#[macro_export]
macro_rules! said {
    ($key:literal, $english:literal) => {
        $crate::kernel::Message::new("", ::std::borrow::Cow::Borrowed($english), ::std::vec::Vec::new())
    };
    ($key:literal, $english:literal $(, $name:ident = $value:expr $(=> $one:literal | $other:literal)?)+ $(,)?) => {
        match ($(&$value,)+) {
            ($($name,)+) => $crate::kernel::Message::verbatim(
                ::std::format!($english, $($name = $crate::said!(@shown $name $($one $other)?)),+),
            ),
        }
    };
    (@shown $name:ident) => { $name };
    (@shown $name:ident $one:literal $other:literal) => { if *$name == 1 { $one } else { $other } };
}

/// Only its key and what goes into it.
#[cfg(all(target_arch = "wasm32", not(feature = "english")))]
#[doc(hidden)]
#[macro_export]
macro_rules! said {
    ($key:literal, $english:literal $(, $name:ident = $value:expr $(=> $one:literal | $other:literal)?)* $(,)?) => {
        $crate::kernel::Message::keyed(
            $key,
            &[$((stringify!($name), &$value as &dyn $crate::kernel::message::ToArgument)),*],
        )
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nothing_before_or_after_a_sentence_leaves_it_as_it_is() {
        let said = || message!("tour-none-yet", "There is no tour yet.");
        assert_eq!(said().then(Message::default()), said());
        assert_eq!(Message::default().then(said()), said());
        assert_eq!(said().then(said()).text(), "There is no tour yet. There is no tour yet.");
        assert!(Message::default().then(Message::default()).is_empty());
    }
}
