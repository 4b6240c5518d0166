//! The field inside a film, and where its energy stays.

use std::{f64::consts::TAU, sync::atomic::AtomicBool};

use nacreous_nacre::Principal;
use num_complex::Complex64;

use crate::{
    Film, OpticsError, Polarisation,
    film::{Met, PLANES, Recursion, turn},
    points::table,
    wave::Plane,
};

/// Light inside a film, at one angle and wavelength.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    /// |E|^2 at each depth, that of the incoming wave being 1.
    pub intensity: Vec<f64>,
    /// Share of the incoming energy that stays in a nm of depth, there.
    pub absorbed_per_nm: Vec<f64>,
    /// Share that stays in each layer, surface first.
    pub absorbed: Vec<f64>,
}

impl Film {
    /// At `depth_nm` below the surface, 0 or more, for each `[angle, wavelength]`; `None` once `stop` is
    /// set. Beyond the last layer is the substrate; at a boundary the layer above counts.
    ///
    /// # Errors
    /// As [`crate::TransferModel::energies`].
    pub fn depth(
        &self,
        polarisation: Polarisation,
        depth_nm: &[f64],
        angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Vec<Profile>>, OpticsError> {
        for &depth in depth_nm {
            crate::error::within("depth_nm", depth, 0.0..=1e10, "0 to 1e10 nm")?;
        }
        let indices = self.indices(angle_rad, wavelength_nm)?;
        let places: Vec<(usize, f64)> = depth_nm.iter().map(|&depth| self.place(depth)).collect();
        let planes = match polarisation {
            Polarisation::S => &PLANES[..1],
            Polarisation::P => &PLANES[1..],
            Polarisation::Unpolarised => &PLANES[..],
        };
        Ok(table(angle_rad, wavelength_nm, stop, &|cos_angle, at| {
            let mut sum = Profile {
                intensity: vec![0.0; places.len()],
                absorbed_per_nm: vec![0.0; places.len()],
                absorbed: vec![0.0; self.layers().len()],
            };
            for &plane in planes {
                let met = self.met(plane, cos_angle, &indices[at], wavelength_nm[at]);
                let inside = Inside::new(self, &met, &indices[at], wavelength_nm[at]);
                inside.add(&places, 1.0 / planes.len() as f64, &mut sum);
            }
            sum
        }))
    }

    /// The region (1 is the first layer) and how far below its top.
    fn place(&self, depth_nm: f64) -> (usize, f64) {
        let mut top_nm = 0.0;
        for (layer, &(_, nm)) in self.layers().iter().enumerate() {
            if depth_nm <= top_nm + nm {
                return (layer + 1, depth_nm - top_nm);
            }
            top_nm += nm;
        }
        (self.layers().len() + 1, depth_nm - top_nm)
    }
}

/// Fields of one polarisation.
struct Inside<'a> {
    film: &'a Film,
    met: &'a Met,
    media: &'a [Principal],
    nm: f64,
    recursion: Recursion,
}

impl<'a> Inside<'a> {
    fn new(film: &'a Film, met: &'a Met, media: &'a [Principal], nm: f64) -> Self {
        Self { film, met, media, nm, recursion: Recursion::through(&met.waves, &met.turn) }
    }

    fn add(&self, places: &[(usize, f64)], part: f64, sum: &mut Profile) {
        for (slot, &place) in places.iter().enumerate() {
            let (intensity, absorbed) = self.at(place);
            sum.intensity[slot] += part * intensity;
            sum.absorbed_per_nm[slot] += part * absorbed;
        }
        for (layer, absorbed) in sum.absorbed.iter_mut().enumerate() {
            let bottom_nm = self.film.layers()[layer].1;
            let stays = self.flux(layer + 1, 0.0) - self.flux(layer + 1, bottom_nm);
            let medium = self.medium(layer + 1);
            let is_clear = medium.ordinary.is_lossless() && medium.extraordinary.is_lossless();
            *absorbed += if is_clear { 0.0 } else { part * stays.max(0.0) };
        }
    }

    /// |E|^2 and the energy that stays per nm.
    fn at(&self, (region, below_nm): (usize, f64)) -> (f64, f64) {
        let medium = self.medium(region);
        let squared = |n: Complex64| n * n;
        let along_layers = squared(medium.ordinary.complex());
        let along_normal = squared(medium.extraordinary.complex());
        let (electric, magnetic) = self.tangential(region, below_nm);
        // Maxwell: n_e^2 E_z = - n_ambient sin H_y.
        let across = match self.met.plane {
            Plane::S => 0.0,
            Plane::P => (magnetic * self.transverse() / along_normal).norm_sqr(),
        };
        let (electric, incoming) = (electric.norm_sqr(), self.incoming());
        let loss = TAU / self.nm * (along_layers.im * electric + along_normal.im * across);
        ((electric + across) / incoming, loss / self.incoming_flux())
    }

    /// The share of the incoming energy that runs down through a depth of a region.
    fn flux(&self, region: usize, below_nm: f64) -> f64 {
        let (electric, magnetic) = self.tangential(region, below_nm);
        (electric * magnetic.conj()).re / self.incoming_flux()
    }

    /// Tangential electric and magnetic field, that of the incoming electric wave being 1.
    fn tangential(&self, region: usize, below_nm: f64) -> (Complex64, Complex64) {
        let wave = self.met.waves[region];
        let from_top = self.recursion.forward[region];
        let down = from_top * turn(wave.along, below_nm, self.nm);
        let up = match self.film.layers().get(region - 1) {
            Some(&(_, thickness_nm)) => {
                from_top
                    * self.met.turn[region - 1]
                    * self.recursion.reflected[region]
                    * turn(wave.along, thickness_nm - below_nm, self.nm)
            }
            None => Complex64::ZERO,
        };
        (down + up, wave.admittance * (down - up))
    }

    /// |E|^2 of an incoming wave whose tangential field is 1.
    fn incoming(&self) -> f64 {
        match self.met.plane {
            Plane::S => 1.0,
            Plane::P => {
                let across = self.transverse() / self.met.waves[0].along.norm();
                1.0 + across * across
            }
        }
    }

    fn incoming_flux(&self) -> f64 {
        self.met.waves[0].admittance.re
    }

    /// n_ambient sin, in all layers the same.
    fn transverse(&self) -> f64 {
        let sine = (1.0 - self.met.cos_angle * self.met.cos_angle).max(0.0).sqrt();
        self.media[0].ordinary.n() * sine
    }

    fn medium(&self, region: usize) -> Principal {
        let place = self.film.layers().get(region - 1).map(|&(medium, _)| medium);
        self.media[place.unwrap_or(self.media.len() - 1)]
    }
}
