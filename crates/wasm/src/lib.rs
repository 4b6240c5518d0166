//! The bindings for browsers and Node.js: they convert types and errors, and decide nothing.
//!
//! Numbers come and go as Float64Array (Float32Array in single precision); tables are
//! `[angle, wavelength]`, flat and row-major. What a room refuses is thrown as an Error with the
//! room's one-line message.
#![allow(clippy::needless_pass_by_value)] // arrays from JavaScript are handed over

mod nacre;
mod optics;

/// What a room refuses, said to JavaScript.
fn refused(error: impl std::fmt::Display) -> wasm_bindgen::JsError {
    wasm_bindgen::JsError::new(&error.to_string())
}
