//! What depth, shininess and grain mean.
//!
//! The paper's three qualities, section 4; its mapping is not printed, this one is **(ours)**.
//! Left out: colour and roundness, which are no knobs.

/// The physical parameters behind depth, shininess and grain, the three qualities by which inspectors
/// judge a pearl (paper, section 4). The mapping is **(ours)**: the paper set its parameters by eye and
/// prints none.
///
/// ```
/// use nacreous_image::Parameters;
/// let (dull, bright) = (Parameters::new(0.5, 0.1, 0.0), Parameters::new(0.5, 0.9, 0.0));
/// assert!(dull.facet_spread_rad > bright.facet_spread_rad);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Parameters {
    /// D of equation (4): share of light scattered at each layer. Less of it, and more layers take
    /// part.
    pub diffuse_loss: f64,
    /// Share of interference against body colour in the mixture.
    pub mixing: f64,
    /// Depth of the outer nacre whose layers interfere, um: the transport model's share of what depth means.
    pub outer_um: f64,
    /// How far light wanders inside: its waves of degree l fade by exp(-l (l + 1) spread).
    pub spread: f64,
    /// Standard deviation of the facets' lean.
    pub facet_spread_rad: f64,
    /// Share of the mirrored surroundings that the surface leaves clear.
    pub mirror_weight: f64,
    /// Radians of hue per unit of the grain's hue texture.
    pub hue_weight: f64,
    /// Relative chroma per unit of the grain's chroma texture.
    pub chroma_weight: f64,
    /// Relative brightness of the mirrored light per unit of the grain's value texture.
    pub value_weight: f64,
    /// Standard deviation of the grain's slopes, in any one direction.
    pub relief_rad: f64,
}

impl Parameters {
    /// Each knob goes from 0 (none) to 1 (the most).
    pub fn new(depth: f64, shininess: f64, grain: f64) -> Self {
        Self {
            // From 0.2, where a few layers are seen, to 0.03, where the even layers of the last weeks
            // are. With still less, the thick layers of the summer shine through and blur the rings.
            diffuse_loss: geometric(0.2, 0.03, depth),
            // Pale in the middle of the scale, where most pearls are; half interference at its end.
            mixing: 0.5 * libm::pow(depth, 1.5),
            // From five layers to 150; the trade reports on the outer 50 um.
            outer_um: 2.0 + 58.0 * depth,
            // From a body nearly as matt as chalk to one that keeps half of its contrast (0.02 to 0.3); how far light
            // goes, the root of it, grows evenly.
            spread: (0.141 + 0.407 * depth).powi(2),
            // From satin (14 degrees) to a mirror with a soft edge (0.7 degrees).
            facet_spread_rad: geometric(0.25, 0.012, shininess),
            mirror_weight: shininess.sqrt(),
            // A body near white has little chroma, and so takes strong weights to show its grain.
            hue_weight: 3.0 * grain,
            chroma_weight: 5.0 * grain,
            value_weight: 4.0 * grain,
            // At most a third of a usual pearl's facets' lean: the grain breaks a lamp's image and does not blur it.
            relief_rad: 0.016 * grain,
        }
    }
}

/// From `start` to `end` in equal ratios.
fn geometric(start: f64, end: f64, share: f64) -> f64 {
    start * libm::pow(end / start, share)
}
