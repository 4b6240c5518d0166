//! Pearls and scenes as image.py hands them over: numbers, all checked there, into the rooms' types.

use std::sync::Arc;

use glam::DVec3;
use nacreous_colour::Spectrum;
use nacreous_image::{Camera, Panorama, Place, Projection, Rgb, Sky, Source, Table, Walls, Window};
use numpy::PyReadonlyArray3;
use pyo3::prelude::*;

use crate::refused;

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct CameraSpec {
    /// None for parallel lines of sight.
    pub distance_mm: Option<f64>,
    pub elevation_rad: f64,
    pub azimuth_rad: f64,
    pub field_mm: f64,
    pub exposure: f64,
    /// Share of the light that is spread, and the radius in the plane of the origin that holds half of it.
    pub glare: f64,
    pub glare_mm: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct LampSpec {
    /// Unit vector towards the lamp, or None where it has a position.
    pub direction: Option<[f64; 3]>,
    pub position_mm: [f64; 3],
    pub angular_radius_rad: f64,
    pub spectrum: Vec<f64>,
    pub intensity: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct WindowSpec {
    pub centre_mm: [f64; 3],
    /// From the middle to two edges.
    pub right_mm: [f64; 3],
    pub up_mm: [f64; 3],
    pub spectrum: Vec<f64>,
    pub luminance: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct TableSpec {
    pub kind: String,
    pub colour: Rgb,
    pub second_colour: Rgb,
    pub check_mm: f64,
    pub weave_mm: f64,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct WallsSpec {
    pub half_width_mm: f64,
    pub height_mm: f64,
    pub colour: Rgb,
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SkySpec<'py> {
    pub horizon: Rgb,
    pub zenith: Rgb,
    /// None where the sky is a gradient.
    pub panorama: Option<PyReadonlyArray3<'py, f32>>,
    pub rotation_rad: f64,
    pub intensity: f64,
}

/// Where a pearl lies.
#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct PlaceSpec {
    /// Its number among the different pearls.
    pub pearl: usize,
    pub centre_mm: [f64; 3],
}

#[derive(FromPyObject)]
#[pyo3(from_item_all)]
pub struct SceneSpec<'py> {
    pub observer: String,
    /// What shall look white; None for the lamps' own mixture.
    pub white: Option<Vec<f64>>,
    pub camera: CameraSpec,
    pub places: Vec<PlaceSpec>,
    pub lamps: Vec<LampSpec>,
    pub windows: Vec<WindowSpec>,
    pub table: Option<TableSpec>,
    pub walls: Option<WallsSpec>,
    pub sky: SkySpec<'py>,
}

impl CameraSpec {
    pub fn camera(&self) -> Camera {
        let projection = match self.distance_mm {
            Some(distance_mm) => Projection::Perspective { distance_mm },
            None => Projection::Orthographic,
        };
        Camera::new(projection, self.elevation_rad, self.azimuth_rad, self.field_mm)
    }
}

impl LampSpec {
    pub fn source(&self) -> PyResult<Source> {
        let spectrum = Spectrum::from_values(&self.spectrum).map_err(refused)?;
        Ok(Source { spectrum, intensity: self.intensity })
    }

    pub fn place(&self) -> Place {
        match self.direction {
            Some(direction) => Place::Direction(DVec3::from(direction)),
            None => Place::Position(DVec3::from(self.position_mm)),
        }
    }
}

impl WindowSpec {
    /// A window of the radiance given.
    pub fn window(&self, radiance: Rgb) -> Window {
        let [centre, right, up] = [self.centre_mm, self.right_mm, self.up_mm].map(DVec3::from);
        Window::new(centre, right, up, radiance)
    }

    /// The window's own surface: what its intensity is, is its radiance.
    pub fn pane(&self) -> PyResult<Source> {
        let spectrum = Spectrum::from_values(&self.spectrum).map_err(refused)?;
        Ok(Source { spectrum, intensity: self.luminance })
    }

    /// The window as a lamp, by its light on a surface in the middle of the scene that faces it.
    pub fn source(&self) -> PyResult<Source> {
        let Source { spectrum, intensity } = self.pane()?;
        let factor = self.window([1.0; 3]).facing_factor(DVec3::ZERO);
        Ok(Source { spectrum, intensity: intensity * factor })
    }
}

impl TableSpec {
    pub fn table(&self) -> Table {
        let (colour, second_colour) = (self.colour, self.second_colour);
        match self.kind.as_str() {
            "checker" => Table::Checker { colour, second_colour, check_mm: self.check_mm },
            "cloth" => Table::Cloth { colour, second_colour, weave_mm: self.weave_mm },
            _ => Table::Plain(colour),
        }
    }
}

impl WallsSpec {
    pub fn walls(&self) -> Walls {
        let (half_width_mm, height_mm) = (self.half_width_mm, self.height_mm);
        Walls { half_width_mm, height_mm, colour: self.colour }
    }
}

impl SkySpec<'_> {
    pub fn sky(&self) -> Sky {
        let scaled = |colour: Rgb| colour.map(|channel| channel * self.intensity);
        match &self.panorama {
            None => Sky::Gradient { horizon: scaled(self.horizon), zenith: scaled(self.zenith) },
            Some(picture) => {
                let picture = picture.as_array();
                let (height, width, _) = picture.dim();
                let pixels = picture.rows().into_iter().map(|p| [p[0], p[1], p[2]]).collect();
                Sky::Panorama {
                    picture: Arc::new(Panorama::new(width, height, pixels)),
                    rotation_rad: self.rotation_rad,
                    intensity: self.intensity,
                }
            }
        }
    }
}
