//! The film of a pearl: columns of tablets of its outer nacre, side by side.

use nacreous_nacre::LayerStack;
use rand_chacha::ChaCha8Rng;
use rand_core::{Rng, SeedableRng};

use super::nacre::stack_by_seed;
use crate::{
    RenderError,
    spec::{nacre::NacreSpec, pearl::FilmSpec},
};

/// Spread of listed layers from column to column: orderly nacre has 10 to 20 nm (Pearl Science Laboratory).
/// Grown layers have their own noise.
const LISTED_SPREAD_NM: f64 = 10.0;

/// No layer gets thinner than this by the spread.
const THINNEST_NM: f64 = 1.0;

/// The columns of a film, the outer `outer_um` of each, on nacre as their core.
///
/// Grown nacre: each column grows by the same season with a seed of its own, the first with the pearl's.
/// Listed layers are the same in all. Both are spread by `film.column_spread_nm`, layer by layer (uniform
/// noise of that standard deviation). Same pearl, same columns, on every machine.
///
/// # Errors
/// As [`stack_of`](super::nacre::stack_of).
pub fn columns_of(
    nacre: &NacreSpec,
    film: &FilmSpec,
    outer_um: f64,
) -> Result<Vec<LayerStack>, RenderError> {
    let own_nm = match nacre {
        NacreSpec::Growth(_) => 0.0,
        NacreSpec::Listed(_) => LISTED_SPREAD_NM,
    };
    let spread_nm = film.column_spread_nm.unwrap_or(own_nm);
    let mut noise = Noise::new(nacre.seed());
    (0..film.columns as u64)
        .map(|column| {
            // Seeds of files end below 2^63.
            let seed = nacre.seed().wrapping_add(column) % (1 << 63);
            let stack = stack_by_seed(nacre, seed)?;
            let layers = &stack.thickness_nm()[..stack.outer(outer_um).layers];
            let spread = |thickness_nm: &f64| match spread_nm {
                0.0 => *thickness_nm,
                _ => (thickness_nm + noise.uniform() * 3.0_f64.sqrt() * spread_nm).max(THINNEST_NM),
            };
            Ok(stack.with_layers(layers.iter().map(spread).collect())?)
        })
        .collect()
}

/// Uniform noise, the same on every machine.
struct Noise(ChaCha8Rng);

impl Noise {
    fn new(seed: u64) -> Self {
        let mut key = *b"-------- nacreous film columns  ";
        key[..8].copy_from_slice(&seed.to_le_bytes());
        Self(ChaCha8Rng::from_seed(key))
    }

    /// In [-1, 1), on a grid of 2^-52.
    fn uniform(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 * (2.0 / (1_u64 << 53) as f64) - 1.0
    }
}
