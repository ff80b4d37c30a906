//! # halfdisk
//!
//! Light transport by running it: from Whitted's ray tracing through a sampler in the half disk of
//! a flat world to full path tracing, every step a program to run, a page to read, a picture to
//! compare, a number to check and a curve to plot.
//!
//! ```no_run
//! use halfdisk::integrators::Path;
//! use halfdisk::render::{Options, render};
//! use halfdisk::scene::gallery;
//!
//! let scene = gallery::load("spheres")?;
//! let picture = render(&scene, &Path::new(8), &Options::default(), &());
//! let (mean, error) = picture.film.mean();
//! println!("{mean:.4} ± {error:.4}");
//! # Ok::<(), halfdisk::scene::SceneError>(())
//! ```
//!
//! ## Reading order
//!
//! Each module uses only modules above it in this list; a test keeps it so.
//!
//! 1. [`numeric`]: care for floating point; [`color`]: a radiometric triple; [`notation`]: light
//!    paths as words; [`time`]: the clock
//! 2. [`sampling`]: random numbers and what they are bent into; [`stats`]: estimates with errors
//! 3. [`geometry`]: rays, shapes, the hierarchy that finds the closest hit; [`space`]: what a
//!    dimension is, so that one source serves both
//! 4. [`materials`]: materials, and the BSDF at a point; [`lights`]; [`camera`]
//! 5. [`scene`]: from a file to something rays can intersect; [`flatland`]: the same in the flat world
//! 6. [`radiosity`]: light on patches, solved at once; [`photons`]: where light from the lights lands
//! 7. [`integrators`]: the stages of the algorithm, side by side, in any [`integrators::world::World`]
//! 8. [`render`]: the pixel loop and the film; [`output`]: pictures as files
//! 9. [`lab`]: the laboratory, which the modules above never use: [`lab::effects`], what a scene calls
//!    for; [`lab::estimators`], smaller questions than a picture; [`lab::mistakes`] and [`lab::doctor`],
//!    wrong estimators and how to tell them; [`lab::exercises`], answers that are graded by what they read;
//!    [`lab::experiment`], repeated runs that end in data;
//!    [`lab::drawing`] and [`lab::figures`], charts; [`lab::chapter`] and [`lab::ledger`], what chapters share
//! 10. [`cli`]: the command
//!
//! The charts, what chapters share, and the command belong to the feature `programs`, which is on
//! unless `default-features = false` is said: then the library is the renderer alone, reads and
//! writes no EXR, and needs none of the crates for commands and charts.
//!
//! ## Vocabulary
//!
//! | symbol | is |
//! |---|---|
//! | `wo` | unit direction towards the eye, leaving the surface |
//! | `wi` | unit direction towards the light, leaving the surface |
//! | `n` | unit normal of a surface, on its front side |
//! | interaction | what a ray met: the point, its BSDF, its emission; the closest hit, looked at once |
//! | `f` | BSDF in 1/sr, **without** the cosine |
//! | `pdf` | probability density in 1/sr; `pdf_area` in 1/m² |
//! | `li` | incoming radiance in W/(m² sr) |
//! | `beta` | throughput: the product of `f cos / pdf` along a path so far |
//! | BSDF sampling | `sample_bsdf`: the next direction of a path, drawn as the surface scatters |
//! | next-event estimation | `sample_light` and a shadow ray: light straight from a light source |
//! | MIS | multiple importance sampling: both, each weighted by the densities of both |
//! | `rr` | Russian roulette |
//! | `u` | uniforms in `[0, 1)`: multiples of 2^-24 where a point is drawn, of 2^-53 where one of many is chosen |
//! | `spp` | samples per pixel |
//! | depth | path segments, the camera ray first, the one that ends on the light last |
//!
//! Light paths are words in Heckbert's letters: `L` light, `D` diffuse, `S` specular, `G` gloss,
//! `E` eye.
//!
//! ## Conventions
//!
//! The world is right-handed with y up; local frames have z along the normal. Lengths are in scene
//! units, angles in radians (degrees in files). Colours are linear. Transport is `f32` with glam's
//! scalar [`Vec3`](glam::Vec3); every sum over samples is `f64`, in a fixed order for each pixel,
//! so a picture is the same bytes on any number of threads.

pub use glam;

pub mod camera;
#[cfg(feature = "programs")]
pub mod cli;
pub mod color;
pub mod flatland;
pub mod geometry;
pub mod integrators;
pub mod lab;
pub mod lights;
pub mod materials;
pub mod notation;
pub mod numeric;
pub mod output;
pub mod photons;
pub mod radiosity;
pub mod render;
pub mod sampling;
pub mod scene;
pub mod space;
pub mod stats;
pub mod time;
