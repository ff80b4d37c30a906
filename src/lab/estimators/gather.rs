//! The gather integral in seven steps: one source for the half disk and the hemisphere.
//!
//! `L = Le + albedo · LAMBERT · (direct + ∫ Li cos θ dω)`, and the radiance `Li` that arrives is
//! the same question at the next surface. Each surface asks in `N` directions, so the rays of
//! depth `d` are `N^d`.
//!
//! Simulates `LD{1,d+1}E` and `LE` among diffuse surfaces, cut off at a given depth: what further
//! bounces would add is missing (`albedo^(d + 1)` of it in a furnace).
//!
//! Sources: the essay's algorithm, steps 1 to 7; Cook, Porter, Carpenter, Distributed Ray Tracing
//! (SIGGRAPH 1984), for the branching tree; Kajiya, The Rendering Equation (SIGGRAPH 1986), for the
//! density, the cosine and the BRDF, of which the essay's formula has none.

use super::directions::{Drawn, Recipe};
use crate::color::Rgb;
use crate::integrators::Integrator;
use crate::integrators::world::World;
use crate::sampling::stream::{Numbers, Purpose, Stream};
use crate::scene::Tracer;
use crate::space::{Ray, Solid, Space};

/// Gathers light over surfaces, `samples` directions at each, `depth` surfaces deep.
#[derive(Clone, Copy, Debug)]
pub struct Gather {
    /// Directions at each surface, at least 1.
    pub samples: u32,
    /// Levels of directions: 0 is direct light only.
    pub depth: u32,
    /// How the directions are chosen.
    pub recipe: Recipe,
}

impl Gather {
    /// Radiance that arrives along a ray from the eye.
    pub fn li<S: Space>(&self, world: &mut impl World<S>, ray: &Ray<S>, stream: &Stream) -> Rgb {
        let hit = world.intersect(ray, 1);
        // The eye looks straight at lamps, also at those which surfaces aim at.
        let emitted = world.emitted(ray, hit.as_ref());
        match hit {
            Some(hit) => emitted + self.reflected(world, &hit, stream),
            None => emitted,
        }
    }

    /// Radiance that a surface reflects, the root of a tree of rays.
    pub fn reflected<S: Space, W: World<S>>(
        &self,
        world: &mut W,
        at: &W::Point,
        stream: &Stream,
    ) -> Rgb {
        self.reflected_at(world, at, 0, self.depth, stream)
    }

    /// The rays of the whole tree, the one from the eye included, where every ray hits something:
    /// `1 + N + N² + ... + N^depth`.
    pub fn rays(&self) -> u64 {
        let n = u64::from(self.samples);
        (0..self.depth).fold(1, |rays, _| rays * n + 1)
    }

    // ANCHOR: steps
    fn reflected_at<S: Space, W: World<S>>(
        &self,
        world: &mut W,
        at: &W::Point,
        node: u64,
        levels: u32,
        stream: &Stream,
    ) -> Rgb {
        let direct = irradiance(world, at, node, stream);
        let surface = world.diffuse(at);
        if levels == 0 {
            return step7_combine::<S>(surface.albedo, direct, Rgb::BLACK);
        }
        let frame = S::frame(surface.n);
        let mut sum = [0.0; 3];
        for index in 0..self.samples {
            let child = child(node, self.samples, index);
            let mut numbers = stream.at(child, Purpose::Direction);
            let drawn = step1_direction::<S>(self.recipe, index, self.samples, &mut numbers);
            let ray = surface.spawn(step2_turn::<S>(&frame, drawn.w));
            let li = self.step3_look(world, at, &ray, child, levels - 1, stream);
            let li_cos = step4_cosine::<S>(li, drawn.w);
            step5_add(&mut sum, li_cos, drawn.pdf);
        }
        let indirect = step6_mean(sum, self.samples);
        step7_combine::<S>(surface.albedo, direct, indirect)
    }
    // ANCHOR_END: steps

    /// Step 3: look along the ray. What it meets sends the light it reflects, and that is taken to
    /// arrive here.
    ///
    /// Exact for diffuse surfaces, which look the same from everywhere; a mirror would have to be
    /// asked for this very direction. A ray that meets nothing brings the light of the surrounding.
    fn step3_look<S: Space, W: World<S>>(
        &self,
        world: &mut W,
        from: &W::Point,
        ray: &Ray<S>,
        node: u64,
        levels: u32,
        stream: &Stream,
    ) -> Rgb {
        let hit = world.intersect(ray, 2 + self.depth - levels);
        // A lamp that the surface behind us aims at was counted there.
        let mut li = Rgb::BLACK;
        if world.pdf_light(from, ray, hit.as_ref()) == 0.0 {
            li = world.emitted(ray, hit.as_ref());
        }
        match hit {
            Some(hit) => li + self.reflected_at(world, &hit, node, levels, stream),
            None => li,
        }
    }
}

