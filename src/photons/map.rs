//! Photons in cells, to find those around a point.

use super::Photon;
use crate::color::Rgb;
use crate::scene::Interaction;
use glam::{DVec3, Vec3};
use std::f64::consts::PI;

/// How far off the plane of a disc its photons may be, in radii: what is farther is on another surface.
const OFF_PLANE: f32 = 0.25;

/// The least cosine between the normals of a point and of its photons, on whichever side: walls that meet in
/// a corner keep their light to themselves.
const ALIKE: f32 = 0.9;

/// The photons of many walks, sorted into a grid of cubes, the side of which is the diameter of a disc: what is
/// around a point is in eight of them. Cells are hashed, so the grid has no bounds and its size is
/// that of the photons; in a cell they keep their order, so that sums are the same bytes in every run.
///
/// Source: Teschner et al., Optimized Spatial Hashing for Collision Detection of Deformable Objects (VMV
/// 2003), for the hash.
#[derive(Clone, Debug)]
pub struct PhotonMap {
    radius: f32,
    /// Cells per unit of length.
    per_length: f64,
    /// One over the number of walks and the area of a disc, in 1/m².
    over_walks_and_area: f32,
    /// Where in `photons` each bucket starts; the last one is their number.
    starts: Vec<usize>,
    photons: Vec<Photon>,
}

impl PhotonMap {
    /// The map of what `walks` from the lights brought, for discs of `radius` in scene units; one without
    /// photons where that is not positive and finite.
    pub fn new(mut photons: Vec<Photon>, walks: u32, radius: f32) -> Self {
        let area = PI * f64::from(radius).powi(2);
        if !(radius > 0.0 && area.is_finite()) {
            photons.clear();
        }
        let mut map = PhotonMap {
            radius,
            per_length: 0.5 / f64::from(radius),
            over_walks_and_area: (1.0 / (f64::from(walks.max(1)) * area)) as f32,
            starts: vec![0; photons.len().next_power_of_two() + 1],
            photons: Vec::new(),
        };
        // Counting sort: how many are in each bucket, where each bucket ends, and from behind each to its place.
        let buckets: Vec<usize> = photons
            .iter()
            .map(|photon| map.bucket((photon.p.as_dvec3() * map.per_length).floor()))
            .collect();
        buckets.iter().for_each(|&bucket| map.starts[bucket] += 1);
        let mut end = 0;
        for start in &mut map.starts {
            end += *start;
            *start = end;
        }
        let mut order = vec![0; photons.len()];
        for (photon, &bucket) in buckets.iter().enumerate().rev() {
            map.starts[bucket] -= 1;
            order[map.starts[bucket]] = photon;
        }
        map.photons = order.into_iter().map(|photon| photons[photon]).collect();
        map
    }

    /// The radius of its discs, in scene units.
    pub fn radius(&self) -> f32 {
        self.radius
    }

    /// All photons, those of a cell side by side.
    pub fn photons(&self) -> &[Photon] {
        &self.photons
    }

    /// The bucket of a cell.
    fn bucket(&self, cell: DVec3) -> usize {
        let [x, y, z] = cell.to_array().map(|x| x as i64 as u64);
        let hash =
            x.wrapping_mul(73_856_093) ^ y.wrapping_mul(19_349_663) ^ z.wrapping_mul(83_492_791);
        // The high bits of a product depend on all of the hash.
        let mixed = hash.wrapping_mul(0x9e37_79b9_7f4a_7c15) >> 32;
        mixed as usize & (self.starts.len() - 2)
    }

    /// Visits the photons less than a radius away from `p`, in an order of their own.
    pub fn near(&self, p: Vec3, mut visit: impl FnMut(&Photon)) {
        if self.photons.is_empty() {
            return;
        }
        let low = (p.as_dvec3() * self.per_length - 0.5).floor();
        let mut buckets = [0; 8];
        for (corner, bucket) in buckets.iter_mut().enumerate() {
            let step = DVec3::new(
                (corner & 1) as f64,
                (corner >> 1 & 1) as f64,
                (corner >> 2) as f64,
            );
            *bucket = self.bucket(low + step);
        }
        // Cells of the same bucket are looked at once.
        buckets.sort_unstable();
        for (i, &bucket) in buckets.iter().enumerate() {
            if i > 0 && buckets[i - 1] == bucket {
                continue;
            }
            for photon in &self.photons[self.starts[bucket]..self.starts[bucket + 1]] {
                if self.reaches(p, photon) {
                    visit(photon);
                }
            }
        }
    }

