//! The cube of side 1 whose ceiling shines and whose walls reflect half: patches without shadow rays, for
//! nothing stands in it.

use glam::DVec3;
use halfdisk::radiosity::{
    Channels, FormFactors, Matrix, Patch, RadiosityError, System, point_to_polygon,
};
use rayon::prelude::*;

/// Radiance that the middle of the floor reflects, and its mean over the floor. No closed form: ever finer
/// patches settle here, and paths agree.
pub const CENTRE: f64 = 0.197_60;
pub const MEAN: f64 = 0.171_22;

/// Corner and edges of each wall, floor first, ceiling second; their normals point inwards.
const WALLS: [[[f64; 3]; 3]; 6] = [
    [[0., 0., 0.], [0., 0., 1.], [1., 0., 0.]],
    [[0., 1., 0.], [1., 0., 0.], [0., 0., 1.]],
    [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.]],
    [[0., 0., 1.], [0., 1., 0.], [1., 0., 0.]],
    [[0., 0., 0.], [0., 1., 0.], [0., 0., 1.]],
    [[1., 0., 0.], [0., 0., 1.], [0., 1., 0.]],
];

/// A room of patches with its light.
pub struct Room {
    pub patches: Vec<Patch>,
    pub system: System<f64>,
    pub radiance: Vec<Channels>,
    side: u32,
}

impl Room {
    /// `side` patches along each edge.
    pub fn new(side: u32) -> Result<Room, RadiosityError> {
        let mut patches = Vec::new();
        for (wall, edges) in WALLS.iter().enumerate() {
            let [corner, u, v] = edges.map(DVec3::from);
            let [u, v] = [u, v].map(|edge| edge / f64::from(side));
            for k in 0..side * side {
                let at = corner + u * f64::from(k % side) + v * f64::from(k / side);
                let polygon = vec![at, at + u, at + u + v, at + v];
                let shines = if wall == 1 { 1.0 } else { 0.0 };
                patches.push(Patch::new(polygon, [0.5; 3], [shines; 3])?);
            }
        }
        let factors = FormFactors {
            patches: &patches,
            scene: None,
            points: 2,
        };
        let rows = (0..patches.len()).into_par_iter();
        let entries = rows.flat_map_iter(|i| factors.row(i)).collect();
        let system = System {
            emission: patches.iter().map(|patch| patch.emission).collect(),
            albedo: patches.iter().map(|patch| patch.albedo).collect(),
            factors: Matrix::new(patches.len(), entries),
        };
        Ok(Room {
            radiance: system.gauss_seidel(1e-12).radiance,
            patches,
            system,
            side,
        })
    }

    fn floor(&self) -> &[Channels] {
        &self.radiance[..(self.side * self.side) as usize]
    }

    /// The mean radiance of the floor.
    pub fn mean(&self) -> f64 {
        self.floor().iter().map(|of| of[0]).sum::<f64>() / self.floor().len() as f64
    }

    /// The radiance of the floor at a point by the patch that it is in.
    pub fn constant(&self, [x, z]: [f64; 2]) -> f64 {
        let place = |x: f64| (x * f64::from(self.side)) as u32;
        // The floor's first edge is along z.
        self.floor()[(place(x) * self.side + place(z)) as usize][0]
    }

    // ANCHOR: gathered
    /// The same, gathered once more from all patches.
    pub fn gathered(&self, [x, z]: [f64; 2]) -> f64 {
        let p = DVec3::new(x, 0.0, z);
        let others = self
            .patches
            .iter()
            .zip(&self.radiance)
            .skip(self.floor().len());
        let seen = others.map(|(patch, of)| of[0] * point_to_polygon(p, DVec3::Y, &patch.polygon));
        0.5 * seen.sum::<f64>()
    }
    // ANCHOR_END: gathered
}
