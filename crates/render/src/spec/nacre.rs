//! The `[nacre]` of a pearl: layers grown over a season, or listed one by one.

use serde::{Deserialize, Deserializer, de::Error};
use serde_json::Value;

/// Where the layers come from.
#[derive(Debug, Clone, PartialEq)]
pub enum NacreSpec {
    /// They grow day by day.
    Growth(Box<GrowthSpec>),
    /// They are listed.
    Listed(ListedSpec),
}

// By hand, for a list beside it is what tells the two apart, and serde's own way would say of a wrong
// key no more than that nothing matches.
impl<'de> Deserialize<'de> for NacreSpec {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let value = Value::deserialize(deserializer)?;
        let found = if value.get("thickness_nm").is_some() {
            ListedSpec::deserialize(value).map(Self::Listed)
        } else {
            GrowthSpec::deserialize(value).map(|growth| Self::Growth(Box::new(growth)))
        };
        found.map_err(|error| D::Error::custom(format!("nacre: {error}")))
    }
}

/// The season's bell curves, and their noise (paper, section 3.2.1).
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct GrowthSpec {
    /// Thickness of every protein layer.
    pub protein_nm: f64,
    /// What the aragonite layers are.
    pub aragonite: MediumSpec,
    /// What the protein layers are.
    pub protein: MediumSpec,
    /// The preset that the values began with; they are all here.
    pub preset: String,
    /// Seed of the growth's random numbers.
    pub seed: u64,
    /// Day on which the nucleus is put in, `MM-DD` or `YYYY-MM-DD`.
    pub seeding: String,
    /// Day of the harvest, likewise.
    pub harvest: String,
    /// Day of each year on which the bell curves are highest, `MM-DD`.
    pub peak: String,
    /// Standard deviation of the bell curves.
    pub season_days: f64,
    /// Thickness of a layer far from the peak.
    pub thickness_winter_nm: f64,
    /// Thickness of a layer at the peak.
    pub thickness_summer_nm: f64,
    /// Layers a day far from the peak.
    pub layers_winter: f64,
    /// Layers a day at the peak.
    pub layers_summer: f64,
    /// Half width of the noise on each thickness.
    pub thickness_noise_nm: f64,
    /// Half width of the noise on the layers of each day.
    pub layers_noise: f64,
}

/// Layers given one by one.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct ListedSpec {
    /// Thickness of every protein layer.
    pub protein_nm: f64,
    /// What the aragonite layers are.
    pub aragonite: MediumSpec,
    /// What the protein layers are.
    pub protein: MediumSpec,
    /// Thickness of each aragonite layer, the surface first.
    pub thickness_nm: Vec<f64>,
}

/// What a kind of layer is made of.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged)]
pub enum MediumSpec {
    /// The index n.
    Index(f64),
    /// n and k of n + ik.
    Absorbing([f64; 2]),
    /// A measured medium by its name.
    Named(String),
    /// A crystal with its axis along the normal.
    Uniaxial(UniaxialSpec),
}

/// The two indices of a crystal.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct UniaxialSpec {
    /// Index for the electric field along the layers.
    pub n_o: f64,
    /// Index for the electric field along their normal.
    pub n_e: f64,
}

impl NacreSpec {
    /// The seed of the growth, which grain and columns share; 1 for listed layers.
    pub fn seed(&self) -> u64 {
        match self {
            Self::Growth(growth) => growth.seed,
            Self::Listed(_) => 1,
        }
    }
}
