//! The walk of [`Path`], sixteen paths at a time: the same light, bit for bit, in less time.
//!
//! Whoever wants to know what `path` does reads [`Path::walk`]. Here its steps are taken in lanes, one path in each: what
//! most paths do as vectors, and what few do (mirrors, glass, gloss, textures, points near the light) lane by lane,
//! by the code of the plain walk. A path that ends leaves its lane to the next sample, and its light in
//! its sample's place, so that no order of things shows in the picture.

mod paths;
mod vertex;

use super::Path;
use super::path::LEAST_SURVIVAL;
use super::world::{Guided, World};
use crate::color::Rgb;
use crate::geometry::Ray;
use crate::geometry::lanes::Rays;
use crate::materials::kinds;
use crate::numeric::lanes::{
    ALL_LANES, Each, Row, Vector, WordRow, bits, floats, level_name, mask, words,
};
use crate::sampling::lanes::Streams;
use crate::sampling::mis::Heuristic;
use crate::sampling::stream::{Purpose, Sampler, Stream};
use crate::scene::lanes::SceneInLanes;
use crate::scene::{RayCounts, Scene, Tracer};
use fearless_simd::prelude::*;
use fearless_simd::{Level, dispatch};
use glam::Vec3;
use paths::{NO_PDF, Paths};

/// The path tracer for one scene, sixteen paths at a time.
#[derive(Clone, Debug)]
pub struct PathInLanes<'s> {
    path: Path,
    scene: SceneInLanes<'s>,
    from_lights: bool,
    pinhole: Option<[Vec3; 4]>,
    level: Level,
}

/// A sample of a pixel that is to be taken.
#[derive(Clone, Copy, Debug)]
pub struct PixelSample {
    /// Column and row.
    pub pixel: [u32; 2],
    /// Its random numbers, none of them fixed.
    pub stream: Stream,
}

impl<'s> PathInLanes<'s> {
    /// `None` for scenes whose paths had better be traced one by one: see [`SceneInLanes::new`]. `None` in programs that are
    /// not optimised, too: each operation is a call there, and all of them together need more stack than a thread has.
    pub fn new(path: &Path, scene: &'s Scene) -> Option<Self> {
        let focuses = scene.kinds() & kinds::SPECULAR != 0;
        let from_lights = focuses && path.traces_caustics(scene);
        // Where caustics are looked for from the eye, most vertices would go lane by lane.
        let guided = focuses && !from_lights && !scene.casters.is_empty();
        let optimised = !cfg!(debug_assertions);
        (optimised && path.max_depth > 0 && !guided).then_some(())?;
        Some(PathInLanes {
            path: *path,
            scene: SceneInLanes::new(scene)?,
            from_lights,
            pinhole: scene.camera.pinhole(),
            level: Level::new(),
        })
    }

    /// The same by other instructions of the processor: one of [`levels`](crate::numeric::lanes::levels).
    #[must_use]
    pub fn by(self, level: Level) -> Self {
        PathInLanes { level, ..self }
    }

    /// What the instructions are called by which it runs.
    pub fn level_name(&self) -> &'static str {
        level_name(self.level)
    }

    /// Takes samples as long as `next` has some, and adds the light of each to `light`, in their order.
    ///
    /// Once `next` has none it is not asked again.
    pub fn take(
        &self,
        tracer: &mut Tracer<'s>,
        sampler: Sampler,
        next: &mut dyn FnMut() -> Option<PixelSample>,
        light: &mut Vec<Rgb>,
    ) {
        dispatch!(self.level, s => Walk::new(s, self, sampler).run(tracer, next, light));
    }
}

/// Sixteen paths on their way.
struct Walk<'w, 's, S> {
    s: S,
    by: &'w PathInLanes<'s>,
    paths: Box<Paths>,
    streams: Streams,
}

impl<'w, 's, S: Simd> Walk<'w, 's, S> {
    #[inline(always)]
    fn new(s: S, by: &'w PathInLanes<'s>, sampler: Sampler) -> Self {
        Walk {
            s,
            by,
            paths: Box::default(),
            streams: Streams::new(sampler),
        }
    }

    #[inline(always)]
    fn run(
        &mut self,
        tracer: &mut Tracer<'s>,
        next: &mut dyn FnMut() -> Option<PixelSample>,
        light: &mut Vec<Rgb>,
    ) {
        let (mut live, mut more) = (0, true);
        loop {
            if more && live != ALL_LANES {
                let free = !live & ALL_LANES;
                let started = self.start(free, next, light);
                more = started == free;
                live |= started;
            }
            if live == 0 {
                return;
            }
            let met = self.intersect(tracer, live);
            let goes_on = self.arrive(tracer, live, met);
            let left = self.scatter(tracer, goes_on);
            for lane in Each(live & !left) {
                light[self.paths.sample[lane]] = self.paths.light(lane);
            }
            live = left;
        }
    }

