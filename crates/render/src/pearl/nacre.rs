//! The layers of a pearl: grown or listed, on their core.

use nacreous_nacre::{Diary, Growth, Index, LayerStack, Medium, Season};

use super::calendar::Calendar;
use crate::{
    RenderError,
    spec::nacre::{GrowthSpec, MediumSpec, NacreSpec},
};

/// What lies under the layers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Core {
    /// The crystal of the layers.
    Crystal,
    /// The paper's index, 1.53.
    Paper,
}

/// The layers of a pearl.
///
/// # Errors
/// [`RenderError`] for layers, media or days that cannot be.
pub fn stack_of(nacre: &NacreSpec) -> Result<LayerStack, RenderError> {
    let (thickness_nm, protein_nm, aragonite, protein) = match nacre {
        NacreSpec::Growth(growth) => (
            outermost_first(&diary_of(growth, growth.seed)?),
            growth.protein_nm,
            &growth.aragonite,
            &growth.protein,
        ),
        NacreSpec::Listed(listed) => {
            (listed.thickness_nm.clone(), listed.protein_nm, &listed.aragonite, &listed.protein)
        }
    };
    stack(thickness_nm, protein_nm, aragonite, protein)
}

/// The same nacre as it would have grown, or was listed, by another seed.
pub(crate) fn stack_by_seed(nacre: &NacreSpec, seed: u64) -> Result<LayerStack, RenderError> {
    match nacre {
        NacreSpec::Growth(growth) => stack(
            outermost_first(&diary_of(growth, seed)?),
            growth.protein_nm,
            &growth.aragonite,
            &growth.protein,
        ),
        NacreSpec::Listed(_) => stack_of(nacre),
    }
}

/// What grew on which day.
///
/// # Errors
/// As [`stack_of`].
pub fn diary_of(growth: &GrowthSpec, seed: u64) -> Result<Diary, RenderError> {
    let grown = Growth {
        days: Calendar::of(growth)?.days,
        season: season_of(growth)?,
        thickness_winter_nm: growth.thickness_winter_nm,
        thickness_summer_nm: growth.thickness_summer_nm,
        layers_winter: growth.layers_winter,
        layers_summer: growth.layers_summer,
        thickness_noise_nm: growth.thickness_noise_nm,
        layers_noise: growth.layers_noise,
    };
    Ok(grown.grow(seed)?)
}

/// The season that nacre grows by, in days since seeding.
///
/// # Errors
/// Days that cannot be.
pub fn season_of(growth: &GrowthSpec) -> Result<Season, RenderError> {
    let peak_day = f64::from(Calendar::of(growth)?.peak_day);
    Ok(Season { peak_day, width_days: growth.season_days })
}

/// What lies under layers of this aragonite: the crystal itself where a name or two indices tell it, else
/// the paper's.
pub fn core_under(aragonite: &MediumSpec) -> Core {
    match aragonite {
        MediumSpec::Named(_) | MediumSpec::Uniaxial(_) => Core::Crystal,
        MediumSpec::Index(_) | MediumSpec::Absorbing(_) => Core::Paper,
    }
}

fn stack(
    thickness_nm: Vec<f64>,
    protein_nm: f64,
    aragonite_spec: &MediumSpec,
    protein: &MediumSpec,
) -> Result<LayerStack, RenderError> {
    let aragonite = medium("nacre.aragonite", aragonite_spec)?;
    let core = match core_under(aragonite_spec) {
        Core::Crystal => aragonite.clone(),
        Core::Paper => Index::PAPER_ARAGONITE.into(),
    };
    let protein = medium("nacre.protein", protein)?;
    let ambient = Index::new("ambient", 1.0, 0.0)?;
    Ok(LayerStack::new(thickness_nm, protein_nm, aragonite, protein, ambient, core)?)
}

fn outermost_first(diary: &Diary) -> Vec<f64> {
    diary.deposits().iter().rev().map(|deposit| deposit.thickness_nm).collect()
}

fn medium(key: &str, given: &MediumSpec) -> Result<Medium, RenderError> {
    Ok(match given {
        MediumSpec::Index(n) => Index::new(key, *n, 0.0)?.into(),
        MediumSpec::Absorbing([n, k]) => Index::new(key, *n, *k)?.into(),
        MediumSpec::Uniaxial(crystal) => {
            Medium::uniaxial(Index::new(key, crystal.n_o, 0.0)?, Index::new(key, crystal.n_e, 0.0)?)
        }
        MediumSpec::Named(name) => Medium::named(name)
            .ok_or_else(|| RenderError::out_of_range(key, name, Medium::NAMES.join(", ")))?,
    })
}
