//! No two files of a crate lead to each other, at any distance.
#![cfg(not(target_arch = "wasm32"))]

#[path = "support/imports.rs"]
mod imports;

use std::{collections::BTreeSet, fmt::Write, path::Path};

use imports::{Arrows, arrows, circles};

/// The crates, by their root files.
const CRATES: [&str; 4] = ["src/lib.rs", "crates/shell/src/lib.rs", "crates/derive/src/lib.rs", "crates/study/src/lib.rs"];

/// Every circle of every crate, edge by edge; empty if there is none.
fn found() -> String {
    let mut found = String::new();
    for root in CRATES {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(root);
        let arrows = arrows(&path);
        let folder = Path::new(root).parent().unwrap().to_string_lossy().into_owned();
        circles(&arrows).iter().for_each(|circle| tell(&folder, &arrows, circle, &mut found));
    }
    found
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
    let found = found();
    assert!(found.is_empty(), "{found}");
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
