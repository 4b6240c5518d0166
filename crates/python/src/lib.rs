//! The bindings for Python: they convert types and errors, and decide nothing.
#![allow(clippy::needless_pass_by_value)] // arrays from Python are handed over
#![allow(clippy::elidable_lifetime_names)] // 'py, named as in all of PyO3's documentation

use pyo3::prelude::*;

mod body;
mod colour;
mod dealing;
mod file;
mod film;
mod image;
mod iridescence;
mod measure;
mod nacre;
mod optics;
mod pearl;
mod render;
mod scaling;
mod texture;
mod threads;
mod watched;

pyo3::import_exception!(nacreous.problem, InputError);

/// What a room refuses, said to Python.
fn refused(error: impl std::fmt::Display) -> PyErr {
    InputError::new_err(error.to_string())
}

/// The compiled rooms of nacreous.
#[pymodule]
mod _core {
    #[pymodule_export]
    use super::body::{kubelka_munk, pigment_absorption, pigments, smooth_reflectance};
    #[pymodule_export]
    use super::colour::{
        adapt_xyz, decode_rgb, delta_e_2000, encode_rgb, hvc_from_rgb, hvc_from_xyz,
        illuminant_spectrum, lab_from_xyz, map_to_gamut, munsell_notation, out_of_gamut_share,
        rgb_from_hvc, rgb_from_xyz, spectrum_from_csv, spectrum_wavelength_nm, xyz_from_hvc,
        xyz_from_lab, xyz_from_rgb, xyz_from_spectrum,
    };
    #[pymodule_export]
    use super::file::{
        png_bytes, read_exr_text, read_panorama, read_photograph, read_png_text, write_exr,
        write_png,
    };
    #[pymodule_export]
    use super::film::Film;
    #[pymodule_export]
    use super::image::develop;
    #[pymodule_export]
    const MAX_SAMPLES: usize = nacreous_render::MAX_SAMPLES;
    #[pymodule_export]
    const MAX_SIZE_PX: usize = nacreous_image::MAX_SIZE_PX;
    #[pymodule_export]
    use super::dealing::spread_of_people;
    #[pymodule_export]
    use super::iridescence::{interference_iridescence, iridescence};
    #[pymodule_export]
    use super::measure::measure;
    #[pymodule_export]
    use super::nacre::{Stack, media};
    #[pymodule_export]
    use super::optics::{energies, ensemble, fresnel, illuminant, resonances};
    #[pymodule_export]
    use super::pearl::{
        body_reflectance, film_columns, grow, resolved_keys, shape_dimensions, stack_of_nacre,
        texture_seed,
    };
    #[pymodule_export]
    use super::render::{Picture, field_mm, files_needed, render};
    #[pymodule_export]
    use super::scaling::{PairModel, PersonalAnswers, log_normal_cdf};
    #[pymodule_export]
    use super::texture::{
        Texture, analysed_grain, limited_grain, measured_grain, procedural_grain,
        synthesise_harmonics, synthesise_texture, texture_of,
    };
}
