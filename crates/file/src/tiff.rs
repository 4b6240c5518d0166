//! What the header of a TIFF says, read before its decoder sees the file.
//!
//! TIFF 6.0 and BigTIFF: the tags of the first directory that say of what kind the pixels are, and the ICC profile.
//! The decoder of the `image` crate says of other kinds that they are damaged or of too many bits, leaves a profile
//! out that is large beside the picture, and takes colours that alpha was multiplied into as they stand.
//! Left out: `TransferFunction`, `WhitePoint` and `PrimaryChromaticities` (section 20), which profiles have replaced.

use crate::picture::PictureFileError;

/// Longest ICC profile that is read, 16 MiB; those of printers with tables take one or two.
const PROFILE_BYTES_MAX: u64 = 1 << 24;
/// Tags by their numbers (TIFF 6.0; ICC.1:2022, annex B.4 for the profile).
const BITS: u16 = 258;
const COMPRESSION: u16 = 259;
const PHOTOMETRIC: u16 = 262;
const SAMPLES: u16 = 277;
const PLANES: u16 = 284;
const EXTRA: u16 = 338;
const FORMAT: u16 = 339;
const PROFILE: u16 = 34_675;

/// The first directory of a TIFF.
pub(crate) struct TiffHeader<'a> {
    bytes: &'a [u8],
    big_endian: bool,
    /// Bytes of a count or an offset: 4, in BigTIFF 8.
    wide: usize,
    /// Tag, type, how many values, and where they or their offset stand.
    entries: Vec<(u16, u16, u64, usize)>,
}

/// TIFF with offsets of eight bytes: 43 in place of 42, from either end.
pub(crate) fn is_big_tiff(bytes: &[u8]) -> bool {
    bytes.starts_with(b"II\x2b\0") || bytes.starts_with(b"MM\0\x2b")
}

impl<'a> TiffHeader<'a> {
    /// Finds the first directory.
    ///
    /// # Errors
    /// A file that ends before it.
    pub(crate) fn new(bytes: &'a [u8]) -> Result<Self, PictureFileError> {
        let big = is_big_tiff(bytes);
        let wide = if big { 8 } else { 4 };
        let big_endian = bytes.starts_with(b"MM");
        let mut header = Self { bytes, big_endian, wide, entries: Vec::new() };
        let cut = || PictureFileError::Damaged("the TIFF ends before its directory".to_owned());
        let start = header.number(wide, wide).ok_or_else(cut)?;
        let start = usize::try_from(start).map_err(|_| cut())?;
        let of_count = if big { 8 } else { 2 };
        let count = header.number(start, of_count).ok_or_else(cut)?;
        let first = start + of_count;
        let entry = 4 + 2 * wide;
        for i in 0..usize::try_from(count).map_err(|_| cut())? {
            let at =
                i.checked_mul(entry).and_then(|past| first.checked_add(past)).ok_or_else(cut)?;
            let tag = header.number(at, 2).ok_or_else(cut)? as u16;
            let kind = header.number(at + 2, 2).ok_or_else(cut)? as u16;
            let values = header.number(at + 4, wide).ok_or_else(cut)?;
            header.entries.push((tag, kind, values, at + 4 + wide));
        }
        Ok(header)
    }

    /// Refuses what is not read here by its own name.
    pub(crate) fn check(&self) -> Result<(), PictureFileError> {
        const NUMBERS: &str = "with 8 or 16 bits a channel, whole numbers";
        let refused = |what: String, instead: &str| {
            Err(PictureFileError::Unsupported(format!("is a TIFF with {what}; save it {instead}")))
        };
        let packing = self.first(COMPRESSION).unwrap_or(1);
        if !matches!(packing, 1 | 5 | 8 | 32_773 | 32_946) {
            let instead = "uncompressed, or with LZW, Deflate or PackBits";
            return refused(compression_name(packing), instead);
        }
        let colours = self.first(PHOTOMETRIC).unwrap_or(1);
        if !matches!(colours, 0..=2) {
            return refused(photometric_name(colours), "as grey or RGB");
        }
        let bits = self.values(BITS).unwrap_or_else(|| vec![1]);
        let Some(&width) = bits.first().filter(|first| bits.iter().all(|each| each == *first))
        else {
            return refused(format!("channels of {bits:?} bits"), NUMBERS);
        };
        match self.values(FORMAT).unwrap_or_default().into_iter().find(|format| *format != 1) {
            Some(2) => return refused(format!("signed whole numbers of {width} bits"), NUMBERS),
            Some(3) => return refused(format!("floating-point numbers of {width} bits"), NUMBERS),
            Some(other) => return refused(format!("sample format {other}"), NUMBERS),
            None => {}
        }
        if !matches!(width, 8 | 16) && (colours == 2 || width != 1) {
            return refused(format!("{width} bits a channel"), NUMBERS);
        }
        let samples = self.first(SAMPLES).unwrap_or(1);
        match (colours, samples) {
            (0 | 1, 1) | (2, 3 | 4) => {}
            (0 | 1, 2) => return refused("grey and alpha".to_owned(), "without alpha, or as RGB"),
            _ => return refused(format!("{samples} channels"), "as grey or RGB, one layer"),
        }
        match self.first(PLANES).unwrap_or(1) {
            1 => Ok(()),
            _ => refused("a plane for each channel".to_owned(), "with channels interleaved"),
        }
    }

