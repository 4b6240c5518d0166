//! Light of one angle of incidence, block by block of wavelengths, and the kernel that suits it. Where
//! wavelengths are few, a block runs on into the next angles.

use std::sync::atomic::AtomicBool;

use nacreous_nacre::LayerStack;

use crate::{
    absorbing,
    grid::{self, Work},
    lanes::{HALF, LANES, Lanes},
    lossless,
    media::Table,
    packing,
    real::Real,
    tablets::{Columns, Tablets},
    tabulated,
    transfer::{Precision, TransferModel},
    wave::{Plane, Polarisation},
    waves::{Media, Waves},
};

/// R, T and A of one block of wavelengths.
pub(crate) type Shares = [Lanes<f64>; 3];

/// Shares of light from the ambient, the mean of `N` polarisations, and of each from aragonite above the layers.
#[derive(Clone, Copy)]
pub(crate) struct OfBoth<const N: usize> {
    pub(crate) ambient: Shares,
    pub(crate) aragonite: [Shares; N],
}

/// What becomes of the light of each angle and block of wavelengths.
pub(crate) trait Use<const K: usize>: Sync {
    /// Bilayers of all stacks together.
    fn bilayers(&self) -> usize;

    /// Fills the block's part of each of the `K` tables.
    fn fill<const N: usize>(&self, block: &Block<'_, N>, tables: [&mut [f64]; K]);
}

/// Fills `K` tables with `using`, or leaves off where `stop` is set.
pub(crate) fn fill<const K: usize>(
    model: TransferModel,
    table: &Table,
    angle_rad: &[f64],
    tables: [&mut [f64]; K],
    using: &impl Use<K>,
    stop: &AtomicBool,
) {
    let precision = model.precision;
    let (s, p) = (Plane::S, Plane::P);
    match model.polarisation {
        Polarisation::S => {
            Light { table, planes: [s], precision, using }.fill_all(angle_rad, tables, stop);
        }
        Polarisation::P => {
            Light { table, planes: [p], precision, using }.fill_all(angle_rad, tables, stop);
        }
        Polarisation::Unpolarised => {
            Light { table, planes: [s, p], precision, using }.fill_all(angle_rad, tables, stop);
        }
    }
}

/// Light of the mean of `N` polarisations.
struct Light<'a, U, const N: usize> {
    table: &'a Table,
    planes: [Plane; N],
    precision: Precision,
    using: &'a U,
}

impl<U, const N: usize> Light<'_, U, N> {
    fn fill_all<const K: usize>(
        &self,
        angle_rad: &[f64],
        tables: [&mut [f64]; K],
        stop: &AtomicBool,
    ) where
        U: Use<K>,
    {
        if packing::is_packed(angle_rad.len(), self.table.wavelengths) {
            let cos_angle = angle_rad.iter().map(|angle| angle.cos()).collect();
            // All points are one row.
            grid::fill(&Points { light: self, cos_angle }, &[0.0], tables, stop);
        } else {
            grid::fill(self, angle_rad, tables, stop);
        }
    }
}

/// The same light at few wavelengths: points (angle, wavelength) side by side, as the table has them.
struct Points<'a, U, const N: usize> {
    light: &'a Light<'a, U, N>,
    cos_angle: Vec<f64>,
}

impl<U: Use<K>, const N: usize, const K: usize> Work<K> for Points<'_, U, N> {
    type Angle = ();

    fn bilayers(&self) -> usize {
        self.light.using.bilayers()
    }

    fn meet(&self, _: f64) {}

    fn fill(&self, (): &(), block: usize, tables: [&mut [f64]; K]) {
        let Light { table, planes, precision, using } = self.light;
        let places = packing::places(block, self.cos_angle.len(), table.wavelengths);
        let cos_angle = places.map(|(angle, _)| self.cos_angle[angle]);
        let of_wavelength = places.map(|(_, wavelength)| wavelength);
        let media = table.at_points(*planes, &cos_angle, &of_wavelength);
        let half_turns_per_nm = &of_wavelength.map(|lane| table.half_turns_per_nm[0][lane]);
        let (precision, lanes) = (*precision, tables[0].len());
        using.fill(&Block { table, half_turns_per_nm, media: &media, precision, lanes }, tables);
    }
}

