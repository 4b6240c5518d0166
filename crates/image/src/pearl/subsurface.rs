use std::f64::consts::PI;

use glam::DVec3;
use nacreous_colour::{SAMPLES, matrix::apply};

use crate::{
    harmonics::{CHANNELS, Coefficients, Place, analyse, directions_of_grid, point, synthesise},
    light::{
        bands::{BANDS, Bands, means},
        palette::Palette,
    },
    parallel,
    rgb::{self, Rgb},
    surface::{
        coating::{Surface, legendre, upsampled},
        film::STEPS,
    },
    surroundings::environment::Surroundings,
};

/// A lamp as the inside of a pearl meets it.
#[derive(Debug, Clone, PartialEq)]
pub struct Beam {
    /// Towards the lamp.
    pub direction: DVec3,
    /// Radius of its disc.
    pub angular_radius_rad: f64,
    /// Light in bands of a white matt surface that faces it.
    pub power: Bands,
}

/// What a pearl does to light that has entered.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// Share that nacre and nucleus send back, by band.
    pub reflectance: Bands,
    /// How far light wanders before it leaves: waves of degree l fade by exp(-l (l + 1) spread). 0 leaves a
    /// matt body, much a body that shines alike on all sides.
    pub spread: f64,
}

impl Body {
    /// Of a reflectance by wavelength.
    pub fn new(reflectance: &[f64; SAMPLES], spread: f64) -> Self {
        Self { reflectance: means(reflectance), spread }
    }
}

/// Light that has been inside, ready to be looked at.
///
/// Enters through the film, wanders over the ball as heat would **(ours)**, leaves through the film:
/// its colour in a direction depends on the angle to the normal by the film, on the place by the light.
#[derive(Debug, Clone)]
pub struct Subsurface {
    /// By direction of the normal, [`ROWS`] rows: light about to leave, by band, and what would leave of it
    /// through a film without colour, in linear RGB.
    places: Vec<[f32; PLACE]>,
    /// By cosine of the view angle: RGB of what leaves, by band.
    leaving: Vec<[[f32; BANDS]; 3]>,
}

/// The highest degree of the waves; what a point lamp leaves out at its terminator is 0.3 % of its light.
const TOP: usize = 40;
const ROWS: usize = 64;
const COSINES: usize = 8 * STEPS;
/// The bands, RGB and one number to fill the registers.
const PLACE: usize = BANDS + 4;

impl Subsurface {
    /// Lets in the light of `surroundings` around ball `ball`, and that of the lamps.
    pub fn new(
        surface: &Surface,
        body: &Body,
        palette: &Palette,
        surroundings: &Surroundings,
        ball: usize,
        beams: &[Beam],
    ) -> Self {
        let outside = Outside::new(palette, surroundings, ball, beams);
        let (entering, leaving) = (surface.moments(TOP), surface.leaving(&body.reflectance));
        let share = |l: usize, band: usize| {
            let fading = libm::exp(-((l * (l + 1)) as f64) * body.spread);
            fading * entering[l][band] * leaving[band]
        };
        let mut places = vec![[0.0_f32; PLACE]; 2 * ROWS * ROWS];
        let mut grid = vec![[0.0_f64; CHANNELS]; 2 * ROWS * ROWS];
        for first in (0..BANDS).step_by(CHANNELS) {
            let bands: [usize; CHANNELS] = std::array::from_fn(|i| (first + i).min(BANDS - 1));
            let waves = outside.waves(bands, share);
            synthesise(&waves, TOP, (ROWS, 2 * ROWS), |texel| texel, &mut grid);
            for (place, values) in places.iter_mut().zip(&grid) {
                for (value, band) in values.iter().zip(bands) {
                    // A cut-off sum of waves swings below zero beside a lamp's terminator.
                    place[band] = value.max(0.0) as f32;
                }
            }
        }
        let whole = surface.entering_from_all_sides();
        let mean = rgb::luminance(palette.rgb(&palette.bands_of_white(&whole)));
        let plain = by_channel(palette, |_| mean);
        for place in &mut places {
            for (channel, weights) in plain.iter().enumerate() {
                place[BANDS + channel] = dot(weights, place);
            }
        }
        let coloured = |share: &Bands| by_channel(palette, |band| share[band]);
        Self { places, leaving: upsampled(surface, COSINES).iter().map(coloured).collect() }
    }

    /// Linear RGB of the light that leaves where the normal is `normal`, at an angle to it, and what it
    /// would be if the film let through the same everywhere.
    pub fn radiance(&self, normal: DVec3, cos_view: f64) -> (Rgb, Rgb) {
        let light = self.light(Place::towards(to_grid(normal)));
        let row = (cos_view.clamp(0.0, 1.0) * COSINES as f64 + 0.5) as usize;
        let whole = self.leaving[row].each_ref().map(|weights| f64::from(dot(weights, &light)));
        (whole, [0, 1, 2].map(|channel| f64::from(light[BANDS + channel])))
    }

