//! Surroundings whose light has fallen: what the table and the walls send on.
//!
//! Soft light on the table is worked out on light maps where that is cheaper; lamps where they are looked up.
//! Left out: light that the walls receive from the pearls.

use std::ops::Deref;

use glam::DVec3;

use crate::{
    light::glow::Glow,
    rgb::{self, Rgb},
    surroundings::{
        environment::Surroundings,
        light_map::LightMap,
        table_light::{self, Reach},
        walls::WallLight,
    },
};

/// Surroundings in whose light pearls can be looked at.
///
/// A type of its own, so that no pearl is lit by a table that has not yet received its light, nor by one that
/// received it before the pearls sent out theirs.
#[derive(Debug, Clone)]
pub struct Lit {
    surroundings: Surroundings,
    /// Soft light on the table, near and far, where it is charted.
    table_lights: Vec<LightMap>,
    /// Light on the walls, where it is charted.
    wall_light: Option<WallLight>,
}

impl Deref for Lit {
    type Target = Surroundings;

    fn deref(&self) -> &Surroundings {
        &self.surroundings
    }
}

impl Surroundings {
    /// Lets the light fall. `charted` works out the soft light on table and walls once and for all, for
    /// scenes in which it is costly; else each place is worked out when it is seen.
    pub fn settled(self, charted: bool) -> Lit {
        let lit = Lit { surroundings: self, table_lights: Vec::new(), wall_light: None };
        if charted { lit.charted(table_light::FINE) } else { lit }
    }

    /// The same with light that each pearl sends out, in the order of the balls, and rough charts: for previews.
    pub fn roughly_settled(self, glows: Vec<Glow>) -> Lit {
        let surroundings = self.with_glows(glows);
        let lit = Lit { surroundings, table_lights: Vec::new(), wall_light: None };
        lit.charted(table_light::ROUGH)
    }
}

impl Lit {
    /// The same in the light that each pearl sends out, in the order of the balls, too. `charted` as for
    /// [`Surroundings::settled`].
    #[must_use]
    pub fn with_glows(mut self, glows: Vec<Glow>, charted: bool) -> Self {
        self.surroundings = self.surroundings.with_glows(glows);
        self.table_lights.clear();
        if charted { self.charted(table_light::FINE) } else { self }
    }

    /// The light that each pearl sends out, in the order of the balls.
    pub fn glows(&self) -> Vec<Glow> {
        self.balls.iter().map(|ball| ball.glow).collect()
    }

    fn charted(mut self, reaches: [Reach; 2]) -> Self {
        let around = &self.surroundings;
        if around.table.is_some() {
            let soft = |point| around.soft_light_on_table(point);
            let light_map =
                |reach| table_light::light_map(&around.balls, around.table_y_mm, reach, soft);
            self.table_lights = reaches.into_iter().filter_map(light_map).collect();
        }
        // Pearls are taken not to light the walls, so this holds whatever they send out.
        if let (Some(walls), None) = (&around.walls, &self.wall_light) {
            let light = |point, inward| around.light_on_wall(point, inward);
            self.wall_light = Some(WallLight::new(walls, around.table_y_mm, light));
        }
        self
    }

    /// Radiance of a white matt table at `point`: lamps past the pearls, the sky beside them, and where
    /// they hide it, their own glow.
    #[inline]
    pub(crate) fn light_on_table(&self, point: DVec3) -> Rgb {
        let known = self.table_lights.iter().find_map(|light| light.at([point.x, point.z]));
        let mut light = known.unwrap_or_else(|| self.soft_light_on_table(point));
        for lamp in &self.lamps {
            let toward = lamp.toward(point);
            if toward.y > 0.0 {
                let past = self.lamp_past(lamp, point, None);
                rgb::add(&mut light, rgb::scaled(lamp.brightness, toward.y * past));
            }
        }
        light
    }

    /// Radiance of a white matt wall at `point`.
    pub(crate) fn light_of_wall(&self, point: DVec3, inward: DVec3) -> Rgb {
        let charted = self.wall_light.as_ref().and_then(|light| light.at(point, inward));
        charted.unwrap_or_else(|| self.light_on_wall(point, inward))
    }
}
