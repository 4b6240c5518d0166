//! Any layers in any order: complex amplitudes from both sides, and a film on a plate whose own
//! reflections are out of step. One point of a table at a time, where [`crate::TransferModel`] takes many
//! at once but knows nacre alone.

use std::sync::atomic::AtomicBool;

use nacreous_nacre::{Medium, NacreError, Principal};
use num_complex::Complex64;

use crate::{
    OpticsError, grid,
    points::table,
    wave::{Plane, Wave},
};

/// Layers of any media, surface first, between an ambient and a substrate.
///
/// ```
/// use nacreous_nacre::Index;
/// use nacreous_optics::Film;
/// let n = |n| Index::new("medium", n, 0.0).unwrap().into();
/// let quarter = Film::new(vec![n(1.0), n(1.5_f64.sqrt()), n(1.5)], vec![(1, 550.0 / 4.0 / 1.5_f64.sqrt())])?;
/// let points = quarter.amplitudes(&[0.0], &[550.0], &Default::default())?.unwrap();
/// assert!(points[0][0].r.norm() < 1e-12); // a coating that lets all through
/// # Ok::<(), nacreous_optics::OpticsError>(())
/// ```
#[derive(Debug, Clone)]
pub struct Film {
    /// Ambient first, substrate last.
    media: Vec<Medium>,
    /// Which of the media, and thickness in nm.
    layers: Vec<(usize, f64)>,
}

/// What a film does to one polarisation at one angle and wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(non_snake_case)] // R and T are the paper's letters for energies, r and t for amplitudes.
pub struct Amplitudes {
    /// Reflected, with the paper's sign: `r_p` is `r_s` at normal incidence.
    pub r: Complex64,
    /// Electric field just inside the substrate, as `crate::fresnel` has it.
    pub t: Complex64,
    /// Shares of the energy.
    pub R: f64,
    /// What arrives just inside the substrate.
    pub T: f64,
    /// Reflected where the light comes from the substrate in the same direction.
    pub R_back: f64,
    /// Transmitted then.
    pub T_back: f64,
}

/// A plate in place of the substrate, too thick for its reflections to keep step with the film's.
#[derive(Debug, Clone)]
pub struct Plate {
    /// Thickness; the medium is the film's substrate.
    pub thickness_nm: f64,
    /// What lies behind the plate.
    pub behind: Medium,
}

/// s and p.
pub(crate) const PLANES: [Plane; 2] = [Plane::S, Plane::P];

impl Film {
    /// Layers by their place in `media`, whose first is the ambient and last the substrate.
    ///
    /// # Errors
    /// [`OpticsError::OutOfRange`] for a thickness outside 0 to 1e6 nm.
    pub fn new(media: Vec<Medium>, layers: Vec<(usize, f64)>) -> Result<Self, OpticsError> {
        for &(_, thickness_nm) in &layers {
            crate::error::within("thickness_nm", thickness_nm, 0.0..=1e6, "0 to 1000000 nm")?;
        }
        Ok(Self { media, layers })
    }

