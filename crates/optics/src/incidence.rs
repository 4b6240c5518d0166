//! Light of one angle of incidence, block by block of wavelengths, and the kernel that suits it.

use nacreous_nacre::LayerStack;

use crate::{
    absorbing,
    lanes::{LANES, Lanes},
    lossless,
    media::{Media, Table},
    transfer::Precision,
    wave::Plane,
};

/// R, T and A of one block of wavelengths.
pub(crate) type Shares = [Lanes<f64>; 3];

/// One angle, for the mean of `N` polarisations.
pub(crate) struct Incidence<'a, const N: usize> {
    table: &'a Table,
    planes: [Plane; N],
    cos_angle: f64,
    precision: Precision,
    /// The media of every block, where they are all the same.
    constant: Option<Media<N>>,
}

/// One angle and one block of wavelengths.
pub(crate) struct Block<'a, const N: usize> {
    table: &'a Table,
    half_turns_per_nm: &'a Lanes<f64>,
    media: &'a Media<N>,
    precision: Precision,
}

impl<'a, const N: usize> Incidence<'a, N> {
    pub(crate) fn new(
        table: &'a Table,
        planes: [Plane; N],
        angle_rad: f64,
        precision: Precision,
    ) -> Self {
        let cos_angle = angle_rad.cos();
        let constant = table.is_constant.then(|| table.at(planes, cos_angle, 0));
        Self { table, planes, cos_angle, precision, constant }
    }

    /// Works with one block of wavelengths.
    #[inline(always)]
    pub(crate) fn with_block(&self, block: usize, work: impl FnOnce(&Block<'_, N>)) {
        let dispersed;
        let media = if let Some(media) = &self.constant {
            media
        } else {
            dispersed = self.table.at(self.planes, self.cos_angle, block);
            &dispersed
        };
        let half_turns_per_nm = &self.table.half_turns_per_nm[block];
        work(&Block { table: self.table, half_turns_per_nm, media, precision: self.precision });
    }
}

impl<const N: usize> Block<'_, N> {
    /// R, T and A of a stack of the media that this light meets.
    pub(crate) fn shares(&self, stack: &LayerStack) -> Shares {
        let mut shares = [[0.0; LANES]; 3];
        if self.table.is_isotropic {
            self.add_shares::<true>(stack, &mut shares);
        } else {
            self.add_shares::<false>(stack, &mut shares);
        }
        shares
    }

    #[inline(always)]
    fn add_shares<const ALIKE: bool>(&self, stack: &LayerStack, shares: &mut Shares) {
        let (waves, turns) = (&self.media.waves, self.half_turns_per_nm);
        if !self.media.is_lossless {
            return absorbing::add_shares::<N, ALIKE>(
                stack,
                self.table.absorbs,
                waves,
                turns,
                shares,
            );
        }
        if self.precision == Precision::Single {
            lossless::add_shares::<f32, N, ALIKE>(stack, waves, turns, shares);
            // Media of extreme contrast overflow it; double precision holds what is allowed.
            let sum = (0..LANES).fold(0.0, |sum, i| sum + shares[0][i] + shares[1][i]);
            if sum.is_finite() {
                return;
            }
            *shares = [[0.0; LANES]; 3];
        }
        lossless::add_shares::<f64, N, ALIKE>(stack, waves, turns, shares);
    }
}
