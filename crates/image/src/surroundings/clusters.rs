//! Far balls on a table, taken together: how much of the sky they hide, and the light they send.
//!
//! A tree of clusters (Barnes and Hut 1986), each by its second moments where it is far off.
//! Left out: third moments, 0.0005 of the sky under 400 balls, and where in a cluster the brighter balls are: 0.015
//! of their glow where every third one is dark (the test below).

use glam::DVec3;

use crate::{
    light::glow::Glow,
    rgb::{self, Rgb},
    shape::ball::Ball,
};

/// A cluster stands for its balls where it is seen from this many times as far as its middle is from the
/// farthest of them (the test below says how right that is) **(ours)**.
const FAR: f64 = 5.0;

/// All balls as a tree: each cluster is followed by its two halves, down to single balls.
#[derive(Debug, Clone)]
pub(crate) struct ClusterTree(Vec<Cluster>);

#[derive(Debug, Clone)]
struct Cluster {
    /// Middle of the balls, weighted as below.
    centre: DVec3,
    /// Sum of the cubes of their radii, by which they count.
    cubes_mm3: f64,
    /// Mean of xx, xz and zz about the middle.
    moments_mm2: [f64; 3],
    /// From this distance on it stands for its balls.
    far_mm: f64,
    glow: Glow,
    glows: bool,
    /// The cluster after all that are part of this one.
    next: usize,
    /// The only ball.
    ball: Option<usize>,
}

/// What balls do to the light of the sky at a point of the table.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Hidden {
    /// Share of the sky's light that is left, as if they hid it independently of each other.
    pub(crate) past: f64,
    /// The shares that each hides, added up.
    pub(crate) shares: f64,
    /// Their glow, each by its share.
    pub(crate) glow: Rgb,
}

impl ClusterTree {
    pub(crate) fn new(balls: &[Ball]) -> Self {
        let mut tree = Self(Vec::with_capacity(2 * balls.len()));
        let mut all: Vec<usize> = (0..balls.len()).collect();
        if !all.is_empty() {
            tree.grow(balls, &mut all);
        }
        tree
    }

    /// Adds the cluster of some balls and, behind it, its halves.
    fn grow(&mut self, balls: &[Ball], members: &mut [usize]) {
        let own = self.0.len();
        self.0.push(Cluster::new(balls, members));
        if members.len() > 1 {
            let [xx, _, zz] = self.0[own].moments_mm2;
            let along = |i: &usize| if xx >= zz { balls[*i].centre.x } else { balls[*i].centre.z };
            members.sort_by(|a, b| along(a).total_cmp(&along(b)));
            let (low, high) = members.split_at_mut(members.len() / 2);
            self.grow(balls, low);
            self.grow(balls, high);
        }
        self.0[own].next = self.0.len();
    }

    /// What `balls`, those of the tree, hide of an even sky at a point of the table, and send there.
    pub(crate) fn hidden(&self, balls: &[Ball], point: DVec3) -> Hidden {
        let mut hidden = Hidden { past: 1.0, shares: 0.0, glow: [0.0; 3] };
        let (mut far, mut i) = (0.0, 0);
        while let Some(cluster) = self.0.get(i) {
            let from = point - cluster.centre;
            let distance_mm = from.length();
            i += 1;
            let share = if let Some(ball) = cluster.ball {
                let beside = balls[ball].sky_past(point);
                hidden.past *= beside;
                1.0 - beside
            } else if distance_mm > cluster.far_mm {
                i = cluster.next;
                let share = cluster.share(from, distance_mm);
                far += share;
                share
            } else {
                continue;
            };
            hidden.shares += share;
            if cluster.glows {
                let seen = cluster.glow.at(from / distance_mm);
                rgb::add(&mut hidden.glow, rgb::scaled(seen, share));
            }
        }
        if far > 0.0 {
            // The product over many balls that hide little each.
            hidden.past *= libm::exp(-far);
        }
        hidden
    }
}

impl Cluster {
    fn new(balls: &[Ball], members: &[usize]) -> Self {
        let cube = |i: usize| balls[i].radius_mm.powi(3);
        let cubes_mm3: f64 = members.iter().map(|&i| cube(i)).sum();
        let weight = |i: usize| cube(i) / cubes_mm3;
        let centre: DVec3 = members.iter().map(|&i| balls[i].centre * weight(i)).sum();
        let mut moments_mm2 = [0.0; 3];
        for &i in members {
            let from = balls[i].centre - centre;
            let products = [from.x * from.x, from.x * from.z, from.z * from.z];
            rgb::add(&mut moments_mm2, rgb::scaled(products, weight(i)));
        }
        let reach = |&i: &usize| balls[i].centre.distance(centre);
        let glow = Glow::mean(members.iter().map(|&i| (weight(i), balls[i].glow)));
        Self {
            centre,
            cubes_mm3,
            moments_mm2,
            far_mm: FAR * members.iter().map(reach).fold(0.0, f64::max),
            glows: glow != Glow::BLACK,
            glow,
            next: 0,
            ball: if let [one] = members { Some(*one) } else { None },
        }
    }

    /// The shares of the sky that its balls hide from afar, added up: each the cube of radius over distance,
    /// expanded about the middle to the second order.
    fn share(&self, from: DVec3, distance_mm: f64) -> f64 {
        let [xx, xz, zz] = self.moments_mm2;
        let square = 1.0 / (distance_mm * distance_mm);
        let along = xx * from.x * from.x + 2.0 * xz * from.x * from.z + zz * from.z * from.z;
        let second = 1.5 * square * (5.0 * along * square - xx - zz);
        self.cubes_mm3 * square / distance_mm * (1.0 + second)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clusters_hide_and_send_what_their_balls_do() {
        let glow = |i: usize| Glow::from_fn(|d| [1.0 + 0.3 * d.x, (i % 3) as f64, 0.5 - 0.4 * d.z]);
        let place = |i: usize| DVec3::new((i % 20) as f64 * 8.8, 0.0, (i / 20) as f64 * 8.8);
        let ball = |i| Ball { centre: place(i), glow: glow(i), ..Ball::alone(4.0) };
        let balls: Vec<Ball> = (0..400).map(ball).collect();
        let tree = ClusterTree::new(&balls);
        for i in 0..400 {
            let t = f64::from(i);
            let point = DVec3::new(0.5 * t - 20.0, -4.0, (0.37 * t * t) % 190.0 - 10.0);
            let beside = |ball: &Ball| ball.sky_past(point);
            let past: f64 = balls.iter().map(beside).product();
            let mut glow = [0.0; 3];
            for ball in &balls {
                let seen = ball.glow.at((point - ball.centre).normalize());
                rgb::add(&mut glow, rgb::scaled(seen, 1.0 - beside(ball)));
            }
            let found = tree.hidden(&balls, point);
            assert!((found.past - past).abs() < 5e-4, "{point}: {} {past}", found.past);
            // The worst case: every third ball dark in this colour. 0.011 is what is seen, 0.001 on average.
            for (found, put) in found.glow.into_iter().zip(glow) {
                assert!((found - put).abs() < 0.015 * put.max(1.0), "{point}: {found} {put}");
            }
        }
    }

    #[test]
    fn a_lone_ball_is_exact() {
        let ball = Ball::alone(4.0);
        let tree = ClusterTree::new(&[ball]);
        let point = DVec3::new(70.0, -4.0, 3.0);
        assert_eq!(tree.hidden(&[ball], point).past.to_bits(), ball.sky_past(point).to_bits());
        assert_eq!(ClusterTree::new(&[]).hidden(&[], point).past.to_bits(), 1.0_f64.to_bits());
    }
}
