//! From a scene to patches.

use super::coarse::refuse_coarse;
use super::error::{MOST_PATCHES, RadiosityError};
use super::pieces::Pieces;
use super::quadrature::{area_vector, gauss_legendre, points_on};
use super::system::Channels;
use super::touching::Outline;
use crate::numeric::gamma;
use crate::scene::{Facet, Scene};
use glam::{DVec3, Vec3};
use std::collections::BTreeMap;

/// How small patches are.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PatchSize {
    /// No edge is longer than this, in scene units, by more than a thousandth.
    Length(f64),
    /// So many at most, all about equally large.
    Number(usize),
}

impl Default for PatchSize {
    fn default() -> Self {
        PatchSize::Number(1000)
    }
}

/// One side of a piece of surface, with the same radiance everywhere.
#[derive(Clone, Debug)]
pub struct Patch {
    /// Its corners, convex and flat, relative to the camera; wound counter-clockwise seen from the side
    /// that it is.
    pub polygon: Vec<DVec3>,
    /// Unit normal on its side.
    pub normal: DVec3,
    /// Area in square scene units.
    pub area: f64,
    /// The mean share of light that it reflects.
    pub albedo: Channels,
    /// The mean radiance that it emits, in W/(m² sr).
    pub emission: Channels,
    /// Bound on the rounding of its corners, in scene units.
    pub(super) close: f64,
}

impl Patch {
    /// A patch on its own.
    ///
    /// * `polygon`: three corners or more, convex, flat and finite, wound counter-clockwise seen from the
    ///   side that counts.
    pub fn new(
        polygon: Vec<DVec3>,
        albedo: Channels,
        emission: Channels,
    ) -> Result<Patch, RadiosityError> {
        let vector = area_vector(&polygon);
        let normal = vector.try_normalize().filter(|n| n.is_finite());
        Ok(Patch {
            normal: normal.ok_or(RadiosityError::Degenerate)?,
            area: 0.5 * vector.length(),
            albedo,
            emission,
            close: rounding(&polygon),
            polygon,
        })
    }

    /// Signed distance of a point from its plane, positive on its side.
    pub(super) fn height(&self, p: DVec3) -> f64 {
        self.normal.dot(p - self.polygon[0])
    }

    /// True where some of it lies in front of `other`.
    pub(super) fn is_before(&self, other: &Patch) -> bool {
        let close = self.close.max(other.close);
        self.polygon.iter().any(|p| other.height(*p) > close)
    }
}

/// The patches of a shape: both sides of its pieces.
#[derive(Clone, Debug)]
pub(super) struct Cut {
    pub pieces: Pieces,
    /// For each piece the patches of its back and its front.
    pub sides: Vec<[Option<u32>; 2]>,
}

/// All patches of a scene.
#[derive(Clone, Debug)]
pub struct Patches {
    /// In the order of the shapes.
    pub all: Vec<Patch>,
    /// Pieces of surface left out because another lies in their very place.
    pub hidden: usize,
    /// By the number of the shape.
    pub(super) cuts: BTreeMap<u32, Cut>,
    /// The indices of the scene's lights whose light starts from patches.
    pub(super) lights: Vec<u32>,
}

/// A shape that has patches, or touches others that do.
struct Side<'a> {
    facet: Facet<'a>,
    outline: Outline,
    /// The shape has patches.
    counts: bool,
}

impl Patches {
    /// The patches of `scene`.
    pub fn new(scene: &Scene, size: PatchSize) -> Result<Patches, RadiosityError> {
        let sides = sides(scene)?;
        // Before any work that takes the square of their number.
        let least = sides.iter().filter(|side| side.counts).count();
        let patches = sides.len();
        match size {
            _ if patches > MOST_PATCHES => return Err(RadiosityError::TooMany { patches }),
            PatchSize::Number(asked) if asked < least => {
                return Err(RadiosityError::TooFew { asked, least });
            }
            _ => {}
        }
        let cut = touched(&sides);
        let patches = match size {
            PatchSize::Length(length) => Patches::of_length(&sides, &cut, length)?,
            PatchSize::Number(number) => Patches::at_most(&sides, &cut, number)?,
        };
        refuse_coarse(&patches.all)?;
        Ok(patches)
    }

    fn at_most(sides: &[Side], cut: &[Pieces], number: usize) -> Result<Patches, RadiosityError> {
        let whole = Patches::build(sides, cut, f64::INFINITY);
        let (asked, least) = (number, whole.all.len());
        if least > number {
            return Err(RadiosityError::TooFew { asked, least });
        }
        if number > MOST_PATCHES {
            return Err(RadiosityError::TooMany { patches: number });
        }
        Ok(of_number(sides, cut, number, whole))
    }

