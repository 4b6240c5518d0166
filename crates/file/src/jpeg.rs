//! What the segments of a JPEG say (ITU-T T.81, annex B), read before its decoder sees the file.

use crate::picture::PictureFileError;

/// Walks the segments for what the decoder forgives: a file cut short, whose rest would come out grey, and CMYK.
/// Answers whether one of them holds a piece of an ICC profile (ICC.1:2022, annex B.4).
pub(crate) fn check_jpeg(bytes: &[u8]) -> Result<bool, PictureFileError> {
    const START_OF_SCAN: u8 = 0xda;
    const END_OF_IMAGE: [u8; 2] = [0xff, 0xd9];
    const APP2: u8 = 0xe2;
    let cut = || PictureFileError::Damaged("the JPEG ends before its picture".to_owned());
    let mut has_profile = false;
    let mut rest = &bytes[2..];
    loop {
        let marker = rest.windows(2).position(|pair| pair[0] == 0xff && pair[1] != 0xff);
        rest = &rest[marker.ok_or_else(cut)?..];
        let [_, code, high, low, ..] = *rest else { return Err(cut()) };
        if code == START_OF_SCAN {
            break;
        }
        // Start of frame, all sorts but the tables DHT, JPG and DAC in between.
        if matches!(code, 0xc0..=0xcf) && !matches!(code, 0xc4 | 0xc8 | 0xcc) {
            let channels = rest.get(9).ok_or_else(cut)?;
            if *channels == 4 {
                let problem = "has CMYK pixels, whose colours depend on a printer; save it as RGB";
                return Err(PictureFileError::Unsupported(problem.to_owned()));
            }
        }
        has_profile |= code == APP2 && rest[4..].starts_with(b"ICC_PROFILE\0");
        let length = 2 + usize::from(u16::from_be_bytes([high, low]));
        rest = rest.get(length..).ok_or_else(cut)?;
    }
    // Inside a scan 0xff is always escaped, so the first such pair is the end.
    if rest.windows(2).any(|pair| pair == END_OF_IMAGE) { Ok(has_profile) } else { Err(cut()) }
}
