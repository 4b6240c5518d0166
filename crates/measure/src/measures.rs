//! Everything that is measured in one picture.

use serde::Serialize;

use crate::blemish::{Blemishes, blemishes};
use crate::candidate::largest;
use crate::contour::Widths;
use crate::disc::Disc;
use crate::face::Face;
use crate::lamp::{LampImage, lamp_image};
use crate::outline::{LEAST_RADIUS_PX, Outline, find, near};
use crate::rings::{Colour, Rings, rings, whole};
use crate::white::White;
use crate::{Circle, MeasureError, Picture, Value};

/// Above this roundness a pearl is no sphere: GIA's limit of near-round, 5 % of the diameter.
const ROUND: f64 = 0.05;
/// A smaller sphere has neither rings nor lamp's image: in a picture of half the size a ring's chroma is then off by up to 7 %,
/// a peak by 5 (`tests/measure/changes.py`); nor are spots looked for.
const LEAST_PLACES_PX: f64 = 40.0;
/// Radius of the copy in which colours are looked at, in pixels.
const COLOUR_PX: f64 = 256.0;
/// Where its error is more than this share of it, the blemished area hangs on faint spots: of pictures made anew, those that
/// move by over 5 % are above it (`tests/measure/changes.py`).
const UNSURE: f64 = 0.08;
/// Of a white that reflects all light; no pearl's mean is above it.
const MOST_LIGHTNESS: f64 = 100.0;

/// What is known of a picture.
#[derive(Clone, Debug)]
pub struct Given {
    /// The pearl's outline, about: it is looked for near it.
    pub circle: Option<Circle>,
    /// Linear RGB of a white matt thing in the picture's light.
    pub white: [f64; 3],
    /// Millimetres in a pixel, on the plane through the pearl's middle.
    pub mm_per_pixel: Option<f64>,
    /// Linear light from which a file's codes no longer follow.
    pub clipped_at: Option<f64>,
}

impl Default for Given {
    fn default() -> Self {
        Self { circle: None, white: [1.0; 3], mm_per_pixel: None, clipped_at: None }
    }
}

/// Where the pearl is.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Place {
    /// The circle as large as it on average.
    pub circle: Circle,
    /// Whether a circle was given to start from.
    pub given: bool,
    /// In how large a share of directions an edge was seen on the outline.
    pub share: f64,
    /// The outline, in pixels.
    pub line: Vec<[f64; 2]>,
}

/// Feret's diameters.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Size {
    /// "mm", or "px" where no scale is given.
    pub unit: &'static str,
    /// The mean over directions.
    pub mean: Value,
    /// The least.
    pub least: Value,
    /// The greatest.
    pub greatest: Value,
}

/// What could not be measured, and why.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Refused {
    /// The part, as in `Measures`.
    pub quantity: &'static str,
    /// The reason.
    pub reason: String,
}

/// What was measured in one picture.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Measures {
    /// Where the pearl is.
    pub place: Place,
    /// How large it is.
    pub size: Size,
    /// (greatest - least) / mean diameter, as a share.
    pub roundness: Value,
    /// Whether it counts as a sphere, seen from here.
    pub sphere: bool,
    /// The colour of the whole pearl.
    pub colour: Option<Colour>,
    /// Colour by ring.
    pub rings: Option<Rings>,
    /// The lamp's image.
    pub lamp: Option<LampImage>,
    /// Spots.
    pub blemishes: Option<Blemishes>,
    /// What is None above, and parts of it, with the reason.
    pub refused: Vec<Refused>,
}

/// Measures the one pearl in a picture.
///
/// # Errors
/// No pearl or more than one, a pearl that leaves the picture or is under 12 pixels in radius, one whose outline cannot
/// be followed, and numbers given that cannot be.
pub fn measure(picture: &Picture<'_>, given: &Given) -> Result<Measures, MeasureError> {
    measure_cut_out(picture, picture, given)
}

/// Measures the one pearl in a picture of which another one, as large, shows the outline: how opaque it is.
///
/// # Errors
/// Those of `measure`, and another size.
pub fn measure_cut_out(
    picture: &Picture<'_>,
    opacity: &Picture<'_>,
    given: &Given,
) -> Result<Measures, MeasureError> {
    let (width, height) = (opacity.width(), opacity.height());
    if (width, height) != (picture.width(), picture.height()) {
        return Err(MeasureError::Size { width, height, numbers: 3 * width * height });
    }
    let white = White::new(given.white)?;
    check(given)?;
    let outline = match given.circle {
        Some(circle) => near(opacity, circle)?,
        None => find(opacity)?,
    };
    let mut refused = Refusals::default();
    let widths = outline.widths();
    let roundness = widths.roundness;
    let sphere = roundness.value <= ROUND;
    let clipped_at = given.clipped_at.unwrap_or(f64::INFINITY);
    let disc = Disc::of(picture, &white, &outline.contour, clipped_at, COLOUR_PX);
    let colour = refused.taken("colour", colour_of(&disc, &outline.contour.middle));
    let OfSphere { rings, lamp, blemishes } = if sphere {
        of_sphere(picture, &white, &outline, &disc, clipped_at, &mut refused)
    } else {
        OfSphere::none(&mut refused)
    };
    let (place, size) = (place(&outline, given), size(&widths, given.mm_per_pixel));
    let refused = refused.0;
    Ok(Measures { place, size, roundness, sphere, colour, rings, lamp, blemishes, refused })
}