    fn of_length(sides: &[Side], cut: &[Pieces], length: f64) -> Result<Patches, RadiosityError> {
        if !(length > 0.0 && length.is_finite()) {
            return Err(RadiosityError::Size(length));
        }
        // Refused by an estimate that is not above the number, before any work.
        let about: f64 = sides.iter().map(|side| about(&side.outline, length)).sum();
        let refuse = |patches| Err(RadiosityError::TooMany { patches });
        if about > MOST_PATCHES as f64 {
            return refuse(about as usize);
        }
        let patches = Patches::build(sides, cut, length);
        match patches.all.len() {
            n if n > MOST_PATCHES => refuse(n),
            _ => Ok(patches),
        }
    }

    fn build(sides: &[Side], cut: &[Pieces], length: f64) -> Patches {
        let mut patches = Patches {
            all: Vec::new(),
            hidden: 0,
            cuts: BTreeMap::new(),
            lights: Vec::new(),
        };
        for (at, side) in sides.iter().enumerate().filter(|(_, side)| side.counts) {
            let mut pieces = cut[at].clone();
            pieces.subdivide(length);
            patches.add(sides, at, pieces);
            patches.lights.extend(side.facet.object.light);
        }
        patches.lights.sort_unstable();
        patches.lights.dedup();
        patches
    }

    fn add(&mut self, all: &[Side], at: usize, pieces: Pieces) {
        let side = &all[at];
        let seen = [-1.0, 1.0].map(|sign| sees_anything(side, sign, all));
        let rule = gauss_legendre(2);
        let mut sides = Vec::with_capacity(pieces.polygons.len());
        for polygon in &pieces.polygons {
            let points = points_on(polygon, &rule);
            if is_hidden(all, at, polygon) {
                self.hidden += 1;
                sides.push([None; 2]);
                continue;
            }
            let (albedo, emission) = mean_colors(side, &points);
            let mut own = [None; 2];
            for (front, seen) in seen.into_iter().enumerate() {
                let shines = front == 1 || side.facet.object.two_sided;
                let emission = if shines { emission } else { [0.0; 3] };
                if !seen || (albedo == [0.0; 3] && emission == [0.0; 3]) {
                    continue;
                }
                own[front] = Some(self.all.len() as u32);
                let mut polygon = polygon.clone();
                if front == 0 {
                    polygon.reverse();
                }
                let vector = area_vector(&polygon);
                self.all.push(Patch {
                    normal: side.outline.normal * if front == 1 { 1.0 } else { -1.0 },
                    area: 0.5 * vector.length(),
                    albedo,
                    emission,
                    close: side.outline.close,
                    polygon,
                });
            }
            sides.push(own);
        }
        let number = side.facet.number;
        self.cuts.insert(number, Cut { pieces, sides });
    }

    /// The patch at a point of a shape, on its front or its back; `None` where it has none.
    pub fn at(&self, shape: u32, p: DVec3, front: bool) -> Option<usize> {
        let cut = self.cuts.get(&shape)?;
        let patch = cut.sides[cut.pieces.find(p)][usize::from(front)];
        patch.map(|i| i as usize)
    }

    /// The same patches in coordinates whose origin is `by` further.
    pub(super) fn move_by(&mut self, by: DVec3) {
        let shift = |polygon: &mut Vec<DVec3>| polygon.iter_mut().for_each(|p| *p -= by);
        self.all
            .iter_mut()
            .for_each(|patch| shift(&mut patch.polygon));
        self.cuts
            .values_mut()
            .for_each(|cut| cut.pieces.move_by(by));
    }
}

/// The coarsest patches are doubled until there would be more than asked for; then the size is halved
/// in on.
fn of_number(sides: &[Side], cut: &[Pieces], number: usize, whole: Patches) -> Patches {
    let longest = sides
        .iter()
        .map(|s| (s.outline.high - s.outline.low).length());
    let mut large = longest.fold(0.0, f64::max);
    let mut best = whole;
    let fits = |size: f64| {
        let about: f64 = sides.iter().map(|side| about(&side.outline, size)).sum();
        (about <= number as f64)
            .then(|| Patches::build(sides, cut, size))
            .filter(|found| found.all.len() <= number)
    };
    let mut small = large;
    while let Some(found) = fits(small) {
        best = found;
        large = small;
        small *= 0.5;
    }
    for _ in 0..12 {
        let middle = (small * large).sqrt();
        match fits(middle) {
            Some(found) => {
                best = found;
                large = middle;
            }
            None => small = middle,
        }
    }
    best
}

