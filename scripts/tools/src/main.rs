//! What builds the package and the book: each command passes its arguments on to a library.

use std::{env, fs, path::Path};

use anyhow::{Result, bail};

fn main() -> Result<()> {
    let arguments: Vec<String> = env::args().skip(1).collect();
    match arguments.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        ["split", module, folder] => split(module, folder),
        ["bind", module, folder, name] => bind(module, folder, name),
        #[cfg(feature = "book")]
        ["book", source, folder] => book(source, folder),
        _ => bail!("usage: forage-tools split MODULE FOLDER | bind MODULE FOLDER NAME | book SOURCE FOLDER"),
    }
}

/// Splits a linked wasm module into `main.wasm` and one file for each split point.
fn split(module: &str, folder: &str) -> Result<()> {
    let bytes = fs::read(module)?;
    let folder = Path::new(folder);
    let main = folder.join("main.wasm");
    let mut options = wasm_split_cli_support::Options::new(&bytes);
    options.output_dir = folder;
    options.main_out_path = &main;
    wasm_split_cli_support::transform(options).map_err(|error| anyhow::anyhow!("{error:?}"))?;
    Ok(())
}

/// Writes a module's glue and types, and the module without what they were made of. Parts of the module need its table of
/// functions, which the linker exports.
fn bind(module: &str, folder: &str, name: &str) -> Result<()> {
    wasm_bindgen_cli_support::Bindgen::new()
        .web(true)?
        .input_path(module)
        .omit_default_module_path(false)
        .keep_lld_exports(true)
        .reset_state_function(true)
        .typescript(true)
        .out_name(name)
        .generate(folder)
}

/// Builds a book.
#[cfg(feature = "book")]
fn book(source: &str, folder: &str) -> Result<()> {
    let mut book = mdbook_driver::MDBook::load(source)?;
    book.config.build.build_dir = env::current_dir()?.join(folder);
    book.build()
}
