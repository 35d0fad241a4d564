//! No two files of a crate lead to each other, at any distance.
//!
//! `tests/circles.txt` lists the files that still do. It only shrinks: `FORAGE_BLESS=1 cargo test --test imports` writes it.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/imports.rs"]
mod imports;

use std::{collections::BTreeSet, fmt::Write, path::Path};

use imports::{Arrows, arrows, circles};

/// The crates, by their root files.
const CRATES: [&str; 3] = ["src/lib.rs", "crates/cli/src/main.rs", "crates/study/src/lib.rs"];
const LIST: &str = "tests/circles.txt";

/// Files in circles, each with its crate's folder in front.
fn in_circles() -> (BTreeSet<String>, String) {
    let (mut files, mut told) = (BTreeSet::new(), String::new());
    for root in CRATES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(root);
        let arrows = arrows(&path);
        let folder = Path::new(root).parent().unwrap().to_string_lossy().into_owned();
        for circle in circles(&arrows) {
            tell(&folder, &arrows, &circle, &mut told);
            files.extend(circle.iter().map(|file| format!("{folder}/{file}")));
        }
    }
    (files, told)
}

/// Every edge of a circle, with the names that make it.
fn tell(folder: &str, arrows: &Arrows, circle: &BTreeSet<String>, out: &mut String) {
    let _ = writeln!(out, "a circle of {} files:", circle.len());
    for from in circle {
        for (to, names) in arrows[from].iter().filter(|(to, _)| circle.contains(*to)) {
            let names: Vec<_> = names.iter().map(String::as_str).collect();
            let _ = writeln!(out, "  {folder}/{from} → {folder}/{to}: {}", names.join(", "));
        }
    }
}

#[test]
fn files_import_one_way() {
    let (found, told) = in_circles();
    let list = Path::new(env!("CARGO_MANIFEST_DIR")).join(LIST);
    if std::env::var_os("FORAGE_BLESS").is_some() {
        let lines: Vec<_> = found.iter().map(String::as_str).chain([""]).collect();
        std::fs::write(&list, lines.join("\n")).unwrap();
        return;
    }
    let text = std::fs::read_to_string(&list).unwrap_or_default();
    let known: BTreeSet<String> = text.lines().map(str::to_owned).collect();
    let fresh: Vec<_> = found.difference(&known).collect();
    assert!(fresh.is_empty(), "these files are in a circle now: {fresh:?}\n{told}");
    let gone: Vec<_> = known.difference(&found).collect();
    assert!(gone.is_empty(), "these are in none any more: take them off {LIST}: {gone:?}");
}

/// The reader sees what hides behind `pub use`, inside of functions and in macros, and not what only tests use.
#[test]
fn paths_are_resolved_to_the_files_that_define_them() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(path, text).unwrap();
    };
    write("lib.rs", "mod a; pub mod b; mod c; pub use a::one;");
    write("a.rs", "use crate::b::Two; pub fn one() -> Two { Two }\n#[cfg(test)] mod tests { use crate::c::three; }");
    write("b/mod.rs", "mod deep; pub use deep::Two;");
    write("b/deep.rs", "pub struct Two; fn f() { use crate::c; println!(\"{}\", c::three()); }");
    write("c.rs", "pub fn three() -> u8 { let _ = crate::one; 3 }");
    let arrows = arrows(&folder.path().join("lib.rs"));
    let to = |from: &str| arrows[from].keys().cloned().collect::<Vec<_>>();
    assert_eq!((to("a.rs"), to("b/deep.rs"), to("c.rs")), (vec!["b/deep.rs".into()], vec!["c.rs".into()], vec!["a.rs".into()]));
    let all = circles(&arrows);
    assert_eq!(all, [["a.rs", "b/deep.rs", "c.rs"].map(str::to_owned).into_iter().collect()]);
}
