//! The flat world: segments, circles and lamps in a plane, where every answer can be drawn.
//!
//! Light transport loses nothing but an angle when it loses a dimension. Lengths are in metres,
//! power in W, irradiance in W/m, radiance in W/(m·rad). A point sees a half *circle* of
//! directions; its irradiance is `∫ L cos θ dθ` over (-π/2, π/2), which is `2 L` under a constant
//! sky, so an ideal diffuse surface of albedo ρ reflects `ρ/2` per radian where a surface in space
//! reflects `ρ/π` per steradian. A point lamp fades with `1/r`, not with `1/r²`.
//! Source: Jarosz et al., Theory, Analysis and Applications of 2D Global Illumination (ACM TOG
//! 31(5), 2012).
//!
//! # Which side is the front
//!
//! A segment faces the left-hand side of the way from its first point to its second: its normal is
//! that way turned by +90°. A floor runs from left to right, a ceiling from right to left; a
//! closed polyline that runs counter-clockwise is a room, one that runs clockwise is a block. A
//! circle or an ellipse faces outwards. Both sides reflect alike, and glass lies behind the front; light is
//! emitted on the front side only.
//!
//! # Who does what
//!
//! [`description`] is what a file says, [`build`](mod@build) checks it, [`gallery`] holds the
//! worlds that come with the program; [`FlatWorld`] answers rays, [`FlatSurface`] lets them leave
//! safely, [`frame()`] turns a half disk to its normal, and [`exact`] knows the answers in closed
//! form.

mod area_light;
pub mod build;
pub mod description;
mod ellipse;
mod emission;
pub mod exact;
mod frame;
pub mod gallery;
mod point_light;
mod shape;
mod specular;
mod surface;
mod world;

pub use area_light::{AreaLight, AreaLightSample};
pub use ellipse::Ellipse;
pub use frame::frame;
pub use gallery::load;
pub use point_light::{LightAtPoint, PointLight};
pub use shape::{Circle, Intersection, Segment, Shape};
pub use specular::FlatSpecular;
pub use surface::FlatSurface;
pub use world::{FlatHit, FlatWorld, Object, Part, Window};