/// The colour of the whole pearl, which no pearl is where it is lighter than the white.
fn colour_of(disc: &Disc, circle: &Circle) -> Result<Colour, String> {
    let colour = whole(disc, circle)?;
    let lightness = colour.lightness.value;
    if lightness > MOST_LIGHTNESS {
        return Err(format!(
            "the pearl is lighter than the white that was given: L* {lightness:.0}; allowed: up to {MOST_LIGHTNESS}"
        ));
    }
    Ok(colour)
}

fn place(outline: &Outline, given: &Given) -> Place {
    Place {
        circle: outline.contour.middle,
        given: given.circle.is_some(),
        share: outline.share,
        line: outline.contour.places(180),
    }
}

/// What is measured of a sphere alone.
#[derive(Default)]
struct OfSphere {
    rings: Option<Rings>,
    lamp: Option<LampImage>,
    blemishes: Option<Blemishes>,
}

impl OfSphere {
    /// Of what is no sphere.
    fn none(refused: &mut Refusals) -> Self {
        for quantity in ["rings", "lamp", "blemishes"] {
            refused.add(quantity, "the pearl is no sphere: its diameters differ by more than 5 %");
        }
        Self::default()
    }
}

fn of_sphere(
    picture: &Picture<'_>,
    white: &White,
    outline: &Outline,
    disc: &Disc,
    clipped_at: f64,
    refused: &mut Refusals,
) -> OfSphere {
    let circle = outline.contour.middle;
    let found = lamp_image(picture, white, disc, &circle);
    let is_small = circle.radius_px < LEAST_PLACES_PX;
    let small = || {
        let radius_px = circle.radius_px.floor();
        format!("the pearl has {radius_px} pixels of radius; wanted: {LEAST_PLACES_PX} or more")
    };
    let lamp = refused.taken("lamp", if is_small { Err(small()) } else { found.image });
    if let Some(image) = &lamp {
        if image.haze.is_none() {
            refused.add("lamp.haze", "the lamp's image lies too near to the outline");
        }
        if image.distinctness.is_none() {
            let reason = "a degree of the surface is less than a pixel, or the outline is near";
            refused.add("lamp.distinctness", reason);
        }
    }
    let few = || "the lamp's image and clipped light leave too little of the pearl".to_owned();
    let rings =
        if is_small { Err(small()) } else { rings(disc, &circle, found.highlight).ok_or_else(few) };
    let rings = refused.taken("rings", rings);
    let spots = if is_small {
        Err(small())
    } else {
        let face = Face::of(picture, white, &outline.contour, clipped_at, found.highlight);
        blemishes(&face).ok_or_else(few)
    };
    let blemishes = refused.taken("blemishes", spots);
    if let Some(reason) = blemishes.as_ref().and_then(faint) {
        refused.add("blemishes.relief", &reason);
    }
    OfSphere { rings, lamp, blemishes }
}

/// What is too faint to be told, or to hold still.
fn faint(found: &Blemishes) -> Option<String> {
    let (least, largest) = (found.threshold, largest());
    if found.count == 0 {
        return Some(format!(
            "no spot of up to {largest:.2} radians differs by {least:.1} and more in L*; larger ones, and relief that differs by less, cannot be told here"
        ));
    }
    let error = found.area.error.unwrap_or(0.0);
    (error > UNSURE * found.area.value).then(|| {
        format!(
            "some spots differ by little more than {least:.1} in L*; how a picture is made (pixels, JPEG) may change the area by {error:.1} % of the pearl"
        )
    })
}

#[derive(Default)]
struct Refusals(Vec<Refused>);

impl Refusals {
    fn add(&mut self, quantity: &'static str, reason: &str) {
        self.0.push(Refused { quantity, reason: reason.to_owned() });
    }

    fn taken<T>(&mut self, quantity: &'static str, found: Result<T, String>) -> Option<T> {
        found.map_err(|reason| self.add(quantity, &reason)).ok()
    }
}

fn size(widths: &Widths, mm_per_pixel: Option<f64>) -> Size {
    let (unit, factor) = mm_per_pixel.map_or(("px", 1.0), |mm| ("mm", mm));
    let scaled = |width: Value| width.times(factor);
    Size {
        unit,
        mean: scaled(widths.mean),
        least: scaled(widths.least),
        greatest: scaled(widths.greatest),
    }
}

/// Numbers given with a picture.
fn check(given: &Given) -> Result<(), MeasureError> {
    let number = |quantity, value: f64, allowed| MeasureError::Number { quantity, value, allowed };
    if let Some(mm) = given.mm_per_pixel.filter(|mm| !(1e-6..=100.0).contains(mm)) {
        return Err(number("mm_per_pixel", mm, "0.000001 to 100 mm"));
    }
    if let Some(level) = given.clipped_at.filter(|level| level.is_nan() || *level <= 0.0) {
        return Err(number("clipped_at", level, "above 0, linear light"));
    }
    match given.circle {
        Some(Circle { x_px, y_px, radius_px })
            if !(x_px.is_finite() && y_px.is_finite() && radius_px.is_finite()) =>
        {
            Err(number("circle", radius_px, "finite pixels"))
        }
        Some(Circle { radius_px, .. }) if radius_px < LEAST_RADIUS_PX => {
            Err(number("the circle's radius", radius_px, "12 pixels and more"))
        }
        _ => Ok(()),
    }
}
