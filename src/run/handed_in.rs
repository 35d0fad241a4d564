//! Lists of links to grade.

/// What was handed in: what stands before a link says whose it is.
#[derive(Debug, Clone, Copy)]
pub struct Handed<'a> {
    /// The number of its line, from 1.
    pub line: usize,
    /// What stands before the link.
    pub name: &'a str,
    /// The link, or a line that has none.
    pub link: &'a str,
}

/// What the lines of a list have. Empty lines and comments are left out.
pub fn handed_in(text: &str) -> impl Iterator<Item = Handed<'_>> {
    text.lines().enumerate().filter_map(|(k, line)| handed(k + 1, line))
}

fn handed(line: usize, text: &str) -> Option<Handed<'_>> {
    let text = text.trim();
    if text.is_empty() || text.starts_with("# ") {
        return None;
    }
    let Some(fragment) = text.find("#v=") else { return Some(Handed { line, name: "", link: text }) };
    // An address has no spaces and no quotes; before it, commas, semicolons and colons part it from a name, in Chinese, too.
    let parts = |c: char| c.is_whitespace() || ['"', ',', ';', '，', '；', '：'].contains(&c);
    let begin = text[..fragment].rfind(parts).map_or(0, |at| text[at..].chars().next().map_or(at, |c| at + c.len_utf8()));
    let end = text[fragment..].find(|c: char| c.is_whitespace() || c == '"').map_or(text.len(), |at| fragment + at);
    // No link ends with a mark: that is the sentence's, or the list's.
    let link = text[begin..end].trim_end_matches([',', ';', '.', '，', '；', '。', '、']);
    Some(Handed { line, name: text[..begin].trim_matches(|c| parts(c) || c == ':'), link })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<(usize, &str, &str)> {
        handed_in(text).map(|one| (one.line, one.name, one.link)).collect()
    }

    #[test]
    fn names_stand_before_links_in_any_script() {
        let text = "# who\n\nAda: https://a.org/#v=1&at=2\n\"B, C\",\"#v=1&at=3\" x\n张三\u{3000}#v=1&at=4\n李四，https://a.org/#v=1\n王五：#v=2。\nEve: #v=1&at=5, late\nnothing\n";
        assert_eq!(
            read(text),
            [
                (3, "Ada", "https://a.org/#v=1&at=2"),
                (4, "B, C", "#v=1&at=3"),
                (5, "张三", "#v=1&at=4"),
                (6, "李四", "https://a.org/#v=1"),
                (7, "王五", "#v=2"),
                (8, "Eve", "#v=1&at=5"),
                (9, "", "nothing"),
            ]
        );
    }
}
