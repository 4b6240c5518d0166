//! What every picture file has in common: its limits, its problems, and the linear picture that a
//! reader hands on.

use std::fs::File;
use std::io::{self, Read};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

/// Longest side of a picture that is read, in pixels.
pub const SIDE_MAX: u32 = 16_384;
/// Most pixels of a picture that is read: 8192 x 8192, "64 megapixels".
pub const PIXELS_MAX: u64 = 1 << 26;
/// Longest picture file that is read, in bytes (512 MiB).
pub const FILE_BYTES_MAX: u64 = 1 << 29;
/// Longest metadata text that is written or read, in bytes (16 MiB).
pub const TEXT_BYTES_MAX: usize = 1 << 24;

/// A picture in linear-light sRGB (Rec. 709 primaries, D65 white), unclipped above 1.
#[derive(Clone, Debug, PartialEq)]
pub struct LinearPicture {
    /// Pixels in a row.
    pub width: usize,
    /// Rows, the topmost first.
    pub height: usize,
    /// `height * width * 3` finite values of 0 or more, in the order [row, column, rgb].
    pub rgb: Vec<f32>,
}

/// Why a picture file cannot be read or written; `Display` is the line for the user.
#[derive(Debug, thiserror::Error)]
pub enum PictureFileError {
    /// A problem with the file at this path.
    #[error("{}: {problem}", path.display())]
    At {
        /// The file as the user named it.
        path: PathBuf,
        /// What is wrong with it.
        problem: Box<PictureFileError>,
    },
    /// Nothing lies at this path.
    #[error("does not exist")]
    Missing,
    /// A folder, where a file was expected.
    #[error("is a directory; a picture file is needed")]
    Directory,
    /// A device, socket or pipe, which might never end.
    #[error("is not an ordinary file")]
    NotAFile,
    /// A file of no bytes.
    #[error("is empty (0 bytes)")]
    Empty,
    /// A file longer than [`FILE_BYTES_MAX`].
    #[error("is {bytes} bytes long; allowed: at most {FILE_BYTES_MAX}")]
    TooManyBytes {
        /// Its length.
        bytes: u64,
    },
    /// A picture beyond [`SIDE_MAX`] or [`PIXELS_MAX`].
    #[error(
        "is {width} x {height} pixels; allowed: 1 to {SIDE_MAX} a side and at most {PIXELS_MAX} \
         pixels in all"
    )]
    PixelSize {
        /// Pixels in a row, as the header says.
        width: u64,
        /// Rows, as the header says.
        height: u64,
    },
    /// The first bytes belong to no format that is read here.
    #[error("is not a picture that can be read here; allowed: {allowed}")]
    Format {
        /// The formats that are read.
        allowed: &'static str,
    },
    /// The decoder stumbled.
    #[error("is damaged or cut short ({0})")]
    Damaged(String),
    /// A legitimate picture of a kind that is not read here.
    #[error("{0}")]
    Unsupported(String),
    /// The embedded ICC profile is broken or does not fit the pixels.
    #[error("has a colour profile that cannot be used ({0}); save the picture as sRGB")]
    ColourProfile(String),
    /// NaN or infinity among the values.
    #[error(
        "holds {count} values that are not finite, the first at row {row}, column {column}, \
         channel {channel}"
    )]
    NotFinite {
        /// How many.
        count: usize,
        /// Where the first stands, counted from 0.
        row: usize,
        /// Counted from 0.
        column: usize,
        /// Counted from 0.
        channel: usize,
    },
    /// A buffer whose length does not fit the size of the picture.
    #[error("{what} has {given} samples; {width} x {height} x {channels} are needed")]
    SampleCount {
        /// Which buffer.
        what: String,
        /// Its length.
        given: usize,
        /// Pixels in a row.
        width: usize,
        /// Rows.
        height: usize,
        /// Channels of a pixel.
        channels: usize,
    },
    /// The name of a layer, or the set of layers, is not one that a file can hold.
    #[error("layer {name:?} {problem}")]
    Layer {
        /// The name as given.
        name: String,
        /// What is wrong and what is allowed.
        problem: String,
    },
    /// A metadata keyword or its text is not one that a file can hold.
    #[error("metadata {keyword:?} {problem}")]
    Text {
        /// The keyword as given.
        keyword: String,
        /// What is wrong and what is allowed.
        problem: &'static str,
    },
    /// An encoder refused for a reason that the checks before it did not foresee.
    #[error("cannot be encoded ({0})")]
    Encoder(String),
    /// The operating system refused to read.
    #[error("cannot be read ({0})")]
    Unreadable(io::Error),
    /// The operating system refused to write.
    #[error("cannot be written ({0})")]
    Unwritable(io::Error),
}

impl PictureFileError {
    /// The same problem, with the file it concerns.
    #[must_use]
    pub fn at(self, path: &Path) -> Self {
        Self::At { path: path.to_owned(), problem: Box::new(self) }
    }

    /// A decoder's complaint in our words; its own are for programmers.
    pub(crate) fn damaged(complaint: &impl ToString) -> Self {
        let text = complaint.to_string().to_lowercase();
        let says = |words: &[&str]| words.iter().any(|word| text.contains(word));
        let what = if says(&["fill whole buffer", "unexpected end", "end of file", "eof"]) {
            "it ends before its picture does"
        } else if says(&["crc", "checksum"]) {
            "a checksum does not match what it is of"
        } else {
            "its data cannot be decoded"
        };
        Self::Damaged(what.to_owned())
    }

