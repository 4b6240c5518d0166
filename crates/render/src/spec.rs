//! A complete pearl and scene, as the declarations of the keys (`nacreous/spec/`) write them out:
//! every default filled in, `null` where a key is left out and the renderer finds its value.
//!
//! Unknown keys and unknown words are refused, and so are numbers outside their keys' declared ranges.

pub mod lights;
pub mod nacre;
pub mod pearl;
mod ranges;
pub mod scene;

use nacreous_colour::decode;
use nacreous_image::Rgb;
use serde::{Deserialize, Deserializer, de::Error};
use serde_json::Value;

use crate::RenderError;
use nacre::NacreSpec;
use pearl::PearlSpec;
use scene::SceneSpec;

/// Everything that makes a picture, files apart.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Recipe {
    /// The pearls given, each different one once.
    pub pearls: Vec<PearlSpec>,
    /// What stands around them; its rows name them `*0`, `*1` and so on.
    pub scene: SceneSpec,
    /// Pixels a side.
    pub size: usize,
    /// Samples a pixel, a square number.
    pub samples: usize,
}

impl Recipe {
    /// Reads a recipe in JSON.
    ///
    /// # Errors
    /// [`RenderError::Recipe`] for what is no recipe: an unknown key, a missing one, an unknown word;
    /// [`RenderError::OutOfRange`] for a number that its key does not allow.
    pub fn from_json(text: &str) -> Result<Self, RenderError> {
        let value: Value = from_json(text)?;
        if !value.is_object() {
            let wanted = "wanted: an object with pearls, scene, size and samples";
            return Err(RenderError::Recipe(wanted.to_owned()));
        }
        if let Some(pearls) = value.get("pearls").and_then(Value::as_array) {
            for (i, pearl) in pearls.iter().enumerate() {
                ranges::check(pearl, "pearl", &format!("pearls.{i}"))?;
            }
        }
        if let Some(scene) = value.get("scene") {
            ranges::check(scene, "scene", "scene")?;
        }
        Self::deserialize(value).map_err(|error| RenderError::Recipe(error.to_string()))
    }
}

impl PearlSpec {
    /// Reads one of a recipe's pearls in JSON.
    ///
    /// # Errors
    /// As [`Recipe::from_json`].
    pub fn from_json(text: &str) -> Result<Self, RenderError> {
        part_from_json(text, "pearl", "pearl")
    }
}

impl NacreSpec {
    /// Reads the `nacre` of one of a recipe's pearls in JSON.
    ///
    /// # Errors
    /// As [`Recipe::from_json`].
    pub fn from_json(text: &str) -> Result<Self, RenderError> {
        part_from_json(text, "pearl.nacre", "nacre")
    }
}

/// A part, its numbers held to the ranges of `path`; messages call it `place`.
fn part_from_json<T: for<'a> Deserialize<'a>>(
    text: &str,
    path: &str,
    place: &str,
) -> Result<T, RenderError> {
    let value: Value = from_json(text)?;
    ranges::check(&value, path, place)?;
    T::deserialize(value).map_err(|error| RenderError::Recipe(error.to_string()))
}

/// Reads one part of a recipe.
///
/// # Errors
/// As [`Recipe::from_json`].
pub fn from_json<T: for<'a> Deserialize<'a>>(text: &str) -> Result<T, RenderError> {
    serde_json::from_str(text).map_err(|error| RenderError::Recipe(error.to_string()))
}

/// A colour written as `#rrggbb` in codes of sRGB, as linear RGB.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Colour(pub Rgb);

impl<'de> Deserialize<'de> for Colour {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let text = String::deserialize(deserializer)?;
        let refused = || D::Error::custom(format!("colour is {text:?}; allowed: \"#rrggbb\""));
        let is_code = |digits: &&str| {
            digits.len() == 6 && digits.bytes().all(|digit| digit.is_ascii_hexdigit())
        };
        let digits = text.strip_prefix('#').filter(is_code);
        let code = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
        let code = code.ok_or_else(refused)?;
        Ok(Self([16, 8, 0].map(|shift| decode(f64::from((code >> shift) & 0xff) / 255.0))))
    }
}
