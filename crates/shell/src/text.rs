//! Text for people: escaped control characters, shortened values, rounded numbers, wrapped lines.

use std::fmt::Write;

pub(super) use forage_study::{
    escape::{escape, escape_lines, is_unsafe},
    table::significant,
};

/// Escapes a text and shortens it in the middle to at most `most` characters.
pub(super) fn shorten(text: &str, most: usize) -> String {
    // No more than this can be shown, and escaping only makes it longer.
    let length = text.chars().count();
    let (start, end): (String, String) = if length > 2 * most {
        (text.chars().take(most).collect(), text.chars().skip(length - most).collect())
    } else {
        (text.to_owned(), String::new())
    };
    let [start, end] = [&start, &end].map(|part| escape(part));
    let escaped: Vec<char> = start.chars().chain(end.chars()).collect();
    if length <= 2 * most && escaped.len() <= most {
        return escaped.into_iter().collect();
    }
    let kept = most.saturating_sub(1);
    let (front, back) = (kept.div_ceil(2), kept / 2);
    escaped[..front].iter().chain(&['…']).chain(&escaped[escaped.len() - back..]).collect()
}

/// A value between backquotes, shortened.
pub(super) fn quoted(text: &str) -> String {
    if text.is_empty() { "an empty text".to_owned() } else { format!("`{}`", shorten(text, 70)) }
}

/// A list of names with at most about `most` characters; what does not fit is counted.
pub(super) fn cut_list(names: &[&str], most: usize) -> String {
    let mut text = String::new();
    for (k, name) in names.iter().enumerate() {
        let name = shorten(name, 40);
        if k > 0 && text.chars().count() + name.chars().count() + 2 > most {
            let _ = write!(text, ", … {} more", names.len() - k);
            break;
        }
        if k > 0 {
            text.push_str(", ");
        }
        text.push_str(&name);
    }
    text
}

/// A number with four significant digits.
pub(super) fn number(number: f64) -> String {
    significant(number, 4)
}

/// A number with four significant digits and its unit; `unit` may be empty.
pub(super) fn measured(value: f64, unit: &str) -> String {
    let value = number(value);
    if unit.is_empty() { value } else { format!("{value} {unit}") }
}

/// A point of the plane.
pub(super) fn point([x, y]: [f64; 2]) -> String {
    format!("({}, {})", number(x), number(y))
}

/// How many columns a page of text may use: what the terminal has, 100 at most, and 100 where there is none.
pub(super) fn columns() -> usize {
    let set = std::env::var("COLUMNS").ok().and_then(|columns| columns.parse().ok()).filter(|&columns| columns > 0);
    let terminal = || terminal_size::terminal_size().map(|(terminal_size::Width(columns), _)| usize::from(columns));
    set.or_else(terminal).unwrap_or(100).clamp(40, 100)
}

/// Breaks a text into lines of at most `columns` characters; the lines after the first are indented.
pub(super) fn wrap(text: &str, columns: usize, indent: usize) -> String {
    let mut lines = String::new();
    let mut used = 0;
    for word in text.split_whitespace() {
        let length = word.chars().count();
        if used > 0 && used + 1 + length > columns {
            lines.push('\n');
            lines.push_str(&" ".repeat(indent));
            used = indent;
        } else if used > 0 {
            lines.push(' ');
            used += 1;
        } else {
            used = indent;
        }
        lines.push_str(word);
        used += length;
    }
    lines
}

/// Cuts a text to at most `columns` characters.
pub(super) fn fit(text: &str, columns: usize) -> String {
    if text.chars().count() <= columns {
        return text.to_owned();
    }
    text.chars().take(columns.saturating_sub(1)).chain(['…']).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn long_texts_are_shortened_in_the_middle_after_escaping() {
        assert_eq!(shorten("short", 10), "short");
        assert_eq!(shorten("0123456789", 5), "01…89");
        for long in ["x".repeat(10_000), "\u{1b}".repeat(10_000), "é".repeat(61), "\n".repeat(40)] {
            let short = shorten(&long, 60);
            assert!(short.chars().count() == 60 && short.contains('…'), "{short}");
        }
        assert_eq!(shorten(&format!("{}end", "y".repeat(1000)), 9), "yyyy…yend");
    }

    #[test]
    fn lists_say_how_many_names_they_leave_out() {
        assert_eq!(cut_list(&["a", "b", "c"], 20), "a, b, c");
        assert_eq!(cut_list(&["alpha", "beta", "gamma", "delta"], 12), "alpha, beta, … 2 more");
    }

    #[test]
    fn lines_are_broken_between_words() {
        assert_eq!(wrap("one two three four", 9, 2), "one two\n  three\n  four");
        assert_eq!(fit("abcdef", 4), "abc…");
    }
}
