//! Reads the tables in `data/`: numbers between commas.

use crate::ColourError;

/// A row of numbers.
pub(crate) struct Row<const COLUMNS: usize> {
    pub cells: [f64; COLUMNS],
}

/// All rows of `text`: `#` begins a comment, a first row without any number is a header.
pub(crate) fn rows<const COLUMNS: usize>(
    text: &str,
    place: &str,
) -> Result<Vec<Row<COLUMNS>>, ColourError> {
    let mut rows = Vec::new();
    let mut header_allowed = true;
    for (index, line) in text.trim_start_matches('\u{feff}').lines().enumerate() {
        let content = line.split('#').next().unwrap_or_default().trim();
        if content.is_empty() {
            continue;
        }
        let is_header = header_allowed && content.split(',').all(|cell| number(cell).is_none());
        header_allowed = false;
        if !is_header {
            let line = index + 1;
            let cells = cells(content).map_err(|problem| ColourError::Line {
                place: place.to_owned(),
                line,
                problem,
            })?;
            rows.push(Row { cells });
        }
    }
    Ok(rows)
}

fn number(cell: &str) -> Option<f64> {
    cell.trim().parse().ok()
}

fn cells<const COLUMNS: usize>(content: &str) -> Result<[f64; COLUMNS], String> {
    let count = content.split(',').count();
    if count != COLUMNS {
        return Err(format!("{count} columns; allowed: {COLUMNS}, separated by commas"));
    }
    let mut cells = [0.0; COLUMNS];
    for (slot, cell) in cells.iter_mut().zip(content.split(',')) {
        *slot = number(cell)
            .filter(|value| value.is_finite())
            .ok_or_else(|| format!("a cell is {:?}; allowed: a finite number", shortened(cell)))?;
    }
    Ok(cells)
}

/// Enough of a cell to find it again; a stray binary file must not fill the screen.
pub(crate) fn shortened(cell: &str) -> String {
    cell.trim().chars().take(24).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn problem(text: &str) -> String {
        rows::<2>(text, "lamp.csv").map(|_| ()).unwrap_err().to_string()
    }

    #[test]
    fn comments_header_blank_lines_and_byte_order_mark_are_skipped() {
        let text = "\u{feff}# a lamp\nwavelength_nm, value\n\n380, 1 # first\r\n381,2\n";
        let rows = rows::<2>(text, "lamp.csv").unwrap();
        assert_eq!(
            rows.iter().map(|row| row.cells).collect::<Vec<_>>(),
            [[380.0, 1.0], [381.0, 2.0]]
        );
    }

    #[test]
    fn every_refusal_names_file_line_and_value() {
        assert_eq!(
            problem("380,1,2"),
            "lamp.csv, line 1: 3 columns; allowed: 2, separated by commas"
        );
        assert_eq!(
            problem("380,1\n381,dark"),
            "lamp.csv, line 2: a cell is \"dark\"; allowed: a finite number"
        );
        assert_eq!(
            problem("a,b\nc,d"),
            "lamp.csv, line 2: a cell is \"c\"; allowed: a finite number"
        );
        assert_eq!(
            problem("380,nan"),
            "lamp.csv, line 1: a cell is \"nan\"; allowed: a finite number"
        );
    }
}
