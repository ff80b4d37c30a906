//! Four ways to choose the directions of a gather; all have the same mean.

use crate::sampling::stream::Numbers;
use crate::space::Space;

/// How the `N` directions over a surface are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Recipe {
    /// Each uniform over the surface: the essay's way.
    Uniform,
    /// Each proportional to its cosine with the normal.
    Cosine,
    /// Uniform, one in each of `N` equal parts.
    Stratified,
    /// Proportional to the cosine, one in each of `N` parts of equal probability.
    StratifiedCosine,
}

/// A direction that was chosen.
#[derive(Clone, Copy, Debug)]
pub struct Drawn<S: Space> {
    /// Local and unit.
    pub w: S::Vector,
    /// The density it was drawn with, per radian or steradian; positive.
    pub pdf: f32,
}

impl Recipe {
    /// All of them.
    pub const ALL: [Recipe; 4] = [
        Recipe::Uniform,
        Recipe::Cosine,
        Recipe::Stratified,
        Recipe::StratifiedCosine,
    ];

    /// The `index`-th of `count` directions.
    ///
    /// Strata leave the density alone: all `count` directions together follow it.
    pub fn draw<S: Space>(self, index: u32, count: u32, numbers: &mut Numbers) -> Drawn<S> {
        let u = S::uniforms(numbers);
        let stratified = matches!(self, Recipe::Stratified | Recipe::StratifiedCosine);
        let u = if stratified {
            S::stratified(index, count, u)
        } else {
            u
        };
        match self {
            Recipe::Uniform | Recipe::Stratified => {
                let w = S::sample_uniform(u);
                let pdf = S::pdf_uniform(w);
                Drawn { w, pdf }
            }
            Recipe::Cosine | Recipe::StratifiedCosine => {
                let w = S::sample_cosine(u);
                let pdf = S::pdf_cosine(w);
                Drawn { w, pdf }
            }
        }
    }
}
