//! The bindings of files for browsers: pictures in and out, measured lights, and the grain of photographs.
//!
//! A bundle of its own, for a page fetches it when its first file is opened or saved. It converts types and errors and
//! decides nothing. What a room refuses is thrown as an Error with the room's one line, without the file's name.
#![allow(clippy::needless_pass_by_value)] // arrays from JavaScript are handed over

mod layers;
mod light;

use js_sys::{Array, Object, Reflect};
use nacreous_file::picture::PictureFileError;
use wasm_bindgen::prelude::*;

/// What a room refuses, said to JavaScript.
fn refused(error: impl std::fmt::Display) -> JsError {
    JsError::new(&error.to_string())
}

/// A file of no bytes has no format that could be named.
fn check_bytes(bytes: &[u8]) -> Result<(), JsError> {
    if bytes.is_empty() { Err(refused(PictureFileError::Empty)) } else { Ok(()) }
}

/// An object with these keys.
fn object(entries: &[(&str, JsValue)]) -> Result<Object, JsValue> {
    let made = Object::new();
    for (key, value) in entries {
        Reflect::set(&made, &(*key).into(), value)?;
    }
    Ok(made)
}

/// Texts as pairs (keyword, text).
fn pairs(texts: &[(String, String)]) -> Array {
    let pair = |(keyword, text): &(String, String)| {
        [keyword, text].into_iter().map(|one| JsValue::from_str(one)).collect::<Array>()
    };
    texts.iter().map(pair).collect()
}

/// Lets a panic, here one of a decoder in a damaged file, reach JavaScript as an Error in the words that it has natively.
#[wasm_bindgen(start)]
pub fn tell_panics() {
    std::panic::set_hook(Box::new(|_| {
        let given_up = PictureFileError::Damaged("its decoder gave up".to_owned());
        wasm_bindgen::throw_val(refused(given_up).into())
    }));
}
