//! One picture, made from the light and from the eye.
//!
//! The eye has a round pupil, so that light can enter it at all. A pixel's value is the radiance
//! that arrives, averaged over the pupil and over the pixel's part of the film. From the eye that
//! is the mean of samples; from the light it is the power of the rays that happen to enter,
//! divided by what a pixel's share of pupil and film amounts to. Both simulate the paths `LE` and
//! `LDE`, and none of them looks for shadows.

use halfdisk::color::Rgb;
use halfdisk::geometry::Ray;
use halfdisk::lights::{Light, SphereLight};
use halfdisk::render::{Film, Pixel};
use halfdisk::sampling::frame::Frame;
use halfdisk::sampling::stream::{Purpose, Stream};
use halfdisk::sampling::{hemisphere, warps};
use halfdisk::scene::{Interaction, Scene, SceneError, Tracer};
use halfdisk::stats::Estimate;
use rayon::prelude::*;
use std::f32::consts::PI;

/// A scene with one round lamp, seen by an eye with a round pupil.
#[derive(Clone, Copy, Debug)]
pub struct TwoWays<'a> {
    /// The scene; its materials scatter diffusely.
    pub scene: &'a Scene,
    /// Its lamp.
    pub lamp: SphereLight,
    /// Radius of the pupil, in scene units.
    pub pupil: f32,
}

/// A picture and the rays it took.
#[derive(Clone, Debug)]
pub struct Traced {
    /// The picture.
    pub film: Film,
    /// Rays traced, the lines from a surface to the lamp included.
    pub rays: u64,
    /// Rays that carried light to the film.
    pub useful: u64,
}

impl<'a> TwoWays<'a> {
    /// The view of a scene whose first round lamp gives the light.
    pub fn new(scene: &'a Scene, pupil: f32) -> Result<Self, SceneError> {
        let lamp = scene.lights.iter().find_map(|light| match light {
            Light::Sphere(lamp) => Some(*lamp),
            _ => None,
        });
        let lamp = lamp.ok_or_else(|| SceneError::File {
            file: scene.name.clone(),
            reason: "has no sphere that emits light".to_owned(),
        })?;
        Ok(TwoWays { scene, lamp, pupil })
    }

    /// The picture from `spp` rays of the lamp for each pixel there is, and from the eye with as
    /// many rays traced.
    pub fn both(&self, spp: u32, seed: u64) -> [Traced; 2] {
        let [width, height] = self.scene.size;
        let light = self.picture_by_light(spp * width * height, seed);
        let from_eye = light.rays / (2 * u64::from(width * height));
        [light, self.picture_by_eye(from_eye.max(1) as u32, seed)]
    }

    // ANCHOR: from_light
    /// The picture from the light: `count` rays leave the lamp, and those that enter the pupil,
    /// straight or after one bounce, count.
    pub fn picture_by_light(&self, count: u32, seed: u64) -> Traced {
        let power = self.lamp.radiance * (PI * 4.0 * PI * self.lamp.sphere.radius.powi(2));
        self.gather(count, |tracer, index| {
            let mut u = Stream::new(seed, index, 0).at(0, Purpose::Emission);
            let n = warps::sample_sphere(u.two());
            let mut surface = self.lamp.sphere.surface_towards(n.as_dvec3());
            let mut direction = Frame::new(n).to_world(hemisphere::sample_cosine(u.two()));
            let mut beta = power;
            for bounce in 0..2 {
                let ray = surface.spawn(direction);
                let hit = tracer.secondary_ray(&ray);
                if let Some(arrival) = self.enters(&ray, hit.as_ref()) {
                    return Some((arrival.pixel, beta * arrival.radiance_per_power));
                }
                // Missed the eye: the ray scatters once, and hopes again.
                let hit = hit?;
                let stream = Stream::new(seed, index, 0);
                let choice = stream.at(bounce, Purpose::Branch).one();
                let u = stream.at(bounce, Purpose::Direction).two();
                let next = hit.bsdf?.scatter(hit.wo, choice, u)?;
                beta *= next.weight;
                surface = hit.surface;
                direction = hit.frame.to_world(next.wi);
            }
            None
        })
    }
    // ANCHOR_END: from_light

    // ANCHOR: from_eye
    /// The picture from the eye: `spp` rays leave each pixel through the pupil, and from what
    /// they meet a line leads to the lamp.
    pub fn picture_by_eye(&self, spp: u32, seed: u64) -> Traced {
        let [width, height] = self.scene.size;
        let pixels = (0..width * height).into_par_iter().map(|index| {
            let mut pixel = Pixel::default();
            let mut tracer = Tracer::new(self.scene);
            for sample in 0..spp {
                let stream = Stream::new(seed, index, sample);
                let ray = self.through_pupil(index, &stream);
                let li = match tracer.camera_ray(&ray) {
                    Some(hit) => hit.emission + self.towards(&hit, &stream),
                    None => Rgb::BLACK,
                };
                pixel.add(li);
            }
            pixel
        });
        // One ray from the eye and one line to the lamp for each sample.
        let rays = 2 * u64::from(spp) * u64::from(width) * u64::from(height);
        Traced {
            film: Film::new(width, pixels.collect()),
            rays,
            useful: rays,
        }
    }
    // ANCHOR_END: from_eye