    /// Starts paths in free lanes; the lanes that have one.
    #[inline(always)]
    fn start(
        &mut self,
        free: u32,
        next: &mut dyn FnMut() -> Option<PixelSample>,
        light: &mut Vec<Rgb>,
    ) -> u32 {
        let (s, scene) = (self.s, self.by.scene.scene());
        let mut started = 0;
        let mut place = [Row::default(); 2];
        for lane in Each(free) {
            let Some(PixelSample { pixel, stream }) = next() else {
                break;
            };
            self.paths.sample[lane] = light.len();
            self.streams.set(lane, &stream);
            light.push(Rgb::BLACK);
            started |= 1 << lane;
            match self.by.pinhole {
                Some(_) => {
                    let [x, y] = pixel.map(|x| x as f32);
                    (place[0].0[lane], place[1].0[lane]) = (x, y);
                }
                None => self
                    .paths
                    .ray
                    .set_lane(lane, &scene.camera_ray(pixel, &stream)),
            }
        }
        self.paths.start(s, started);
        if let Some([origin, forward, right, up]) = self.by.pinhole {
            // `Scene::camera_ray`.
            let at = self.streams.at(s, words(s, 0));
            let [u, v, ..] = self.streams.four(s, &at, Purpose::Pixel);
            let [width, height] = scene.size.map(|n| n as f32);
            let x = (place[0].get(s) + u) / width * 2.0 - 1.0;
            let y = floats(s, 1.0) - (place[1].get(s) + v) / height * 2.0;
            let toward =
                Vector::splat(s, forward) + Vector::splat(s, right) * x + Vector::splat(s, up) * y;
            let started = mask(s, started);
            self.paths
                .ray
                .origin
                .set_where(s, started, Vector::splat(s, origin));
            self.paths
                .ray
                .direction
                .set_where(s, started, toward.normalize());
        }
        started
    }

    /// What each path meets; the lanes that meet anything.
    #[inline(always)]
    fn intersect(&mut self, tracer: &mut Tracer<'s>, live: u32) -> u32 {
        let (s, scene, paths) = (self.s, &self.by.scene, &mut *self.paths);
        let first = bits(paths.depth.get(s).simd_eq(words(s, 1))) & live;
        tracer.count(RayCounts {
            camera: first.count_ones().into(),
            secondary: (live & !first).count_ones().into(),
            shadow: 0,
        });
        let (mut met, mut doubt) = (0, live);
        if let Some(shapes) = scene.shapes() {
            let rays = Rays {
                origin: paths.ray.origin.get(s),
                direction: paths.ray.direction.get(s),
                t_max: floats(s, f32::MAX),
                from: paths.left.shape.get(s),
            };
            let hits = shapes.intersect(s, &rays);
            met = bits(hits.hit) & live;
            doubt = bits(hits.doubt) & live;
            paths.t.set(hits.t);
            paths.u.set(hits.u);
            paths.v.set(hits.v);
            paths.part = WordRow::default();
            paths.here.p.set(hits.p);
            paths.here.error.set(hits.error);
            paths.here.n.set(hits.n);
            paths.here.shape.set(hits.id);
            paths.albedo.set(hits.albedo);
            paths.shines = bits(hits.shines);
            for lane in Each(bits(hits.at_triangles) & live) {
                // Of two at the same distance the one with the lower number is met, whichever is found first.
                let few =
                    (met >> lane & 1 == 1).then_some((paths.t.0[lane], paths.here.shape.0[lane]));
                let ray = Ray {
                    t_max: few.map_or(f32::INFINITY, |(t, _)| t),
                    ..paths.ray.lane(lane)
                };
                if let Some(hit) = scene.first_triangle(&ray)
                    && few.is_none_or(|few| (hit.intersection.t, hit.shape) < few)
                {
                    met |= 1 << lane;
                    paths.set_hit(lane, &hit, scene.note(hit.shape));
                }
            }
        }
        for lane in Each(doubt) {
            if let Some(hit) = scene.first_hit(&paths.ray.lane(lane)) {
                met |= 1 << lane;
                paths.set_hit(lane, &hit, scene.note(hit.shape));
            }
        }
        if scene.has_contacts() {
            for lane in Each(met) {
                let hit = scene.met(&paths.ray.lane(lane), paths.hit(lane));
                if hit.shape != paths.here.shape.0[lane] {
                    paths.set_hit(lane, &hit, scene.note(hit.shape));
                }
            }
        }
        met
    }

