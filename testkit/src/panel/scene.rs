//! A scene in code with all four effects: balls of silver, glaze, brass and clay on a chequered
//! table at dusk.

use crate::tracer::{Camera, Checker, Finish, Material, Plane, Renderer, Sky, Sphere};
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, Polygon, ThinLens};
use hemidisc::{Domain, Error, FastF32, Frame, Screen};

/// The renderer of the scene, in polynomials of `f32` alone.
///
/// In a scene without one of the effects another type is in its place here, and its code is not in
/// the image.
pub type StillLife<'a> = Renderer<
    'a,
    FastF32,
    ThinLens<Polygon<FastF32, 6>, f32>,
    DiscLight<FastF32>,
    AmbientOcclusion<FastF32>,
    Glossy<FastF32>,
    Screen,
>;

/// The balls and the table.
#[derive(Debug)]
pub struct Objects {
    spheres: [Sphere<FastF32, Glossy<FastF32>>; 7],
    planes: [Plane<FastF32, Glossy<FastF32>>; 1],
}

impl Objects {
    /// All of them.
    ///
    /// # Errors
    /// None for the values that are here.
    pub fn new() -> Result<Self, Error> {
        let material = |albedo, finish| Material { albedo, emission: [0.0; 3], finish };
        let shiny = |albedo, reflectance, exponent| {
            let lobe = Glossy::new(exponent, BelowHorizon::Flip)?;
            Ok(material(albedo, Finish::Glossy(reflectance, lobe)))
        };
        let matte = |albedo| material(albedo, Finish::Matte);
        let silver = shiny([0.03, 0.03, 0.03], [0.86, 0.85, 0.82], 3000.0)?;
        let glaze = shiny([0.55, 0.12, 0.06], [0.14, 0.14, 0.14], 400.0)?;
        let brass = shiny([0.12, 0.08, 0.03], [0.7, 0.52, 0.25], 30.0)?;
        let ball = |centre, radius, material| Sphere { centre, radius, material };
        Ok(Self {
            spheres: [
                ball([0.1, 0.8, -0.2], 0.8, silver),
                ball([-1.35, 0.55, 0.2], 0.55, glaze),
                ball([1.4, 0.5, 0.4], 0.5, brass),
                ball([-0.5, 0.27, 1.1], 0.27, matte([0.7, 0.4, 0.08])),
                ball([0.62, 0.24, 1.15], 0.24, matte([0.25, 0.4, 0.1])),
                ball([2.3, 0.6, -2.0], 0.6, matte([0.2, 0.3, 0.5])),
                ball([-2.6, 0.6, -2.4], 0.6, matte([0.45, 0.42, 0.36])),
            ],
            planes: [Plane {
                point: [0.0; 3],
                frame: Frame::new([0.0, 1.0, 0.0])?,
                material: matte([0.58, 0.55, 0.5]),
                checker: Some(Checker { albedo: [0.16, 0.17, 0.2], size: 0.7 }),
            }],
        })
    }

    /// The scene with these objects, for a panel of a width and a height in pixels and a number of
    /// samples in each.
    ///
    /// # Errors
    /// None for the values that are here.
    pub fn still_life(&self, size: [u32; 2], samples: u32) -> Result<StillLife<'_>, Error> {
        let toward = Frame::normalized([0.45, -0.75, -0.45])?;
        Ok(Renderer {
            camera: Camera::new([0.2, 1.7, 5.0], [-0.03, -0.21, -1.0], 0.36, size)?,
            lens: ThinLens::new(Polygon::new(1 << 30), 0.1, 4.9)?,
            light: DiscLight::new([-2.6, 4.6, 2.6], toward, 0.6)?,
            intensity: [58.0, 53.0, 45.0],
            ambient: [0.16, 0.17, 0.21],
            occlusion: AmbientOcclusion::new(1.2)?,
            sky: Sky { horizon: [0.42, 0.3, 0.28], zenith: [0.05, 0.09, 0.25] },
            spheres: &self.spheres,
            planes: &self.planes,
            source: Screen::new(Domain::new(7), size, samples)?,
        })
    }
}
