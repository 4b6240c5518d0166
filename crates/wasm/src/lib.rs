//! The bindings for browsers and Node.js: they convert types and errors, and decide nothing.
//!
//! Numbers come and go as Float64Array (Float32Array in single precision and of pixels); tables are
//! `[angle, wavelength]`, flat and row-major. What a room refuses is thrown as an Error with the
//! room's one-line message, and so is a fault of our own.
#![allow(clippy::needless_pass_by_value)] // arrays from JavaScript are handed over

mod colour;
mod difference;
mod job;
mod measure;
mod nacre;
mod optics;
mod pearl;
mod picture;
mod resources;

/// What a room refuses, said to JavaScript.
fn refused(error: impl std::fmt::Display) -> wasm_bindgen::JsError {
    wasm_bindgen::JsError::new(&error.to_string())
}

/// Lets a panic, which is a fault of ours, reach JavaScript as an Error in one line and not as a trap without
/// words. The object that was asked is of no use any more; all others are.
#[wasm_bindgen::prelude::wasm_bindgen(start)]
pub fn tell_panics() {
    std::panic::set_hook(Box::new(|panic| {
        let (payload, place) = (panic.payload(), panic.location());
        let text = payload.downcast_ref::<&str>().copied();
        let text = text.or_else(|| payload.downcast_ref::<String>().map(String::as_str));
        let what = text.unwrap_or("a fault").replace('\n', " ");
        let place = place.map(ToString::to_string).unwrap_or_default();
        wasm_bindgen::throw_val(
            refused(format!("broken off: {what} ({place}); please report this")).into(),
        )
    }));
}
