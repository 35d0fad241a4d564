//! Lists the files of messages and texts of each language, to be compiled in.

use std::{env, fmt::Write, fs, io, path::Path};

fn main() -> io::Result<()> {
    let root = env::var("CARGO_MANIFEST_DIR").map_err(io::Error::other)?;
    let locales = Path::new(&root).join("locales");
    let mut list = String::from("&[\n");
    for language in sorted(&locales)? {
        for folder in ["messages", "texts"] {
            let within = locales.join(&language).join(folder);
            if !within.is_dir() {
                continue;
            }
            println!("cargo::rerun-if-changed={}", within.display());
            for file in sorted(&within)?.iter().filter(|file| Path::new(file).extension().is_some_and(|kind| kind == "json")) {
                let path = within.join(file).display().to_string();
                writeln!(list, "    ({language:?}, {folder:?}, include_str!({path:?})),").map_err(io::Error::other)?;
            }
        }
    }
    list.push(']');
    println!("cargo::rerun-if-changed={}", locales.display());
    fs::write(Path::new(&env::var("OUT_DIR").map_err(io::Error::other)?).join("files.rs"), list)
}

/// The names in a folder, in the same order on every machine.
fn sorted(folder: &Path) -> io::Result<Vec<String>> {
    let entries = fs::read_dir(folder)?.map(|entry| entry.map(|entry| entry.file_name().to_string_lossy().into_owned()));
    let mut names = entries.collect::<io::Result<Vec<_>>>()?;
    names.sort_unstable();
    Ok(names)
}
