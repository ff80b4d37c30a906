//! Estimators that answer one question each, smaller than a picture. Those that serve one chapter
//! alone stand in its folder.
//!
//! * [`hit_or_miss`], [`many_dimensions`]: integrals, before there is any light;
//! * [`directions`], [`gather`]: the light over a surface, in the flat world and in space;
//! * [`worlds`]: worlds with known answers, to gather and to walk in;
//! * [`furnace`]: the reading every right estimator must give;
//! * [`walks`]: many walks along one ray;
//! * [`overhead`]: one lamp found by chance, by aiming, by both.

pub mod directions;
pub mod furnace;
pub mod gather;
pub mod hit_or_miss;
pub mod many_dimensions;
pub mod overhead;
pub mod walks;
pub mod worlds;
