//! The ICC profile that a PNG carries, written tag by tag after ICC.1:2022.
//!
//! A display profile of primaries, D65 and the transfer function of sRGB, relative to D50 by the Bradford transform
//! (annex E). Strict readers refuse what lenient ones forgive: here every tag begins at a multiple of four bytes and is
//! padded to one (7.2.1, 7.3), the illuminant is D50 to the last bit (7.2.16), and reserved bytes are zero.
//!
//! Out of scope: reading profiles, which is [`crate::profile`]'s.

use moxcms::{ColorPrimaries, adaption_matrix_d};
use nacreous_colour::RgbSpace;

use crate::profile::{D50, D65, d50_from_rgb};

/// Version 4.4 of the format, which ICC.1:2022 describes.
const VERSION: u32 = 0x0440_0000;
/// The day and time at which the profile was made, always the same, so that equal pictures have equal bytes.
const MADE: [u16; 6] = [2025, 1, 1, 0, 0, 0];
/// D50 as the header states it: 0.9642, 1 and 0.8249 in 1/65536.
const ILLUMINANT: [u32; 3] = [0xf6d6, 0x1_0000, 0xd32d];
/// Bytes of the header, and of an entry in the table of tags behind it.
const HEADER: usize = 128;
const ENTRY: usize = 12;

/// What the space is called, in its profile and beside it.
pub(crate) const fn icc_name(space: RgbSpace) -> &'static str {
    match space {
        RgbSpace::Srgb => "sRGB IEC61966-2.1",
        RgbSpace::DisplayP3 => "Display P3",
    }
}

/// The bytes of the ICC profile for this space, always the same.
///
/// ```
/// use nacreous_colour::RgbSpace;
/// let profile = nacreous_file::icc::icc_profile(RgbSpace::DisplayP3);
/// assert_eq!(profile.len() % 4, 0);
/// assert_eq!(&profile[36..40], b"acsp");
/// ```
pub fn icc_profile(space: RgbSpace) -> Vec<u8> {
    let primaries = match space {
        RgbSpace::Srgb => ColorPrimaries::BT_709,
        RgbSpace::DisplayP3 => ColorPrimaries::SMPTE_432,
    };
    let colourants = d50_from_rgb(primaries, D65).v;
    let column = |channel: usize| xyz(colourants.map(|row| row[channel]));
    let white = [D50.x, D50.y, D50.z]; // of a display: adapted (9.2.36)
    let tags: [(&[&[u8; 4]], Vec<u8>); 8] = [
        (&[b"desc"], text(icc_name(space))),
        (&[b"cprt"], text("No copyright: use freely.")),
        (&[b"wtpt"], xyz(white)),
        (&[b"chad"], matrix(adaption_matrix_d(D65.to_xyz(), D50.to_xyz()).v)),
        (&[b"rXYZ"], column(0)),
        (&[b"gXYZ"], column(1)),
        (&[b"bXYZ"], column(2)),
        (&[b"rTRC", b"gTRC", b"bTRC"], srgb_curve()),
    ];
    assembled(&tags)
}

/// Header, table of tags, and the tags, each of which may have several names.
fn assembled(tags: &[(&[&[u8; 4]], Vec<u8>)]) -> Vec<u8> {
    let names: usize = tags.iter().map(|(names, _)| names.len()).sum();
    let (mut table, mut data) = (bytes(&[names as u32]), Vec::new());
    let first = HEADER + table.len() + ENTRY * names;
    for (names, tag) in tags {
        for name in *names {
            table.extend_from_slice(*name);
            table.extend(bytes(&[(first + data.len()) as u32, tag.len() as u32]));
        }
        data.extend_from_slice(tag);
        data.resize(data.len().next_multiple_of(4), 0);
    }
    [header(first + data.len()), table, data].concat()
}

/// The 128 bytes of ICC.1:2022, 7.2; of perceptual intent, by no particular program or maker.
fn header(profile_bytes: usize) -> Vec<u8> {
    let mut header = bytes(&[profile_bytes as u32, 0, VERSION]);
    header.extend_from_slice(b"mntrRGB XYZ ");
    header.extend(MADE.iter().flat_map(|number| number.to_be_bytes()));
    header.extend_from_slice(b"acsp");
    header.resize(68, 0);
    header.extend(bytes(&ILLUMINANT));
    header.resize(HEADER, 0);
    header
}

