//! The binary `forage`.

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    forage_cli::main_with(forage::Registry::standard())
}

/// There is no shell in wasm.
#[cfg(target_arch = "wasm32")]
fn main() {}
