/// Numbers per pixel: four parts of three channels, the texture's three, and the pearls' coverage.
pub const CHANNELS: usize = 16;

/// The parts of a picture and the channels they take in each pixel. The first four add up to the
/// picture.
pub const PARTS: [(&str, std::ops::Range<usize>); 6] = [
    ("interference", 0..3),
    ("diffuse", 3..6),
    ("mirror", 6..9),
    ("surroundings", 9..12),
    ("texture", 12..15),
    ("coverage", 15..16),
];

/// The largest picture: 8192 pixels a side take 4 GB.
pub const MAX_SIZE_PX: usize = 8192;
