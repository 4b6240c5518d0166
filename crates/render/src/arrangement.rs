//! Which pearl lies where, and what that leaves room for.

mod neck;
mod sight;

use std::sync::Arc;

use glam::DVec3;
use nacreous_image::{Ball, Camera, Hull, Projection, Solid};

use self::neck::{Bead, neck};
pub use self::sight::Sighted;
use crate::{
    RenderError,
    frame::Frame,
    pearl::shape::solid_key,
    spec::{
        Recipe,
        pearl::PearlSpec,
        scene::{CameraSpec, ProjectionSpec, RowForm, SceneSpec},
    },
};

/// Left out, pitch and row gap are this many of the largest diameters **(ours)**.
const ROOM: f64 = 1.1;
/// A lone pearl's view is this many diameters wide **(ours)**.
const LONE_FIELD: f64 = 1.5;
/// Nor narrower than its outline by less than this, which an eye near to it sees larger **(ours)**.
const NEAR_FIELD: f64 = 1.1;
/// The eye is at least this many times as far from the middle as the farthest pearl **(ours)**.
const CLEAR: f64 = 1.2;

/// The most pearls in one scene.
pub const MOST_PEARLS: usize = 400;

/// A pearl by its number among those given, and where it is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Place {
    /// Its number among the pearls given.
    pub pearl: usize,
    /// Its middle.
    pub centre_mm: DVec3,
    /// Its radius; half its width where it is not round.
    pub radius_mm: f64,
    /// The farthest that it reaches from its middle.
    pub reach_mm: f64,
    /// What stands for it where it is not round and others see it.
    pub hull: Option<Hull>,
}

/// The forms of the pearls given that are not round, by their number.
pub(crate) type Solids = [Option<Arc<Solid>>];

/// The pearls of a picture in their places, clear of each other and of everything else.
#[derive(Debug, Clone, PartialEq)]
pub struct Arrangement {
    places: Vec<Place>,
    frames: Vec<Frame>,
    field_mm: f64,
    camera: CameraSpec,
}

impl Arrangement {
    /// Puts the pearls into the scene's rows; the origin is the middle of the rows, as high as the centre of
    /// the deepest.
    ///
    /// # Errors
    /// [`RenderError::Scene`] for a scene without a place for each pearl, and for pearls that touch each
    /// other, a wall, a lamp, a window or the eye.
    pub fn new(recipe: &Recipe) -> Result<Self, RenderError> {
        let solid = |pearl| solid_key(pearl).map(|key| Arc::new(key.solid()));
        let solids: Vec<Option<Arc<Solid>>> = recipe.pearls.iter().map(solid).collect();
        Self::of_forms(recipe, &solids)
    }

    /// The same where the forms of pearls that are not round are known.
    pub(crate) fn of_forms(recipe: &Recipe, solids: &Solids) -> Result<Self, RenderError> {
        let Recipe { pearls, scene, .. } = recipe;
        let sizes: Vec<Size> = pearls
            .iter()
            .zip(solids)
            .map(|(pearl, solid)| Size::of(pearl, solid.as_deref()))
            .collect();
        let largest_mm = sizes.iter().map(|size| 2.0 * size.reach_mm).fold(0.0, f64::max);
        let places = if scene.rows.is_empty() {
            let [size] = sizes[..] else {
                let fault = format!("has a place for one pearl, not {}", pearls.len());
                return Err(RenderError::scene(&scene.name, fault));
            };
            let places = vec![size.placed(0, DVec3::ZERO)];
            if size.hull.is_some() {
                check_clearance(scene, &places)?;
            }
            places
        } else {
            let places = in_rows(scene, (&sizes, solids), largest_mm)?;
            check_clearance(scene, &places)?;
            places
        };
        let frames = frames(scene, &places)?;
        let field_mm = match (scene.camera.field_mm, scene.rows.is_empty()) {
            (Some(field_mm), _) => field_mm,
            (None, true) => {
                (LONE_FIELD * largest_mm).max(NEAR_FIELD * field_of(&scene.camera, &places))
            }
            (None, false) => field_of(&scene.camera, &places) + 0.5 * largest_mm,
        };
        Ok(Self { places, frames, field_mm, camera: scene.camera.clone() })
    }