    /// The same of an OpenEXR file, or what kind of it is not read.
    #[cfg(any(feature = "exr", feature = "panorama"))]
    pub(crate) fn exr(complaint: &exr::error::Error) -> Self {
        let exr::error::Error::NotSupported(text) = complaint else {
            return Self::damaged(complaint);
        };
        let what = if text.contains("deep") { "deep data" } else { "a compression or parts" };
        Self::Unsupported(format!(
            "is OpenEXR with {what} that is not read here; allowed: flat pictures, uncompressed or \
             with RLE, ZIP, PIZ, PXR24 or B44"
        ))
    }
}

/// The whole file, after every check that needs no decoding.
pub(crate) fn read_bytes(path: &Path) -> Result<Vec<u8>, PictureFileError> {
    let unreadable = |problem: io::Error| match problem.kind() {
        io::ErrorKind::NotFound => PictureFileError::Missing,
        _ => PictureFileError::Unreadable(problem),
    };
    // Asked by path and before opening, for opening a pipe would wait for its other end.
    let metadata = std::fs::metadata(path).map_err(unreadable)?;
    if metadata.is_dir() {
        return Err(PictureFileError::Directory);
    }
    if !metadata.is_file() {
        return Err(PictureFileError::NotAFile);
    }
    // One byte past the limit is enough to notice a file that grows while it is read.
    let mut bytes = Vec::new();
    if metadata.len() <= FILE_BYTES_MAX {
        let file = File::open(path).map_err(unreadable)?;
        file.take(FILE_BYTES_MAX + 1).read_to_end(&mut bytes).map_err(unreadable)?;
    }
    match metadata.len().max(bytes.len() as u64) {
        0 => Err(PictureFileError::Empty),
        length if length > FILE_BYTES_MAX => Err(PictureFileError::TooManyBytes { bytes: length }),
        _ => Ok(bytes),
    }
}

/// Runs a decoder so that a defect of its own, met in a damaged file, is an error and no crash.
pub(crate) fn guarded<T>(
    decode: impl FnOnce() -> Result<T, PictureFileError>,
) -> Result<T, PictureFileError> {
    // Sound to go on after: whatever the decoder had under way is dropped here.
    catch_unwind(AssertUnwindSafe(decode))
        .unwrap_or_else(|_| Err(PictureFileError::Damaged("its decoder gave up".to_owned())))
}

/// Holds the size that a header claims against the limits, before anything is decoded.
pub(crate) fn check_size(width: u64, height: u64) -> Result<(), PictureFileError> {
    let side = 1..=u64::from(SIDE_MAX);
    if side.contains(&width) && side.contains(&height) && width * height <= PIXELS_MAX {
        Ok(())
    } else {
        Err(PictureFileError::PixelSize { width, height })
    }
}

/// Holds a buffer to write against the size of its picture.
pub(crate) fn check_sample_count(
    what: &str,
    given: usize,
    (width, height, channels): (usize, usize, usize),
) -> Result<(), PictureFileError> {
    let needed = width.checked_mul(height).and_then(|pixels| pixels.checked_mul(channels));
    if needed == Some(given) && given > 0 {
        Ok(())
    } else {
        let what = what.to_owned();
        Err(PictureFileError::SampleCount { what, given, width, height, channels })
    }
}

/// Refuses NaN and infinity, naming the first.
pub(crate) fn check_finite(
    samples: &[f32],
    width: usize,
    channels: usize,
) -> Result<(), PictureFileError> {
    let Some(first) = samples.iter().position(|sample| !sample.is_finite()) else {
        return Ok(());
    };
    Err(PictureFileError::NotFinite {
        count: samples.iter().filter(|sample| !sample.is_finite()).count(),
        row: first / channels / width,
        column: first / channels % width,
        channel: first % channels,
    })
}

/// Checks metadata against what both PNG (section 11.3.3) and EXR can hold: keywords of 1 to
/// 79 printable ASCII characters without spaces at the ends or in a row, each given once; texts
/// without the character NUL.
pub(crate) fn check_text(text: &[(String, String)]) -> Result<(), PictureFileError> {
    for (index, (keyword, value)) in text.iter().enumerate() {
        let printable = keyword.bytes().all(|byte| (b' '..=b'~').contains(&byte));
        let spaced = keyword.split(' ').any(str::is_empty);
        let problem = if !printable || spaced || keyword.len() > 79 {
            "is no keyword; allowed: 1 to 79 printable ASCII characters, single spaces inside"
        } else if text[..index].iter().any(|(earlier, _)| earlier == keyword) {
            "is given twice; allowed: each keyword once"
        } else if value.contains('\0') {
            "has the character NUL in its text, which no file can hold"
        } else if value.len() > TEXT_BYTES_MAX {
            "has a text of more than 16 MiB; allowed: at most 16777216 bytes"
        } else {
            continue;
        };
        return Err(PictureFileError::Text { keyword: keyword.clone(), problem });
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_decoder_that_panics_is_a_damaged_file() {
        let outcome = guarded::<()>(|| panic!("as third-party code may"));
        assert_eq!(
            outcome.unwrap_err().to_string(),
            "is damaged or cut short (its decoder gave up)"
        );
    }

    #[test]
    fn the_limits_are_inclusive() {
        assert!(check_size(16_384, 4096).is_ok());
        for (width, height) in [(0, 1), (1, 0), (16_385, 1), (16_384, 4097), (u64::MAX, u64::MAX)] {
            assert!(check_size(width, height).is_err());
        }
    }
}