    /// Whether its colours were multiplied by alpha (`ExtraSamples` 1; TIFF 6.0, section 18).
    pub(crate) fn has_associated_alpha(&self) -> bool {
        self.first(SAMPLES) == Some(4) && self.first(EXTRA) == Some(1)
    }

    /// The ICC profile.
    ///
    /// # Errors
    /// One that is not where the directory says, is not bytes, or is longer than 16 MiB.
    pub(crate) fn profile(&self) -> Result<Option<Vec<u8>>, PictureFileError> {
        let Some(&(_, kind, length, place)) = self.entries.iter().find(|(tag, ..)| *tag == PROFILE)
        else {
            return Ok(None);
        };
        let unusable = |problem: String| Err(PictureFileError::ColourProfile(problem));
        if !matches!(kind, 1 | 7) {
            return unusable(format!("its values are of type {kind}, not bytes"));
        }
        if length > PROFILE_BYTES_MAX {
            return unusable(format!("{length} bytes long; allowed: up to {PROFILE_BYTES_MAX}"));
        }
        match self.data(place, length) {
            Some(profile) => Ok(Some(profile.to_vec())),
            None => unusable(format!("its {length} bytes are not all in the file")),
        }
    }

    fn first(&self, tag: u16) -> Option<u64> {
        self.values(tag)?.first().copied()
    }

    /// The values of a tag of whole numbers, at most the 16 first of them.
    fn values(&self, tag: u16) -> Option<Vec<u64>> {
        let &(_, kind, count, place) = self.entries.iter().find(|(own, ..)| *own == tag)?;
        let size = match kind {
            1 => 1,
            3 => 2,
            4 => 4,
            16 => 8,
            _ => return None,
        };
        let data = self.data(place, count.checked_mul(size)?)?;
        let number = |bytes: &[u8]| self.whole(bytes);
        Some(data.chunks_exact(size as usize).take(16).map(number).collect())
    }

    /// So many bytes of an entry, in it or elsewhere.
    fn data(&self, place: usize, length: u64) -> Option<&'a [u8]> {
        let length = usize::try_from(length).ok()?;
        let start = if length <= self.wide {
            place
        } else {
            usize::try_from(self.number(place, self.wide)?).ok()?
        };
        self.bytes.get(start..start.checked_add(length)?)
    }

    fn number(&self, at: usize, size: usize) -> Option<u64> {
        self.bytes.get(at..at.checked_add(size)?).map(|bytes| self.whole(bytes))
    }

    fn whole(&self, bytes: &[u8]) -> u64 {
        let add = |sum: u64, byte: &u8| sum << 8 | u64::from(*byte);
        if self.big_endian { bytes.iter().fold(0, add) } else { bytes.iter().rev().fold(0, add) }
    }
}

/// As libtiff's `tiff.h` numbers them.
fn compression_name(number: u64) -> String {
    let name = match number {
        2..=4 => "a fax machine's",
        6 | 7 => "JPEG",
        33_003 | 33_005 | 34_712 => "JPEG 2000",
        34_887 => "LERC",
        34_892 => "lossy JPEG of DNG",
        34_925 => "LZMA",
        50_000 => "Zstandard",
        50_001 => "WebP",
        50_002 | 52_546 => "JPEG XL",
        _ => return format!("compression {number}"),
    };
    format!("compression {number} ({name})")
}

/// TIFF 6.0 and DNG.
fn photometric_name(number: u64) -> String {
    let name = match number {
        3 => "a palette",
        4 => "a transparency mask",
        5 => "CMYK pixels, whose colours depend on a printer",
        6 => "YCbCr pixels",
        8..=10 => "CIE Lab pixels",
        32_803 | 34_892 => "a camera's raw pixels",
        _ => return format!("pixels of kind {number} (PhotometricInterpretation)"),
    };
    name.to_owned()
}
