//! A scene: camera, rows, lamps, windows, table, walls and sky.

use serde::Deserialize;

use super::{
    Colour,
    lights::{LampSpec, WindowSpec},
};

/// Everything around the pearls.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SceneSpec {
    /// What the scene is called; messages begin with it.
    pub name: String,
    /// CIE standard observer.
    pub observer: ObserverSpec,
    /// Distance in a row; from the largest pearl where left out.
    pub pitch_mm: Option<f64>,
    /// Distance between rows; from the largest pearl where left out.
    pub row_gap_mm: Option<f64>,
    /// The camera.
    pub camera: CameraSpec,
    /// The lamps.
    pub lamps: Vec<LampSpec>,
    /// Rectangles of light.
    pub windows: Vec<WindowSpec>,
    /// Rows of pearls; without them, the one pearl given.
    pub rows: Vec<RowSpec>,
    /// What the pearls lie on.
    pub table: TableSpec,
    /// The walls around, if any.
    pub walls: Option<WallsSpec>,
    /// What lies beyond.
    pub sky: SkySpec,
}

/// A CIE standard observer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum ObserverSpec {
    /// Of 1931, for 2 degrees.
    #[serde(rename = "1931-2")]
    Cie1931,
    /// Of 1964, for 10 degrees.
    #[serde(rename = "1964-10")]
    Cie1964,
}

/// Where the picture is taken from, how wide it is and how bright.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct CameraSpec {
    /// How the lines of sight run.
    pub projection: ProjectionSpec,
    /// Height above the horizon, seen from the pearl.
    pub elevation_deg: f64,
    /// Direction around the pearl.
    pub azimuth_deg: f64,
    /// Width of the view at the origin; such that every pearl is seen where left out.
    pub field_mm: Option<f64>,
    /// Distance of the eye from the origin.
    pub distance_mm: f64,
    /// Factor on the linear picture.
    pub exposure: f64,
    /// Share of the light that lens and eye spread.
    pub glare: f64,
    /// Radius within which half of it stays.
    pub glare_deg: f64,
    /// The light shown as white; `auto` is the lamps' own.
    pub white: String,
}

/// How the lines of sight run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum ProjectionSpec {
    /// All parallel.
    Orthographic,
    /// From one point.
    Perspective,
}

/// A row of pearls from left to right.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct RowSpec {
    /// `*0`, `*1` and so on: places among the pearls given.
    pub pearls: Vec<String>,
    /// How they lie.
    pub form: RowForm,
    /// What the row is, for people.
    pub label: Option<String>,
}

/// How the pearls of a row lie.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum RowForm {
    /// Side by side on a line.
    Line,
    /// Around a neck, each touching the next.
    Neck,
}

/// The table below the pearls.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct TableSpec {
    /// What it is made of.
    pub kind: TableKind,
    /// Its colour.
    pub colour: Colour,
    /// The colour of every other square, or between the threads.
    pub second_colour: Colour,
    /// Side of a square.
    pub check_mm: f64,
    /// Distance between threads.
    pub weave_mm: f64,
}

/// What a table is made of.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum TableKind {
    /// There is none.
    None,
    /// One colour.
    Plain,
    /// Squares of two colours.
    Checker,
    /// Woven cloth.
    Cloth,
}

/// Four walls around the table.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct WallsSpec {
    /// Distance of each wall from the origin.
    pub half_width_mm: f64,
    /// Height above the table.
    pub height_mm: f64,
    /// Their colour.
    pub colour: Colour,
}

/// What lies beyond table and walls.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct SkySpec {
    /// How its light changes.
    pub kind: SkyKind,
    /// Colour at the horizon.
    pub horizon: Colour,
    /// Colour overhead.
    pub zenith: Colour,
    /// Irradiance of a whole white sky on a surface facing up.
    pub intensity: f64,
    /// Where the panorama comes from.
    pub path: Option<String>,
    /// Turn of the panorama about the y axis.
    pub rotation_deg: f64,
}

/// How the light of a sky changes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum SkyKind {
    /// The horizon's colour everywhere.
    Constant,
    /// From the horizon's colour to the zenith's.
    Gradient,
    /// A panorama.
    Panorama,
}
