//! Text for people: escaped control characters, shortened values, rounded numbers, wrapped lines.

use forage::{kernel::Message, message};
use unicode_linebreak::linebreaks;
use unicode_width::{UnicodeWidthChar, UnicodeWidthStr};

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
    if text.is_empty() { message!("shell-empty-text", "an empty text").to_string() } else { format!("`{}`", shorten(text, 70)) }
}

/// Names with commas between.
pub(super) fn listed<T: AsRef<str>>(names: &[T]) -> String {
    let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
    names.join(&message!("shell-comma", ", ").text())
}

/// Names between backquotes, of which one is meant.
pub(super) fn either<T: AsRef<str>>(names: &[T]) -> String {
    let names = names.iter().map(|name| format!("`{}`", name.as_ref()));
    names.reduce(|first, second| message!("shell-or", "{first} or {second}", first, second).to_string()).unwrap_or_default()
}

/// Names that are written, each between backquotes.
pub(super) fn together(names: &[String]) -> String {
    all_of(&names.iter().map(|name| quoted(name)).collect::<Vec<_>>())
}

/// Names with "and" between.
pub(super) fn all_of<T: AsRef<str>>(names: &[T]) -> String {
    let names = names.iter().map(|name| name.as_ref().to_owned());
    names.reduce(|first, second| message!("shell-and", "{first} and {second}", first, second).to_string()).unwrap_or_default()
}

/// A list of names with at most about `most` characters; what does not fit is counted.
pub(super) fn cut_list(names: &[&str], most: usize) -> String {
    let mut kept: Vec<String> = Vec::new();
    for name in names {
        let name = shorten(name, 40);
        if !kept.is_empty() && listed(&kept).chars().count() + name.chars().count() + 2 > most {
            let more = names.len() - kept.len();
            return message!("shell-more-names", "{names}, … {more} more", names = listed(&kept), more).to_string();
        }
        kept.push(name);
    }
    listed(&kept)
}

/// What is said of a place.
pub(super) fn at(place: &str, said: &Message) -> Message {
    message!("shell-at", "{place}: {said}", place, said)
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

/// How many columns a text takes: Han takes two for each character.
pub(super) fn wide(text: &str) -> usize {
    UnicodeWidthStr::width(text)
}

/// A text and spaces up to so many columns.
pub(super) fn padded(text: &str, columns: usize) -> String {
    format!("{text}{}", " ".repeat(columns.saturating_sub(wide(text))))
}

/// Breaks a text into lines of at most `columns` columns; the lines after the first are indented.
pub(super) fn wrap(text: &str, columns: usize, indent: usize) -> String {
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let han = |c: Option<char>| c.and_then(UnicodeWidthChar::width) == Some(2);
    // Words are whole: between letters and signs there would be places to break, too.
    let whole =
        |at: usize| text[..at].ends_with(' ') || at == text.len() || han(text[..at].chars().last()) || han(text[at..].chars().next());
    let (mut lines, mut used, mut from) = (String::new(), indent, 0);
    for (at, _) in linebreaks(&text).filter(|&(at, _)| whole(at)) {
        let piece = &text[from..at];
        from = at;
        if used > indent && used + wide(piece.trim_end()) > columns {
            lines.truncate(lines.trim_end().len());
            lines.push('\n');
            lines.push_str(&" ".repeat(indent));
            used = indent;
        }
        lines.push_str(piece);
        used += wide(piece);
    }
    lines
}

/// Cuts a text to at most `columns` columns.
pub(super) fn fit(text: &str, columns: usize) -> String {
    if wide(text) <= columns {
        return text.to_owned();
    }
    let mut cut = String::new();
    for character in text.chars() {
        if wide(&cut) + UnicodeWidthChar::width(character).unwrap_or(0) + 1 > columns {
            break;
        }
        cut.push(character);
    }
    cut + "…"
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
        assert_eq!(wrap("粒子保留部分速度，同时移向 A* 群体最优", 12, 0), "粒子保留部分\n速度，同时移\n向 A* 群体最\n优");
        assert_eq!((fit("惯性权重", 6).as_str(), padded("惯性", 6).as_str(), wide("权 w")), ("惯性…", "惯性  ", 4));
    }
}
