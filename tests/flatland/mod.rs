//! The flat world: its first hits, the rays that leave its walls, its closed forms and its files.
//!
//! | What | Test | Figure seen |
//! |---|---|---|
//! | First hits against plain `f64` | `rays::the_first_hit_*` | 400 000 rays agree, \|Δt\| / t 5.9e-8, points 0.50 of their bound |
//! | Rays that leave, sizes 1e-3 to 1e4 | `rays::rays_that_leave_*` | 0 of 277 234 again; 45 % from plain hit points |
//! | Corners of rooms | `rays::nothing_slips_*` | 0 of 157 500 rays escape |
//! | Sky, segments, circles | `light::*` | all \|z\| < 1.6 |
//! | The room by random walks | `light::the_room_*` | 0.33092 ± 0.00028, exactly 0.3306794 |

mod draw;
mod files;
mod light;
mod rays;
