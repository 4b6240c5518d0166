//! A pearl's coat: what its outer layers are like at every place.
//!
//! Relief, terraces, blemishes and the layers' thickness, each by its own file, put together.
//! Left out: cross terms; slopes add up.

use std::f64::consts::FRAC_PI_2;

use glam::DVec3;

use crate::coat::{
    blemish::{Blemishes, THICKER},
    drill::Drill,
    fields::Fields,
    layout::layout,
    local::Local,
    nucleus::{NucleusBands, Slices},
    pose::Pose,
    rulings::Rulings,
    spots::Spots,
    terraces::Terraces,
};

/// What a coat is made from. Zeros are an even pearl.
#[derive(Debug, Clone, PartialEq)]
pub struct CoatParameters {
    /// Of the pearl.
    pub radius_mm: f64,
    /// How it is turned.
    pub pose: Pose,
    /// What draws the fields.
    pub seed: u64,
    /// Standard deviation of the layers' thickness from place to place, as a share of it.
    pub thickness_spread: f64,
    /// Within this length the thickness is alike.
    pub patch_mm: f64,
    /// Share of the fields' variance that lies in bands about the axis of growth, 0 to 1.
    pub banding: f64,
    /// Share of the rest of that variance which changes with the angle that a place is seen at.
    pub liveliness: f64,
    /// Standard deviation of the lean of a hammered surface, in any one direction.
    pub hammering_rad: f64,
    /// Size of the dents.
    pub dent_mm: f64,
    /// Spacing of the growth front's terraces; none where it is 0.
    pub terrace_mm: f64,
    /// Height of a terrace.
    pub step_mm: f64,
    /// Pits, bumps and the like.
    pub blemishes: Blemishes,
    /// What shows of the nucleus.
    pub nucleus: NucleusBands,
    /// The hole along its axis.
    pub drill: Drill,
}

/// What a pearl's outer layers are like at every place.
#[derive(Debug)]
pub struct Coat {
    made_from: CoatParameters,
    fields: Option<Fields>,
    /// What the field of the thickness becomes at other angles, where it does.
    states: Option<Fields>,
    terraces: Option<Terraces>,
    spots: Option<Spots>,
    slices: Option<Slices>,
}

/// The fields, by number.
const THICKNESS: usize = 0;
const FRONT: usize = 1;
const DENTS: usize = 2;

/// So many standard deviations of the thickness are told apart; what lies beyond counts as these.
const MOST_SPREADS: f64 = 2.5;

/// A growth front is alike within this share of the pearl's radius **(ours)**.
const FRONT_RADII: f64 = 0.6;

impl CoatParameters {
    /// Whether it is the same everywhere.
    pub fn is_even(&self) -> bool {
        !self.has_fields()
            && self.nucleus.contrast <= 0.0
            && self.drill.radius_mm <= 0.0
            && self.blemishes.counts.iter().all(|(_, count)| *count == 0)
    }

    /// Whether the layers' thickness differs, and by how large a share at most.
    pub fn thickness_range(&self) -> f64 {
        let swollen = self.blemishes.counts.iter().any(|(_, count)| *count > 0);
        MOST_SPREADS * self.thickness_spread + if swollen { THICKER } else { 0.0 }
    }

    fn has_fields(&self) -> bool {
        self.thickness_spread > 0.0 || self.hammering_rad > 0.0 || self.terrace_mm > 0.0
    }
}

impl Coat {
    /// Draws the fields and places the blemishes: same parameters, same coat, on every machine.
    pub fn new(made_from: CoatParameters) -> Self {
        let radius_mm = made_from.radius_mm;
        let fields = made_from.has_fields().then(|| {
            let lengths =
                [made_from.patch_mm / radius_mm, FRONT_RADII, made_from.dent_mm / radius_mm];
            Fields::draw(lengths, made_from.banding, made_from.seed)
        });
        let terraces = fields.as_ref().filter(|_| made_from.terrace_mm > 0.0).map(|fields| {
            let steepness = fields.steepness()[FRONT];
            Terraces::new(made_from.step_mm, made_from.terrace_mm, steepness, radius_mm)
        });
        let is_live = made_from.thickness_spread > 0.0 && made_from.liveliness > 0.0;
        let states = is_live.then(|| {
            Fields::states(made_from.patch_mm / radius_mm, made_from.banding, made_from.seed)
        });
        let placed = layout(&made_from.blemishes, radius_mm);
        let spots = (!placed.is_empty()).then(|| Spots::new(placed, radius_mm));
        let bands = made_from.nucleus;
        let slices = (bands.contrast > 0.0).then(|| Slices::new(bands, made_from.seed));
        Self { made_from, fields, states, terraces, spots, slices }
    }

