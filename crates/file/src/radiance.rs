//! Radiance `.hdr`: pixels with a common exponent (RGBE), and the lines above them that change what they mean.
//!
//! Ward, "Real Pixels" (Graphics Gems II, 1991) and the format's own description, "The RADIANCE Picture File
//! Format" (Larson and Shakespeare 1998): any program's name behind `#?`, lines that end LF or CR LF, all
//! eight orders of pixels, flat or run-length coded of either kind. `EXPOSURE` and `COLORCORR` are factors on the
//! pixels, each counting once more wherever it stands, and are divided out; `PRIMARIES` are converted. A mantissa m
//! is m/256, as nearly every program writes and reads it: Radiance itself adds half a step, by which black would
//! not be black.
//!
//! Out of scope: XYZE pixels, whose white no line states; pixels that are not in linear light (`GAMMA` other than
//! 1, as old programs may write; no description says whether before or after the exposure); `PIXASPECT`, `VIEW` and whatever else says nothing
//! about light.

use crate::picture::{LinearPicture, PictureFileError, check_size};
use crate::profile::{convert, srgb_from_rgb};

/// How every such file begins, whichever program wrote it.
pub(crate) const SIGNATURE: &[u8] = b"#?";
/// The longest line that a header has; the format's own readers allow half as much.
const LONGEST_LINE: usize = 4096;
/// The most lines of a header.
const MOST_LINES: usize = 4096;

/// What the lines above the pixels say.
#[derive(Debug)]
struct Header {
    /// Factor on each channel that the writer has applied.
    applied: [f64; 3],
    /// The matrix to linear sRGB, where primaries are stated.
    conversion: Option<[[f64; 3]; 3]>,
    order: Order,
}

/// The order in which pixels stand: scan lines along the second axis, one after the other along the first.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
struct Order {
    lines: usize,
    length: usize,
    /// Whether a scan line is a column.
    by_column: bool,
    /// Whether the first row of the file is the lowest.
    from_below: bool,
    /// Whether the first column of the file is the rightmost.
    from_right: bool,
}

/// Decodes a file to linear-light sRGB; values below zero where its primaries are wider.
pub(crate) fn decode(bytes: &[u8]) -> Result<LinearPicture, PictureFileError> {
    let mut rest = bytes;
    let header = header(&mut rest)?;
    let Order { lines, length, .. } = header.order;
    let (width, height) = header.order.size();
    check_size(width as u64, height as u64)?;
    let mut rgb = vec![0.0; lines * length * 3];
    let mut line = vec![[0_u8; 4]; length];
    for number in 0..lines {
        scan_line(&mut rest, &mut line)?;
        for (place, pixel) in line.iter().enumerate() {
            let first = header.order.index(number, place) * 3;
            for (i, value) in light(*pixel).into_iter().enumerate() {
                rgb[first + i] = unexposed(value, header.applied[i])?;
            }
        }
    }
    if let Some(matrix) = header.conversion {
        convert(&mut rgb, matrix);
    }
    Ok(LinearPicture { width, height, rgb })
}

fn header(rest: &mut &[u8]) -> Result<Header, PictureFileError> {
    let (mut applied, mut conversion) = ([1.0; 3], None);
    for _ in 0..MOST_LINES {
        let line = text_line(rest)?;
        if line.is_empty() {
            let order = order(&text_line(rest)?)?;
            return Ok(Header { applied, conversion, order });
        }
        let Some((name, value)) = line.split_once('=') else { continue };
        // At the line's start: programs indent the lines of pictures that they made this one from.
        match name {
            "FORMAT" => check_format(value.trim())?,
            "EXPOSURE" => {
                let [factor] = factors("EXPOSURE", value)?;
                applied = applied.map(|own| own * factor);
            }
            "COLORCORR" => {
                let each: [f64; 3] = factors("COLORCORR", value)?;
                applied = std::array::from_fn(|i| applied[i] * each[i]);
            }
            "GAMMA" => check_gamma(value)?,
            "PRIMARIES" => conversion = Some(primaries(value)?),
            _ => {}
        }
        if applied.iter().any(|factor| !factor.is_normal()) {
            let problem = "has EXPOSURE or COLORCORR lines whose product is no number above 0";
            return Err(PictureFileError::Unsupported(problem.to_owned()));
        }
    }
    Err(PictureFileError::Damaged("its header does not end".to_owned()))
}

