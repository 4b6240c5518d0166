//! The numbers of a pixel and what they are called.
//!
//! Four parts that add up, the grain, the coverage, and the shadow.
//! Left out: the codes of a screen, which developing makes.

/// Numbers per pixel: four parts of three channels, the texture's three, the pearls' coverage, and their shadow.
pub const CHANNELS: usize = 17;

/// The parts of a picture and the channels they take in each pixel. The first four add up to the
/// picture.
pub const PARTS: [(&str, std::ops::Range<usize>); 7] = [
    ("interference", 0..3),
    ("diffuse", 3..6),
    ("mirror", 6..9),
    ("surroundings", 9..12),
    ("texture", 12..15),
    ("coverage", 15..16),
    ("shadow", 16..17),
];

/// The largest picture: 8192 pixels a side take 4.6 GB.
pub const MAX_SIZE_PX: usize = 8192;
