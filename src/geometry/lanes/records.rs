//! What is kept of each of few shapes, and fetched for sixteen rays that meet one each.

use super::MOST_SHAPES;
use crate::geometry::Quad;
use crate::numeric::lanes::{
    Floats, LANES, Mask, Vector, WideVector, WordRow, Words, floats, transpose, transpose_wide,
};
use fearless_simd::prelude::*;

/// What whoever asks for hits keeps with each shape.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Note {
    /// The albedo, where it is diffuse and of one colour; else black.
    pub albedo: [f32; 3],
    /// True where it shines.
    pub shines: bool,
}

/// The shapes, slot by slot.
#[derive(Clone, Debug)]
pub(super) struct Records(Box<[Record; MOST_SHAPES]>);

/// A shape. Its numbers lie side by side, so that a few loads fetch them all.
#[derive(Clone, Copy, Debug, Default)]
#[repr(align(64))]
struct Record {
    /// The corners and the normal, coordinate by coordinate, and the number.
    corners: [f32; LANES],
    /// The error of a point, the box of the corners, the albedo, and 1 where it shines.
    others: [f32; LANES],
    /// The plane: a point of it and its normal.
    plane: [f64; LANES / 2],
}

/// What is kept of the shape in each lane. The numbers of spheres, but for their notes, are zeros.
#[derive(Clone, Copy)]
pub(super) struct Facts<S: Simd> {
    pub(super) id: Words<S>,
    pub(super) corners: [Vector<S>; 4],
    pub(super) normal: Vector<S>,
    pub(super) error: Vector<S>,
    /// The box of the corners.
    pub(super) low: Vector<S>,
    pub(super) high: Vector<S>,
    pub(super) albedo: Vector<S>,
    pub(super) shines: Mask<S>,
    /// A point of the plane, and its normal.
    pub(super) point: WideVector<S>,
    pub(super) plane: WideVector<S>,
}

impl Default for Records {
    fn default() -> Self {
        Records(Box::new([Record::default(); MOST_SHAPES]))
    }
}

impl Records {
    /// Stores a shape.
    pub(super) fn set(&mut self, slot: usize, id: u32, note: Note) {
        let record = &mut self.0[slot];
        record.corners[15] = f32::from_bits(id);
        let [r, g, b] = note.albedo;
        let shines = f32::from(u8::from(note.shines));
        record.others[9..13].copy_from_slice(&[r, g, b, shines]);
    }

    /// Stores what is kept of a quad.
    pub(super) fn set_quad(&mut self, slot: usize, quad: &Quad) {
        let record = &mut self.0[slot];
        let (plane, bounds) = (quad.plane(), quad.bounds());
        for axis in 0..3 {
            for (i, corner) in quad.corners().iter().enumerate() {
                record.corners[4 * axis + i] = corner[axis];
            }
            record.corners[12 + axis] = quad.normal()[axis];
            record.others[axis] = quad.error[axis];
            record.others[3 + axis] = bounds.min[axis];
            record.others[6 + axis] = bounds.max[axis];
            record.plane[axis] = plane.point[axis];
            record.plane[4 + axis] = plane.normal[axis];
        }
    }

    /// What is kept of the shape in each lane's slot; of any where that is none.
    #[inline(always)]
    pub(super) fn fetch<S: Simd>(&self, s: S, slot: &WordRow) -> Facts<S> {
        let zero = floats(s, 0.0);
        let (mut corners, mut others) = ([zero; LANES], [zero; LANES]);
        let mut planes = [&self.0[0].plane; LANES];
        for lane in 0..LANES {
            let record = &self.0[slot.0[lane] as usize % MOST_SHAPES];
            corners[lane] = Floats::from_slice(s, &record.corners);
            others[lane] = Floats::from_slice(s, &record.others);
            planes[lane] = &record.plane;
        }
        let [
            ax,
            bx,
            cx,
            dx,
            ay,
            by,
            cy,
            dy,
            az,
            bz,
            cz,
            dz,
            nx,
            ny,
            nz,
            id,
        ] = transpose(corners);
        let [ex, ey, ez, x0, y0, z0, x1, y1, z1, r, g, b, shines, ..] = transpose(others);
        let [px, py, pz, _, u, v, w, _] = transpose_wide(s, &planes);
        Facts {
            id: id.bitcast(),
            corners: [
                Vector::new(ax, ay, az),
                Vector::new(bx, by, bz),
                Vector::new(cx, cy, cz),
                Vector::new(dx, dy, dz),
            ],
            normal: Vector::new(nx, ny, nz),
            error: Vector::new(ex, ey, ez),
            low: Vector::new(x0, y0, z0),
            high: Vector::new(x1, y1, z1),
            albedo: Vector::new(r, g, b),
            shines: shines.simd_gt(zero),
            point: WideVector {
                x: px,
                y: py,
                z: pz,
            },
            plane: WideVector { x: u, y: v, z: w },
        }
    }
}
