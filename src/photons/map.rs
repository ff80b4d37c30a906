//! Photons in cells, to find those around a point.

use super::{Kernel, Photon};
use crate::color::Rgb;
use crate::space::{Solid, Space};
use glam::DVec3;

/// How far off the plane of a disc its photons may be, in radii: what is farther is on another surface.
const OFF_PLANE: f32 = 0.25;

/// The least cosine between the normals of a point and of its photons, on whichever side: walls that meet in
/// a corner keep their light to themselves.
const ALIKE: f32 = 0.9;

/// The photons of many walks, sorted into a grid of cubes (flat: squares), the side of which is the diameter of
/// a disc: what is around a point is in eight of them. Cells are hashed, so the grid has no bounds and its size
/// is that of the photons; in a cell they keep their order, so that sums are the same bytes in every run.
///
/// Source: Teschner et al., Optimized Spatial Hashing for Collision Detection of Deformable Objects (VMV
/// 2003), for the hash.
#[derive(Clone, Debug)]
pub struct PhotonMap<S: Space = Solid> {
    radius: f32,
    kernel: Kernel,
    walks: u32,
    /// Cells per unit of length.
    per_length: f64,
    /// Where in `photons` each bucket starts; the last one is their number.
    starts: Vec<usize>,
    photons: Vec<Photon<S>>,
}

