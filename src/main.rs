//! The shell: `forage list`, `forage run`, `forage exact`, `forage convert`, `forage generate`, `forage reproduce`,
//! `forage experiment`.

#[cfg(not(target_arch = "wasm32"))]
mod cli;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    cli::main()
}

/// The page and Node use the library; there is no shell in wasm.
#[cfg(target_arch = "wasm32")]
fn main() {}
