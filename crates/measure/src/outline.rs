//! The outline of one pearl: found or given, then traced finer than a pixel.

use std::f64::consts::TAU;

use libm::{fabs, sqrt};

use crate::contour::Contour;
use crate::edge::{Edge, edge};
use crate::path::closed_line;
use crate::search::Steepness;
use crate::{Circle, MeasureError, Picture};

/// An outline is believed when the steepest place lies on it in this share of directions **(ours)**; chance
/// alone gives a fifth. A second one must be seen more clearly, for a checkered table has many corners.
const LEAST_FOUND: f64 = 0.4;
const LEAST_SECOND: f64 = 0.7;
/// A second pearl has at least this share of the first one's radius.
const LEAST_BESIDE: f64 = 0.5;
/// How far from the outline that place may lie, in radii; a pixel is always allowed.
const NEAR: f64 = 0.02;
/// How far about the last outline edges are looked for, in radii, and with how many waves.
const FIRST_ROUNDS: [(f64, usize); 3] = [(0.10, 1), (0.05, 1), (0.05, 2)];
const LAST_ROUNDS: [(f64, usize); 2] = [(0.04, 4), (0.03, 6)];
const ROUNDS_OF_OVALS: [(f64, usize); 4] = [(0.12, 2), (0.08, 3), (0.05, 5), (0.04, 6)];
/// What deviates by more than this from three waves is no pearl: corners, several things **(ours)**.
const SMOOTH: f64 = 0.03;
/// Most rays of a first look, and of the outline in the end.
const RAYS: (usize, usize) = (240, 720);
/// The smallest pearl that is measured, in pixels of radius.
const LEAST_RADIUS_PX: f64 = 12.0;

/// The outline of the pearl that is measured.
pub struct Outline {
    /// Its shape.
    pub contour: Contour,
    /// In how large a share of directions an edge was seen on it.
    pub share: f64,
}

impl Outline {
    /// Whether it was seen, or is only what was given.
    pub fn is_seen(&self) -> bool {
        self.share >= LEAST_FOUND
    }

    /// How much more it is than chance: of a long line a share is harder to come by.
    fn weight(&self) -> f64 {
        self.share * sqrt(self.contour.middle.radius_px)
    }
}

/// The outline near a given circle; that circle itself where no edge stands out.
pub fn near(picture: &Picture<'_>, given: Circle) -> Result<Outline, MeasureError> {
    require_inside(picture, given)?;
    match trace(picture, Contour::round(given), &FIRST_ROUNDS, RAYS.0) {
        Some(first) if first.is_seen() => {
            let outline = refined(picture, first);
            require_inside(picture, outline.contour.middle)?;
            Ok(outline)
        }
        other => Ok(Outline {
            contour: Contour::round(given),
            share: other.map_or(0.0, |one| one.share),
        }),
    }
}

/// The outline of the one pearl in a picture.
///
/// Of circles that lie within the picture, those along which colour changes most are looked at more nearly, one
/// of each size; the one is taken that is seen in the largest share of directions, large ones before small. Where
/// none is seen so far, the closed line about the middle of one. A second one clear of the first is refused.
pub fn find(picture: &Picture<'_>) -> Result<Outline, MeasureError> {
    let steepness = Steepness::of(picture);
    let starts = steepness.best(None);
    let seen = starts
        .iter()
        .filter_map(|start| trace(picture, Contour::round(*start), &FIRST_ROUNDS, RAYS.0));
    let best = seen.max_by(|one, other| one.weight().total_cmp(&other.weight()));
    let share = best.as_ref().map_or(0.0, |outline| outline.share);
    let outline = match best {
        Some(outline) if outline.is_seen() => refined(picture, outline),
        _ => starts
            .iter()
            .filter_map(|start| oval(picture, *start))
            .max_by(|one, other| one.weight().total_cmp(&other.weight()))
            .ok_or(MeasureError::NoPearl { percent: 100.0 * share })?,
    };
    require_alone(picture, &steepness, &outline)?;
    require_inside(picture, outline.contour.middle)?;
    Ok(outline)
}

/// The same outline with all its waves; how clearly it is seen stays that of the simpler one.
fn refined(picture: &Picture<'_>, first: Outline) -> Outline {
    match trace(picture, first.contour.clone(), &LAST_ROUNDS, RAYS.1) {
        Some(last) => Outline { contour: last.contour, share: first.share },
        None => first,
    }
}

