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

/// Reads `#rrggbb` or `#rrggbbaa`; `None` for any other text.
pub fn read_color(text: &str) -> Option<Rgba> {
    let digits: Option<Vec<u8>> = text.strip_prefix('#')?.bytes().map(|letter| digit(letter.to_ascii_lowercase())).collect();
    match *digits?.as_chunks().0 {
        [[r, s], [g, h], [b, c]] if text.len() == 7 => Some([16 * r + s, 16 * g + h, 16 * b + c, 255]),
        [[r, s], [g, h], [b, c], [a, d]] if text.len() == 9 => Some([16 * r + s, 16 * g + h, 16 * b + c, 16 * a + d]),
        _ => None,
    }
}

/// The colour of a share from 0 to 1 in a row of colours at equal distances; channels from 0 to 255. Of no colour: nothing.
pub fn color_at(colors: &[Rgba], share: f64) -> [f64; 4] {
    let last = colors.len().saturating_sub(1);
    let along = share.clamp(0.0, 1.0) * last as f64;
    let i = (along as usize).min(last.saturating_sub(1));
    let channels = |k: usize| colors.get(k).map_or([0.0; 4], |color| color.map(f64::from));
    let (from, to) = (channels(i), channels((i + 1).min(last)));
    std::array::from_fn(|c| from[c] + (along - i as f64) * (to[c] - from[c]))
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
        let palette: BTreeMap<String, Vec<String>> = serde_json::from_str(PALETTE).unwrap();
        assert!(palette.len() > 50);
        for (name, colours) in palette {
            // Some have a third one, for paper.
            let [light, dark, ..] = &colours[..] else { panic!("{name}") };
            assert_eq!(Color::named(&name), Color::new(light, dark), "{name}");
        }
    }

    #[test]
    fn colours_are_read_and_mixed() {
        assert_eq!(read_color("#0A10ff"), Some([10, 16, 255, 255]));
        assert_eq!(read_color("#9678c880"), Some([150, 120, 200, 128]));
        for wrong in ["", "#", "0a10ff", "#0a10f", "#0a10ff8", "#0a10ff800", "#0a10fg", "red", "#0é10f"] {
            assert_eq!(read_color(wrong), None, "{wrong}");
        }
        let three = [[0, 0, 0, 0], [10, 20, 30, 40], [20, 40, 60, 80]];
        let shares = [-1.0, 0.0, 0.25, 0.5, 0.75, 1.0, 2.0];
        assert_eq!(shares.map(|share| color_at(&three, share)[0]), [0.0, 0.0, 5.0, 10.0, 15.0, 20.0, 20.0]);
        assert_eq!((color_at(&three[2..], 0.3), color_at(&[], 0.3)), ([20.0, 40.0, 60.0, 80.0], [0.0; 4]));
    }

    #[test]
    fn a_colour_is_read_and_written_with_its_opacity() {
        let color = Color::new("#0a10ff", "#9678c880");
        assert_eq!((color.light, color.dark), ([10, 16, 255, 255], [150, 120, 200, 128]));
        assert_eq!(serde_json::to_string(&color).unwrap(), r##"{"light":"#0a10ff","dark":"#9678c880"}"##);
    }
}
