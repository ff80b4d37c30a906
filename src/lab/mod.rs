//! The laboratory: experiments, mistakes, charts, and what chapters share. It stands on the renderer, which
//! never uses it.

pub mod doctor;
pub mod effects;
pub mod estimators;
pub mod exercises;
pub mod experiment;
pub mod mistakes;
pub mod naive;

#[cfg(feature = "programs")]
pub mod chapter;
#[cfg(feature = "programs")]
pub mod drawing;
#[cfg(feature = "programs")]
pub mod figures;
#[cfg(feature = "programs")]
pub mod ledger;