    /// The places, row by row from the left.
    pub fn places(&self) -> &[Place] {
        &self.places
    }

    /// Where each window of the scene is.
    pub fn frames(&self) -> &[Frame] {
        &self.frames
    }

    /// Width of the view: the camera's own, or one that shows every pearl and some room.
    pub fn field_mm(&self) -> f64 {
        self.field_mm
    }

    /// The pearls' shapes in their places, dark.
    pub fn balls(&self) -> Vec<Ball> {
        let ball = |place: &Place| Ball {
            centre: place.centre_mm,
            hull: place.hull,
            ..Ball::alone(place.radius_mm)
        };
        self.places.iter().map(ball).collect()
    }

    /// The camera, in front of all pearls.
    pub fn camera(&self) -> Camera {
        let reach = |place: &Place| place.centre_mm.length() + place.reach_mm;
        let reach_mm = self.places.iter().map(reach).fold(0.0, f64::max);
        camera(&self.camera, self.field_mm).in_front_of(reach_mm)
    }

    /// The least width on a pearl that a pixel has, `size_px` of them a side.
    pub fn pixel_mm(&self, size_px: usize) -> f64 {
        self.field_mm / size_px as f64 * self.nearest()
    }

    /// Distance from the eye to the nearest pearl, over that to the middle; at most 1.
    fn nearest(&self) -> f64 {
        if self.camera.projection == ProjectionSpec::Orthographic {
            return 1.0;
        }
        let (back, eye_mm) = (camera(&self.camera, 1.0).back(), self.camera.distance_mm);
        let ahead = |place: &Place| eye_mm - place.centre_mm.dot(back) - place.reach_mm;
        let ahead_mm = self.places.iter().map(ahead).fold(f64::INFINITY, f64::min);
        (ahead_mm / eye_mm).clamp(0.0, 1.0)
    }
}

impl Place {
    /// How far below its middle it reaches.
    fn below_mm(&self) -> f64 {
        self.hull.map_or(self.radius_mm, |hull| hull.below_mm())
    }
}

/// The room that a pearl takes.
#[derive(Debug, Clone, Copy)]
struct Size {
    radius_mm: f64,
    reach_mm: f64,
    below_mm: f64,
    hull: Option<Hull>,
}

impl Size {
    fn of(pearl: &PearlSpec, solid: Option<&Solid>) -> Self {
        let radius_mm = 0.5 * pearl.common().diameter_mm;
        let hull = solid.map(Solid::hull);
        Self {
            radius_mm,
            reach_mm: hull.map_or(radius_mm, |hull| hull.reach_mm()),
            below_mm: hull.map_or(radius_mm, |hull| hull.below_mm()),
            hull,
        }
    }

    fn placed(&self, pearl: usize, centre_mm: DVec3) -> Place {
        let Self { radius_mm, reach_mm, hull, .. } = *self;
        Place { pearl, centre_mm, radius_mm, reach_mm, hull }
    }
}

fn camera(spec: &CameraSpec, field_mm: f64) -> Camera {
    let projection = match spec.projection {
        ProjectionSpec::Orthographic => Projection::Orthographic,
        ProjectionSpec::Perspective => Projection::Perspective { distance_mm: spec.distance_mm },
    };
    let (elevation_rad, azimuth_rad) =
        (spec.elevation_deg.to_radians(), spec.azimuth_deg.to_radians());
    Camera::new(projection, elevation_rad, azimuth_rad, field_mm)
}