/// The next line, without its end: a line feed, or a carriage return before it.
fn text_line(rest: &mut &[u8]) -> Result<String, PictureFileError> {
    let end = rest.iter().take(LONGEST_LINE).position(|&byte| byte == b'\n');
    let end = end.ok_or_else(|| PictureFileError::Damaged("its header does not end".to_owned()))?;
    let line = String::from_utf8_lossy(&rest[..end]);
    *rest = &rest[end + 1..];
    Ok(line.trim_end_matches('\r').to_owned())
}

fn check_format(value: &str) -> Result<(), PictureFileError> {
    let problem = match value {
        "32-bit_rle_rgbe" => return Ok(()),
        "32-bit_rle_xyze" => {
            "has XYZE pixels, whose white the file does not state; convert it: ra_xyze -r OLD > NEW"
                .to_owned()
        }
        other => format!("has the FORMAT {:?}; allowed: 32-bit_rle_rgbe", shortened(other)),
    };
    Err(PictureFileError::Unsupported(problem))
}

fn check_gamma(value: &str) -> Result<(), PictureFileError> {
    if numbers(value) == Some([1.0]) {
        return Ok(());
    }
    let given = shortened(value.trim());
    let problem = format!("has the GAMMA {given:?}; allowed: 1, which is linear light");
    Err(PictureFileError::Unsupported(problem))
}

/// What a pixel was before a factor was applied; none is beyond what a float32 holds but by that factor.
fn unexposed(value: f64, applied: f64) -> Result<f32, PictureFileError> {
    let own = (value / applied) as f32;
    if own.is_finite() {
        return Ok(own);
    }
    let problem = format!(
        "has EXPOSURE or COLORCORR lines whose product is {applied:.1e}, by which its light is beyond {:e}",
        f32::MAX
    );
    Err(PictureFileError::Unsupported(problem))
}

/// So many finite numbers above 0.
fn factors<const N: usize>(name: &str, value: &str) -> Result<[f64; N], PictureFileError> {
    let allowed =
        if N == 1 { "a number above 0".to_owned() } else { format!("{N} numbers above 0") };
    numbers(value).filter(|all: &[f64; N]| all.iter().all(|own| *own > 0.0)).ok_or_else(|| {
        let given = shortened(value.trim());
        PictureFileError::Unsupported(format!("has the {name} {given:?}; allowed: {allowed}"))
    })
}

fn numbers<const N: usize>(value: &str) -> Option<[f64; N]> {
    let all: Option<Vec<f64>> = value.split_whitespace().map(|own| own.parse().ok()).collect();
    let all: [f64; N] = all?.try_into().ok()?;
    all.iter().all(|own| own.is_finite()).then_some(all)
}

/// The matrix to linear sRGB from `x y` of red, green, blue and white.
fn primaries(value: &str) -> Result<[[f64; 3]; 3], PictureFileError> {
    let stated = numbers(value).and_then(|all: [f64; 8]| {
        let [rx, ry, gx, gy, bx, by, wx, wy] = all.map(|own| own as f32);
        srgb_from_rgb([[rx, ry], [gx, gy], [bx, by]], [wx, wy])
    });
    stated.ok_or_else(|| {
        let given = shortened(value.trim());
        let allowed = "x and y of red, green, blue and white that span a colour space";
        PictureFileError::Unsupported(format!("has the PRIMARIES {given:?}; allowed: {allowed}"))
    })
}

/// The line of the picture's size, such as `-Y 512 +X 1024`: rows from the top, each from the left.
fn order(line: &str) -> Result<Order, PictureFileError> {
    let words: Vec<&str> = line.split_whitespace().collect();
    let wrong = || {
        let given = shortened(line);
        let allowed = "such as \"-Y 512 +X 1024\"";
        PictureFileError::Damaged(format!("its size is {given:?}; allowed: {allowed}"))
    };
    let [first, lines, second, length] = words[..] else { return Err(wrong()) };
    let count = |word: &str| word.parse::<u32>().map_err(|_| wrong());
    let (lines, length) = (count(lines)? as usize, count(length)? as usize);
    let (down, aside, by_column) = match (first, second) {
        ("-Y" | "+Y", "-X" | "+X") => (first, second, false),
        ("-X" | "+X", "-Y" | "+Y") => (second, first, true),
        _ => return Err(wrong()),
    };
    let (from_below, from_right) = (down == "+Y", aside == "-X");
    Ok(Order { lines, length, by_column, from_below, from_right })
}

