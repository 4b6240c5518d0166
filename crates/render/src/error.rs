//! Why a picture cannot be made.

use nacreous_colour::ColourError;
use nacreous_image::grain::spectrum::GrainError;
use nacreous_nacre::NacreError;
use nacreous_optics::OpticsError;

/// Why a picture cannot be made, in one line: the quantity, its value, what is allowed.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RenderError {
    /// JSON that is no recipe.
    #[error("recipe: {0}")]
    Recipe(String),
    /// A quantity of the recipe that cannot be.
    #[error("{quantity} is {value}; allowed: {allowed}")]
    OutOfRange {
        /// The quantity, by its public name.
        quantity: String,
        /// What was given.
        value: String,
        /// What may be.
        allowed: String,
    },
    /// Keys of the scene that do not fit the pearls.
    #[error("scene {scene}: {fault}")]
    Scene {
        /// The scene's name.
        scene: String,
        /// What is wrong, with what is allowed.
        fault: String,
    },
    /// A file whose contents were not handed over.
    #[error("{0}: its contents were not handed over with the recipe")]
    Missing(String),
    /// A light or a colour that cannot be.
    #[error(transparent)]
    Colour(#[from] ColourError),
    /// Layers that cannot be.
    #[error(transparent)]
    Nacre(#[from] NacreError),
    /// Optics that cannot be.
    #[error(transparent)]
    Optics(#[from] OpticsError),
    /// A grain that cannot be.
    #[error(transparent)]
    Grain(#[from] GrainError),
}

impl RenderError {
    /// Of work that other jobs did on something else.
    pub(crate) fn parts() -> Self {
        Self::out_of_range("parts", "those of other work", "all parts of the work that comes next")
    }

    /// A fault of one quantity.
    pub(crate) fn out_of_range(
        quantity: impl Into<String>,
        value: impl std::fmt::Debug,
        allowed: impl Into<String>,
    ) -> Self {
        let (quantity, allowed) = (quantity.into(), allowed.into());
        Self::OutOfRange { quantity, value: format!("{value:?}"), allowed }
    }

    /// A fault of the scene.
    pub(crate) fn scene(scene: &str, fault: impl Into<String>) -> Self {
        Self::Scene { scene: scene.to_owned(), fault: fault.into() }
    }
}
