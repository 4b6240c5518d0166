//! Recipes to test with: complete ones from `tests/golden/recipes`, and changes of them.

use nacreous_render::spec::Recipe;
use serde_json::Value;

/// A complete recipe as `nacreous.image.recipe_json` writes it.
pub fn value(name: &str) -> Value {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/golden/recipes");
    let text = std::fs::read_to_string(format!("{folder}/{name}.json")).expect("a golden recipe");
    serde_json::from_str(&text).expect("JSON")
}

/// The recipe with some values changed, by their places.
pub fn recipe(name: &str, changes: &[(&str, Value)]) -> Recipe {
    let mut value = value(name);
    for (place, new) in changes {
        *value.pointer_mut(place).expect("a key of the recipe") = new.clone();
    }
    Recipe::from_json(&value.to_string()).expect("a recipe")
}
