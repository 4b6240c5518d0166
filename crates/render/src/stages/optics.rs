//! First stage: what each pearl does with light, the same in all its places.

mod sharing;

use std::{cell::RefCell, sync::Arc};

use nacreous_image::{
    Coat, CoatParameters, Film, FilmDraft, FilmParts, FilmSampling, Microfacets, Progress,
    Response, Rgb, Rings, Skin, Surface, TorranceSparrow, Waviness, grain::texture::Texture,
    parallel,
};
use nacreous_optics::IlluminantModel;

use super::{kept::Kept, work::Work};
use crate::{
    RenderError, Resources,
    lights::{Lights, LightsKey},
    pearl::{
        body::body_of,
        coat::{FILM_STEP, films_of, parameters_of as coat_parameters_of, thickness_of},
        columns::columns_of,
        grain::{GrainKey, is_seen},
        knobs::{facet_spread_rad_of, grain_of, outer_um_of, parameters_of, spread_of},
        nacre::stack_of,
    },
    spec::{
        nacre::NacreSpec,
        pearl::{BodySpec, FacetsSpec, FilmSpec, IlluminantSpec, PearlSpec, TransportSpec},
    },
};

/// A pearl before its light is known.
#[derive(Debug, Clone)]
pub(crate) enum Optics {
    /// The paper's model of 1996.
    Illuminant { rings: Arc<Rings>, look: Look },
    /// Light through the film, into the pearl and out again.
    Transport { response: Arc<Response> },
}

/// What the model of 1996 asks of a pearl beside its layers.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Look {
    pub(crate) facets: TorranceSparrow,
    pub(crate) mixing: f64,
    pub(crate) body_colour: Rgb,
    pub(crate) mirror_weight: f64,
    pub(crate) falloff_mm: f64,
}

/// What a film is made from.
#[derive(Debug, Clone, PartialEq)]
struct FilmKey {
    nacre: NacreSpec,
    film: FilmSpec,
    outer_um: f64,
    parts: FilmParts,
    /// For layers so many times as thick, by even steps.
    count: usize,
}

/// What a film on facets is made from.
#[derive(Debug, Clone, PartialEq)]
struct SurfaceKey {
    film: FilmKey,
    facets: FacetsSpec,
    spread_rad: f64,
    waviness: Waviness,
}

/// What a pearl's response to light is made from.
#[derive(Debug, Clone, PartialEq)]
struct ResponseKey {
    surface: SurfaceKey,
    body: BodySpec,
    spread: f64,
    diameter_mm: f64,
    lights: LightsKey,
}

/// What rings of interference colour are made from.
#[derive(Debug, Clone, PartialEq)]
struct RingsKey {
    nacre: NacreSpec,
    model: IlluminantModel,
    lights: LightsKey,
}

/// The optics of all pearls, kept.
#[derive(Debug)]
pub(crate) struct OpticsStage {
    sampling: FilmSampling,
    films: Kept<FilmKey, Vec<Film>>,
    /// The film that is being made, where work ended amid it.
    begun: RefCell<Option<(FilmKey, FilmDraft)>>,
    surfaces: Kept<SurfaceKey, Vec<Surface>>,
    responses: Kept<ResponseKey, Response>,
    rings: Kept<RingsKey, Rings>,
    textures: Kept<GrainKey, Texture>,
    coats: Kept<CoatParameters, Coat>,
}

impl OpticsStage {
    /// Nothing yet, of films that are asked so densely.
    pub(crate) fn new(sampling: FilmSampling) -> Self {
        Self {
            sampling,
            films: Kept::default(),
            begun: RefCell::default(),
            surfaces: Kept::default(),
            responses: Kept::default(),
            rings: Kept::default(),
            textures: Kept::default(),
            coats: Kept::default(),
        }
    }

    /// The optics of each pearl; `None` where `work` ends before.
    pub(crate) fn optics(
        &mut self,
        pearls: &[PearlSpec],
        (lights_key, lights): (&LightsKey, &Lights),
        work: &Work<'_>,
    ) -> Result<Option<Vec<Optics>>, RenderError> {
        let Some(responses) = self.responses(pearls, (lights_key, lights), work)? else {
            return Ok(None);
        };
        let illuminant = pearls.iter().filter_map(|pearl| match pearl {
            PearlSpec::Transport(_) => None,
            PearlSpec::Illuminant(spec) => Some(rings_key(pearl, spec, lights_key)),
        });
        let make = |key: &RingsKey| {
            work.piece(|progress| {
                let stack = stack_of(&key.nacre)?;
                Ok::<_, RenderError>(Rings::new(&stack, &key.model, &lights.light, progress)?)
            })
        };
        let Some(rings) = self.rings.all(illuminant.collect(), make)? else { return Ok(None) };
        let (mut responses, mut rings) = (responses.into_iter(), rings.into_iter());
        let mut all = Vec::with_capacity(pearls.len());
        for pearl in pearls {
            all.extend(match pearl {
                PearlSpec::Transport(_) => {
                    responses.next().map(|response| Optics::Transport { response })
                }
                PearlSpec::Illuminant(spec) => {
                    let look = look_of(pearl, spec)?;
                    rings.next().map(|rings| Optics::Illuminant { rings, look })
                }
            });
        }
        Ok(Some(all))
    }

