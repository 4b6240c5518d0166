//! From pixels to lines of sight and back.
//!
//! A tent filter two pixels wide by equal weights at uneven places, the same in every pixel **(ours)**.
//! Left out: random places; nothing that is finer than a sample is left unaveraged.

use std::sync::Arc;

use crate::{
    parallel,
    pearl::model::Pearl,
    picture::{
        channels::CHANNELS,
        detail::{Detail, Range},
        pixel::Pixel,
        reflections::{Reflections, pixels_mm},
        tent::{rook, tent, width_between},
        view::View,
    },
    progress::Progress,
    rgb::{self, Rgb},
    shape::ball::Hit,
    surroundings::lit::Lit,
    view::{camera::Camera, ray::Ray},
};

/// What looks at a lit scene through the pixels of a square picture.
///
/// No random numbers: every sample stands for its cell, and lamps, table and silhouette are averaged over the
/// cell in closed form.
#[derive(Debug)]
pub struct Sampler {
    pub(super) pearls: Vec<Pearl>,
    pub(super) surroundings: Arc<Lit>,
    camera: Camera,
    pub(super) offsets: Vec<f64>,
    /// What a sample stands for beside the place of the others.
    pub(super) width_px: f64,
    size_px: usize,
    /// Factor on the light in the finished picture.
    pub(super) exposure: f64,
    /// Width of a pixel at each ball.
    pub(super) pixel_mm: Vec<f64>,
    pub(super) reflections: Arc<Reflections>,
}

impl Sampler {
    /// `pearls[i]` is the ball `surroundings.balls[i]`; `samples_side` samples stand along a pixel's side.
    /// `reflections` are those of the same pearls, surroundings, camera and size.
    pub fn new(
        pearls: Vec<Pearl>,
        surroundings: Arc<Lit>,
        camera: Camera,
        (size_px, samples_side): (usize, usize),
        reflections: Arc<Reflections>,
    ) -> Self {
        let pixel_mm = pixels_mm(&surroundings, &camera, size_px);
        let offsets = tent(samples_side);
        let (width_px, exposure) = (width_between(&offsets), 1.0);
        Self {
            pearls,
            surroundings,
            camera,
            offsets,
            width_px,
            size_px,
            exposure,
            pixel_mm,
            reflections,
        }
    }

    /// Says what factor, above 0, the finished picture has on the light of the rows: grain goes by lightness, and
    /// samples are alike if they look so. The rows themselves are not multiplied by it.
    #[must_use]
    pub fn exposed(self, exposure: f64) -> Self {
        Self { exposure, ..self }
    }

    /// Some rows from the top: linear light, [`CHANNELS`] numbers a pixel. `None` once `progress` says to
    /// stop. Memory: 68 bytes a pixel.
    pub fn rows(&self, rows: std::ops::Range<usize>, progress: &Progress) -> Option<Vec<f32>> {
        let width = self.size_px * CHANNELS;
        let mut pixels = vec![0.0_f32; rows.len() * width];
        parallel::map_chunks(&mut pixels, width, |row, out| {
            if !progress.is_stopped() {
                self.row(rows.start + row, out.chunks_mut(CHANNELS));
                progress.row_done();
            }
        });
        (!progress.is_stopped()).then_some(pixels)
    }