    fn through_pupil(&self, pixel: u32, stream: &Stream) -> Ray {
        let [width, height] = self.scene.size.map(|n| n as f32);
        let [u, v] = stream.at(0, Purpose::Pixel).two();
        let x = (pixel % self.scene.size[0]) as f32 + u;
        let y = (pixel / self.scene.size[0]) as f32 + v;
        let on_pupil = warps::sample_disk(stream.at(0, Purpose::Lens).two()) * self.pupil;
        let camera = &self.scene.camera;
        Ray::new(
            camera.beside(on_pupil),
            camera.ray(x / width, y / height).direction,
        )
    }

    /// The light of the lamp that a surface scatters back.
    fn towards(&self, hit: &Interaction, stream: &Stream) -> Rgb {
        let u = stream.at(0, Purpose::LightPoint).two();
        let (Some(bsdf), Some(sample)) = (hit.bsdf, self.lamp.sample(&hit.surface, u)) else {
            return Rgb::BLACK;
        };
        let wi = hit.frame.to_local(sample.wi);
        bsdf.f(hit.wo, wi) * sample.incident.facing_irradiance() * wi.z.abs()
    }

    /// Where and with what weight a ray from the light enters the pupil, if nothing stands before.
    fn enters(&self, ray: &Ray, hit: Option<&Interaction>) -> Option<Arrival> {
        let camera = &self.scene.camera;
        let cos = -ray.direction.dot(camera.forward());
        let t = ray.origin.dot(camera.forward()) / cos;
        let inside = cos > 0.0 && t > 0.0 && ray.at(t).length() < self.pupil;
        if !inside || hit.is_some_and(|h| h.t < t) {
            return None;
        }
        let [s, row] = camera.film_position(-ray.direction)?;
        let [width, height] = self.scene.size.map(|n| n as f32);
        let (x, y) = ((s * width) as u32, (row * height) as u32);
        // Power per area and solid angle: dΦ = L cos θ dA dω, and dω = cos³ θ dA_film.
        let pupil_area = PI * self.pupil * self.pupil;
        let pixel_area = camera.film_area() / (width * height);
        Some(Arrival {
            pixel: y * self.scene.size[0] + x,
            radiance_per_power: 1.0 / (pupil_area * pixel_area * cos.powi(4)),
        })
    }

    /// Adds up what `count` rays bring to the film, in their order whatever the threads.
    fn gather(
        &self,
        count: u32,
        trace: impl Fn(&mut Tracer, u32) -> Option<(u32, Rgb)> + Sync,
    ) -> Traced {
        const CHUNK: u32 = 1 << 14;
        let [width, height] = self.scene.size;
        let size = width as usize * height as usize;
        let starts: Vec<u32> = (0..count).step_by(CHUNK as usize).collect();
        let chunks: Vec<(Sums, u64)> = starts
            .into_par_iter()
            .map(|start| {
                let mut tracer = Tracer::new(self.scene);
                let mut sums = Sums::new(size);
                for index in start..count.min(start.saturating_add(CHUNK)) {
                    if let Some((pixel, value)) = trace(&mut tracer, index) {
                        sums.add(pixel as usize, value);
                    }
                }
                (sums, tracer.counts().total())
            })
            .collect();
        let mut whole = Sums::new(size);
        let mut rays = 0;
        for (sums, n) in &chunks {
            whole.merge(sums);
            rays += n;
        }
        Traced {
            film: Film::new(width, whole.pixels(u64::from(count))),
            rays,
            useful: whole.entered,
        }
    }
}

/// A ray from the light that enters the eye.
struct Arrival {
    pixel: u32,
    radiance_per_power: f32,
}

/// Sums and sums of squares for each channel of each pixel: most rays add nothing to most pixels.
struct Sums {
    pixels: Vec<[(f64, f64); 3]>,
    entered: u64,
}

impl Sums {
    fn new(size: usize) -> Self {
        Sums {
            pixels: vec![[(0.0, 0.0); 3]; size],
            entered: 0,
        }
    }

    fn add(&mut self, pixel: usize, value: Rgb) {
        self.entered += 1;
        for ((sum, squares), x) in self.pixels[pixel].iter_mut().zip(value.channels()) {
            *sum += f64::from(x);
            *squares += f64::from(x) * f64::from(x);
        }
    }

    fn merge(&mut self, other: &Sums) {
        self.entered += other.entered;
        for (a, b) in self
            .pixels
            .iter_mut()
            .flatten()
            .zip(other.pixels.iter().flatten())
        {
            a.0 += b.0;
            a.1 += b.1;
        }
    }

    fn pixels(&self, count: u64) -> Vec<Pixel> {
        let estimate = |(sum, squares)| Estimate::from_sums(count, sum, squares);
        self.pixels
            .iter()
            .map(|channels| Pixel {
                channels: channels.map(estimate),
                ..Pixel::default()
            })
            .collect()
    }
}
