//! Colours: by a name of the palette that the page and all pictures share, or a planner's own pair.

use std::fmt::{self, Write};

use serde::{Serialize, Serializer, ser::SerializeStruct};

/// The palette: each name's colour in the light and in the dark theme. The page makes its style sheet of the same file.
pub(crate) const PALETTE: &str = include_str!("palette.json");

/// Red, green, blue and opacity, 0 to 255 each.
pub type Rgba = [u8; 4];

/// A colour in the light and in the dark theme.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct Color {
    /// On a light ground.
    #[cfg_attr(feature = "types", ts(type = "string"))]
    pub light: Rgba,
    /// On a dark ground.
    #[cfg_attr(feature = "types", ts(type = "string"))]
    pub dark: Rgba,
}

impl Color {
    /// A colour of the palette. In a constant, a name that the palette lacks does not compile.
    ///
    /// # Panics
    /// For a name that the palette lacks.
    pub const fn named(name: &str) -> Self {
        let text = PALETTE.as_bytes();
        let mut at = 0;
        // What opens an entry: `"name":`.
        while !(quoted_at(text, at, name.as_bytes()) && text[at + name.len() + 2] == b':') {
            at += 1;
            assert!(at < text.len(), "the palette has no colour of this name");
        }
        at += name.len() + 2;
        let (light, end) = next_color(text, at);
        let (dark, _) = next_color(text, end);
        Self { light, dark }
    }

    /// A colour of a planner's own, in the light and in the dark theme: `#rrggbb` or `#rrggbbaa`.
    ///
    /// # Panics
    /// For any other text. In a constant, it does not compile.
    pub const fn new(light: &str, dark: &str) -> Self {
        Self { light: rgba(light.as_bytes(), 0), dark: rgba(dark.as_bytes(), 0) }
    }

    /// The colour on a light or a dark ground.
    pub const fn on(self, dark: bool) -> Rgba {
        if dark { self.dark } else { self.light }
    }
}

/// A colour as `#rrggbb`, or `#rrggbbaa` where it does not cover what lies beneath.
pub(crate) struct Hex(pub Rgba);

impl fmt::Display for Hex {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bytes = if self.0[3] == 255 { &self.0[..3] } else { &self.0[..] };
        let digit = |value: u8| char::from(b"0123456789abcdef"[usize::from(value & 15)]);
        out.write_char('#')?;
        bytes.iter().flat_map(|byte| [digit(byte >> 4), digit(*byte)]).try_for_each(|digit| out.write_char(digit))
    }
}

impl Serialize for Color {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut out = serializer.serialize_struct("Color", 2)?;
        for (name, color) in [("light", self.light), ("dark", self.dark)] {
            out.serialize_field(name, &*Hex(color).to_string())?;
        }
        out.end()
    }
}

/// Whether `"word"` begins here.
const fn quoted_at(text: &[u8], at: usize, word: &[u8]) -> bool {
    if text[at] != b'"' || at + word.len() + 2 >= text.len() || text[at + word.len() + 1] != b'"' {
        return false;
    }
    let mut i = 0;
    while i < word.len() {
        if text[at + 1 + i] != word[i] {
            return false;
        }
        i += 1;
    }
    true
}

/// The next colour in quotes, and where it ends.
const fn next_color(text: &[u8], from: usize) -> (Rgba, usize) {
    let mut at = from;
    while text[at] != b'#' {
        at += 1;
    }
    (rgba(text, at), at + 7)
}

/// The colour at this place: as many hexadecimal digits as there are, six or eight.
const fn rgba(text: &[u8], at: usize) -> Rgba {
    assert!(text.len() >= at + 7 && text[at] == b'#', "a colour is #rrggbb or #rrggbbaa");
    let opaque = text.len() < at + 9 || digit(text[at + 7]).is_none();
    [two(text, at + 1), two(text, at + 3), two(text, at + 5), if opaque { 255 } else { two(text, at + 7) }]
}

const fn two(text: &[u8], at: usize) -> u8 {
    match (digit(text[at]), digit(text[at + 1])) {
        (Some(high), Some(low)) => 16 * high + low,
        _ => panic!("a colour is #rrggbb or #rrggbbaa"),
    }
}

const fn digit(letter: u8) -> Option<u8> {
    match letter {
        b'0'..=b'9' => Some(letter - b'0'),
        b'a'..=b'f' => Some(letter - b'a' + 10),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeMap;

    use super::*;

    #[test]
    fn every_name_of_the_palette_has_a_colour_by_day_and_by_night() {
        let palette: BTreeMap<String, [String; 2]> = serde_json::from_str(PALETTE).unwrap();
        assert!(palette.len() > 50);
        for (name, [light, dark]) in palette {
            assert_eq!(Color::named(&name), Color::new(&light, &dark), "{name}");
        }
    }

    #[test]
    fn a_colour_is_read_and_written_with_its_opacity() {
        let color = Color::new("#0a10ff", "#9678c880");
        assert_eq!((color.light, color.dark), ([10, 16, 255, 255], [150, 120, 200, 128]));
        assert_eq!(serde_json::to_string(&color).unwrap(), r##"{"light":"#0a10ff","dark":"#9678c880"}"##);
    }
}