    /// Whether it is the same everywhere.
    pub(crate) fn is_even(&self) -> bool {
        let is_drilled = self.made_from.drill.radius_mm > 0.0;
        self.fields.is_none() && self.spots.is_none() && self.slices.is_none() && !is_drilled
    }

    /// Whether it may have edges as fine as a pixel.
    pub(crate) fn has_edges(&self) -> bool {
        self.terraces.is_some() || self.spots.is_some() || self.made_from.drill.radius_mm > 0.0
    }

    /// How the pearl is turned.
    pub(crate) fn pose(&self) -> &Pose {
        &self.made_from.pose
    }

    /// The place in a direction of the scene from the pearl's middle, `away_mm` from there and as wide as
    /// `footprint_mm`, seen at an angle of this cosine to the normal.
    pub(crate) fn at(
        &self,
        outward: DVec3,
        [away_mm, footprint_mm]: [f64; 2],
        cos_view: f64,
    ) -> Local {
        let own = self.pose().own(outward);
        let mut local = Local::EVEN;
        if let Some(fields) = &self.fields {
            local = local.and(self.smooth(fields, own, footprint_mm, cos_view));
        }
        if let Some(spots) = &self.spots {
            for blemish in spots.near(own) {
                let here = blemish.at(own, self.made_from.radius_mm, footprint_mm);
                local = here.map_or(local, |here| local.and(here));
            }
        }
        if let Some(slices) = &self.slices {
            local.inside = slices.at(own, self.made_from.radius_mm, footprint_mm);
        }
        let drill = &self.made_from.drill;
        if drill.radius_mm > 0.0
            && let Some(here) = drill.at(own, away_mm, footprint_mm)
        {
            local = local.and(here);
        }
        let rulings =
            local.rulings.map(|rulings| Rulings { up: self.pose().scene(rulings.up), ..rulings });
        Local { slope: self.pose().scene(local.slope), rulings, ..local }
    }

    /// The field of the thickness as it is seen: the flatter the view, the farther on its way through its states.
    fn seen_at(&self, cos_view: f64, own: DVec3, still: f64) -> f64 {
        let Some(states) = &self.states else { return still };
        let next = states.at(own).value.to_array().map(f64::from);
        let all = [still, next[0], next[1], next[2]];
        let way = (1.0 - cos_view).clamp(0.0, 1.0) * (all.len() - 1) as f64;
        let state = (way as usize).min(all.len() - 2);
        // The squares add up to one, so that the variance stays.
        let (sin, cos) = libm::sincos(FRAC_PI_2 * (way - state as f64));
        let live = all[state] * cos + all[state + 1] * sin;
        let liveliness = self.made_from.liveliness;
        // What both have in common, so that all of it together has variance one.
        let common = if state == 0 { cos } else { 0.0 };
        let (a, b) = ((1.0 - liveliness).sqrt(), liveliness.sqrt());
        (a * still + b * live) / (1.0 + 2.0 * a * b * common).sqrt()
    }

    /// What the fields make of a place.
    fn smooth(&self, fields: &Fields, own: DVec3, footprint_mm: f64, cos_view: f64) -> Local {
        let CoatParameters { radius_mm, thickness_spread, hammering_rad, .. } = self.made_from;
        let (here, mut local) = (fields.at(own), Local::EVEN);
        let spreads = self.seen_at(cos_view, own, f64::from(here.value[THICKNESS]));
        let spreads = spreads.clamp(-MOST_SPREADS, MOST_SPREADS);
        local.thickness = 1.0 + thickness_spread * spreads;
        if let Some(terraces) = &self.terraces {
            let (front, per_mm) = (here.value[FRONT], here.gradient(FRONT) / radius_mm);
            local = local.and(terraces.at(f64::from(front), per_mm, footprint_mm));
        }
        // In one direction of the two a slope has half of the square.
        let per_slope = hammering_rad * 2.0_f64.sqrt() / fields.steepness()[DENTS];
        local.slope += here.gradient(DENTS) * per_slope;
        local
    }
}
