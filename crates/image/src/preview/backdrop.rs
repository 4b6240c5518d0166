//! What lies behind the pearls of a preview, pixel by pixel.
//!
//! One line of sight a pixel, as wide as the pixel. Kept while camera and light stay.
//! Left out: whatever pearls hide wholly.

use crate::{
    parallel,
    picture::reflections::pixels_mm,
    surroundings::lit::Lit,
    view::{camera::Camera, ray::Ray},
};

/// The light behind the pearls, row by row; black where none is seen.
#[derive(Debug)]
pub struct Backdrop(pub(super) Vec<[f32; 3]>);

impl Backdrop {
    /// Before a camera.
    pub fn new(surroundings: &Lit, camera: &Camera, size_px: usize) -> Self {
        let pixel_mm = pixels_mm(surroundings, camera, size_px);
        let middle = 0.5 * size_px as f64;
        let mut light = vec![[0.0; 3]; size_px * size_px];
        parallel::map_chunks(&mut light, size_px, |row, pixels| {
            let y = (middle - row as f64 - 0.5) / middle;
            let near = |&ball: &usize| {
                let place = &surroundings.balls[ball];
                camera.off_row_mm(y, place.centre) < place.radius_mm
            };
            let balls: Vec<usize> = (0..pixel_mm.len()).filter(near).collect();
            let rays = (0..size_px).filter_map(|column| {
                let ray = camera.ray((column as f64 + 0.5 - middle) / middle, y);
                let hides = |ball: &usize| is_hidden(surroundings, *ball, &ray, pixel_mm[*ball]);
                let pixel_rad = camera.cell_mm(size_px) / camera.reach_mm(&ray);
                (!balls.iter().any(hides)).then_some((column, ray, pixel_rad))
            });
            surroundings.each_scenery(rays, |column, light| {
                pixels[column] = light.map(|channel| channel as f32);
            });
        });
        Self(light)
    }
}

/// Whether a round pearl hides all that a pixel would see behind it.
fn is_hidden(surroundings: &Lit, ball: usize, ray: &Ray, pixel_mm: f64) -> bool {
    let place = &surroundings.balls[ball];
    surroundings.solid(ball).is_none() && place.passing_mm(ray) < place.radius_mm - pixel_mm
}
