//! `cargo xtask wasm` builds `target/wasm/`: `nacreous.js`, an ES module for browsers and Node.js,
//! `nacreous_bg.wasm` beside it, and its TypeScript declarations; and the same of `nacreous_files`, the codecs
//! of pictures, which a page fetches when it first opens or saves one.
//!
//! It installs nothing. Where Rust's WebAssembly target is missing it prints the line that installs
//! it and ends with status 2.

use std::path::Path;
use std::process::{Command, ExitCode};

use wasm_bindgen_cli_support::Bindgen;

/// Crates, and what their bundles are called.
const BUNDLES: [(&str, &str); 2] =
    [("nacreous-wasm", "nacreous"), ("nacreous-wasm-files", "nacreous_files")];

const TARGET: &str = "wasm32-unknown-unknown";

fn main() -> ExitCode {
    let task = std::env::args().nth(1);
    if task.as_deref() != Some("wasm") {
        eprintln!("call: cargo xtask wasm");
        return ExitCode::from(2);
    }
    if !target_is_installed() {
        eprintln!("Rust's WebAssembly target is missing; nothing was built. Install it with:");
        eprintln!("      rustup target add {TARGET}");
        return ExitCode::from(2);
    }
    match build() {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("{problem}");
            ExitCode::FAILURE
        }
    }
}

fn target_is_installed() -> bool {
    let asked =
        Command::new("rustc").args(["--print", "target-libdir", "--target", TARGET]).output();
    asked.is_ok_and(|said| Path::new(String::from_utf8_lossy(&said.stdout).trim()).is_dir())
}

fn build() -> Result<(), String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let target = root.join("target");
    let built = Command::new("cargo")
        .args(["build", "--quiet", "--release", "--target", TARGET])
        .args(BUNDLES.map(|(package, _)| format!("--package={package}")))
        .arg("--target-dir")
        .arg(&target)
        .current_dir(&root)
        // They would replace the vector instructions that .cargo/config.toml asks for.
        .env_remove("RUSTFLAGS")
        .env_remove("CARGO_ENCODED_RUSTFLAGS")
        .status()
        .map_err(|error| format!("cargo does not start: {error}"))?;
    if !built.success() {
        return Err("the crates for browsers did not build".to_owned());
    }
    BUNDLES.iter().try_for_each(|(package, name)| bundle(&target, package, name))
}

fn bundle(target: &Path, package: &str, name: &str) -> Result<(), String> {
    let program = format!("release/{}.wasm", package.replace('-', "_"));
    Bindgen::new()
        .input_path(target.join(TARGET).join(program))
        .out_name(name)
        // Without an address, init() takes the file beside the module.
        .omit_default_module_path(false)
        .web(true)
        .and_then(|bindgen| bindgen.typescript(true).generate(target.join("wasm")))
        .map_err(|error| format!("no bundle {name}: {error:#}"))
}