impl Order {
    /// (width, height) of the picture upright.
    fn size(self) -> (usize, usize) {
        if self.by_column { (self.lines, self.length) } else { (self.length, self.lines) }
    }

    /// Where in the upright picture, row by row from the top left, a pixel of a scan line lies.
    fn index(self, line: usize, place: usize) -> usize {
        let (width, height) = self.size();
        let (row, column) = if self.by_column { (place, line) } else { (line, place) };
        let row = if self.from_below { height - 1 - row } else { row };
        let column = if self.from_right { width - 1 - column } else { column };
        row * width + column
    }
}

/// Mantissas times a power of two: value = mantissa 2^(exponent - 136).
fn light([r, g, b, exponent]: [u8; 4]) -> [f64; 3] {
    if exponent == 0 {
        return [0.0; 3];
    }
    let unit = f64::from_bits(u64::from(1023 - 136 + u32::from(exponent)) << 52);
    [r, g, b].map(|mantissa| f64::from(mantissa) * unit)
}

/// A scan line, whichever way it is coded: it begins 2, 2 and its length where channels are coded apart.
fn scan_line(rest: &mut &[u8], line: &mut [[u8; 4]]) -> Result<(), PictureFileError> {
    let apart = (8..0x8000).contains(&line.len());
    match **rest {
        [2, 2, high, low, ..] if apart && high < 0x80 => {
            if usize::from(u16::from_be_bytes([high, low])) != line.len() {
                return Err(PictureFileError::Damaged("a scan line has another length".to_owned()));
            }
            *rest = &rest[4..];
            (0..4).try_for_each(|channel| channel_runs(rest, line, channel))
        }
        _ => pixel_runs(rest, line),
    }
}

/// One channel of a line: a count up to 128 and so many bytes, or 128 more than a count and the byte repeated.
fn channel_runs(
    rest: &mut &[u8],
    line: &mut [[u8; 4]],
    channel: usize,
) -> Result<(), PictureFileError> {
    let mut place = 0;
    while place < line.len() {
        let code = usize::from(taken::<1>(rest)?[0]);
        let (count, repeated) = if code > 128 { (code - 128, true) } else { (code, false) };
        if count == 0 || place + count > line.len() {
            return Err(PictureFileError::Damaged("a run leaves its scan line".to_owned()));
        }
        let mut value = if repeated { taken::<1>(rest)?[0] } else { 0 };
        for pixel in &mut line[place..place + count] {
            if !repeated {
                [value] = taken(rest)?;
            }
            pixel[channel] = value;
        }
        place += count;
    }
    Ok(())
}

/// Pixels one by one; 1, 1, 1 and a count repeats the one before, further such ones count 256 times as much.
fn pixel_runs(rest: &mut &[u8], line: &mut [[u8; 4]]) -> Result<(), PictureFileError> {
    let (mut place, mut shift) = (0, 0);
    while place < line.len() {
        let pixel: [u8; 4] = taken(rest)?;
        if let [1, 1, 1, count] = pixel {
            let count = usize::from(count).checked_shl(shift).unwrap_or(usize::MAX);
            if place == 0 || count > line.len() - place {
                return Err(PictureFileError::Damaged("a run leaves its scan line".to_owned()));
            }
            let before = line[place - 1];
            line[place..place + count].fill(before);
            (place, shift) = (place + count, shift + 8);
        } else {
            line[place] = pixel;
            (place, shift) = (place + 1, 0);
        }
    }
    Ok(())
}

fn taken<const N: usize>(rest: &mut &[u8]) -> Result<[u8; N], PictureFileError> {
    let (first, behind) = rest.split_first_chunk().ok_or_else(cut_short)?;
    *rest = behind;
    Ok(*first)
}

fn cut_short() -> PictureFileError {
    PictureFileError::Damaged("the file ends before its pixels".to_owned())
}

/// What a message shows of a file's own text.
fn shortened(text: &str) -> String {
    text.chars().take(60).collect()
}