impl<S: Space> PhotonMap<S> {
    /// The map of what `walks` from the lights brought, for discs of at most `radius` in scene units; one
    /// without photons where a disc of that radius has no measure, or one without end.
    pub fn new(mut photons: Vec<Photon<S>>, walks: u32, radius: f32, kernel: Kernel) -> Self {
        if !over(walks, S::disc(f64::from(radius))).is_some_and(|x| x > 0.0) {
            photons.clear();
        }
        let mut map = PhotonMap {
            radius,
            kernel,
            walks: walks.max(1),
            per_length: 0.5 / f64::from(radius),
            starts: vec![0; photons.len().next_power_of_two() + 1],
            photons: Vec::new(),
        };
        // Counting sort: how many are in each bucket, where each bucket ends, and from behind each to its place.
        let buckets: Vec<usize> = photons
            .iter()
            .map(|photon| map.bucket((map.at(photon.p) * map.per_length).floor()))
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

    /// The walks from the lights that it is made from; 1 where there were none.
    pub fn walks(&self) -> u32 {
        self.walks
    }

    /// All photons, those of a cell side by side.
    pub fn photons(&self) -> &[Photon<S>] {
        &self.photons
    }

    fn at(&self, p: S::Vector) -> DVec3 {
        DVec3::from_array(S::coordinates(p))
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
    pub fn near(&self, p: S::Vector, mut visit: impl FnMut(&Photon<S>)) {
        if self.photons.is_empty() {
            return;
        }
        let low = (self.at(p) * self.per_length - 0.5).floor();
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
    pub fn near_by_loop(&self, p: S::Vector, visit: impl FnMut(&Photon<S>)) {
        let all = self.photons.iter();
        all.filter(|photon| self.reaches(p, photon)).for_each(visit);
    }

    fn reaches(&self, p: S::Vector, photon: &Photon<S>) -> bool {
        let from = photon.p - p;
        S::dot(from, from) < self.radius * self.radius
    }

    /// The squared distance of a photon along the surface through `p` with normal `n`; `None` for one that
    /// does not lie on it, or not within `radius`.
    pub(super) fn aside2(
        &self,
        p: S::Vector,
        n: S::Vector,
        radius: f32,
        photon: &Photon<S>,
    ) -> Option<f32> {
        let from = photon.p - p;
        let off = S::dot(from, n).abs();
        let distance2 = S::dot(from, from);
        let counts = distance2 < radius * radius
            && off <= OFF_PLANE * radius
            && S::dot(n, photon.n).abs() >= ALIKE;
        counts.then(|| (distance2 - off * off).max(0.0))
    }

    // ANCHOR: estimate
    /// The density estimate at a point: the light of the photons on the disc around it, each weighted
    /// by its kernel, over the measure of the disc and the number of walks.
    ///
    /// With `scatter` the BSDF times the power it is radiance in W/(m² sr) (flat: W/(m rad)), with the
    /// power alone irradiance. Its expectation is that light blurred over the disc, and lacks what the
    /// disc has beyond the edges of the surface.
    ///
    /// * `p`, `n`: the point and its unit normal, on either side.
    /// * `radius`: of the disc in scene units, at most that of the map.
    ///
    /// Sources: Jensen, Global Illumination Using Photon Maps (Rendering Techniques 1996), equation 8;
    /// Silverman, Density Estimation for Statistics and Data Analysis (1986), section 4.2.
    pub fn estimate(
        &self,
        p: S::Vector,
        n: S::Vector,
        radius: f32,
        mut scatter: impl FnMut(&Photon<S>) -> Rgb,
    ) -> Rgb {
        let mut sum = Rgb::BLACK;
        self.near(p, |photon| {
            if let Some(aside2) = self.aside2(p, n, radius, photon) {
                let weight = self.kernel.weight::<S>(aside2 / (radius * radius));
                sum += scatter(photon) * weight;
            }
        });
        match over(self.walks, S::disc(f64::from(radius))) {
            Some(over) => sum * over,
            None => Rgb::BLACK,
        }
    }
    // ANCHOR_END: estimate
}

/// One over the number of walks and the measure of a disc; `None` where that is no number.
fn over(walks: u32, disc: f64) -> Option<f32> {
    let over = (1.0 / (f64::from(walks.max(1)) * disc)) as f32;
    over.is_finite().then_some(over)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::space::Flat;
    use glam::{Vec2, Vec3};

    #[test]
    fn only_photons_of_the_surface_count_and_each_by_its_kernel() {
        fn check<S: Space>(kernel: Kernel, [up, aside]: [S::Vector; 2], disc: f32, weight: f32) {
            let good = Photon::<S> {
                p: aside * 0.1,
                n: up,
                wi: up,
                power: Rgb::new(1.0, 2.0, 3.0),
                segments: 3,
            };
            let (radius, walks) = (0.2, 7);
            let read = |photon: Photon<S>| {
                let map = PhotonMap::new(vec![photon], walks, radius, kernel);
                let light = |photon: &Photon<S>| photon.power;
                map.estimate(aside * 0.0, up, radius, light).channels()
            };
            for (x, power) in read(good).into_iter().zip([1.0, 2.0, 3.0]) {
                let expected = power * weight / (7.0 * disc);
                assert!((x / expected - 1.0).abs() < 1e-5, "{x} {expected}");
            }
            let back = Photon { n: -up, ..good };
            assert_eq!(read(back), read(good), "a wall has two sides");
            let above = Photon {
                p: aside * 0.1 + up * 0.1,
                ..good
            };
            let other = Photon { n: aside, ..good };
            let far = Photon {
                p: aside * 0.201,
                ..good
            };
            for (what, photon) in [("above", above), ("on another", other), ("far", far)] {
                assert_eq!(read(photon), [0.0; 3], "{what}");
            }
        }
        // Half a radius away the kernel is 3/2 or 2 times 1 - 1/4.
        let (line, disc) = (0.4, std::f32::consts::PI * 0.04);
        check::<Flat>(Kernel::Constant, [Vec2::Y, Vec2::X], line, 1.0);
        check::<Flat>(Kernel::Epanechnikov, [Vec2::Y, Vec2::X], line, 1.125);
        check::<Solid>(Kernel::Constant, [Vec3::Y, Vec3::X], disc, 1.0);
        check::<Solid>(Kernel::Epanechnikov, [Vec3::Y, Vec3::X], disc, 1.5);
    }
}