    /// The response to light of each pearl of the transport model.
    fn responses(
        &mut self,
        pearls: &[PearlSpec],
        (lights_key, lights): (&LightsKey, &Lights),
        work: &Work<'_>,
    ) -> Result<Option<Vec<Arc<Response>>>, RenderError> {
        let specs: Vec<(&PearlSpec, &TransportSpec)> = pearls
            .iter()
            .filter_map(|pearl| match pearl {
                PearlSpec::Transport(spec) => Some((pearl, &**spec)),
                PearlSpec::Illuminant(_) => None,
            })
            .collect();
        let keys: Vec<SurfaceKey> =
            specs.iter().map(|(pearl, spec)| surface_key(pearl, spec)).collect();
        let Some(surfaces) = self.surfaces(&keys, work)? else { return Ok(None) };
        let response_keys = specs.iter().zip(&keys).map(|((_, spec), surface)| ResponseKey {
            surface: surface.clone(),
            body: spec.body.clone(),
            spread: spread_of(spec),
            diameter_mm: spec.diameter_mm,
            lights: lights_key.clone(),
        });
        let response_keys: Vec<ResponseKey> = response_keys.collect();
        let make = |key: &ResponseKey| {
            // Equal keys are made once, by the first of their pearls.
            let Some(first) = response_keys.iter().position(|known| known == key) else {
                return Ok(None);
            };
            work.piece(|progress| {
                let (surface, body) = (&surfaces[first], body_of(specs[first].1)?);
                let surfaces = (surface.as_slice(), FILM_STEP);
                let response = Response::new(surfaces, &body, &lights.palette, &lights.lamp_bands);
                Ok::<_, RenderError>((!progress.is_stopped()).then_some(response))
            })
        };
        self.responses.all(response_keys.clone(), make)
    }

    /// What differs from place to place of each pearl. `None` where `work` ends before.
    pub(crate) fn skins(
        &mut self,
        pearls: &[PearlSpec],
        resources: &Resources,
        pixel_mm: f64,
        work: &Work<'_>,
    ) -> Result<Option<Vec<Skin>>, RenderError> {
        let Some(textures) = self.textures(pearls, resources, pixel_mm, work)? else {
            return Ok(None);
        };
        let Some(coats) = self.coats(pearls, work)? else { return Ok(None) };
        let skin = |(pearl, (texture, coat))| Skin { texture, grain: grain_of(pearl), coat };
        Ok(Some(pearls.iter().zip(textures.into_iter().zip(coats)).map(skin).collect()))
    }

    /// The grain of each pearl that shows any; pearls of the same grain share it. `None` where `work` ends
    /// before.
    fn textures(
        &mut self,
        pearls: &[PearlSpec],
        resources: &Resources,
        pixel_mm: f64,
        work: &Work<'_>,
    ) -> Result<Option<Vec<Option<Arc<Texture>>>>, RenderError> {
        let seen: Vec<bool> = pearls.iter().map(|pearl| is_seen(&grain_of(pearl))).collect();
        let keys = pearls.iter().enumerate().filter(|(i, _)| seen[*i]);
        let keys = keys
            .map(|(i, pearl)| GrainKey::new(pearl, resources.grains.get(&i), pixel_mm))
            .collect::<Result<Vec<_>, _>>()?;
        let make = |key: &GrainKey| work.piece(|_| key.texture().map(Some));
        let Some(textures) = self.textures.all(keys, make)? else { return Ok(None) };
        let mut textures = textures.into_iter();
        let of_seen = |seen: bool| if seen { textures.next() } else { None };
        Ok(Some(seen.into_iter().map(of_seen).collect()))
    }

    /// The coat of each pearl, where it differs from place to place. `None` where `work` ends before.
    fn coats(
        &mut self,
        pearls: &[PearlSpec],
        work: &Work<'_>,
    ) -> Result<Option<Vec<Option<Arc<Coat>>>>, RenderError> {
        let made_from: Vec<Option<CoatParameters>> =
            pearls.iter().map(coat_parameters_of).collect::<Result<_, _>>()?;
        let keys = made_from.iter().flatten().cloned().collect();
        let make = |key: &CoatParameters| {
            work.piece(|_| Ok::<_, RenderError>(Some(Coat::new(key.clone()))))
        };
        let Some(coats) = self.coats.all(keys, make)? else { return Ok(None) };
        let mut coats = coats.into_iter();
        Ok(Some(made_from.iter().map(|key| key.as_ref().and_then(|_| coats.next())).collect()))
    }

