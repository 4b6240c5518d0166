use crate::{Medium, NacreError, error::within};

/// The most layers a stack may have. The thickest nacre known to us, a keshi, has 2615.
pub const MAX_LAYERS: usize = 5000;

/// The thickest single layer. Chalky shell reaches 1.25 um; a millimetre is no longer a layer.
const MAX_THICKNESS_NM: f64 = 1e6;

/// Aragonite layers from the surface inward, each followed by a protein layer, then the substrate.
///
/// A value of this type is always valid: 1 to [`MAX_LAYERS`] layers, every thickness positive and
/// finite, every medium as [`Medium`] promises.
///
/// ```
/// use nacreous_nacre::{Index, LayerStack};
/// let (air, aragonite, protein) =
///     (Index::new("air", 1.0, 0.0)?, Index::new("aragonite", 1.53, 0.0)?, Index::new("protein", 1.43, 0.0)?);
/// let stack = LayerStack::new(vec![410.0, 395.0], 20.0, aragonite, protein, air, aragonite)?;
/// assert_eq!(stack.total_um(), 0.845);
/// # Ok::<(), nacreous_nacre::NacreError>(())
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct LayerStack {
    thickness_nm: Vec<f64>,
    protein_nm: f64,
    aragonite: Medium,
    protein: Medium,
    ambient: Medium,
    substrate: Medium,
}

/// The aragonite layers of a stack down to some depth, in two numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Thickness {
    /// How many layers were counted.
    pub layers: usize,
    /// Their mean thickness.
    pub mean_nm: f64,
    /// The standard deviation of their thickness (over all of them, not an estimate).
    pub spread_nm: f64,
}

impl LayerStack {
    /// `thickness_nm` counts from the surface inward; 0 < thickness <= 1e6 nm, 0 <= `protein_nm` <= 1e6.
    ///
    /// # Errors
    /// [`NacreError::LayerCount`] for none or more than [`MAX_LAYERS`], [`NacreError::OutOfRange`]
    /// naming the first bad layer.
    pub fn new(
        thickness_nm: Vec<f64>,
        protein_nm: f64,
        aragonite: impl Into<Medium>,
        protein: impl Into<Medium>,
        ambient: impl Into<Medium>,
        substrate: impl Into<Medium>,
    ) -> Result<Self, NacreError> {
        if !(1..=MAX_LAYERS).contains(&thickness_nm.len()) {
            return Err(NacreError::LayerCount(thickness_nm.len()));
        }
        for (layer, &thickness) in thickness_nm.iter().enumerate() {
            if !(thickness > 0.0 && thickness <= MAX_THICKNESS_NM) {
                return Err(NacreError::OutOfRange {
                    quantity: format!("thickness_nm[{layer}]"),
                    value: thickness,
                    allowed: "above 0, up to 1000000 nm",
                });
            }
        }
        within("protein_nm", protein_nm, 0.0..=MAX_THICKNESS_NM, "0 to 1000000 nm")?;
        Ok(Self {
            thickness_nm,
            protein_nm,
            aragonite: aragonite.into(),
            protein: protein.into(),
            ambient: ambient.into(),
            substrate: substrate.into(),
        })
    }

    /// The same media with other layers.
    ///
    /// # Errors
    /// As [`LayerStack::new`].
    pub fn with_layers(&self, thickness_nm: Vec<f64>) -> Result<Self, NacreError> {
        let Self { protein_nm, aragonite, protein, ambient, substrate, .. } = self.clone();
        Self::new(thickness_nm, protein_nm, aragonite, protein, ambient, substrate)
    }

    /// Thickness of the aragonite layers, surface first.
    pub fn thickness_nm(&self) -> &[f64] {
        &self.thickness_nm
    }

    /// Thickness of every protein layer.
    pub fn protein_nm(&self) -> f64 {
        self.protein_nm
    }

    /// Medium of the aragonite layers, index n1 of the paper.
    pub fn aragonite(&self) -> &Medium {
        &self.aragonite
    }

    /// Medium of the protein layers, index n2 of the paper.
    pub fn protein(&self) -> &Medium {
        &self.protein
    }

    /// What surrounds the pearl, index n0 of the paper.
    pub fn ambient(&self) -> &Medium {
        &self.ambient
    }

    /// What lies under the innermost layer.
    pub fn substrate(&self) -> &Medium {
        &self.substrate
    }

    /// Whether layers, surroundings and substrate are made of the same as the other stack's.
    pub fn has_media_of(&self, other: &Self) -> bool {
        self.aragonite == other.aragonite
            && self.protein == other.protein
            && self.ambient == other.ambient
            && self.substrate == other.substrate
    }

    /// Thickness of the whole nacre, protein included.
    pub fn total_um(&self) -> f64 {
        let aragonite_nm: f64 = self.thickness_nm.iter().sum();
        (aragonite_nm + self.thickness_nm.len() as f64 * self.protein_nm) / 1e3
    }

    /// Mean and spread of the aragonite layers that begin within `depth_um` of the surface.
    ///
    /// The trade's reports give them for the outer 10 and 50 um, which decide the look. The first
    /// layer is always counted.
    pub fn outer(&self, depth_um: f64) -> Thickness {
        let mut top_nm = 0.0;
        let within_depth = self.thickness_nm.iter().take_while(|&&thickness| {
            let begins_nm = top_nm;
            top_nm += thickness + self.protein_nm;
            begins_nm <= (depth_um * 1e3).max(0.0)
        });
        let counted: Vec<f64> = within_depth.copied().collect();
        let layers = counted.len();
        let mean_nm = counted.iter().sum::<f64>() / layers as f64;
        let variance = counted.iter().map(|d| (d - mean_nm).powi(2)).sum::<f64>() / layers as f64;
        Thickness { layers, mean_nm, spread_nm: variance.sqrt() }
    }
}
