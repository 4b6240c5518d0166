//! The cells of one line of a table, as people and instruments of any country part and write them.

/// The cells of a line: between semicolons, else tabs, else commas where those part numbers, else
/// blanks. Empty cells at the end are none.
pub(crate) fn cells(content: &str) -> Vec<&str> {
    let by = |separator: char| split(content, separator);
    let mut cells = if content.contains(';') {
        by(';')
    } else if content.contains('\t') {
        by('\t')
    } else {
        let between_commas = by(',');
        let between_blanks: Vec<&str> = content.split_whitespace().collect();
        let are_numbers = |cells: &[&str]| cells.iter().all(|cell| number(cell).is_some());
        if between_blanks.len() > 1 && are_numbers(&between_blanks) && !are_numbers(&between_commas)
        {
            between_blanks
        } else {
            between_commas
        }
    };
    while cells.len() > 1 && cells.last().is_some_and(|cell| cell.is_empty()) {
        cells.pop();
    }
    cells
}

/// Parts between separators that stand outside quotes, without blanks and quotes around them.
fn split(content: &str, separator: char) -> Vec<&str> {
    let mut quoted = false;
    content
        .split(|letter: char| {
            quoted ^= letter == '"';
            letter == separator && !quoted
        })
        .map(|cell| cell.trim().trim_matches('"').trim())
        .collect()
}

/// A finite number with a decimal point or a decimal comma.
pub(crate) fn number(cell: &str) -> Option<f64> {
    let parsed = match cell.matches(',').count() {
        0 => cell.parse(),
        1 if !cell.contains('.') => cell.replace(',', ".").parse(),
        _ => return None,
    };
    parsed.ok().filter(|value: &f64| value.is_finite())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_comma_parts_columns_only_where_numbers_are_left() {
        let numbers = |line| cells(line).into_iter().map(number).collect::<Option<Vec<f64>>>();
        for line in
            ["380.5,0.25", "380.5;0.25", "380,5;0,25", "380,5\t0,25", "380,5  0,25", "380.5, 0.25"]
        {
            assert_eq!(numbers(line), Some(vec![380.5, 0.25]), "{line}");
        }
        assert_eq!(numbers("\"380,5\",\"0,25\";"), None);
        assert_eq!(numbers("\"380,5\",\"0,25\""), Some(vec![380.5, 0.25]));
        assert_eq!(numbers("380;0.25;;"), Some(vec![380.0, 0.25]));
        for word in ["1.234,5", "1,2,3", "nan", "inf", "", "dark"] {
            assert_eq!(number(word), None, "{word}");
        }
    }
}