/// Gathering makes pictures, too: of diffuse scenes, cut off at a depth.
impl Integrator for Gather {
    fn li(&self, tracer: &mut Tracer, ray: &Ray<Solid>, stream: &Stream) -> Rgb {
        self.li(tracer, ray, stream)
    }
}

/// An estimate of `∫ L cos θ dω` over the lights that can be sampled, by a shadow ray to each.
fn irradiance<S: Space, W: World<S>>(
    world: &mut W,
    at: &W::Point,
    node: u64,
    stream: &Stream,
) -> Rgb {
    (0..world.lights())
        .filter_map(|light| world.sample_light(at, light, node, stream))
        .map(|direct| direct.irradiance * direct.cos)
        .sum()
}

// ANCHOR: step_functions
/// Step 1: a random direction over the surface, as an angle of the half disk.
///
/// The essay speaks of a location in the half disk and draws an angle between 0 and π: a point of
/// the half circle. Angles of uniform points of the half disk follow the same law, so both are
/// right. On the hemisphere a uniform polar angle is not: see
/// [`mistakes`](crate::lab::mistakes).
pub fn step1_direction<S: Space>(
    recipe: Recipe,
    index: u32,
    count: u32,
    numbers: &mut Numbers,
) -> Drawn<S> {
    recipe.draw(index, count, numbers)
}

/// Step 2: turn the direction with the surface, by a matrix made from the normal.
///
/// In the plane `(x, y)` and `(y, -x)` are at a right angle: the normal gives the tangent. Tangent
/// and normal must be the columns of the matrix; as rows they turn the other way.
pub fn step2_turn<S: Space>(frame: &S::Frame, w: S::Vector) -> S::Vector {
    S::to_world(frame, w)
}

/// Step 4: light that comes in at a slant spreads over more surface: times the cosine of the angle
/// between normal and direction.
///
/// Where angles count from the tangent, that is the sine of the sampled angle. It is read off the
/// local direction here, whatever the angles count from.
pub fn step4_cosine<S: Space>(li: Rgb, w: S::Vector) -> Rgb {
    li * S::cos(w)
}

/// Step 5: add the sample's contribution, divided by the density of its direction.
///
/// The essay adds without dividing. A direction that is drawn often must count little, or the sum
/// approaches another integral: `∫ Li cos θ p dω`.
pub fn step5_add(sum: &mut [f64; 3], li_cos: Rgb, pdf: f32) {
    for (sum, channel) in sum.iter_mut().zip(li_cos.channels()) {
        *sum += f64::from(channel) / f64::from(pdf);
    }
}

/// Step 6: divide the sum by the number of samples.
///
/// There are `N` of them, numbered from 0 to `N - 1`; the essay's sum runs to `N`.
pub fn step6_mean(sum: [f64; 3], count: u32) -> Rgb {
    Rgb::from(sum.map(|total| (total / f64::from(count)) as f32))
}

/// Step 7: add direct and indirect light, and multiply by what the surface reflects.
///
/// That is the BRDF, albedo times [`Space::LAMBERT`] (1/2 in the flat world, 1/π in space), and it
/// holds for both terms alike.
pub fn step7_combine<S: Space>(albedo: Rgb, direct: Rgb, indirect: Rgb) -> Rgb {
    albedo * ((direct + indirect) * S::LAMBERT)
}
// ANCHOR_END: step_functions

/// The number of a ray in its tree, as in a heap: the root is 0, and no two rays share one.
fn child(node: u64, count: u32, index: u32) -> u64 {
    // Trees so deep that the numbers wrap have more rays than anyone will wait for.
    node.wrapping_mul(u64::from(count))
        .wrapping_add(u64::from(index) + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_ray_of_a_tree_has_a_number_of_its_own() {
        for count in [1, 2, 3, 16] {
            let mut numbers = vec![0];
            let mut level = vec![0];
            for _ in 0..3 {
                level = level
                    .iter()
                    .flat_map(|&node| (0..count).map(move |i| child(node, count, i)))
                    .collect();
                numbers.extend(&level);
            }
            let last = numbers.len() as u64 - 1;
            assert_eq!(numbers, (0..=last).collect::<Vec<u64>>(), "{count}");
        }
    }
}
