use crate::{
    parallel,
    pearl::model::Pearl,
    picture::{channels::CHANNELS, sampler::Sampler},
    progress::Progress,
    surroundings::environment::Surroundings,
    view::camera::Camera,
};

/// Renders a square picture, `size_px` a side, `samples_side` squared samples a pixel: linear light,
/// [`CHANNELS`] numbers a pixel, row by row from the top. `None` if it was stopped.
///
/// `pearls[i]` is the ball `surroundings.balls[i]`.
///
/// No random numbers: every sample stands for its cell, and lamps, table and silhouette are averaged
/// over the cell in closed form. Memory: 64 bytes a pixel.
pub fn render(
    pearls: &[Pearl<'_>],
    surroundings: &Surroundings,
    camera: &Camera,
    size_px: usize,
    samples_side: usize,
    progress: &Progress,
) -> Option<Vec<f32>> {
    let mut pixels = vec![0.0_f32; size_px * size_px * CHANNELS];
    let sampler = Sampler::new(pearls, surroundings, camera, size_px, samples_side);
    parallel::map_chunks(&mut pixels, size_px * CHANNELS, |row, out| {
        if !progress.is_stopped() {
            sampler.row(row, out.chunks_mut(CHANNELS));
            progress.row_done();
        }
    });
    (!progress.is_stopped()).then_some(pixels)
}
