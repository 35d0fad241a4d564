//! The binary `forage`.

#[cfg(not(target_arch = "wasm32"))]
mod shell;

#[cfg(not(target_arch = "wasm32"))]
fn main() -> std::process::ExitCode {
    shell::main()
}

/// There is no shell in wasm.
#[cfg(target_arch = "wasm32")]
fn main() {}