    /// One row of pixels. Balls far from its lines of sight are told apart here, once.
    fn row<'p>(&self, row: usize, pixels: impl Iterator<Item = &'p mut [f32]>) {
        let (_, y) = self.place(row, 0, 0.0, 0.0);
        let near = |&i: &usize| {
            let ball = &self.surroundings.balls[i];
            self.camera.off_row_mm(y, ball.centre) < ball.reach_mm() + 2.0 * self.pixel_mm[i]
        };
        let balls: Vec<usize> = (0..self.pearls.len()).filter(near).collect();
        let mut view = View::default();
        for (column, out) in pixels.enumerate() {
            self.find(row, column, &balls, &mut view);
            let mut pixel = self.pixel(row, column, &mut view);
            let (x, y) = self.place(row, column, 0.0, 0.0);
            pixel.shadow = self.surroundings.shadow(&self.camera.ray(x, y));
            pixel.store(out);
        }
    }

    /// Through a point of a pixel, offsets in pixels from the pixel's middle.
    pub(super) fn ray(&self, (row, column): (usize, usize), down: f64, aside: f64) -> Ray {
        let (x, y) = self.place(row, column, down, aside);
        self.camera.ray(x, y)
    }

    /// How many samples stand along a pixel's side.
    pub(super) fn samples_side(&self) -> usize {
        self.offsets.len()
    }

    /// Where in the view a point of a pixel is, offsets in pixels from the pixel's middle.
    fn place(&self, row: usize, column: usize, down: f64, aside: f64) -> (f64, f64) {
        let middle = 0.5 * self.size_px as f64;
        let x = (column as f64 + 0.5 + aside - middle) / middle;
        let y = (middle - row as f64 - 0.5 - down) / middle;
        (x, y)
    }

    fn pixel(&self, row: usize, column: usize, view: &mut View) -> Pixel {
        match self.detail(row, column, view) {
            Detail::None => {
                let (x, y) = self.place(row, column, 0.0, 0.0);
                self.sample(&self.camera.ray(x, y), (1.0, (0, 1)), view);
            }
            Detail::BelowPixel => {
                self.few((row, column), false, view);
                if self.shows_steps(view) {
                    view.clear();
                    self.all((row, column), view);
                } else {
                    view.brighten(self.offsets.len() as f64);
                }
            }
            Detail::Unknown if view.balls.is_empty() => {
                view.behind = self.open((row, column), &mut view.lights);
            }
            Detail::Unknown if self.few((row, column), true, view) => {
                view.brighten(self.offsets.len() as f64);
                self.lay_rings((row, column), view);
            }
            Detail::Unknown => {
                view.clear();
                self.all((row, column), view);
            }
            Detail::Edges => self.all((row, column), view),
            Detail::Rim => self.lines((row, column), view),
        }
        let mut pixel = Pixel::of_surroundings(view.behind);
        for (part, &ball) in view.parts.iter_mut().zip(&view.balls) {
            part.lay_texture(&self.pearls[ball], self.exposure);
            pixel.join(part);
        }
        pixel
    }

    /// One sample in each row and column of a pixel's samples, whose mean is that of all where light changes in
    /// a straight line; whether they are alike.
    fn few(&self, (row, column): (usize, usize), spread: bool, view: &mut View) -> bool {
        let side = self.offsets.len();
        let mut range = Range::default();
        for (i, &down) in self.offsets.iter().enumerate() {
            let j = rook(i, side);
            let (x, y) = self.place(row, column, down, self.offsets[j]);
            // Alone, the samples share all facets out among themselves.
            let part = if spread { (i * side + j, side * side) } else { (i, side) };
            let light = self.sample(&self.camera.ray(x, y), (self.weight(), part), view);
            range.add(light);
        }
        range.is_narrow(self.exposure)
    }

    /// All samples.
    fn all(&self, (row, column): (usize, usize), view: &mut View) {
        let side = self.offsets.len();
        for (i, &down) in self.offsets.iter().enumerate() {
            for (j, &aside) in self.offsets.iter().enumerate() {
                let (x, y) = self.place(row, column, down, aside);
                self.sample(
                    &self.camera.ray(x, y),
                    (self.weight(), (i * side + j, side * side)),
                    view,
                );
            }
        }
    }

    /// The light of rings by all samples, on the inner disc of the only pearl: it depends on nothing but the
    /// view angle, so neither may the samples of it.
    fn lay_rings(&self, (row, column): (usize, usize), view: &mut View) {
        let ([ball], [part]) = (&view.balls[..], &mut view.parts[..]) else { return };
        let (ball, mut sum) = (*ball, [0.0; 3]);
        for &down in &self.offsets {
            for &aside in &self.offsets {
                let (x, y) = self.place(row, column, down, aside);
                let hit = self.surroundings.hit(ball, &self.camera.ray(x, y));
                let rings = hit.and_then(|hit| self.pearls[ball].model.rings(hit.cos_view));
                rgb::add(&mut sum, rgb::scaled(rings.unwrap_or_default(), self.weight()));
            }
        }
        part.interference = sum;
    }

    /// The share of a pixel that each of all its samples stands for.
    pub(super) fn weight(&self) -> f64 {
        1.0 / self.offsets.len().pow(2) as f64
    }

    /// What one line of sight shows. Gives its light.
    fn sample(&self, ray: &Ray, (weight, part): (f64, (usize, usize)), view: &mut View) -> Rgb {
        let Some((place, hit)) = self.front(ray, view) else {
            return self.behind(ray, weight, self.width_px, view);
        };
        let ball = view.balls[place];
        let bend = self.bend(ball, &hit, ray, view);
        let spread = self.bent_spread(ball, &hit, bend, self.width_px);
        let sight = self.sight((ball, hit), -ray.along, spread, part);
        let shade = self.pearls[ball].shade(&self.surroundings, &sight);
        view.parts[place].add(&shade, weight);
        shade.light()
    }

    /// Adds what a line of sight, so many pixels wide, shows behind all pearls. Gives its light.
    pub(super) fn behind(&self, ray: &Ray, weight: f64, width_px: f64, view: &mut View) -> Rgb {
        let light = self.surroundings.scenery(ray, self.wide_rad(ray, width_px));
        rgb::add(&mut view.behind, rgb::scaled(light, weight));
        light
    }

    /// The angle that so many pixels are seen in.
    pub(super) fn wide_rad(&self, ray: &Ray, width_px: f64) -> f64 {
        let pixel_rad = self.camera.cell_mm(self.size_px) / self.camera.reach_mm(ray);
        width_px * pixel_rad
    }

    /// Where a line of sight meets the first ball of a view, by place in it.
    fn front(&self, ray: &Ray, view: &View) -> Option<(usize, Hit)> {
        let met = |(place, &ball): (usize, &usize)| {
            Some((place, self.surroundings.hit_beside(ball, ray, &view.known[place])?))
        };
        let far_mm = |hit: &Hit| hit.point.distance_squared(ray.from);
        let hits = view.balls.iter().enumerate().filter_map(met);
        hits.min_by(|a, b| far_mm(&a.1).total_cmp(&far_mm(&b.1)))
    }
}
