//! What previews of one size keep: what lobes see, the points under the pixels, what pixels look at, what lies behind, and a
//! film's view of the light.

use std::{convert::Infallible, sync::Arc};

use nacreous_image::{
    Backdrop, Camera, Canvas, Coat, Fineness, Glimpses, Lit, Points, Sitter, Skin, Subsurface,
    Veil, grain::texture::Texture,
};

use super::{
    kept::{Kept, Same},
    seen::{FacetsKey, Seen, fineness},
};
use crate::arrangement::Place;

/// What previews of a size keep.
#[derive(Debug, Default)]
pub(super) struct Sized {
    glimpses: Kept<GlimpsesKey, Glimpses>,
    points: Kept<PointsKey, Points>,
    canvas: Kept<CanvasKey, Canvas>,
    backdrop: Kept<BackdropKey, Backdrop>,
    veils: Kept<VeilKey, Veil>,
}

/// What the lobes of one pearl see is made from, but for the index of its film.
#[derive(Debug, Clone, PartialEq)]
struct GlimpsesKey {
    lit: Same<Lit>,
    camera: Camera,
    ball: usize,
    facets: FacetsKey,
    fineness: Fineness,
}

/// The points under the pixels are made from.
#[derive(Debug, Clone, PartialEq)]
struct PointsKey {
    places: Vec<Place>,
    camera: Camera,
    size_px: usize,
    skins: Vec<SkinKey>,
}

/// What pixels look at is made from.
#[derive(Debug, Clone, PartialEq)]
struct CanvasKey {
    /// Not the points themselves, which would outlive their time in it.
    points: PointsKey,
    /// How steep the grain of each pearl is.
    relief_rad: Vec<f64>,
    /// Where there are lamps, whose images they show.
    lamps: Option<(Same<Lit>, Vec<FacetsKey>)>,
}

/// What lies behind is made from.
#[derive(Debug, Clone, PartialEq)]
struct BackdropKey {
    lit: Same<Lit>,
    camera: Camera,
    size_px: usize,
}

/// A film's view of light is made from; light inside knows the film.
#[derive(Debug, Clone, PartialEq)]
struct VeilKey {
    glimpses: Same<Glimpses>,
    inside: Same<Subsurface>,
    ball: usize,
}

/// The grain of a pearl, whether it is steep at all, and its coat.
type SkinKey = (Option<Same<Texture>>, bool, Option<Same<Coat>>);

impl Sized {
    /// What each pearl's lobes see of it; `None` for a camera within a pearl.
    pub(super) fn glimpses(&mut self, seen: &Seen<'_>) -> Option<Vec<Arc<Glimpses>>> {
        let camera = seen.before.arrangement.camera();
        let fineness = fineness(seen.asked.size_px);
        let key = |ball| GlimpsesKey {
            lit: Same(Arc::clone(seen.lit)),
            camera,
            ball,
            facets: seen.facets(ball),
            fineness,
        };
        let make = |key: &GlimpsesKey| {
            let response = seen.response(key.ball).0;
            Ok::<_, Infallible>(Glimpses::new(&response, seen.lit, key.ball, &camera, fineness))
        };
        let Ok(made) = self.glimpses.all(seen.balls().map(key).collect(), make);
        made
    }

    /// What each pixel looks at.
    pub(super) fn canvas(
        &mut self,
        seen: &Seen<'_>,
        glimpses: &[Arc<Glimpses>],
    ) -> Option<Arc<Canvas>> {
        let Seen { before, lit, .. } = seen;
        let key = points_key(seen);
        let points = self.points(seen, key.clone())?;
        let has_lamps = !lit.lamps.is_empty();
        let key = CanvasKey {
            points: key,
            relief_rad: before.skins.iter().map(|skin| skin.grain.relief_rad).collect(),
            lamps: has_lamps.then(|| {
                (Same(Arc::clone(lit)), seen.balls().map(|ball| seen.facets(ball)).collect())
            }),
        };
        let make = |key: &CanvasKey| {
            let sitter = |(ball, place): (usize, &Place)| {
                let skin = &before.skins[place.pearl];
                let response = &seen.responses[place.pearl];
                Sitter::new(skin, &glimpses[ball], response, lit)
            };
            let sitters: Vec<_> = key.points.places.iter().enumerate().map(sitter).collect();
            Ok::<_, Infallible>(Some(Canvas::new(&points, &sitters, lit, &key.points.camera)))
        };
        let Ok(made) = self.canvas.one(key, make);
        made
    }

    /// The points under the pixels.
    fn points(&mut self, seen: &Seen<'_>, key: PointsKey) -> Option<Arc<Points>> {
        let make = |key: &PointsKey| {
            let skin = |place: &Place| &seen.before.skins[place.pearl];
            let skins: Vec<&Skin> = key.places.iter().map(skin).collect();
            let points = Points::new(&skins, seen.lit, &key.camera, key.size_px);
            Ok::<_, Infallible>(Some(points))
        };
        let Ok(made) = self.points.one(key, make);
        made
    }

    /// What lies behind.
    pub(super) fn backdrop(&mut self, seen: &Seen<'_>) -> Option<Arc<Backdrop>> {
        let (camera, size_px) = (seen.before.arrangement.camera(), seen.asked.size_px);
        let key = BackdropKey { lit: Same(Arc::clone(seen.lit)), camera, size_px };
        let make =
            |_: &BackdropKey| Ok::<_, Infallible>(Some(Backdrop::new(seen.lit, &camera, size_px)));
        let Ok(made) = self.backdrop.one(key, make);
        made
    }

    /// The light in and around each pearl, by its net.
    pub(super) fn veils(
        &mut self,
        seen: &Seen<'_>,
        glimpses: &[Arc<Glimpses>],
        inside: &[Arc<Subsurface>],
    ) -> Option<Vec<Arc<Veil>>> {
        let key = |ball: usize| VeilKey {
            glimpses: Same(Arc::clone(&glimpses[ball])),
            inside: Same(Arc::clone(&inside[ball])),
            ball,
        };
        let camera = seen.before.arrangement.camera();
        let make = |key: &VeilKey| {
            let response = seen.response(key.ball).0;
            let before = (&camera, &seen.lit.balls[key.ball]);
            let veil = Veil::new(&key.glimpses.0, &response, &key.inside.0, before);
            Ok::<_, Infallible>(Some(veil))
        };
        let Ok(made) = self.veils.all(seen.balls().map(key).collect(), make);
        made
    }
}

fn points_key(Seen { before, asked, .. }: &Seen<'_>) -> PointsKey {
    let skin = |skin: &Skin| {
        let (texture, coat) = (skin.texture.clone(), skin.coat.clone());
        (texture.map(Same), skin.grain.relief_rad > 0.0, coat.map(Same))
    };
    PointsKey {
        places: before.arrangement.places().to_vec(),
        camera: before.arrangement.camera(),
        size_px: asked.size_px,
        skins: before.skins.iter().map(skin).collect(),
    }
}
