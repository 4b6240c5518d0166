//! Whether each number of a recipe lies in its key's declared range.
//!
//! `ranges.csv` is made from the declarations in `nacreous/spec/`; a test there holds it to them.
//! Left out: what two keys ask of each other, which is checked where they meet.

use std::{collections::HashMap, sync::LazyLock};

use serde_json::Value;

use crate::RenderError;

/// What a number, or the length of a list, may be.
struct Range {
    least: f64,
    above: f64,
    most: f64,
    below: f64,
    allowed: String,
}

/// By path and kind, as `scene.lamps[].intensity` and `number`.
static RANGES: LazyLock<HashMap<(String, String), Range>> =
    LazyLock::new(|| include_str!("ranges.csv").lines().skip(1).filter_map(row).collect());

/// One row of the table; its last cell may hold commas, and then stands in quotes.
fn row(line: &str) -> Option<((String, String), Range)> {
    let mut cells = line.splitn(7, ',');
    let mut cell = || cells.next();
    let key = (cell()?.to_owned(), cell()?.to_owned());
    let mut bound = |open: f64| cell().map(|text| text.parse().unwrap_or(open));
    let (least, above) = (bound(f64::NEG_INFINITY)?, bound(f64::NEG_INFINITY)?);
    let (most, below) = (bound(f64::INFINITY)?, bound(f64::INFINITY)?);
    let allowed = cell()?.trim_matches('"').replace("\"\"", "\"");
    Some((key, Range { least, above, most, below, allowed }))
}

impl Range {
    fn holds(&self, value: f64) -> bool {
        (self.least..=self.most).contains(&value) && self.above < value && value < self.below
    }
}

/// Checks every number of a pearl or a scene, and the length of every list. `kind` is `pearl` or `scene`,
/// `place` what messages call it.
///
/// # Errors
/// [`RenderError::OutOfRange`] for the first that lies outside.
pub(crate) fn check(value: &Value, kind: &str, place: &str) -> Result<(), RenderError> {
    match value {
        Value::Number(number) => {
            let number = number.as_f64().unwrap_or(f64::INFINITY);
            within(kind, "number", number, || (place.to_owned(), value.to_string()))
        }
        // serde takes a list for a table, whose keys would then go by no name here.
        Value::Array(_) if !RANGES.contains_key(&(kind.to_owned(), "length".to_owned())) => {
            let (quantity, value) = (place.to_owned(), "a list".to_owned());
            Err(RenderError::OutOfRange { quantity, value, allowed: "no list".to_owned() })
        }
        Value::Array(items) => {
            let shown = || (place.to_owned(), format!("a list of {}", items.len()));
            within(kind, "length", items.len() as f64, shown)?;
            for (i, item) in items.iter().enumerate() {
                let one = format!("{kind}[{i}]");
                let known = RANGES.contains_key(&(one.clone(), "number".to_owned()));
                let each = if known { one } else { format!("{kind}[]") };
                check(item, &each, &format!("{place}.{i}"))?;
            }
            Ok(())
        }
        Value::Object(keys) => keys.iter().try_for_each(|(key, item)| {
            check(item, &format!("{kind}.{key}"), &format!("{place}.{key}"))
        }),
        _ => Ok(()),
    }
}

fn within(
    path: &str,
    kind: &str,
    value: f64,
    shown: impl Fn() -> (String, String),
) -> Result<(), RenderError> {
    match RANGES.get(&(path.to_owned(), kind.to_owned())) {
        Some(range) if !range.holds(value) => {
            let (quantity, value) = shown();
            Err(RenderError::OutOfRange { quantity, value, allowed: range.allowed.clone() })
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    fn refusal(value: &Value, kind: &str) -> String {
        check(value, kind, kind).expect_err("a refusal").to_string()
    }

    #[test]
    fn a_bound_is_kept_or_excluded_as_declared() {
        let pearl = |nm: f64| json!({"nacre": {"protein_nm": nm}});
        assert_eq!(
            refusal(&pearl(-1.0), "pearl"),
            "pearl.nacre.protein_nm is -1.0; allowed: 0 to 200 nm"
        );
        assert!(check(&pearl(0.0), "pearl", "pearl").is_ok());
        let listed = |nm: f64| json!({"nacre": {"thickness_nm": [400.0, nm]}});
        assert!(refusal(&listed(0.0), "pearl").starts_with("pearl.nacre.thickness_nm.1 is 0.0; "));
        assert!(check(&listed(1.0), "pearl", "pearl").is_ok());
    }

    #[test]
    fn a_list_stands_for_no_table() {
        for (value, said) in [
            (json!([1.0, 2.0]), "pearl is a list"),
            (json!({"film": [2.0, 64, null]}), "pearl.film is a list"),
        ] {
            assert!(refusal(&value, "pearl").starts_with(said));
        }
    }

    #[test]
    fn lists_have_lengths_and_their_items_ranges() {
        let lamps = |intensity: f64| json!({"lamps": [{"intensity": intensity}]});
        assert!(check(&lamps(1.0), "scene", "scene").is_ok());
        assert!(refusal(&lamps(-1.0), "scene").starts_with("scene.lamps.0.intensity is -1.0; "));
        let many = json!({"lamps": vec![json!({}); 257]});
        assert!(
            refusal(&many, "scene").starts_with("scene.lamps is a list of 257; allowed: 0 to 256")
        );
        let facing = json!({"windows": [{"facing": [0.0, 1e6, 0.0]}]});
        assert!(refusal(&facing, "scene").contains("facing.1 is 1000000.0"));
    }
}
