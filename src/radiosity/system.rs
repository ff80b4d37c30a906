//! The linear system of radiosity, and three ways to solve it.
//!
//! `B = E + ρ F B`: what leaves a patch is what it emits and the share it reflects of what arrives.
//! One source for both worlds: the patches may be segments of a flat world as well.
//!
//! Sources: Goral, Torrance, Greenberg, Battaile, Modeling the Interaction of Light Between Diffuse
//! Surfaces (SIGGRAPH 1984); Cohen, Wallace, Radiosity and Realistic Image Synthesis (1993), chapter 5.

use super::Matrix;

/// A value for each colour channel.
pub type Channels = [f64; 3];

/// What is known of each patch, and the form factors between them.
#[derive(Clone, Debug)]
pub struct System<T = f32> {
    /// Radiance that each patch sends out without the others: emitted, or reflected from lights that
    /// are no patches.
    pub emission: Vec<Channels>,
    /// The share of light that each patch reflects.
    pub albedo: Vec<Channels>,
    /// Form factors.
    pub factors: Matrix<T>,
}

/// A solution with what it took.
#[derive(Clone, Debug)]
pub struct Solved {
    /// Radiance that leaves each patch, in W/(m² sr); in a flat world in W/(m rad). Radiosity is π
    /// times that, or 2 times.
    pub radiance: Vec<Channels>,
    /// Sweeps over all patches.
    pub sweeps: u32,
    /// The largest change of the last sweep, relative to the largest radiance.
    pub change: f64,
}

/// More sweeps than this are never needed in rooms that absorb a per cent of the light.
const MOST_SWEEPS: u32 = 10_000;

impl<T: Copy + Into<f64>> System<T> {
    /// What arrives at a patch from the others, as a mean of their radiances over its hemisphere.
    pub fn arriving(&self, i: usize, radiance: &[Channels]) -> Channels {
        let mut sum = [0.0; 3];
        for (&factor, of) in self.factors.row(i).iter().zip(radiance) {
            let factor: f64 = factor.into();
            (0..3).for_each(|c| sum[c] += factor * of[c]);
        }
        sum
    }

    fn leaving(&self, i: usize, radiance: &[Channels]) -> Channels {
        let arrives = self.arriving(i, radiance);
        [0, 1, 2].map(|c| self.emission[i][c] + self.albedo[i][c] * arrives[c])
    }

    // ANCHOR: gauss_seidel
    /// Solves by the iteration of Gauss and Seidel: each patch in turn gathers from the others as they
    /// are by now, until a sweep changes nothing by more than `tolerance` of the largest radiance.
    pub fn gauss_seidel(&self, tolerance: f64) -> Solved {
        let mut radiance = self.emission.clone();
        let mut sweeps = 0;
        loop {
            let [mut change, mut largest] = [0.0_f64, 0.0_f64];
            for i in 0..radiance.len() {
                let new = self.leaving(i, &radiance);
                for (old, new) in radiance[i].iter().zip(new) {
                    change = change.max((new - old).abs());
                    largest = largest.max(new);
                }
                radiance[i] = new;
            }
            sweeps += 1;
            let change = if largest > 0.0 { change / largest } else { 0.0 };
            if change <= tolerance || sweeps == MOST_SWEEPS {
                return Solved {
                    radiance,
                    sweeps,
                    change,
                };
            }
        }
    }
    // ANCHOR_END: gauss_seidel

    // ANCHOR: jacobi
    /// The light of at most `bounces` reflections: each sweep of Jacobi's iteration lets all patches gather
    /// at once from the sweep before, and so adds one.
    pub fn jacobi(&self, bounces: u32) -> Vec<Channels> {
        let mut radiance = self.emission.clone();
        for _ in 0..bounces {
            let gather = |i| self.leaving(i, &radiance);
            radiance = (0..radiance.len()).map(gather).collect();
        }
        radiance
    }
    // ANCHOR_END: jacobi

