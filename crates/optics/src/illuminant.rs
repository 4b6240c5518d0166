use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::LayerStack;

use crate::{
    OpticsError,
    error::within,
    grid::{self, Work},
    interference::{Sums, interference},
    lanes::{LANES, Lanes, filled},
    packing,
    sight::{Direction, Indices, Sight},
    window::{self, Ends},
};

/// The illuminant model of the paper, section 3: nacre lit from within.
///
/// Light that has entered spreads through the whole nacre, so every point of it sends light in every
/// direction. What reaches the eye interferes within its coherence length and depends on the view
/// angle alone, not on where the lamp is.
///
/// The answer is a relative spectral intensity, dimensionless: the light sent up from below one
/// protein layer counts as 1, and the intensities of all start layers are added. It does not conserve
/// energy; only its shape and its change with angle mean something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct IlluminantModel {
    /// Waves interfere while their optical path difference is below this; 5000 nm in the paper.
    pub coherence_nm: f64,
    /// The sum ends where the light going down falls below this share; 0.05 in the paper.
    pub threshold: f64,
    /// D of equation (4): the share scattered diffusely at each layer.
    pub diffuse_loss: f64,
}

impl IlluminantModel {
    /// Spectral intensity `[view angle, wavelength]` as one flat row-major table.
    ///
    /// View angles from 0 to pi/2 (theta_0), wavelengths from 1 to 1e6 nm. Time and memory grow with
    /// layers, not with layers times coherence length: the coherent sums telescope.
    ///
    /// # Errors
    /// [`OpticsError`] for a value out of range, a medium that absorbs, that is not known at a wavelength
    /// or whose index changes with direction, or layers thinner optically than the ambient.
    ///
    /// ```
    /// use nacreous_nacre::{Index, LayerStack};
    /// use nacreous_optics::IlluminantModel;
    /// let index = |n| Index::new("medium", n, 0.0);
    /// let stack = LayerStack::new(vec![420.0; 100], 20.0, index(1.53)?, index(1.43)?, index(1.0)?, index(1.53)?)?;
    /// let model = IlluminantModel { coherence_nm: 5000.0, threshold: 0.05, diffuse_loss: 0.02 };
    /// let table = model.spectra(&stack, &[0.0, 0.5], &[450.0, 550.0, 650.0])?;
    /// assert_eq!(table.len(), 2 * 3);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn spectra(
        &self,
        stack: &LayerStack,
        view_angle_rad: &[f64],
        wavelength_nm: &[f64],
    ) -> Result<Vec<f64>, OpticsError> {
        let found =
            self.spectra_unless(stack, view_angle_rad, wavelength_nm, &AtomicBool::new(false))?;
        // Nobody else holds that flag, so nobody can have stopped the work.
        Ok(found.unwrap_or_default())
    }

    /// [`Self::spectra`], or `None` once another thread has set `stop`.
    ///
    /// # Errors
    /// Those of [`Self::spectra`].
    pub fn spectra_unless(
        &self,
        stack: &LayerStack,
        view_angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Vec<f64>>, OpticsError> {
        within("coherence_nm", self.coherence_nm, 0.0..=1e9, "0 to 1e9 nm")?;
        within("threshold", self.threshold, 0.0..=1.0, "0 to 1")?;
        within("diffuse_loss", self.diffuse_loss, 0.0..=1.0, "0 to 1")?;
        grid::check(view_angle_rad, wavelength_nm)?;
        let nacre = Nacre::new(*self, stack, wavelength_nm)?;
        let mut table = vec![0.0; view_angle_rad.len() * wavelength_nm.len()];
        if packing::is_packed(view_angle_rad.len(), wavelength_nm.len()) {
            let directions = view_angle_rad.iter().copied().map(Direction::new).collect();
            // All points are one row.
            grid::fill(&Points { nacre: &nacre, directions }, &[0.0], [&mut table], stop);
        } else {
            grid::fill(&nacre, view_angle_rad, [&mut table], stop);
        }
        Ok((!stop.load(Ordering::Relaxed)).then_some(table))
    }

    /// Whether [`Self::spectra`] answers before another thread would have taken up the question, in some
    /// tens of microseconds; then it stays on the caller's thread.
    pub fn is_brief(stack: &LayerStack, angles: usize, wavelengths: usize) -> bool {
        grid::is_brief(packing::blocks(angles, wavelengths), stack.thickness_nm().len())
    }
}

