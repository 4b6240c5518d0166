use crate::{
    pearl::{model::Pearl, reflection_cache::ReflectionCache, sight::Sight},
    picture::pixel::Pixel,
    rgb::{self, Rgb},
    shape::ball::Hit,
    surroundings::environment::Surroundings,
    view::{camera::Camera, ray::Ray},
};

/// What looks at the scene through the pixels of a picture.
pub(crate) struct Sampler<'a> {
    pearls: &'a [Pearl<'a>],
    surroundings: &'a Surroundings,
    camera: &'a Camera,
    offsets: Vec<f64>,
    size_px: usize,
    /// Width of a pixel at each ball.
    pixel_mm: Vec<f64>,
    reflections: Vec<Option<ReflectionCache>>,
}

impl<'a> Sampler<'a> {
    pub(crate) fn new(
        pearls: &'a [Pearl<'a>],
        surroundings: &'a Surroundings,
        camera: &'a Camera,
        size_px: usize,
        samples_side: usize,
    ) -> Self {
        let width_mm = |centre| camera.cell_mm(size_px) * camera.scale_at(centre).max(0.0);
        let pixel_mm: Vec<_> =
            surroundings.balls.iter().map(|ball| width_mm(ball.centre)).collect();
        let of = |(i, pearl): (usize, &Pearl<'_>)| {
            pearl.reflection_cache(surroundings, i, camera, pixel_mm[i])
        };
        let reflections = pearls.iter().enumerate().map(of).collect();
        Self {
            pearls,
            surroundings,
            camera,
            offsets: tent(samples_side),
            size_px,
            pixel_mm,
            reflections,
        }
    }

    /// One row of pixels. Balls far from its lines of sight are told apart here, once.
    pub(crate) fn row<'p>(&self, row: usize, pixels: impl Iterator<Item = &'p mut [f32]>) {
        let (_, y) = self.place(row, 0, 0.0, 0.0);
        let near = |&i: &usize| {
            let ball = &self.surroundings.balls[i];
            self.camera.off_row_mm(y, ball.centre) < ball.radius_mm + 2.0 * self.pixel_mm[i]
        };
        let balls: Vec<usize> = (0..self.pearls.len()).filter(near).collect();
        let mut view = View::default();
        for (column, out) in pixels.enumerate() {
            self.find(row, column, &balls, &mut view);
            self.pixel(row, column, &mut view).store(out);
        }
    }

    /// The balls that a pixel may show.
    fn find(&self, row: usize, column: usize, balls: &[usize], view: &mut View) {
        let (x, y) = self.place(row, column, 0.0, 0.0);
        let ray = self.camera.ray(x, y);
        let near = |&i: &usize| {
            let ball = &self.surroundings.balls[i];
            ball.passing_mm(&ray) < ball.radius_mm + 2.0 * self.pixel_mm[i]
        };
        view.balls.clear();
        view.balls.extend(balls.iter().copied().filter(near));
        view.parts.clear();
        view.parts.resize(view.balls.len(), Pixel::default());
        view.behind = [0.0; 3];
    }

    /// Where in the view a point of a pixel is, offsets in pixels from the pixel's middle.
    fn place(&self, row: usize, column: usize, down: f64, aside: f64) -> (f64, f64) {
        let middle = 0.5 * self.size_px as f64;
        let x = (column as f64 + 0.5 + aside - middle) / middle;
        let y = (middle - row as f64 - 0.5 - down) / middle;
        (x, y)
    }

    fn pixel(&self, row: usize, column: usize, view: &mut View) -> Pixel {
        let side = self.offsets.len();
        let smooth = self.is_smooth(row, column, view);
        let weight = 1.0 / (if smooth { side } else { side * side }) as f64;
        for (i, &down) in self.offsets.iter().enumerate() {
            for (j, &aside) in self.offsets.iter().enumerate() {
                if smooth && j != rook(i, side) {
                    continue;
                }
                let (x, y) = self.place(row, column, down, aside);
                let part = if smooth { i } else { (i + j) % side };
                self.sample(&self.camera.ray(x, y), (weight, part), view);
            }
        }
        let mut pixel = Pixel::of_surroundings(view.behind);
        for (part, &ball) in view.parts.iter_mut().zip(&view.balls) {
            part.lay_texture(&self.pearls[ball]);
            pixel.join(part);
        }
        pixel
    }

    /// Whether nothing but the inner disc of one pearl is seen whose light has no detail finer than a pixel:
    /// then one sample in each row and column will do.
    fn is_smooth(&self, row: usize, column: usize, view: &View) -> bool {
        let [ball] = view.balls[..] else { return false };
        let (x, y) = self.place(row, column, 0.0, 0.0);
        let edge_mm = self.surroundings.balls[ball].radius_mm - 3.0 * self.pixel_mm[ball];
        self.pearls[ball].is_smooth()
            && self.surroundings.balls[ball].passing_mm(&self.camera.ray(x, y)) < edge_mm
    }

    /// From front to back, each pearl covers what lies behind it.
    fn sample(&self, ray: &Ray, (weight, part): (f64, usize), view: &mut View) {
        self.meet(ray, view);
        let mut left = 1.0;
        for (place, hit) in &view.hits {
            let ball = view.balls[*place];
            let pixel_mm = self.pixel_mm[ball];
            let around = self.reflections[ball].as_ref().map(|cache| cache.at(hit.normal));
            let sight = Sight { ball, hit: *hit, view: -ray.along, pixel_mm, part, around };
            let shade = self.pearls[ball].shade(self.surroundings, &sight);
            view.parts[*place].add(&shade, weight * left * hit.coverage);
            left *= 1.0 - hit.coverage;
            if left <= 0.0 {
                return;
            }
        }
        let pixel_rad = self.camera.cell_mm(self.size_px) / self.camera.reach_mm(ray);
        let seen = self.surroundings.scenery(ray, pixel_rad);
        rgb::add(&mut view.behind, rgb::scaled(seen.radiance, weight * left));
    }

    /// Where a line of sight meets the balls of a view, the nearest first.
    fn meet(&self, ray: &Ray, view: &mut View) {
        let cells = self.offsets.len() as f64;
        let met = |(place, &ball): (usize, &usize)| {
            let hit = self.surroundings.balls[ball].hit(ray, self.pixel_mm[ball] / cells)?;
            Some((place, hit))
        };
        view.hits.clear();
        view.hits.extend(view.balls.iter().enumerate().filter_map(met));
        if view.hits.len() > 1 {
            let far_mm = |hit: &Hit| hit.point.distance_squared(ray.from);
            view.hits.sort_by(|a, b| far_mm(&a.1).total_cmp(&far_mm(&b.1)));
        }
    }
}

/// What a pixel shows, while it is being made.
#[derive(Default)]
struct View {
    balls: Vec<usize>,
    /// Light of each of those balls.
    parts: Vec<Pixel>,
    /// Light of what lies behind them all.
    behind: Rgb,
    /// Where the present line of sight meets them, by place in `balls`.
    hits: Vec<(usize, Hit)>,
}

/// Column of the one sample that is taken in row `i`, such that no column comes twice.
fn rook(i: usize, side: usize) -> usize {
    (2 * i + 1) % (side + usize::from(side.is_multiple_of(2)))
}

/// Positions of the samples along one side, in pixels from the pixel's middle, such that equal weights
/// make a tent filter two pixels wide. The same pattern on both axes and in every pixel: pixels that
/// mirror each other about a lone pearl's centre see the same view angles.
fn tent(samples_side: usize) -> Vec<f64> {
    (0..samples_side)
        .map(|i| {
            let u = (i as f64 + 0.5) / samples_side as f64;
            if u < 0.5 { (2.0 * u).sqrt() - 1.0 } else { 1.0 - (2.0 - 2.0 * u).sqrt() }
        })
        .collect()
}