/// `multiLocalizedUnicodeType`, in English (10.15).
fn text(text: &str) -> Vec<u8> {
    let letters: Vec<u8> = text.encode_utf16().flat_map(u16::to_be_bytes).collect();
    let mut tag = [b"mluc\0\0\0\0".to_vec(), bytes(&[1, 12])].concat();
    tag.extend_from_slice(b"enUS");
    tag.extend(bytes(&[letters.len() as u32, 28]));
    [tag, letters].concat()
}

/// `XYZType` (10.31).
fn xyz(values: [f64; 3]) -> Vec<u8> {
    [b"XYZ \0\0\0\0".to_vec(), fixed(&values)].concat()
}

/// `s15Fixed16ArrayType` (10.22), row by row.
fn matrix(rows: [[f64; 3]; 3]) -> Vec<u8> {
    [b"sf32\0\0\0\0".to_vec(), fixed(rows.as_flattened())].concat()
}

/// `parametricCurveType` of type 3 (10.18) with the numbers of IEC 61966-2-1.
fn srgb_curve() -> Vec<u8> {
    let numbers = [2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.040_45];
    [b"para\0\0\0\0\0\x03\0\0".to_vec(), fixed(&numbers)].concat()
}

/// `s15Fixed16Number`: in 1/65536, negative ones as two's complement (4.6).
fn fixed(values: &[f64]) -> Vec<u8> {
    values.iter().flat_map(|value| ((value * 65_536.0).round() as i32).to_be_bytes()).collect()
}

fn bytes(numbers: &[u32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_be_bytes()).collect()
}

#[cfg(test)]
mod tests {
    use moxcms::{ColorProfile, Xyzd};

    use super::*;

    const SPACES: [RgbSpace; 2] = [RgbSpace::Srgb, RgbSpace::DisplayP3];

    fn colourants(space: RgbSpace) -> [[f64; 3]; 3] {
        let profile = ColorProfile::new_from_slice(&icc_profile(space)).unwrap();
        [profile.red_colorant, profile.green_colorant, profile.blue_colorant]
            .map(|Xyzd { x, y, z }| [x, y, z])
    }

    #[test]
    fn every_tag_is_aligned_padded_with_zeros_and_apart_from_the_others() {
        for profile in SPACES.map(icc_profile) {
            let number =
                |at: usize| u32::from_be_bytes(profile[at..at + 4].try_into().unwrap()) as usize;
            assert_eq!((number(0), profile.len() % 4), (profile.len(), 0));
            let mut end = HEADER + 4 + ENTRY * number(HEADER);
            let entries = (0..number(HEADER)).map(|i| HEADER + 4 + ENTRY * i);
            let mut places: Vec<_> = entries.map(|at| (number(at + 4), number(at + 8))).collect();
            places.sort_unstable();
            places.dedup(); // curves share one
            for (start, length) in places {
                assert_eq!((start % 4, start), (0, end));
                end = (start + length).next_multiple_of(4);
                assert!(profile[start + length..end].iter().all(|byte| *byte == 0));
                assert_eq!(profile[start + 4..start + 8], [0; 4]); // reserved
            }
            assert_eq!(end, profile.len());
        }
    }

    #[test]
    fn srgb_colourants_are_the_published_ones() {
        // The ICC's sRGB2014 profile. Its own sum is off the white of the connection space by
        // 2e-4, hence the tolerance.
        let published =
            [[0.4361, 0.2225, 0.0139], [0.3851, 0.7169, 0.0971], [0.1431, 0.0606, 0.7141]];
        for (own, other) in
            colourants(RgbSpace::Srgb).as_flattened().iter().zip(published.as_flattened())
        {
            assert!((own - other).abs() < 2.5e-4, "{own} {other}");
        }
    }

    #[test]
    fn colourants_add_up_to_the_white_of_the_connection_space() {
        for space in SPACES {
            let [red, green, blue] = colourants(space);
            for (axis, white) in [D50.x, D50.y, D50.z].into_iter().enumerate() {
                let sum = red[axis] + green[axis] + blue[axis];
                assert!((sum - white).abs() < 2.5 / 65_536.0, "{space:?}, axis {axis}: {sum}");
            }
        }
    }
}