    /// Shoots light from one patch after the other, that with the most unshot power first: progressive
    /// refinement, which is Southwell's relaxation.
    ///
    /// * `areas`: of the patches.
    /// * Returns the radiance after so many shots, and the unshot share of the emitted power before each
    ///   of them.
    ///
    /// Source: Cohen, Chen, Wallace, Greenberg, A Progressive Refinement Approach to Fast Radiosity Image
    /// Generation (SIGGRAPH 1988).
    pub fn southwell(&self, areas: &[f64], shots: usize) -> (Vec<Channels>, Vec<f64>) {
        let mut radiance = self.emission.clone();
        let mut unshot = self.emission.clone();
        let power = |i: usize, unshot: &[Channels]| areas[i] * unshot[i].iter().sum::<f64>();
        let total = |unshot: &[Channels]| (0..unshot.len()).map(|i| power(i, unshot)).sum::<f64>();
        let emitted = total(&unshot);
        let mut left = Vec::with_capacity(shots);
        for _ in 0..shots {
            left.push(if emitted > 0.0 {
                total(&unshot) / emitted
            } else {
                0.0
            });
            let brighter = |a: &usize, b: &usize| power(*a, &unshot).total_cmp(&power(*b, &unshot));
            let Some(source) = (0..unshot.len()).max_by(brighter) else {
                break;
            };
            let shot = std::mem::take(&mut unshot[source]);
            for i in 0..radiance.len() {
                let factor = self.factors.at(i, source);
                for c in 0..3 {
                    let gained = self.albedo[i][c] * factor * shot[c];
                    radiance[i][c] += gained;
                    unshot[i][c] += gained;
                }
            }
        }
        (radiance, left)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A closed room of three surfaces, of reciprocal factors and unequal areas.
    fn room() -> (System<f64>, [f64; 3]) {
        let areas = [1.0, 2.0, 4.0];
        let rows = [[0.0, 0.4, 0.6], [0.2, 0.3, 0.5], [0.15, 0.25, 0.6]];
        let system = System {
            emission: vec![[1.0, 0.5, 0.0], [0.0; 3], [0.0, 0.0, 2.0]],
            albedo: vec![[0.5; 3], [0.8, 0.1, 0.0], [0.3; 3]],
            factors: Matrix::new(3, rows.concat()),
        };
        (system, areas)
    }

    fn worst(a: &[Channels], b: &[Channels]) -> f64 {
        let pairs = a.iter().flatten().zip(b.iter().flatten());
        pairs.map(|(x, y)| (x - y).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn three_solvers_agree() {
        let (system, areas) = room();
        let solved = system.gauss_seidel(1e-15);
        assert!(worst(&solved.radiance, &system.jacobi(400)) < 1e-14);
        let (radiance, left) = system.southwell(&areas, 400);
        assert!(worst(&solved.radiance, &radiance) < 1e-13);
        assert_eq!(left[0], 1.0);
        assert!(left.last().is_some_and(|&l| l < 1e-13));
    }

    #[test]
    fn what_is_emitted_is_absorbed() {
        let (system, areas) = room();
        let solved = system.gauss_seidel(1e-16);
        for c in 0..3 {
            let [mut emitted, mut absorbed] = [0.0; 2];
            for (i, area) in areas.iter().enumerate() {
                emitted += area * system.emission[i][c];
                let arrives = system.arriving(i, &solved.radiance)[c];
                absorbed += area * (1.0 - system.albedo[i][c]) * arrives;
            }
            assert!((emitted - absorbed).abs() < 1e-13, "{emitted} {absorbed}");
        }
    }

    #[test]
    fn nothing_that_shines_is_dark() {
        let (mut system, areas) = room();
        system.emission.fill([0.0; 3]);
        assert_eq!(system.gauss_seidel(1e-9).sweeps, 1);
        assert_eq!(system.southwell(&areas, 2).1, [0.0, 0.0]);
    }
}
