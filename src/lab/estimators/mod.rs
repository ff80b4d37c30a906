//! Estimators that answer one question each, smaller than a picture.
//!
//! * [`hit_or_miss`], [`many_dimensions`]: integrals, before there is any light;
//! * [`directions`], [`gather`]: the light over a surface, in the flat world and in space;
//! * [`worlds`]: worlds with known answers, to gather and to walk in;
//! * [`furnace`]: the reading every right estimator must give;
//! * [`mixed_furnace`]: the choice of one ray among three, under light from everywhere;
//! * [`walks`]: many walks along one ray; [`shrinking_lamp`]: chance and aim under a small lamp;
//!   [`pick_one`]: one lamp of many; [`split`]: several paths from the first surface;
//! * [`aperture`], [`two_ways`]: light that looks for the eye;
//! * [`overhead`]: one lamp found by chance, by aiming, by both;
//! * [`survival`]: walks that end by chance, and what that costs;
//! * [`profiles`]: integrals of a picture one at a time, against closed forms.

pub mod aperture;
pub mod directions;
pub mod furnace;
pub mod gather;
pub mod hit_or_miss;
pub mod many_dimensions;
pub mod mixed_furnace;
pub mod overhead;
pub mod pick_one;
pub mod plane_world;
pub mod profiles;
pub mod shrinking_lamp;
pub mod split;
pub mod survival;
pub mod two_ways;
pub mod walks;
pub mod worlds;