/// A stack as the model sees it. The step numbers below are those of section 3 of docs/model.md.
struct Nacre<'a> {
    model: IlluminantModel,
    protein_nm: f64,
    /// Of the lower face of each aragonite layer, protein not counted, as in equation (3).
    depth_nm: Vec<f64>,
    wavelength_nm: &'a [f64],
    /// `[block]`, or one for all where no medium is dispersive.
    indices: Vec<Lanes<Indices>>,
    is_constant: bool,
}

/// One line of sight.
struct Line {
    direction: Direction,
    /// What all wavelengths share, where no medium is dispersive.
    constant: Option<(Sight, Vec<usize>)>,
}

impl<'a> Nacre<'a> {
    fn new(
        model: IlluminantModel,
        stack: &LayerStack,
        wavelength_nm: &'a [f64],
    ) -> Result<Self, OpticsError> {
        let media = [stack.ambient(), stack.aragonite(), stack.protein()];
        let is_constant = media.iter().all(|medium| medium.constant().is_some());
        let blocks = wavelength_nm.chunks(LANES).take(if is_constant { 1 } else { usize::MAX });
        let indices = blocks.map(|nm| Indices::of(stack, &filled(nm)));
        let depth_nm = stack.thickness_nm().iter().scan(0.0, |depth_nm, d| {
            *depth_nm += d;
            Some(*depth_nm)
        });
        Ok(Self {
            model,
            protein_nm: stack.protein_nm(),
            depth_nm: depth_nm.collect(),
            wavelength_nm,
            indices: indices.collect::<Result<_, _>>()?,
            is_constant,
        })
    }

    /// The media at each wavelength of a block.
    fn indices(&self, block: usize) -> &Lanes<Indices> {
        &self.indices[if self.is_constant { 0 } else { block }]
    }

    /// Steps 1 to 7 where lanes see the media along paths of their own.
    fn by_lane(
        &self,
        light: &Lanes<(Indices, Direction)>,
        wavelength_nm: &Lanes<f64>,
    ) -> Lanes<f64> {
        let sight = Sight::new(self.protein_nm, light);
        let coherence_nm = self.model.coherence_nm;
        let ends = window::lane_ends(&self.depth_nm, &sight.path_per_nm, coherence_nm);
        self.intensity(&sight, &ends, wavelength_nm)
    }

    /// Steps 3 to 7 for a block.
    fn intensity<E: Ends>(
        &self,
        sight: &Sight,
        ends: &[E],
        wavelength_nm: &Lanes<f64>,
    ) -> Lanes<f64> {
        let mut sums = Sums::for_windows(window::widest(ends));
        interference(&self.model, sight, &self.depth_nm, ends, wavelength_nm, &mut sums)
    }
}

impl Work<1> for Nacre<'_> {
    type Angle = Line;

    fn bilayers(&self) -> usize {
        self.depth_nm.len()
    }

    fn meet(&self, theta_0: f64) -> Line {
        let direction = Direction::new(theta_0);
        let constant = self.is_constant.then(|| {
            let sight =
                Sight::new(self.protein_nm, &self.indices[0].map(|media| (media, direction)));
            let ends = window::ends(&self.depth_nm, sight.path_per_nm[0], self.model.coherence_nm);
            (sight, ends.collect())
        });
        Line { direction, constant }
    }

    fn fill(&self, line: &Line, block: usize, [out]: [&mut [f64]; 1]) {
        let from = block * LANES;
        let nm = filled(&self.wavelength_nm[from..from + out.len()]);
        let intensity = if let Some((sight, ends)) = &line.constant {
            self.intensity(sight, ends, &nm)
        } else {
            self.by_lane(&self.indices(block).map(|media| (media, line.direction)), &nm)
        };
        out.copy_from_slice(&intensity[..out.len()]);
    }
}

/// The same nacre at few wavelengths: points (angle, wavelength) side by side, as the table has them.
struct Points<'a> {
    nacre: &'a Nacre<'a>,
    directions: Vec<Direction>,
}

impl Work<1> for Points<'_> {
    type Angle = ();

    fn bilayers(&self) -> usize {
        self.nacre.bilayers()
    }

    fn meet(&self, _: f64) {}

    fn fill(&self, (): &(), block: usize, [out]: [&mut [f64]; 1]) {
        let Self { nacre, directions } = self;
        let places = packing::places(block, directions.len(), nacre.wavelength_nm.len());
        let indices = nacre.indices(0);
        let light = places.map(|(angle, wavelength)| (indices[wavelength], directions[angle]));
        let nm = places.map(|(_, wavelength)| nacre.wavelength_nm[wavelength]);
        out.copy_from_slice(&nacre.by_lane(&light, &nm)[..out.len()]);
    }
}
