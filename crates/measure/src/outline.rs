//! The outline of one pearl: found or given, then traced finer than a pixel.

use std::f64::consts::TAU;

use libm::{fabs, sqrt};

use crate::contour::{Contour, Widths};
use crate::edge::{Edge, distance, edge, shade};
use crate::hollow::is_hollow;
use crate::path::closed_line;
use crate::search::Steepness;
use crate::soft::{is_sharp, softness};
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
const ROUNDS_OF_OVALS: [(f64, usize); 3] = [(0.10, 4), (0.06, 5), (0.04, 6)];
/// With more waves, once it is believed: a drop's tip.
const LAST_OF_OVALS: [(f64, usize); 2] = [(0.10, 8), (0.06, 10)];
/// How often a closed line is looked for, each time from the middle of the last.
const ROUNDS_OF_LINES: usize = 3;
/// Seen in this share a circle is the outline; below, what is not round is looked for. That must be seen in a large
/// share too, for it bends to what edges it meets: on a checkered table up to 0.73 **(ours)**.
const CLEAR: f64 = 0.9;
const LEAST_OF_OVALS: f64 = 0.8;
/// What is not round must be seen in so much more of all directions than a circle there **(ours)**.
const MORE: f64 = 0.1;
/// What is seen less clearly must be this round: half of what is not round passes for rounder **(ours)**.
const ROUND: f64 = 0.03;
/// The outline is closed where no gap is longer than this share of a turn: of what is clear and round, of what is round alone, and
/// of what is not **(ours)**.
const LONGEST_GAP: [f64; 3] = [0.25, 0.125, 0.075];
/// What deviates by more than this from three waves is no pearl: corners, several things **(ours)**.
const SMOOTH: f64 = 0.045;
/// Colour changes across an outline over so many pixels to both sides, and more than this often what it does along it
/// **(ours)**: a table's squares cross a circle at any angle.
const ACROSS_PX: f64 = 1.5;
const ACROSS: f64 = 1.0;
/// Edges are looked for so far at the least: noise has somewhere else to be steep.
const LEAST_REACH_PX: f64 = 6.0;
/// Most rays of a first look, and of the outline in the end.
const RAYS: (usize, usize) = (240, 720);
/// The smallest pearl that is measured, in pixels of radius.
pub const LEAST_RADIUS_PX: f64 = 12.0;