    /// Between the four nearest places.
    #[inline]
    fn light(&self, place: Place) -> [f32; PLACE] {
        let scale = ROWS as f32 / std::f32::consts::PI;
        let (columns, rows) = (2 * ROWS, ROWS as f32);
        // A turn and a row more keep both positive.
        let across = place.longitude * scale + columns as f32;
        let down = (place.colatitude * scale + 0.5).min(rows + 0.4999);
        let (column, row) = (across as usize, down as usize);
        let (aside, below) = (across - column as f32, down - row as f32);
        let mut sum = [0.0; PLACE];
        for (r, row_share) in [(row, 1.0 - below), (row + 1, below)] {
            // Beyond a pole lies the same ring, half way round.
            let (ring, turn) = match r {
                0 => (0, ROWS),
                r if r > ROWS => (ROWS - 1, ROWS),
                r => (r - 1, 0),
            };
            for (c, share) in [(column, 1.0 - aside), (column + 1, aside)] {
                let cell = &self.places[ring * columns + (c + turn) % columns];
                let share = share * row_share;
                for (sum, value) in sum.iter_mut().zip(cell) {
                    *sum += share * value;
                }
            }
        }
        sum
    }
}

#[inline]
fn dot(weights: &[f32; BANDS], place: &[f32; PLACE]) -> f32 {
    let mut sums = [0.0_f32; 8];
    for (a, b) in weights.chunks_exact(8).zip(place.chunks_exact(8)) {
        for lane in 0..8 {
            sums[lane] += a[lane] * b[lane];
        }
    }
    sums.iter().sum()
}

/// The grid's pole is the scene's zenith.
fn to_grid(direction: DVec3) -> DVec3 {
    DVec3::new(direction.z, direction.x, direction.y)
}

fn from_grid(direction: DVec3) -> DVec3 {
    DVec3::new(direction.y, direction.z, direction.x)
}

/// The light around a pearl in waves on the sphere of directions, before it enters.
struct Outside<'a> {
    palette: &'a Palette,
    /// As amounts of the palette's curves.
    around: Coefficients,
    beams: &'a [Beam],
    /// Unit light from each lamp's direction.
    lamps: Vec<Coefficients>,
}

impl<'a> Outside<'a> {
    fn new(
        palette: &'a Palette,
        surroundings: &Surroundings,
        ball: usize,
        beams: &'a [Beam],
    ) -> Self {
        let lamps = beams.iter().map(|beam| point(to_grid(beam.direction), TOP)).collect();
        Self { palette, around: around(palette, surroundings, ball), beams, lamps }
    }

    /// The waves of some bands, each times its share by degree and band.
    fn waves(&self, bands: [usize; CHANNELS], share: impl Fn(usize, usize) -> f64) -> Coefficients {
        let mut waves = Coefficients::zero(TOP);
        for l in 0..=TOP {
            let shares = bands.map(|band| share(l, band));
            for m in 0..=l {
                *waves.at_mut(l, m) = std::array::from_fn(|channel| {
                    self.wave((l, m), bands[channel]).map(|part| part * shares[channel])
                });
            }
        }
        waves
    }

    /// One wave of one band.
    fn wave(&self, (l, m): (usize, usize), band: usize) -> [f64; 2] {
        let amounts = self.around.at(l, m);
        let curves = self.palette.curves_of_white(band);
        let mut sum = [0, 1].map(|part| (0..3).map(|i| curves[i] * amounts[i][part]).sum::<f64>());
        for (beam, lamp) in self.beams.iter().zip(&self.lamps) {
            // Unit light on a surface that faces it is pi of radiance times solid angle.
            let factor = PI * beam.power[band] * disc(beam.angular_radius_rad, l);
            for (sum, part) in sum.iter_mut().zip(lamp.at(l, m)[0]) {
                *sum += factor * part;
            }
        }
        sum
    }
}

/// The light around in waves, as amounts of the palette's curves.
fn around(palette: &Palette, surroundings: &Surroundings, ball: usize) -> Coefficients {
    let step_rad = PI / ROWS as f64;
    let directions: Vec<DVec3> =
        directions_of_grid(ROWS).map(|(direction, _)| from_grid(direction)).collect();
    let amounts = |seen: Rgb| apply(palette.amounts(), seen);
    let values = parallel::map(directions.len(), |i| {
        amounts(surroundings.seen_without_windows(ball, directions[i], step_rad))
    });
    let mut waves = analyse(ROWS, &values, TOP);
    for (along, solid_angle, more) in surroundings.window_points(ball) {
        let amounts = amounts(more).map(|amount| amount * solid_angle);
        waves.add(&point(to_grid(along), TOP), amounts);
    }
    waves
}

/// What a disc of an angular radius leaves of a wave of degree l, against a point.
fn disc(radius_rad: f64, l: usize) -> f64 {
    let cosine = libm::cos(radius_rad);
    if l == 0 || 1.0 - cosine < 1e-9 {
        return 1.0;
    }
    let mut two = legendre(cosine).skip(l - 1).step_by(2);
    let (below, above) = (two.next().unwrap_or(1.0), two.next().unwrap_or(1.0));
    (below - above) / ((2 * l + 1) as f64 * (1.0 - cosine))
}

/// RGB of each band's light after a filter, channel by channel.
fn by_channel(palette: &Palette, filter: impl Fn(usize) -> f64) -> [[f32; BANDS]; 3] {
    let unit = palette.band_rgb();
    [0, 1, 2].map(|i| std::array::from_fn(|band| (unit[band][i] * filter(band)) as f32))
}
