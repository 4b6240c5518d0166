//! The rows of a measured spectrum, among the instrument's own words.

use crate::{
    ColourError,
    cells::{Comma, cells, number},
    table::shortened,
};

/// A measured value with the line it stands on, counted from 1.
#[derive(Debug)]
pub(crate) struct Sample {
    pub line: usize,
    pub nm: f64,
    pub value: f64,
}

/// A line that is neither empty nor a comment.
enum Line<'a> {
    /// Two numbers.
    Row([&'a str; 2]),
    /// Begins with a number, and is no row.
    Broken { first: f64, problem: String },
    /// Begins with a word, or with a number and its unit.
    Words { cell: String, is_pair: bool },
}

/// So many steps beyond the rows, a line that begins with a number is one of them that is broken.
const NEAR_STEPS: f64 = 2.0;

/// Rows of two numbers. Lines before the first and after the last are the instrument's own words.
pub(crate) fn samples(text: &str, place: &str) -> Result<Vec<Sample>, ColourError> {
    let refused = |line, problem| ColourError::Line { place: place.to_owned(), line, problem };
    let lines: Vec<(usize, Line<'_>)> = text
        .trim_start_matches('\u{feff}')
        .lines()
        .map(|line| line.split('#').next().unwrap_or_default().trim())
        .enumerate()
        .filter(|(_, content)| !content.is_empty())
        .map(|(index, content)| (index + 1, line_of(content)))
        .collect();
    let is_row = |(_, line): &(usize, Line<'_>)| matches!(line, Line::Row(_));
    let (Some(first), Some(last)) = (lines.iter().position(is_row), lines.iter().rposition(is_row))
    else {
        return Err(no_row(&lines, place));
    };
    let mut rows = Vec::new();
    for (number, line) in &lines[first..=last] {
        match line {
            Line::Row(row) => rows.push((*number, *row)),
            Line::Broken { problem, .. } => return Err(refused(*number, problem.clone())),
            Line::Words { cell, .. } => return Err(refused(*number, not_a_number(cell))),
        }
    }
    let with_semicolons = text.contains(';');
    let comma = Comma::of(&rows, with_semicolons).map_err(|(line, why)| refused(line, why))?;
    let sample = |&(line, [nm, value]): &(usize, [&str; 2])| {
        Some(Sample { line, nm: comma.number(nm)?, value: comma.number(value)? })
    };
    let samples: Vec<Sample> = rows.iter().filter_map(sample).collect();
    let before = samples.first().zip(samples.get(1));
    let after = samples.last().zip(samples.iter().nth_back(1));
    for (around, end) in [(&lines[..first], before), (&lines[last + 1..], after)] {
        for (number, line) in around {
            if let Line::Broken { first, problem } = line
                && end.is_none_or(|(end, inner)| goes_on(*first, end.nm, inner.nm))
            {
                return Err(refused(*number, problem.clone()));
            }
        }
    }
    if samples.len() < 2 { Err(too_few(samples.len(), place)) } else { Ok(samples) }
}

/// Whether a wavelength continues the rows beyond their end.
fn goes_on(nm: f64, end: f64, inner: f64) -> bool {
    let steps = (nm - end) / (end - inner);
    steps > 0.0 && steps <= NEAR_STEPS
}

fn line_of(content: &str) -> Line<'_> {
    let cells = cells(content);
    let numbers: Vec<Option<f64>> = cells.iter().map(|cell| number(cell)).collect();
    match numbers[..] {
        [Some(_), Some(_)] => Line::Row([cells[0], cells[1]]),
        [Some(first), None] => Line::Broken { first, problem: not_a_number(cells[1]) },
        [Some(first), ..] => {
            let count = cells.len();
            let problem = format!("{count} columns; allowed: 2, wavelength and value");
            Line::Broken { first, problem }
        }
        _ => Line::Words { cell: cells[0].to_owned(), is_pair: cells.len() == 2 },
    }
}

/// Why no line is a row: the first that begins with a number is broken; else one of two cells, or any other,
/// begins with a digit and has a unit behind it; else the first of two cells is of words.
fn no_row(lines: &[(usize, Line<'_>)], place: &str) -> ColourError {
    let broken = lines.iter().find_map(|(number, line)| match line {
        Line::Broken { problem, .. } => Some((*number, problem.clone())),
        _ => None,
    });
    if let Some((line, problem)) = broken {
        return ColourError::Line { place: place.to_owned(), line, problem };
    }
    let words = |wanted: &dyn Fn(&str, bool) -> bool| {
        lines.iter().find_map(|(number, line)| match line {
            Line::Words { cell, is_pair } if wanted(cell, *is_pair) => Some((*number, cell)),
            _ => None,
        })
    };
    let digit = |cell: &str| cell.starts_with(|first: char| first.is_ascii_digit());
    let found = words(&|cell, is_pair| is_pair && digit(cell))
        .or_else(|| words(&|cell, _| digit(cell)))
        .or_else(|| words(&|_, is_pair| is_pair));
    let Some((line, cell)) = found else {
        return too_few(0, place);
    };
    let problem = format!(
        "0 rows of numbers, and line {line} has {:?}; allowed: at least 2 of numbers alone",
        shortened(cell)
    );
    ColourError::Table { place: place.to_owned(), problem }
}

fn too_few(rows: usize, place: &str) -> ColourError {
    let problem = format!("{rows} rows of numbers; allowed: at least 2");
    ColourError::Table { place: place.to_owned(), problem }
}

fn not_a_number(cell: &str) -> String {
    format!("a cell is {:?}; allowed: a finite number", shortened(cell))
}

#[cfg(test)]
mod tests {
    use super::*;

    const ROWS: &str = "380.0;0.5\n400.0;1\n420.0;2";

    fn read(text: &str) -> Result<Vec<f64>, String> {
        match samples(text, "lamp.csv") {
            Ok(samples) => Ok(samples.iter().map(|sample| sample.value).collect()),
            Err(problem) => Err(problem.to_string()),
        }
    }

    #[test]
    fn lines_around_that_begin_with_a_number_are_words_unless_they_continue_the_rows() {
        for text in [
            format!("3;scans\n81\n{ROWS}"),
            format!("{ROWS}\n81;points\n2024"),
            format!("1;2;3\n{ROWS}\n\nRa;95"),
        ] {
            assert_eq!(read(&text), Ok(vec![0.5, 1.0, 2.0]), "{text}");
        }
        for (text, problem) in [
            (format!("360;dark\n{ROWS}"), "line 1: a cell is \"dark\"; allowed: a finite number"),
            (format!("{ROWS}\n440;-"), "line 4: a cell is \"-\"; allowed: a finite number"),
            (format!("{ROWS}\n440;1;2"), "line 4: 3 columns; allowed: 2, wavelength and value"),
            (format!("{ROWS}\n81;points\n440;1"), "line 4: a cell is \"points\""),
        ] {
            let found = read(&text).unwrap_err();
            assert!(found.starts_with(&format!("lamp.csv, {problem}")), "{found}");
        }
    }

    #[test]
    fn where_no_row_is_of_numbers_the_first_cell_that_is_none_is_named() {
        for (text, line, cell) in [
            ("380 nm, 0.118\n390 nm, 0.119", 1, "380 nm"),
            ("2048 pixels\nwavelength,value\n380nm,0.118\n390nm,0.119", 3, "380nm"),
            ("380 nm 0.118\n390 nm 0.119", 1, "380 nm 0.118"),
            ("Lamp B\na;b\nc;d", 2, "a"),
        ] {
            let allowed = "allowed: at least 2 of numbers alone";
            let problem = format!("0 rows of numbers, and line {line} has {cell:?}; {allowed}");
            assert_eq!(read(text).unwrap_err(), format!("lamp.csv: {problem}"));
        }
        for text in ["", "Lamp B\nno numbers"] {
            let problem = "lamp.csv: 0 rows of numbers; allowed: at least 2";
            assert_eq!(read(text).unwrap_err(), problem);
        }
        let problem = read("380,0.118 %\n390,0.119 %").unwrap_err();
        assert_eq!(problem, "lamp.csv, line 1: a cell is \"0.118 %\"; allowed: a finite number");
    }

    #[test]
    fn one_sign_is_decimal_in_a_whole_file() {
        assert_eq!(read("380.0\t760\n385.0\t1,020\n"), Ok(vec![760.0, 1020.0]));
        assert_eq!(read("380,\"999.5\"\n385,\"1,020.5\"\n"), Ok(vec![999.5, 1020.5]));
        assert_eq!(read("380;1,020\n385;1,250\n"), Ok(vec![1.02, 1.25]));
        assert_eq!(read("380\t0,998\n385\t1,020\n"), Ok(vec![0.998, 1.02]));
        assert_eq!(read("380\t1\n385\t1,02\n"), Ok(vec![1.0, 1.02]));
        assert_eq!(
            read("380.5;0.5\n385.5;0,25").unwrap_err(),
            "lamp.csv, line 2: a cell is \"0,25\" and another \"380.5\"; allowed: one decimal sign"
        );
        for text in ["480\t960\n510\t1,020", "480;960\n510;1,020", "480,\"1,010\"\n510,\"1,020\""] {
            let problem = read(text).unwrap_err();
            assert!(problem.contains("whose comma may part thousands or decimals"), "{problem}");
        }
    }
}