fn in_rows(
    scene: &SceneSpec,
    (sizes, solids): (&[Size], &Solids),
    largest_mm: f64,
) -> Result<Vec<Place>, RenderError> {
    let rows = numbered(scene, sizes.len())?;
    let deepest_mm = sizes.iter().map(|size| size.below_mm).fold(0.0, f64::max);
    if scene.rows.iter().any(|row| row.form == RowForm::Neck) {
        return around_neck(scene, &rows, (sizes, solids), deepest_mm);
    }
    let pitch_mm = distance(scene, "pitch_mm", scene.pitch_mm, largest_mm)?;
    let gap_mm = distance(scene, "row_gap_mm", scene.row_gap_mm, largest_mm)?;
    let middle = |count: usize| 0.5 * (count as f64 - 1.0);
    let mut places = Vec::new();
    for (line, row) in rows.iter().enumerate() {
        for (column, &pearl) in row.iter().enumerate() {
            let centre_mm = DVec3::new(
                (column as f64 - middle(row.len())) * pitch_mm,
                sizes[pearl].below_mm - deepest_mm,
                (line as f64 - middle(rows.len())) * gap_mm,
            );
            places.push(sizes[pearl].placed(pearl, centre_mm));
        }
    }
    Ok(places)
}

/// The only row's pearls around a neck.
fn around_neck(
    scene: &SceneSpec,
    rows: &[Vec<usize>],
    (sizes, solids): (&[Size], &Solids),
    deepest_mm: f64,
) -> Result<Vec<Place>, RenderError> {
    let [row] = rows else {
        let fault =
            format!("has {} rows, one of them around a neck; allowed: that one alone", rows.len());
        return Err(RenderError::scene(&scene.name, fault));
    };
    let bead = |&pearl: &usize| {
        let Size { radius_mm, below_mm, .. } = sizes[pearl];
        Bead::new(radius_mm, below_mm, solids[pearl].as_deref())
    };
    let beads: Vec<Bead> = row.iter().map(bead).collect();
    let placed = |(&pearl, [x, z]): (&usize, [f64; 2])| {
        sizes[pearl].placed(pearl, DVec3::new(x, sizes[pearl].below_mm - deepest_mm, z))
    };
    Ok(row.iter().zip(neck(&beads)).map(placed).collect())
}

/// The numbers of each row's pearls.
fn numbered(scene: &SceneSpec, given: usize) -> Result<Vec<Vec<usize>>, RenderError> {
    let number = |name: &String| {
        let digits = name.strip_prefix('*').filter(|digits| !digits.starts_with('+'));
        let number = digits.and_then(|digits| digits.parse().ok());
        number.filter(|&number| number < given).ok_or_else(|| {
            let last = given.saturating_sub(1);
            let fault =
                format!("a row has {name:?}; allowed: \"*0\" to \"*{last}\", for {given} given");
            RenderError::scene(&scene.name, fault)
        })
    };
    let rows: Vec<Vec<usize>> = scene
        .rows
        .iter()
        .map(|row| row.pearls.iter().map(number).collect())
        .collect::<Result<_, _>>()?;
    let pearls: usize = rows.iter().map(Vec::len).sum();
    if !(1..=MOST_PEARLS).contains(&pearls) {
        let fault = format!("its rows hold {pearls} pearls together; allowed: 1 to {MOST_PEARLS}");
        return Err(RenderError::scene(&scene.name, fault));
    }
    Ok(rows)
}

fn distance(
    scene: &SceneSpec,
    key: &str,
    given_mm: Option<f64>,
    largest_mm: f64,
) -> Result<f64, RenderError> {
    match given_mm {
        None => Ok(ROOM * largest_mm),
        Some(value) if value < largest_mm => Err(RenderError::scene(
            &scene.name,
            format!(
                "{key} is {value:?}; allowed: at least {largest_mm} mm, the diameter of the largest pearl"
            ),
        )),
        Some(value) => Ok(value),
    }
}