    /// Of s and p at each `[angle, wavelength]`; `None` once `stop` is set.
    ///
    /// # Errors
    /// As [`crate::TransferModel::energies`].
    pub fn amplitudes(
        &self,
        angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Vec<[Amplitudes; 2]>>, OpticsError> {
        let indices = self.indices(angle_rad, wavelength_nm)?;
        Ok(table(angle_rad, wavelength_nm, stop, &|cos_angle, at| {
            PLANES.map(|plane| {
                self.met(plane, cos_angle, &indices[at], wavelength_nm[at]).amplitudes()
            })
        }))
    }

    /// (R, T) of s and p at each `[angle, wavelength]` with a plate between the film and what is behind;
    /// energies are added, and a plate that absorbs weakens them on each way.
    ///
    /// # Errors
    /// As [`crate::TransferModel::energies`].
    pub fn on_plate(
        &self,
        plate: &Plate,
        angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Vec<[[f64; 2]; 2]>>, OpticsError> {
        let indices = self.indices(angle_rad, wavelength_nm)?;
        let behind = wavelength_nm.iter().map(|&nm| principal("behind", &plate.behind, nm));
        let behind = behind.collect::<Result<Vec<_>, _>>()?;
        Ok(table(angle_rad, wavelength_nm, stop, &|cos_angle, at| {
            PLANES.map(|plane| {
                let met = self.met(plane, cos_angle, &indices[at], wavelength_nm[at]);
                let last = refracted(plane, behind[at], indices[at][0].ordinary.n(), cos_angle);
                met.on_plate(plate.thickness_nm, last, wavelength_nm[at])
            })
        }))
    }

    /// Media by wavelength.
    pub(crate) fn indices(
        &self,
        angle_rad: &[f64],
        wavelength_nm: &[f64],
    ) -> Result<Vec<Vec<Principal>>, OpticsError> {
        grid::check(angle_rad, wavelength_nm)?;
        let of_all =
            |&nm: &f64| self.media.iter().map(|medium| principal("medium", medium, nm)).collect();
        let indices = wavelength_nm.iter().map(of_all).collect::<Result<Vec<Vec<_>>, _>>()?;
        if indices.iter().any(|media| media[0].ordinary != media[0].extraordinary) {
            return Err(OpticsError::Anisotropic { medium: "ambient" });
        }
        Ok(indices)
    }

    /// The layers as one plane wave meets them.
    pub(crate) fn met(&self, plane: Plane, cos_angle: f64, media: &[Principal], nm: f64) -> Met {
        let ambient = media[0].ordinary.complex();
        let incident = Wave::incident(plane, ambient, cos_angle);
        let substrate = media.len() - 1;
        let within = self.layers.iter().map(|&(medium, _)| medium).chain([substrate]);
        let mut waves = vec![incident];
        waves.extend(within.map(|medium| refracted(plane, media[medium], ambient.re, cos_angle)));
        let crossed = self.layers.iter().zip(&waves[1..]);
        let turn = crossed.map(|(&(_, d), wave)| turn(wave.along, d, nm)).collect();
        Met {
            plane,
            cos_angle,
            turn,
            waves,
            ambient,
            substrate: media[substrate].ordinary.complex(),
        }
    }

    pub(crate) fn layers(&self) -> &[(usize, f64)] {
        &self.layers
    }
}

/// Waves of one polarisation in the ambient, the layers and the substrate.
pub(crate) struct Met {
    pub(crate) plane: Plane,
    pub(crate) cos_angle: f64,
    /// exp(i phase) across each layer, at most 1 in size.
    pub(crate) turn: Vec<Complex64>,
    pub(crate) waves: Vec<Wave>,
    ambient: Complex64,
    substrate: Complex64,
}

impl Met {
    fn amplitudes(&self) -> Amplitudes {
        let down = Recursion::through(&self.waves, &self.turn);
        let mut waves = self.waves.clone();
        waves.reverse();
        let up = Recursion::through(&waves, &self.turn.iter().rev().copied().collect::<Vec<_>>());
        let (above, below) = (self.waves[0].admittance, waves[0].admittance);
        let (r, tangential) = (down.reflected[0], down.forward[self.waves.len() - 1]);
        let t = match self.plane {
            Plane::S => tangential,
            // Magnetic fields go over, and E = H / n.
            Plane::P => tangential * below / above * self.ambient / self.substrate,
        };
        Amplitudes {
            r,
            t,
            R: r.norm_sqr(),
            T: (below.re / above.re) * tangential.norm_sqr(),
            R_back: up.reflected[0].norm_sqr(),
            T_back: if below.re > 0.0 {
                (above.re / below.re) * up.forward[self.waves.len() - 1].norm_sqr()
            } else {
                0.0
            },
        }
    }

    /// (R, T), the sum over all ways up and down the plate.
    fn on_plate(&self, thickness_nm: f64, behind: Wave, nm: f64) -> [f64; 2] {
        let film = self.amplitudes();
        let plate = self.waves[self.waves.len() - 1];
        let below = (plate.admittance - behind.admittance) / (plate.admittance + behind.admittance);
        let through = 2.0 * plate.admittance / (plate.admittance + behind.admittance);
        let once = turn(plate.along, thickness_nm, nm).norm_sqr();
        let (back, on) = if plate.admittance.re > 0.0 {
            (below.norm_sqr(), behind.admittance.re / plate.admittance.re * through.norm_sqr())
        } else {
            (0.0, 0.0) // no wave runs in the plate
        };
        let rounds = 1.0 / (1.0 - film.R_back * back * once * once);
        let reflected = film.R + film.T * film.T_back * back * once * once * rounds;
        [reflected, film.T * once * on * rounds]
    }
}

/// Tangential electric fields, by region: the first is the ambient, the last the substrate.
///
/// From below upward what comes back, from above downward what goes on; nothing grows on the way, however
/// thick and dark a layer is.
pub(crate) struct Recursion {
    /// Upward over downward wave at the bottom of each region but the last.
    pub(crate) reflected: Vec<Complex64>,
    /// Downward wave at the top of each region, the incoming being 1.
    pub(crate) forward: Vec<Complex64>,
}

impl Recursion {
    pub(crate) fn through(waves: &[Wave], turn: &[Complex64]) -> Self {
        let layers = turn.len();
        let step = |j: usize| {
            let (q, next) = (waves[j].admittance, waves[j + 1].admittance);
            ((q - next) / (q + next), 2.0 * q / (q + next))
        };
        let mut reflected = vec![step(layers).0; layers + 1];
        let below = |reflected: &[Complex64], j: usize| {
            if j == layers { Complex64::ZERO } else { reflected[j + 1] * turn[j] * turn[j] }
        };
        for j in (0..layers).rev() {
            let (r, returns) = (step(j).0, below(&reflected, j));
            reflected[j] = (r + returns) / (1.0 + r * returns);
        }
        let mut forward = vec![Complex64::ONE; layers + 2];
        for j in 0..=layers {
            let (r, t) = step(j);
            let at_bottom = forward[j] * if j == 0 { Complex64::ONE } else { turn[j - 1] };
            forward[j + 1] = at_bottom * t / (1.0 + r * below(&reflected, j));
        }
        Self { reflected, forward }
    }
}

fn refracted(plane: Plane, medium: Principal, ambient: f64, cos_angle: f64) -> Wave {
    let indices = (medium.ordinary.complex(), medium.extraordinary.complex());
    Wave::refracted(plane, indices, ambient, ambient * cos_angle)
}

/// exp(i phase) of a way along the normal.
pub(crate) fn turn(along: Complex64, nm: f64, wavelength_nm: f64) -> Complex64 {
    let phase = along * (std::f64::consts::TAU * nm / wavelength_nm);
    Complex64::from_polar((-phase.im).exp(), phase.re)
}

fn principal(name: &str, medium: &Medium, nm: f64) -> Result<Principal, OpticsError> {
    let found = medium.at(name, nm)?;
    for index in [found.ordinary, found.extraordinary] {
        if index.n() < 1e-3 {
            let (quantity, value) = (format!("{name}: n"), index.n());
            let allowed = "0.001 to 100 for exact optics";
            return Err(NacreError::OutOfRange { quantity, value, allowed }.into());
        }
    }
    Ok(found)
}
