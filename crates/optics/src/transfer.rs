use std::sync::atomic::{AtomicBool, Ordering};

use nacreous_nacre::LayerStack;

use crate::{
    OpticsError, Polarisation, grid,
    incidence::{self, Block, Use},
    media::Table,
    packing,
};

/// The exact answer: every wave in every layer, all reflections included, by 2x2 transfer matrices.
///
/// Layers are plane, smooth and coherent; media isotropic or uniaxial with their axis along the normal,
/// dispersive, absorbing, metals; total reflection is nothing special.
///
/// Source: M. Born and E. Wolf, Principles of Optics, 1.6, for the matrices; the admittances of a
/// uniaxial layer from its Maxwell equations (docs/optics.md).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct TransferModel {
    /// Of the incoming light.
    pub polarisation: Polarisation,
    /// `Single` computes stacks of lossless layers in single precision.
    pub precision: Precision,
    /// Where the light comes from.
    pub origin: Origin,
}

/// Where light comes from. Angles are those in the ambient in any case.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Origin {
    /// The ambient.
    #[default]
    Ambient,
    /// Aragonite above the first protein layer, which it has come to through the surface: what the surface
    /// itself mirrors is left out, and the outermost layer's thickness means nothing.
    Aragonite,
}

/// How exactly to compute.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Precision {
    /// Right to about 1e-13.
    #[default]
    Double,
    /// Faster, and right to 2e-4 (1e-5 rms) for 400 bilayers; for pictures that follow a hand.
    Single,
}

impl std::str::FromStr for Precision {
    type Err = OpticsError;

    fn from_str(name: &str) -> Result<Self, OpticsError> {
        match name {
            "double" => Ok(Self::Double),
            "single" => Ok(Self::Single),
            other => Err(OpticsError::Precision(other.chars().take(40).collect())),
        }
    }
}

/// Shares of the incoming energy, `[angle, wavelength]`, flat and row-major.
///
/// They add up to 1 wherever the ambient is lossless. In an absorbing ambient the incoming and the
/// reflected wave exchange energy, and shares of it lose their meaning.
#[derive(Debug, Clone, PartialEq)]
pub struct Energies {
    /// R, T and A one after the other. One table and not three: the allocator keeps it for the next
    /// call, and its pages need not be cleared again, which would cost as much as a thin stack.
    shares: Vec<f64>,
}

impl Energies {
    /// What comes back.
    pub fn reflectance(&self) -> &[f64] {
        self.share(0)
    }

    /// What arrives just inside the substrate.
    pub fn transmittance(&self) -> &[f64] {
        self.share(1)
    }

    /// What stays in the layers.
    pub fn absorptance(&self) -> &[f64] {
        self.share(2)
    }

    /// `[R T A, angle, wavelength]`.
    pub fn into_flat(self) -> Vec<f64> {
        self.shares
    }

    fn share(&self, which: usize) -> &[f64] {
        let values = self.shares.len() / 3;
        &self.shares[which * values..(which + 1) * values]
    }
}

impl TransferModel {
    /// R, T and A for angles of incidence from 0 to pi/2 and wavelengths from 1 to 1e6 nm.
    ///
    /// `None` once `stop` is set, which is looked at every few hundred microseconds.
    ///
    /// # Errors
    /// [`OpticsError`] for a value out of range, a medium that is not known at a wavelength, or an
    /// ambient whose index depends on direction.
    ///
    /// ```
    /// use nacreous_nacre::{LayerStack, Medium};
    /// use nacreous_optics::TransferModel;
    /// let named = |name| Medium::named(name).unwrap();
    /// let air = nacreous_nacre::Index::new("ambient", 1.0, 0.0)?;
    /// let stack = LayerStack::new(vec![380.0; 100], 20.0, named("aragonite"), named("chitin"), air, named("aragonite"))?;
    /// let shares = TransferModel::default().energies(&stack, &[0.0, 0.5], &[450.0, 550.0], &Default::default())?.unwrap();
    /// assert!((shares.reflectance()[3] + shares.transmittance()[3] - 1.0).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn energies(
        &self,
        stack: &LayerStack,
        angle_rad: &[f64],
        wavelength_nm: &[f64],
        stop: &AtomicBool,
    ) -> Result<Option<Energies>, OpticsError> {
        let media = table(stack, self.origin, angle_rad, wavelength_nm)?;
        let values = angle_rad.len() * wavelength_nm.len();
        let mut shares = vec![0.0; 3 * values];
        let (reflectance, others) = shares.split_at_mut(values);
        let (transmittance, absorptance) = others.split_at_mut(values);
        let tables = [reflectance, transmittance, absorptance];
        incidence::fill(*self, &media, angle_rad, tables, &Stack(stack), stop);
        Ok((!stop.load(Ordering::Relaxed)).then_some(Energies { shares }))
    }

    /// Whether [`Self::energies`] answers before another thread would have taken up the question, in some
    /// tens of microseconds; then it stays on the caller's thread.
    pub fn is_brief(stack: &LayerStack, angles: usize, wavelengths: usize) -> bool {
        grid::is_brief(packing::blocks(angles, wavelengths), stack.thickness_nm().len())
    }
}

/// The media of a question within its range.
pub(crate) fn table(
    stack: &LayerStack,
    origin: Origin,
    angle_rad: &[f64],
    wavelength_nm: &[f64],
) -> Result<Table, OpticsError> {
    grid::check(angle_rad, wavelength_nm)?;
    Ok(Table::new(stack, wavelength_nm)?.seen_from(origin))
}

struct Stack<'a>(&'a LayerStack);

impl Use<3> for Stack<'_> {
    fn bilayers(&self) -> usize {
        self.0.thickness_nm().len()
    }

    fn fill<const N: usize>(&self, block: &Block<'_, N>, tables: [&mut [f64]; 3]) {
        let shares = block.met(self.0.protein_nm()).shares(self.0);
        for (table, share) in tables.into_iter().zip(shares) {
            table.copy_from_slice(&share[..table.len()]);
        }
    }
}