/// One angle of it.
pub(crate) struct Incidence<const N: usize> {
    cos_angle: f64,
    /// The media of every block, where they are all the same.
    constant: Option<Media<N>>,
}

/// One angle and one block of wavelengths.
pub(crate) struct Block<'a, const N: usize> {
    table: &'a Table,
    half_turns_per_nm: &'a Lanes<f64>,
    media: &'a Media<N>,
    precision: Precision,
    /// Wavelengths in the block; those of the lanes behind them are nobody's.
    lanes: usize,
}

impl<U: Use<K>, const N: usize, const K: usize> Work<K> for Light<'_, U, N> {
    type Angle = Incidence<N>;

    fn bilayers(&self) -> usize {
        self.using.bilayers()
    }

    fn meet(&self, angle_rad: f64) -> Incidence<N> {
        let cos_angle = angle_rad.cos();
        let constant = self.table.is_constant.then(|| self.table.at(self.planes, cos_angle, 0));
        Incidence { cos_angle, constant }
    }

    fn fill(&self, angle: &Incidence<N>, block: usize, tables: [&mut [f64]; K]) {
        let dispersed;
        let media = if let Some(media) = &angle.constant {
            media
        } else {
            dispersed = self.table.at(self.planes, angle.cos_angle, block);
            &dispersed
        };
        let half_turns_per_nm = &self.table.half_turns_per_nm[block];
        let (table, precision, lanes) = (self.table, self.precision, tables[0].len());
        self.using.fill(&Block { table, half_turns_per_nm, media, precision, lanes }, tables);
    }
}

impl<const N: usize> Block<'_, N> {
    /// The media, as this light meets them in every stack with protein layers of one thickness.
    pub(crate) fn met(&self, protein_nm: f64) -> Met<'_, N> {
        let layers = match (self.media.is_lossless, self.precision) {
            (false, _) => Layers::Any,
            (true, Precision::Double) => Layers::Double(self.lossless(protein_nm)),
            (true, Precision::Single) => Layers::Single(self.lossless(protein_nm)),
        };
        Met { block: self, layers }
    }

    /// R, T and A of each column.
    pub(crate) fn each(&self, columns: &Columns<'_>) -> Vec<Shares> {
        let stacks = columns.stacks;
        match &columns.tablets {
            Some(tablets) if self.media.is_lossless => self.tabulated(stacks, tablets),
            _ => {
                let met = self.met(stacks[0].protein_nm());
                stacks.iter().map(|stack| met.shares(stack)).collect()
            }
        }
    }

    fn tabulated(&self, stacks: &[LayerStack], tablets: &Tablets) -> Vec<Shares> {
        let protein_nm = stacks[0].protein_nm();
        let waves = &self.media.waves;
        let met = tabulated::Met::new(waves, self.half_turns_per_nm, protein_nm, tablets);
        let mut each = vec![[[0.0; LANES]; 3]; stacks.len()];
        for ((stack, column), shares) in stacks.iter().zip(&tablets.columns).zip(&mut each) {
            if self.lanes > HALF {
                tabulated::add_shares::<N, LANES>(column, &met, waves, shares);
            } else {
                tabulated::add_shares::<N, HALF>(column, &met, waves, shares);
            }
            if !is_finite(shares) {
                *shares = self.met(protein_nm).shares(stack);
            }
        }
        each
    }

    /// Shares of each column from the ambient, which the block's light comes from, and from aragonite: in one pass where
    /// both have the same field.
    pub(crate) fn each_of_both(&self, columns: &Columns<'_>) -> Vec<OfBoth<N>> {
        let inside = self.media.waves.each_ref().map(Waves::within_aragonite);
        let in_one = columns.tablets.as_ref().filter(|_| self.media.is_lossless);
        let in_one = in_one.and_then(|tablets| self.in_one_pass(columns.stacks, tablets, &inside));
        in_one.unwrap_or_else(|| {
            let alone: [Vec<Shares>; N] = std::array::from_fn(|n| {
                let is_lossless = self.media.waves[n].are_lossless();
                let media = &Media { waves: [inside[n].clone()], is_lossless };
                let Self { table, half_turns_per_nm, precision, lanes, .. } = *self;
                Block { table, half_turns_per_nm, media, precision, lanes }.each(columns)
            });
            let column = |(i, ambient): (usize, Shares)| OfBoth {
                ambient,
                aragonite: alone.each_ref().map(|columns| columns[i]),
            };
            self.each(columns).into_iter().enumerate().map(column).collect()
        })
    }

    /// `None` where single precision overflowed.
    fn in_one_pass(
        &self,
        stacks: &[LayerStack],
        tablets: &Tablets,
        inside: &[Waves; N],
    ) -> Option<Vec<OfBoth<N>>> {
        let (waves, nothing) = (&self.media.waves, [[0.0; LANES]; 3]);
        let met =
            tabulated::Met::new(waves, self.half_turns_per_nm, stacks[0].protein_nm(), tablets);
        let mut each = vec![OfBoth { ambient: nothing, aragonite: [nothing; N] }; stacks.len()];
        for (column, shares) in tablets.columns.iter().zip(&mut each) {
            if self.lanes > HALF {
                tabulated::add_shares_of_both::<N, LANES>(column, &met, waves, inside, shares);
            } else {
                tabulated::add_shares_of_both::<N, HALF>(column, &met, waves, inside, shares);
            }
            if !(is_finite(&shares.ambient) && shares.aragonite.iter().all(is_finite)) {
                return None;
            }
        }
        Some(each)
    }

    fn lossless<T: Real>(&self, protein_nm: f64) -> lossless::Met<T, N> {
        lossless::Met::new(&self.media.waves, self.half_turns_per_nm, protein_nm)
    }
}