    /// What [`PhotonMap::near`] finds, by a loop over all of them.
    pub fn near_by_loop(&self, p: Vec3, visit: impl FnMut(&Photon)) {
        let all = self.photons.iter();
        all.filter(|photon| self.reaches(p, photon)).for_each(visit);
    }

    fn reaches(&self, p: Vec3, photon: &Photon) -> bool {
        (photon.p - p).length_squared() < self.radius * self.radius
    }

    // ANCHOR: radiance
    /// The radiance estimate: what the smooth part of the surface at a point scatters to where it is seen from,
    /// in W/(m² sr), of light whose paths from the source have at most so many segments.
    ///
    /// The power of the photons around the point by the area of their disc, weighted by Epanechnikov's
    /// kernel `2 (1 - d² / r²)`, so that they count for less towards its edge. Its expectation is that light
    /// blurred over the disc, and lacks what the disc has beyond the edges of the surface.
    ///
    /// Sources: Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996), equation 8;
    /// Silverman, Density Estimation for Statistics and Data Analysis (1986), section 4.2.
    pub fn radiance(&self, at: &Interaction, most_segments: u32) -> Rgb {
        let Some(bsdf) = at.bsdf.as_ref().filter(|bsdf| bsdf.is_smooth()) else {
            return Rgb::BLACK;
        };
        let surface = &at.surface;
        let mut sum = Rgb::BLACK;
        self.near(surface.p, |photon| {
            let from = photon.p - surface.p;
            let off = from.dot(surface.n).abs();
            if photon.segments > most_segments
                || off > OFF_PLANE * self.radius
                || surface.n.dot(photon.n).abs() < ALIKE
            {
                return;
            }
            let aside2 = (from.length_squared() - off * off).max(0.0);
            let kernel = 2.0 * (1.0 - aside2 / (self.radius * self.radius));
            // The cosine of its direction is in the power already.
            sum += bsdf.f(at.wo, at.frame.to_local(photon.wi)) * photon.power * kernel;
        });
        sum * self.over_walks_and_area
    }
    // ANCHOR_END: radiance
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Ray;
    use crate::scene::{Tracer, gallery};
    use std::f32::consts::PI;

    #[test]
    fn only_photons_of_the_surface_count_and_each_by_its_kernel() {
        // The middle of a wall of albedo 1/2, whose front side is seen.
        let furnace = gallery::load("furnace").expect("a scene");
        let mut tracer = Tracer::new(&furnace);
        let at = tracer.camera_ray(&Ray::new(Vec3::ZERO, Vec3::Z));
        let at = at.expect("a wall");
        let (p, n, aside) = (at.surface.p, at.surface.n, Vec3::X * 0.1);
        let good = Photon {
            p: p + aside,
            n,
            wi: n,
            power: Rgb::new(1.0, 2.0, 3.0),
            segments: 3,
        };
        let (radius, walks) = (0.2, 7);
        let read = |photon: Photon| {
            let map = PhotonMap::new(vec![photon], walks, radius);
            map.radiance(&at, 3).channels()
        };
        let disc = PI * radius * radius;
        // Half a radius away the kernel is 2 (1 - 1/4).
        let one = 0.5 / PI * 1.5 / (7.0 * disc);
        for (x, power) in read(good).into_iter().zip([1.0, 2.0, 3.0]) {
            assert!((x / (power * one) - 1.0).abs() < 1e-5, "{x}");
        }
        let back = Photon { n: -n, ..good };
        assert_eq!(read(back), read(good), "a wall has two sides");
        let (p, wi) = (p + aside + n * 0.1, -n);
        for (what, photon) in [
            ("above", Photon { p, ..good }),
            ("from behind", Photon { wi, ..good }),
            ("on another wall", Photon { n: Vec3::X, ..good }),
            (
                "after too long a way",
                Photon {
                    segments: 4,
                    ..good
                },
            ),
        ] {
            assert_eq!(read(photon), [0.0; 3], "{what}");
        }
    }
}
