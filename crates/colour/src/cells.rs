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

/// A finite number with a decimal point or a decimal comma, or with commas between thousands before a point.
pub(crate) fn number(cell: &str) -> Option<f64> {
    match cell.matches(',').count() {
        1 if !cell.contains('.') => Comma::Decimal.number(cell),
        0 => Comma::Thousands.number(cell),
        _ if parts_thousands(cell) && cell.contains('.') => Comma::Thousands.number(cell),
        _ => None,
    }
}

/// What the commas in the numbers of one file are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Comma {
    /// The decimal sign.
    Decimal,
    /// Marks between thousands, beside decimal points.
    Thousands,
}

impl Comma {
    /// Decided over all rows of a file, given with their lines; or the line at fault and why.
    pub(crate) fn of(
        rows: &[(usize, [&str; 2])],
        with_semicolons: bool,
    ) -> Result<Self, (usize, String)> {
        let cells = || rows.iter().flat_map(|(line, row)| row.map(|cell| (*line, cell)));
        let commas = || cells().filter(|(_, cell)| cell.contains(','));
        let Some((line, comma)) = commas().next() else {
            return match points_may_part_thousands(rows) {
                Some(found) => Err(found),
                None => Ok(Self::Thousands),
            };
        };
        let odd = commas().find(|(_, cell)| !parts_thousands(cell));
        let point = cells().find(|(_, cell)| cell.contains('.'));
        match (odd, point) {
            (Some((line, comma)), Some((_, point))) => {
                let given = format!("a cell is {comma:?} and another {point:?}");
                Err((line, format!("{given}; allowed: one decimal sign")))
            }
            (None, Some(_)) => Ok(Self::Thousands),
            (Some(_), None) => Ok(Self::Decimal),
            // Who parts columns by semicolons does so because the comma is the decimal sign.
            (None, None) if with_semicolons && is_in_whole_columns(rows) => Ok(Self::Decimal),
            (None, None) => {
                let whole = comma.replace(',', "");
                let decimal = comma.replace(',', ".");
                let given =
                    format!("a cell is {comma:?}, whose comma may part thousands or decimals");
                Err((line, format!("{given}; allowed: such as {whole} or {decimal}")))
            }
        }
    }

    /// A finite number; Fortran writes exponents of double precision with a D.
    pub(crate) fn number(self, cell: &str) -> Option<f64> {
        let pointed = match self {
            Self::Decimal => cell.replace(',', "."),
            Self::Thousands => cell.replace(',', ""),
        };
        let parsed = pointed.replace(['D', 'd'], "e").parse();
        parsed.ok().filter(|value: &f64| value.is_finite())
    }
}

/// The line and what is wrong where whole numbers stand beside such as `1.020` alone in a column: who writes
/// decimals to three places writes them for whole numbers too.
fn points_may_part_thousands(rows: &[(usize, [&str; 2])]) -> Option<(usize, String)> {
    [0, 1].iter().find_map(|&column| {
        let cells = || rows.iter().map(|(line, row)| (*line, row[column]));
        let (line, point) = cells().find(|(_, cell)| cell.contains('.'))?;
        let only_groups = cells()
            .filter(|(_, cell)| cell.contains('.'))
            .all(|(_, cell)| parts_thousands(&cell.replace('.', ",")));
        let whole = cells()
            .any(|(_, cell)| !cell.contains('.') && cell.parse::<u32>().is_ok_and(|n| n > 9));
        (only_groups && whole).then(|| {
            let bare = point.replace('.', "");
            let given = format!("a cell is {point:?}, whose point may part thousands or decimals");
            (line, format!("{given}; allowed: such as {bare} or {point}0"))
        })
    })
}

/// Whether commas stand in all cells of a column or in none.
fn is_in_whole_columns(rows: &[(usize, [&str; 2])]) -> bool {
    [0, 1].iter().all(|&column| {
        let commas = rows.iter().filter(|(_, row)| row[column].contains(',')).count();
        commas == 0 || commas == rows.len()
    })
}

/// Whether commas stand as between thousands: `1,020`, `12,345,678.9`, but not `0,020`.
fn parts_thousands(cell: &str) -> bool {
    let digits = cell.trim_start_matches(['+', '-']);
    let whole = digits.split('.').next().unwrap_or_default();
    let all_digits = |group: &str| group.bytes().all(|byte| byte.is_ascii_digit());
    let mut groups = whole.split(',');
    let first = groups.next().unwrap_or_default();
    let mut rest = groups.peekable();
    (1..=3).contains(&first.len())
        && all_digits(first)
        && !first.starts_with('0')
        && rest.peek().is_some()
        && rest.all(|group| group.len() == 3 && all_digits(group))
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
        for word in ["1.234,5", "1,2,3", "nan", "inf", "", "dark", "D5", "1D", "1DD2"] {
            assert_eq!(number(word), None, "{word}");
        }
    }

    #[test]
    fn an_exponent_of_fortran_is_an_exponent() {
        for (cell, value) in
            [("0.11833D+00", 0.11833), ("3.8D2", 380.0), ("-.5d-1", -0.05), ("0,118D+01", 1.18)]
        {
            assert_eq!(number(cell), Some(value), "{cell}");
        }
        let line = cells(" 0.38000D+03   0.11833D+00");
        assert_eq!(line.into_iter().map(number).collect::<Vec<_>>(), [Some(380.0), Some(0.11833)]);
    }

    #[test]
    fn points_that_may_part_thousands_are_refused_and_decimals_are_not() {
        let of = |values: &[&'static str]| {
            let rows: Vec<_> = values.iter().map(|value| (1, ["380", *value])).collect();
            Comma::of(&rows, true).map_err(|(_, why)| why)
        };
        assert!(of(&["960", "1.020", "2.000"]).unwrap_err().contains("such as 1020 or 1.0200"));
        for decimals in [
            &["0.960", "1.020"][..],
            &["960.000", "1.020"],
            &["0", "1.020", "2.5"],
            &["0", "0.125", "1.020"],
            &["1", "1.125"],
        ] {
            assert_eq!(of(decimals), Ok(Comma::Thousands), "{decimals:?}");
        }
    }
}