    /// Adds the light that comes along the paths by itself; the lanes that go on.
    #[inline(always)]
    fn arrive(&mut self, tracer: &mut Tracer<'s>, live: u32, met: u32) -> u32 {
        let (s, scene, paths) = (self.s, &self.by.scene, &mut *self.paths);
        let beyond = match scene.is_black_beyond() {
            true => 0,
            false => live & !met,
        };
        for lane in Each(met & paths.shines | beyond) {
            let hit = met >> lane & 1 == 1;
            let ray = paths.ray.lane(lane);
            let here = hit.then(|| scene.interaction(&ray, &paths.hit(lane)));
            let mut li = match &here {
                Some(here) => here.emission,
                None => scene.scene().background(ray.direction),
            };
            let pdf = paths.pdf.0[lane];
            if pdf != NO_PDF && !li.is_black() {
                let from = paths.left.lane(lane);
                let pdf_light = tracer.chosen_light_pdf(&from, ray.direction, here.as_ref());
                li = li * Heuristic::Power.weight(pdf, pdf_light);
            }
            // What is focused onto a diffuse surface, and found by chance, is traced from the lights.
            let is_focused = (paths.first_is_diffuse & paths.last_is_specular) >> lane & 1 == 1;
            let is_traced = self.by.from_lights
                && is_focused
                && (here.is_some() || scene.scene().environment_light.is_some());
            if !is_traced {
                paths.add(lane, li);
            }
        }
        let ends = paths.depth.get(s).simd_ge(words(s, self.by.path.max_depth));
        met & !bits(ends)
    }

    /// Aims at the light from each vertex, and chooses where the paths go on; the lanes that do.
    #[inline(always)]
    fn scatter(&mut self, tracer: &mut Tracer<'s>, live: u32) -> u32 {
        let s = self.s;
        let mut vectors = live & !bits(self.paths.albedo.get(s).is_zero(s));
        let scene = self.by.scene.scene();
        if scene.kinds() & kinds::SPECULAR != 0 && !scene.casters.is_empty() {
            for lane in Each(vectors) {
                if self.by.from_lights && self.paths.depth.0[lane] == 1 {
                    self.paths.on_caustic |= 1 << lane;
                }
                let p = Vec3::from(self.paths.here.p.lane(lane));
                let guided = self.paths.on_caustic >> lane & 1 == 0;
                if guided && !scene.casters.seen_from(p).is_empty() {
                    vectors &= !(1 << lane);
                }
            }
        }
        let mut on = self.scatter_vectors(tracer, vectors);
        for lane in Each(live & !vectors) {
            on |= u32::from(self.scatter_plain(tracer, lane)) << lane;
        }
        on
    }

    /// The same for one path by the code of the plain walk; true where it goes on.
    #[inline(never)]
    fn scatter_plain(&mut self, tracer: &mut Tracer<'s>, lane: usize) -> bool {
        let paths = &mut *self.paths;
        let (stream, depth) = (self.streams.lane(lane), paths.depth.0[lane]);
        let here = self
            .by
            .scene
            .interaction(&paths.ray.lane(lane), &paths.hit(lane));
        let on_caustic = paths.on_caustic >> lane & 1 == 1;
        let mut world = Guided::<{ kinds::ALL }>::new(tracer, self.by.from_lights)
            .at_vertex(on_caustic, &here, depth);
        paths.on_caustic |= u32::from(world.on_caustic()) << lane;
        let vertex = u64::from(depth);
        if world.smooth_event(&here).is_some()
            && let Some(direct) = world.sample_light(&here, 0, vertex, &stream)
        {
            paths.add(lane, direct.weighted(Heuristic::Power));
        }
        let Some(step) = world.sample_bsdf(&here, vertex, &stream) else {
            return false;
        };
        paths.note(1 << lane, u32::from(depth == 1) << lane, step.event);
        let mut beta = Rgb::from(paths.beta.lane(lane)) * step.weight;
        let mut rr_beta = Rgb::from(paths.rr_beta.lane(lane)) * step.bsdf_weight;
        if depth >= self.by.path.roulette_from {
            let q = rr_beta.max_channel().clamp(LEAST_SURVIVAL, 1.0);
            let survives = step.left < q;
            if !survives {
                return false;
            }
            beta = beta / q;
            rr_beta = rr_beta / q;
        }
        paths.beta.set_lane(lane, beta.channels());
        paths.rr_beta.set_lane(lane, rr_beta.channels());
        paths.ray.set_lane(lane, &step.ray);
        paths.pdf.0[lane] = step.pdf.unwrap_or(NO_PDF);
        paths
            .left
            .set_lane(lane, &here.surface.facing(here.back), here.shape);
        paths.depth.0[lane] += 1;
        true
    }
}

#[cfg(test)]
mod tests;