/// How edges are looked for about an outline: along so many rays, so far in radii, by its blur.
type Look = fn(&Picture<'_>, &Contour, usize, f64, f64) -> Vec<Edge>;

/// The outline of the pearl that is measured.
pub struct Outline {
    /// Its shape.
    pub contour: Contour,
    /// In how large a share of directions an edge was seen on it.
    pub share: f64,
    /// The longest part of it on which none was, in turns.
    gap: f64,
    /// Its blur, a standard deviation in pixels.
    soft: f64,
}

impl Outline {
    /// The diameters of what it holds.
    pub fn widths(&self) -> Widths {
        self.contour.widths(self.soft)
    }

    /// How much more it is than chance: of a long line a share is harder to come by.
    fn weight(&self) -> f64 {
        self.share * sqrt(self.contour.middle.radius_px)
    }
}

/// The outline near a given circle.
pub fn near(picture: &Picture<'_>, given: Circle) -> Result<Outline, MeasureError> {
    require_inside(picture, given)?;
    let nothing = Outline { contour: Contour::round(given), share: 0.0, gap: 1.0, soft: 0.0 };
    let outline = best_of(picture, &[given]).unwrap_or(nothing);
    require_pearl(picture, &outline)?;
    Ok(outline)
}

/// The outline of the one pearl in a picture.
///
/// Of circles that lie within the picture, those along which colour changes most are looked at more nearly, one
/// of each size; the one is taken that is seen in the largest share of directions, large ones before small. Where
/// none is seen nearly all round, the closed line about the middle of one, if it is seen in more directions. A
/// second one clear of the first is refused.
pub fn find(picture: &Picture<'_>) -> Result<Outline, MeasureError> {
    let steepness = Steepness::of(picture);
    let found = best_of(picture, &steepness.best(None));
    let percent = 100.0 * found.as_ref().map_or(0.0, |outline| outline.share);
    let is_seen = |outline: &Outline| outline.share >= LEAST_FOUND;
    let outline = found.filter(is_seen).ok_or(MeasureError::NoPearl { percent })?;
    require_pearl(picture, &outline)?;
    require_alone(picture, &steepness, &outline)?;
    Ok(outline)
}

/// The outline about one of some circles that is seen best.
fn best_of(picture: &Picture<'_>, starts: &[Circle]) -> Option<Outline> {
    let by_weight = |one: &Outline, other: &Outline| one.weight().total_cmp(&other.weight());
    let round = starts
        .iter()
        .filter_map(|start| trace(picture, Contour::round(*start), &FIRST_ROUNDS, RAYS.0, edges))
        .max_by(by_weight);
    if let Some(round) = round.as_ref().filter(|round| round.share >= CLEAR) {
        return Some(refined(picture, round, &LAST_ROUNDS));
    }
    let clear = |oval: &Outline| oval.share >= LEAST_OF_OVALS;
    let ovals = starts.iter().filter_map(|start| oval(picture, *start)).filter(clear);
    match (ovals.max_by(by_weight), round) {
        // A closed line bends to noise, a circle does not.
        (Some(oval), Some(round)) if oval.share < round.share + MORE => {
            Some(refined(picture, &round, &LAST_ROUNDS))
        }
        (Some(oval), _) => {
            let last = refined(picture, &oval, &LAST_OF_OVALS);
            // A tip is reached with all waves alone.
            let (_, gap) = seen_on(picture, &last.contour, last.soft);
            Some(Outline { gap: gap.min(oval.gap), ..last })
        }
        (None, round) => round.map(|round| refined(picture, &round, &LAST_ROUNDS)),
    }
}

/// The same outline with all its waves; how clearly it is seen stays that of the simpler one.
fn refined(picture: &Picture<'_>, first: &Outline, rounds: &[(f64, usize)]) -> Outline {
    let last = trace(picture, first.contour.clone(), rounds, RAYS.1, sharp_edges);
    let (contour, soft) =
        last.map_or_else(|| (first.contour.clone(), first.soft), |last| (last.contour, last.soft));
    Outline { contour, share: first.share, gap: first.gap, soft }
}

/// Refuses what cannot be followed, leaves the picture, or has nothing within.
fn require_pearl(picture: &Picture<'_>, outline: &Outline) -> Result<(), MeasureError> {
    require_followed(outline)?;
    require_inside(picture, outline.contour.middle)?;
    if is_hollow(picture, &outline.contour) {
        let Circle { x_px: x, y_px: y, radius_px: radius } = outline.contour.middle;
        return Err(MeasureError::Hollow { x, y, radius });
    }
    Ok(())
}

/// Refuses an outline that is not seen, of which a long part is not, and one that is not round and not seen clearly.
fn require_followed(outline: &Outline) -> Result<(), MeasureError> {
    let is_clear = outline.share >= LEAST_OF_OVALS;
    let is_round = outline.widths().roundness.value <= ROUND;
    let longest = match (is_clear, is_round) {
        (true, true) => LONGEST_GAP[0],
        (false, true) => LONGEST_GAP[1],
        _ => LONGEST_GAP[2],
    };
    if outline.share >= LEAST_FOUND && (is_clear || is_round) && outline.gap <= longest {
        return Ok(());
    }
    let Circle { x_px: x, y_px: y, radius_px: radius } = outline.contour.middle;
    let (percent, degrees) = (100.0 * outline.share, 360.0 * outline.gap);
    Err(MeasureError::NotFollowed { x, y, radius, percent, degrees })
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
        let other = trace(picture, Contour::round(start), &FIRST_ROUNDS[..2], RAYS.0, edges);
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
    let mut about = start;
    let mut contour = Contour::fit(&closed_line(picture, about), about, 3)?;
    for _ in 1..ROUNDS_OF_LINES {
        about = contour.centroid();
        contour = Contour::fit(&closed_line(picture, about), about, 4)?;
    }
    let outline = trace(picture, contour, &ROUNDS_OF_OVALS, RAYS.1, edges)?;
    let edges = edges(picture, &outline.contour, 180, 0.04, outline.soft);
    let smooth = Contour::fit(&edges, outline.contour.middle, 3)?;
    let off: f64 = (0..180)
        .map(|at| TAU * f64::from(at) / 180.0)
        .map(|turn| smooth.radius(turn) - outline.contour.radius(turn))
        .map(|off| off * off)
        .sum();
    (sqrt(off / 180.0) < SMOOTH * outline.contour.middle.radius_px).then_some(outline)
}

/// Follows an outline, ever nearer and with more waves, and says in which share of directions it is seen.
fn trace(
    picture: &Picture<'_>,
    start: Contour,
    rounds: &[(f64, usize)],
    most_rays: usize,
    look: Look,
) -> Option<Outline> {
    let mut contour = start;
    let mut soft = 0.0;
    for &(reach, order) in rounds {
        soft = softness(picture, &contour, (reach * contour.middle.radius_px).max(LEAST_REACH_PX));
        let rays = (TAU * contour.middle.radius_px).clamp(90.0, most_rays as f64) as usize;
        let found = look(picture, &contour, rays, reach, soft);
        let middle = contour.middle;
        contour = Contour::fit(&found, middle, order)?;
        // Rays start from the middle of what they found.
        let centre = contour.centre();
        if fabs(centre.x_px - middle.x_px) + fabs(centre.y_px - middle.y_px) > 0.01 {
            let moved = look(picture, &shifted(&contour, centre), rays, reach, soft);
            contour = Contour::fit(&moved, centre, order)?;
        }
    }
    let (share, gap) = seen_on(picture, &contour, soft);
    Some(Outline { contour, share, gap, soft })
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
fn edges(
    picture: &Picture<'_>,
    contour: &Contour,
    rays: usize,
    reach: f64,
    soft: f64,
) -> Vec<Edge> {
    (0..rays)
        .map(|at| TAU * at as f64 / rays as f64)
        .map(|turn| {
            let reach = reach * contour.middle.radius_px;
            edge(picture, contour.middle, turn, contour.radius(turn), reach, soft)
        })
        .collect()
}

/// The same, those that are softer than the outline not seen: a shadow's.
fn sharp_edges(
    picture: &Picture<'_>,
    contour: &Contour,
    rays: usize,
    reach: f64,
    soft: f64,
) -> Vec<Edge> {
    let is_seen = |edge: &Edge| {
        let more = edge.away - contour.radius(edge.turn);
        edge.seen && is_sharp(picture, contour.place(edge.turn, more), soft)
    };
    let all = edges(picture, contour, rays, reach, soft).into_iter();
    all.map(|edge| Edge { seen: is_seen(&edge), ..edge }).collect()
}

/// The share of directions in which the steepest place far about an outline lies on it and colour changes across it
/// rather than along it, and the longest gap between them, in turns.
fn seen_on(picture: &Picture<'_>, contour: &Contour, soft: f64) -> (f64, f64) {
    let radius = contour.middle.radius_px;
    let found = sharp_edges(picture, contour, 288, (LEAST_REACH_PX / radius).max(0.1), soft);
    let near = (NEAR * radius).max(1.0 + 0.5 * soft);
    let on: Vec<bool> = found
        .iter()
        .map(|edge| {
            edge.seen
                && fabs(edge.away - contour.radius(edge.turn)) < near
                && is_across(picture, contour, edge.turn, soft)
        })
        .collect();
    let (mut gap, mut longest) = (0, 0);
    for seen in on.iter().chain(&on) {
        gap = if *seen { 0 } else { gap + 1 };
        longest = longest.max(gap.min(on.len()));
    }
    let count = on.len() as f64;
    (on.iter().filter(|seen| **seen).count() as f64 / count, longest as f64 / count)
}

/// Whether shade changes more across an outline than along it.
fn is_across(picture: &Picture<'_>, contour: &Contour, turn: f64, soft: f64) -> bool {
    let ([x, y], (c, s)) = (contour.place(turn, 0.0), contour.outwards(turn));
    let change = |along: f64, across: f64| {
        let at = |side: f64| {
            let (along, across) = (side * along, side * across);
            shade(picture.at(x + along * -s + across * c, y + along * c + across * s))
        };
        distance(at(1.0), at(-1.0))
    };
    let far = ACROSS_PX + soft;
    change(0.0, far) > ACROSS * change(far, 0.0)
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