    fn surfaces(
        &mut self,
        keys: &[SurfaceKey],
        work: &Work<'_>,
    ) -> Result<Option<Vec<Arc<Vec<Surface>>>>, RenderError> {
        let (begun, sampling) = (&self.begun, self.sampling);
        let film = |key: &FilmKey| {
            let before = begun.take().filter(|(known, _)| known == key).map(|(_, draft)| draft);
            let mut draft = match before {
                Some(draft) => draft,
                None => FilmDraft::new(
                    columns_of(&key.nacre, &key.film, key.outer_um)?,
                    key.parts,
                    sampling,
                ),
            };
            loop {
                let add = |progress: &Progress| draft.add(work.film_angles, progress.stop_flag());
                match work.piece(add)? {
                    Some(true) => {
                        let films = thickness_of(key.count).map(|share| draft.film_of(share));
                        let films = films.collect::<Result<Vec<_>, _>>()?;
                        return Ok::<_, RenderError>(Some(films));
                    }
                    Some(false) => {}
                    None => {
                        begun.replace(Some((key.clone(), draft)));
                        return Ok(None);
                    }
                }
            }
        };
        let film_keys = keys.iter().map(|key| key.film.clone()).collect();
        let Some(films) = self.films.all(film_keys, film)? else { return Ok(None) };
        let is_whole = sampling == FilmSampling::WHOLE;
        let film_of = |wanted: &SurfaceKey| {
            let place = keys.iter().position(|key| key.film == wanted.film);
            place.map(|place| &films[place])
        };
        let surface = |key: &SurfaceKey| {
            let microfacets = microfacets(key.facets, key.spread_rad);
            let new = if is_whole { Surface::new } else { Surface::quick };
            let surface = |film: &Film| new(film, microfacets, key.waviness);
            Ok(film_of(key).map(|films| parallel::map(films.len(), |i| surface(&films[i]))))
        };
        self.surfaces.all(keys.to_vec(), surface)
    }
}

/// The facets of a pearl's surface.
pub(crate) fn microfacets_of(pearl: &PearlSpec) -> Microfacets {
    let facets = match pearl {
        PearlSpec::Transport(spec) => spec.surface.facets,
        PearlSpec::Illuminant(_) => FacetsSpec::TorranceSparrow,
    };
    microfacets(facets, facet_spread_rad_of(pearl))
}

fn microfacets(facets: FacetsSpec, spread_rad: f64) -> Microfacets {
    match facets {
        FacetsSpec::TorranceSparrow => Microfacets::grooves(spread_rad),
        FacetsSpec::Ggx => Microfacets::ggx(spread_rad),
    }
}

fn surface_key(pearl: &PearlSpec, spec: &TransportSpec) -> SurfaceKey {
    let (nacre, film) = (spec.nacre.clone(), spec.film.clone());
    let waviness = Waviness::new(spec.surface.waviness_rad);
    SurfaceKey {
        film: FilmKey {
            nacre,
            film,
            outer_um: outer_um_of(spec),
            parts: waviness.parts(),
            count: films_of(spec),
        },
        facets: spec.surface.facets,
        spread_rad: facet_spread_rad_of(pearl),
        waviness,
    }
}

fn rings_key(pearl: &PearlSpec, spec: &IlluminantSpec, lights: &LightsKey) -> RingsKey {
    let how = &spec.interference;
    let diffuse_loss = how.diffuse_loss.unwrap_or_else(|| parameters_of(pearl).diffuse_loss);
    let (coherence_nm, threshold) = (how.coherence_nm, how.threshold);
    RingsKey {
        nacre: spec.nacre.clone(),
        model: IlluminantModel { coherence_nm, threshold, diffuse_loss },
        lights: lights.clone(),
    }
}

fn look_of(pearl: &PearlSpec, spec: &IlluminantSpec) -> Result<Look, RenderError> {
    let (knobs, surface) = (parameters_of(pearl), &spec.surface);
    let index = stack_of(&spec.nacre)?.aragonite().index("aragonite")?.n();
    Ok(Look {
        facets: TorranceSparrow::new(facet_spread_rad_of(pearl), index, surface.layer_reflectance),
        mixing: spec.interference.mixing.unwrap_or(knobs.mixing),
        body_colour: spec.body_colour.0,
        mirror_weight: surface.mirror_weight.unwrap_or(knobs.mirror_weight),
        falloff_mm: surface.falloff_mm,
    })
}
