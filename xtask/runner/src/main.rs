//! Runs the tests of a wasm in a browser: what `wasm-bindgen-test-runner` does, but never of another version than
//! the library's, and compiled with the rest of the workspace.

fn main() -> anyhow::Result<()> {
    wasm_bindgen_cli::wasm_bindgen_test_runner::run_cli_with_args(std::env::args_os())
}