/// The media of one block of wavelengths, as light at one angle meets them.
pub(crate) struct Met<'a, const N: usize> {
    block: &'a Block<'a, N>,
    layers: Layers<N>,
}

/// What is the same in all stacks, by the kernel that suits them.
enum Layers<const N: usize> {
    Single(lossless::Met<f32, N>),
    Double(lossless::Met<f64, N>),
    Any,
}

impl<const N: usize> Met<'_, N> {
    /// R, T and A of a stack of these media, and of the thickness of protein that was asked for.
    pub(crate) fn shares(&self, stack: &LayerStack) -> Shares {
        let mut shares = [[0.0; LANES]; 3];
        if self.block.table.is_isotropic {
            self.add_shares::<true>(stack, &mut shares);
        } else {
            self.add_shares::<false>(stack, &mut shares);
        }
        shares
    }

    #[inline(always)]
    fn add_shares<const ALIKE: bool>(&self, stack: &LayerStack, shares: &mut Shares) {
        let block = self.block;
        match &self.layers {
            Layers::Any => absorbing::add_shares::<N, ALIKE>(
                stack,
                block.table.absorbs,
                &block.media.waves,
                block.half_turns_per_nm,
                shares,
            ),
            Layers::Double(met) => self.add_lossless::<f64, ALIKE>(stack, met, shares),
            Layers::Single(met) => {
                self.add_lossless::<f32, ALIKE>(stack, met, shares);
                // Media of extreme contrast overflow it; double precision holds what is allowed.
                if !is_finite(shares) {
                    *shares = [[0.0; LANES]; 3];
                    let met = block.lossless(stack.protein_nm());
                    self.add_lossless::<f64, ALIKE>(stack, &met, shares);
                }
            }
        }
    }

    #[inline(always)]
    fn add_lossless<T: Real, const ALIKE: bool>(
        &self,
        stack: &LayerStack,
        met: &lossless::Met<T, N>,
        shares: &mut Shares,
    ) {
        let (nm, waves) = (stack.thickness_nm(), &self.block.media.waves);
        if self.block.lanes > HALF {
            lossless::add_shares::<T, N, ALIKE, LANES>(nm, met, waves, shares);
        } else {
            lossless::add_shares::<T, N, ALIKE, HALF>(nm, met, waves, shares);
        }
    }
}

/// Whether no lane of R and T overflowed.
fn is_finite(shares: &Shares) -> bool {
    // Without a way out in the middle, which would keep the lanes apart.
    (0..LANES).fold(true, |all, i| all & (shares[0][i] + shares[1][i]).is_finite())
}