/// A number of patches that the pieces of a shape have at least.
fn about(outline: &Outline, length: f64) -> f64 {
    0.5 * area_vector(&outline.polygon).length() / (length * length)
}

/// A bound on how far rounding to `f32` moves a corner, in scene units.
fn rounding(polygon: &[DVec3]) -> f64 {
    let largest = polygon.iter().map(|p| p.abs().max_element());
    largest.fold(0.0, f64::max) * f64::from(gamma(16))
}

fn sides(scene: &Scene) -> Result<Vec<Side<'_>>, RadiosityError> {
    if scene.moves() {
        return Err(RadiosityError::Motion);
    }
    if scene.has_instances() {
        return Err(RadiosityError::Shared(scene.report.instances));
    }
    let [mut round, mut diffuse] = [0, 0];
    let mut sides = Vec::new();
    for facet in scene.facets() {
        let scatters = facet.scatters_diffusely();
        let corners = facet.shape.corners();
        if corners.is_empty() {
            round += usize::from(scatters);
            continue;
        }
        let polygon: Vec<DVec3> = corners.into_iter().map(Vec3::as_dvec3).collect();
        diffuse += usize::from(scatters);
        let close = rounding(&polygon);
        let normal = area_vector(&polygon).normalize_or_zero();
        sides.push(Side {
            counts: scatters || facet.object.light.is_some(),
            outline: Outline::new(polygon, normal, close),
            facet,
        });
    }
    match (round, diffuse) {
        (0, 0) => Err(RadiosityError::NothingDiffuse),
        (0, _) => Ok(sides),
        (n, _) => Err(RadiosityError::Spheres(n)),
    }
}

/// Each shape, cut where others touch it.
fn touched(sides: &[Side]) -> Vec<Pieces> {
    let cut = |(at, side): (usize, &Side)| {
        let outline = &side.outline;
        let polygon = outline.polygon.clone();
        let mut pieces = Pieces::whole(polygon, outline.normal, outline.close);
        if side.counts {
            let others = sides.iter().enumerate().filter(|(other, _)| *other != at);
            outline.cut_where_touched(&mut pieces, others.map(|(_, other)| &other.outline));
        }
        pieces
    };
    sides.iter().enumerate().map(cut).collect()
}

/// True where some shape reaches above one side of another: otherwise the side sees no patch, and none
/// sees it.
fn sees_anything(side: &Side, sign: f64, all: &[Side]) -> bool {
    let above = |other: &Side| {
        let close = side.outline.close.max(other.outline.close);
        let mut corners = other.outline.polygon.iter();
        corners.any(|p| sign * side.outline.height(*p) > close)
    };
    all.iter().any(above)
}

/// True where a piece lies in a place that rays find another shape in: a lamp, or else the first.
fn is_hidden(all: &[Side], at: usize, polygon: &[DVec3]) -> bool {
    let side = &all[at];
    let rank = |at: usize| (all[at].facet.object.light.is_none(), at);
    let middle = polygon.iter().sum::<DVec3>() / polygon.len() as f64;
    all.iter().enumerate().any(|(other, o)| {
        rank(other) < rank(at) && side.outline.is_coplanar(&o.outline) && o.outline.holds(middle)
    })
}

/// The mean albedo and emission at points of a shape.
fn mean_colors(side: &Side, points: &[(DVec3, f64)]) -> (Channels, Channels) {
    let mut sums = [[0.0; 3]; 2];
    for (p, weight) in points {
        let place = side.place(*p);
        let colors = [side.facet.diffuse_albedo(place), side.facet.emission(place)];
        for (sum, color) in sums.iter_mut().zip(colors) {
            let channels = color.channels().map(f64::from);
            (0..3).for_each(|c| sum[c] += weight * channels[c]);
        }
    }
    let [albedo, emission] = sums;
    (albedo, emission)
}

impl Side<'_> {
    /// The coordinates of a point along the edges at the first corner.
    fn place(&self, p: DVec3) -> [f32; 2] {
        let corners = &self.outline.polygon;
        let [u, v] = match corners.as_slice() {
            [a, b, .., d] => [*b - *a, *d - *a],
            _ => return [0.0; 2],
        };
        let (normal, from) = (u.cross(v), p - corners[0]);
        let square = normal.length_squared();
        let along = |x: f64| (x / square).clamp(0.0, 1.0) as f32;
        [
            along(from.cross(v).dot(normal)),
            along(u.cross(from).dot(normal)),
        ]
    }
}