/// Refuses a picture in which another outline is seen beside the first.
fn require_alone(
    picture: &Picture<'_>,
    steepness: &Steepness,
    outline: &Outline,
) -> Result<(), MeasureError> {
    let first = outline.contour.middle;
    for start in steepness.best(Some(first)) {
        // A circle alone: with more waves an outline would bend to what corners it meets.
        let other = trace(picture, Contour::round(start), &FIRST_ROUNDS[..2], RAYS.0);
        let Some(other) = other.filter(|other| other.share > LEAST_SECOND) else { continue };
        let second = other.contour.middle;
        if second.radius_px > LEAST_BESIDE * first.radius_px {
            let [first, second] =
                [first, second].map(|circle| [circle.x_px, circle.y_px, circle.radius_px]);
            return Err(MeasureError::Several { first, second });
        }
    }
    Ok(())
}

/// What is round in no sense, but smooth, and closed.
fn oval(picture: &Picture<'_>, start: Circle) -> Option<Outline> {
    let line = closed_line(picture, start);
    let first = Contour::fit(&line, start, 3)?;
    let mut about = first.centre();
    about.radius_px = first.middle.radius_px;
    let second = Contour::fit(&closed_line(picture, about), about, 4)?;
    let outline = trace(picture, second, &ROUNDS_OF_OVALS, RAYS.1)?;
    let edges = edges(picture, &outline.contour, 180, 0.04);
    let smooth = Contour::fit(&edges, outline.contour.middle, 3)?;
    let off: f64 = (0..180)
        .map(|at| TAU * f64::from(at) / 180.0)
        .map(|turn| smooth.radius(turn) - outline.contour.radius(turn))
        .map(|off| off * off)
        .sum();
    let is_smooth = sqrt(off / 180.0) < SMOOTH * outline.contour.middle.radius_px;
    (outline.is_seen() && is_smooth).then_some(outline)
}

/// Follows an outline, ever nearer and with more waves, and says in which share of directions it is seen.
fn trace(
    picture: &Picture<'_>,
    start: Contour,
    rounds: &[(f64, usize)],
    most_rays: usize,
) -> Option<Outline> {
    let mut contour = start;
    for &(reach, order) in rounds {
        let rays = (TAU * contour.middle.radius_px).clamp(90.0, most_rays as f64) as usize;
        let found = edges(picture, &contour, rays, reach);
        let middle = contour.middle;
        contour = Contour::fit(&found, middle, order)?;
        // Rays start from the middle of what they found.
        let centre = contour.centre();
        if fabs(centre.x_px - middle.x_px) + fabs(centre.y_px - middle.y_px) > 0.01 {
            let moved = edges(picture, &shifted(&contour, centre), rays, reach);
            contour = Contour::fit(&moved, centre, order)?;
        }
    }
    Some(Outline { share: share_on(picture, &contour), contour })
}

/// The same outline seen from its centre, to the first order.
fn shifted(contour: &Contour, centre: Circle) -> Contour {
    let edges: Vec<Edge> = contour
        .places(180)
        .into_iter()
        .map(|[x, y]| {
            let (right, down) = (x - centre.x_px, y - centre.y_px);
            let away = sqrt(right * right + down * down);
            Edge { turn: libm::atan2(down, right), away, seen: true }
        })
        .collect();
    Contour::fit(&edges, centre, 6).unwrap_or_else(|| Contour::round(centre))
}

/// The edge near an outline along each of some rays.
fn edges(picture: &Picture<'_>, contour: &Contour, rays: usize, reach: f64) -> Vec<Edge> {
    (0..rays)
        .map(|at| TAU * at as f64 / rays as f64)
        .map(|turn| {
            let expected = contour.radius(turn);
            edge(picture, contour.middle, turn, expected, reach * contour.middle.radius_px)
        })
        .collect()
}

/// The share of directions in which the steepest place far about an outline lies on it.
fn share_on(picture: &Picture<'_>, contour: &Contour) -> f64 {
    let radius = contour.middle.radius_px;
    // Far enough that noise has somewhere else to be steep.
    let found = edges(picture, contour, 288, (6.0 / radius).max(0.1));
    let near = (NEAR * radius).max(1.0);
    let on = |edge: &&Edge| edge.seen && fabs(edge.away - contour.radius(edge.turn)) < near;
    found.iter().filter(on).count() as f64 / found.len() as f64
}

/// Refuses a pearl that is too small, or leaves the picture.
fn require_inside(picture: &Picture<'_>, circle: Circle) -> Result<(), MeasureError> {
    let (width, height) = (picture.width(), picture.height());
    let Circle { x_px: x, y_px: y, radius_px: radius } = circle;
    let within = |at: f64, side: usize| at - radius >= -1.0 && at + radius <= side as f64 + 1.0;
    if radius >= LEAST_RADIUS_PX && within(x, width) && within(y, height) {
        return Ok(());
    }
    Err(MeasureError::Outside { x, y, radius, width, height })
}
