//! tmp
pub mod camera;
pub mod chart;
pub mod cli;
pub mod color;
pub mod desk;
pub mod estimators;
pub mod geometry;
pub mod integrators;
pub mod ledger;
pub mod lights;
pub mod materials;
pub mod numeric;
pub mod output;
pub mod render;
pub mod sampling;
pub mod scene;
pub mod stats;