/// Nothing may stand inside a pearl, nor a pearl inside a wall.
fn check_clearance(scene: &SceneSpec, places: &[Place]) -> Result<(), RenderError> {
    let fault = |text: String| Err(RenderError::scene(&scene.name, text));
    let most = |reach: fn(&Place) -> f64| places.iter().map(reach).fold(0.0, f64::max);
    let least_mm = CLEAR * most(|place| place.centre_mm.length() + place.reach_mm);
    let eye_mm = scene.camera.distance_mm;
    if scene.camera.projection == ProjectionSpec::Perspective && eye_mm < least_mm {
        let allowed = format!("at least {} mm, clear of every pearl", four_digits(least_mm));
        return fault(format!("camera.distance_mm is {eye_mm:?}; allowed: {allowed}"));
    }
    let side_mm =
        most(|place| place.centre_mm.x.abs().max(place.centre_mm.z.abs()) + place.reach_mm);
    if let Some(walls) = &scene.walls
        && walls.half_width_mm < side_mm
    {
        let (given, allowed) = (walls.half_width_mm, four_digits(side_mm));
        return fault(format!(
            "walls.half_width_mm is {given:?}; allowed: at least {allowed} mm, around all rows"
        ));
    }
    for (number, lamp) in scene.lamps.iter().enumerate() {
        let Some(position_mm) = lamp.position_mm else { continue };
        let inside = |place: &Place| place.centre_mm.distance(position_mm.into()) <= place.reach_mm;
        if places.iter().any(inside) {
            return fault(format!(
                "lamps.{number}.position_mm is {position_mm:?}; allowed: outside of every pearl of the rows"
            ));
        }
    }
    Ok(())
}

/// The windows' places; no pearl may reach through one.
fn frames(scene: &SceneSpec, places: &[Place]) -> Result<Vec<Frame>, RenderError> {
    let lowest_mm = places
        .iter()
        .map(|place| place.centre_mm.y - place.below_mm())
        .fold(f64::INFINITY, f64::min);
    let mut frames = Vec::new();
    for (number, window) in scene.windows.iter().enumerate() {
        let frame = Frame::of(window, lowest_mm);
        for place in places {
            let apart_mm = frame.distance_mm(place.centre_mm);
            if apart_mm < place.reach_mm {
                let fault = format!(
                    "windows.{number} passes {} mm from a pearl's centre; allowed: at least its radius of {} mm",
                    digits(apart_mm, 3),
                    place.reach_mm,
                );
                return Err(RenderError::scene(&scene.name, fault));
            }
        }
        frames.push(frame);
    }
    Ok(frames)
}

/// Twice the farthest that a pearl's outline reaches from the middle of the view.
fn field_of(spec: &CameraSpec, places: &[Place]) -> f64 {
    let camera = camera(spec, 1.0);
    let eye_mm = match spec.projection {
        ProjectionSpec::Orthographic => f64::INFINITY,
        ProjectionSpec::Perspective => spec.distance_mm,
    };
    let reach = |place: &Place| {
        let ahead_mm = eye_mm - place.centre_mm.dot(camera.back());
        let reach =
            |axis: DVec3| outline_mm(place.centre_mm.dot(axis), place.reach_mm, ahead_mm, eye_mm);
        reach(camera.right()).max(reach(camera.up()))
    };
    2.0 * places.iter().map(reach).fold(0.0, f64::max)
}

/// How far from the middle of the view a ball's outline reaches along one axis, there.
fn outline_mm(aside_mm: f64, radius_mm: f64, ahead_mm: f64, eye_mm: f64) -> f64 {
    if eye_mm.is_infinite() {
        return aside_mm.abs() + radius_mm;
    }
    let middle_rad = libm::atan2(aside_mm.abs(), ahead_mm);
    let half_rad = libm::asin((radius_mm / libm::hypot(aside_mm, ahead_mm)).min(1.0));
    eye_mm * libm::tan(middle_rad + half_rad)
}

fn four_digits(value: f64) -> String {
    digits(value, 4)
}

/// A length with so many significant digits, as messages show it.
fn digits(value: f64, count: i32) -> String {
    let decimals = (count - 1 - libm::floor(libm::log10(value.max(1e-9))) as i32).max(0);
    let text = format!("{value:.*}", decimals as usize);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}
