//! The chunks with which a PNG says what its samples stand for.
//!
//! Precedence as in the third edition of PNG (W3C, 2025, section 4.3): `cICP`, `iCCP`, `sRGB`, then `gAMA` and
//! `cHRM`. A `gAMA` of 0.45455 without primaries, or with those of sRGB, is the stand-in for sRGB that the standard
//! wants beside `sRGB` (11.3.2.5) and programs leave alone; it is taken as sRGB, as libpng's simplified API does.
//! Not read, and refused: the transfer functions PQ and HLG, whose light has no white, and samples of a narrow range.

use nacreous_colour::RgbSpace;

use crate::encoding::{BT_709, Curve, Encoding, Primaries};
use crate::icc::icc_profile;
use crate::picture::PictureFileError;

/// Rec. ITU-R BT.2020, table 3.
const BT_2020: Primaries =
    Primaries { rgb: [[0.708, 0.292], [0.170, 0.797], [0.131, 0.046]], white: BT_709.white };
/// SMPTE EG 432-1, with D65.
const P3: Primaries =
    Primaries { rgb: [[0.680, 0.320], [0.265, 0.690], [0.150, 0.060]], white: BT_709.white };
/// `gAMA` holds this many for 1.
const GAMMA_SCALE: f64 = 1e5;
/// What `gAMA` holds that stands in for sRGB.
const SRGB_GAMMA: u32 = 45_455;

/// The encoding of a PNG, or nothing where its `iCCP` says it.
///
/// # Errors
/// A chunk about colours that is damaged, or that says what is not read here.
pub(crate) fn png_encoding(bytes: &[u8]) -> Result<Option<Encoding>, PictureFileError> {
    let chunks = Chunks::of(bytes);
    if let Some(numbers) = chunks.numbers(*b"cICP")? {
        return from_cicp(numbers).map(Some);
    }
    if chunks.get(*b"iCCP")?.is_some() {
        return Ok(None);
    }
    if chunks.get(*b"sRGB")?.is_some() {
        return Ok(Some(Encoding::SRGB));
    }
    let primaries = chunks.numbers(*b"cHRM")?.map(|chunk: [u8; 32]| {
        let xy: [f32; 8] = std::array::from_fn(|i| {
            u32::from_be_bytes(std::array::from_fn(|j| chunk[4 * i + j])) as f32 / 1e5
        });
        let [x, y, red_x, red_y, green_x, green_y, blue_x, blue_y] = xy;
        Primaries { rgb: [[red_x, red_y], [green_x, green_y], [blue_x, blue_y]], white: [x, y] }
    });
    let primaries = primaries.filter(|primaries| !primaries.are_srgb());
    let curve = match chunks.numbers(*b"gAMA")?.map(u32::from_be_bytes) {
        None => Curve::Srgb,
        Some(SRGB_GAMMA) if primaries.is_none() => Curve::Srgb,
        Some(gamma) => Curve::Power(power(gamma)?),
    };
    Ok(Some(Encoding::Curve(curve, primaries)))
}

/// The power that undoes a `gAMA`.
fn power(gamma: u32) -> Result<f64, PictureFileError> {
    let gamma = f64::from(gamma) / GAMMA_SCALE;
    if (0.1..=10.0).contains(&gamma) {
        return Ok(1.0 / gamma);
    }
    Err(PictureFileError::Unsupported(format!(
        "has a chunk gAMA of {gamma}; allowed: 0.1 to 10; save it as sRGB"
    )))
}

/// Primaries, transfer function, matrix and range by the numbers of ITU-T H.273.
fn from_cicp(chunk: [u8; 4]) -> Result<Encoding, PictureFileError> {
    let refused = |what: String, allowed: &str| {
        let [a, b, c, d] = chunk;
        PictureFileError::Unsupported(format!(
            "has a chunk cICP of {a}, {b}, {c}, {d}, with {what}; allowed: {allowed}; save it as sRGB"
        ))
    };
    let [primaries, transfer, matrix, range] = chunk;
    if matrix != 0 {
        return Err(refused(format!("matrix {matrix}"), "0, RGB"));
    }
    if range != 1 {
        return Err(refused(format!("range {range}"), "1, the full range"));
    }
    match (primaries, transfer) {
        // Our own pictures say the same by both chunks, and are the same by both.
        (1, 13) => return Ok(Encoding::Profile(icc_profile(RgbSpace::Srgb))),
        (12, 13) => return Ok(Encoding::Profile(icc_profile(RgbSpace::DisplayP3))),
        _ => {}
    }
    let primaries = match primaries {
        1 => None,
        9 => Some(BT_2020),
        12 => Some(P3),
        other => {
            let allowed = "1 (BT.709, sRGB), 9 (BT.2020), 12 (Display P3)";
            return Err(refused(format!("primaries {other}"), allowed));
        }
    };
    let curve = match transfer {
        1 | 6 | 14 | 15 => Curve::Bt709,
        4 => Curve::Power(2.2),
        5 => Curve::Power(2.8),
        8 => Curve::Power(1.0),
        13 => Curve::Srgb,
        other => {
            let name = match other {
                16 => " (PQ)",
                18 => " (HLG)",
                _ => "",
            };
            let allowed =
                "1, 6, 14, 15 (BT.709), 4 and 5 (gamma 2.2 and 2.8), 8 (linear), 13 (sRGB)";
            return Err(refused(format!("transfer function {other}{name}"), allowed));
        }
    };
    Ok(Encoding::Curve(curve, primaries))
}

/// The chunks ahead of the pixels: name, data, and whether the checksum is right.
struct Chunks<'a>(Vec<(&'a [u8], &'a [u8], bool)>);

impl<'a> Chunks<'a> {
    /// Of a PNG's bytes, as far as they go; what is cut off is the decoder's to say.
    fn of(bytes: &'a [u8]) -> Self {
        const SIGNATURE: usize = 8;
        let (mut found, mut rest) = (Vec::new(), bytes.get(SIGNATURE..).unwrap_or_default());
        while let Some((length, after)) = rest.split_first_chunk::<4>() {
            let length = u32::from_be_bytes(*length) as usize;
            let Some((named, after)) = after.split_at_checked(length.saturating_add(4)) else {
                break;
            };
            let Some((sum, after)) = after.split_first_chunk::<4>() else { break };
            let (name, data) = named.split_at(4);
            if name == b"IDAT" {
                break;
            }
            let mut crc = flate2::Crc::new();
            crc.update(named);
            found.push((name, data, crc.sum() == u32::from_be_bytes(*sum)));
            rest = after;
        }
        Self(found)
    }

    /// The data of a chunk of this name.
    fn get(&self, name: [u8; 4]) -> Result<Option<&'a [u8]>, PictureFileError> {
        match self.0.iter().find(|(own, ..)| *own == name) {
            None => Ok(None),
            Some((_, data, true)) => Ok(Some(data)),
            Some(_) => Err(damaged(&name, "a wrong checksum")),
        }
    }

    /// The same, of a fixed length.
    fn numbers<const N: usize>(&self, name: [u8; 4]) -> Result<Option<[u8; N]>, PictureFileError> {
        let fixed = |data: &[u8]| {
            data.try_into().map_err(|_| damaged(&name, &format!("{} bytes, not {N}", data.len())))
        };
        self.get(name)?.map(fixed).transpose()
    }
}

fn damaged(name: &[u8], what: &str) -> PictureFileError {
    PictureFileError::Damaged(format!("its chunk {} has {what}", String::from_utf8_lossy(name)))
}
