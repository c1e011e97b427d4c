//! A scene as its file describes it: lengths in any one unit, y up, colours linear RGB.
//!
//! An effect is called for by its field: `lens`, the light's `radius`, the ambient light's `reach`,
//! a reflection's `exponent`. Without it what is left is a pinhole, a light at a point, plain
//! ambient light, a mirror.

use crate::render::effects::{Effect, Effects};
use crate::render::values::{Angle, Colour, Direction, Distance, Exponent, Point, Radius, Size};
use serde::Deserialize;

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Scene {
    pub camera: Camera,
    pub lens: Option<Lens>,
    pub light: Light,
    pub ambient: Ambient,
    pub sky: Sky,
    #[serde(default)]
    pub spheres: Vec<Sphere>,
    #[serde(default)]
    pub planes: Vec<Plane>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    pub position: Point,
    pub ahead: Direction,
    /// From the bottom of the image to its top, in degrees.
    pub field_of_view: Angle,
}

/// Depth of field.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Lens {
    pub radius: Radius,
    pub focus: Distance,
    #[serde(default)]
    pub aperture: Aperture,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub enum Aperture {
    #[default]
    Round,
    Hexagon,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Light {
    pub position: Point,
    /// Its axis.
    pub toward: Direction,
    /// Along the axis.
    pub intensity: Colour,
    #[serde(default)]
    pub two_sided: bool,
    /// Of a disc: soft shadows.
    pub radius: Option<Radius>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Ambient {
    pub colour: Colour,
    /// How far occlusion looks.
    pub reach: Option<Distance>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sky {
    pub horizon: Colour,
    pub zenith: Colour,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Sphere {
    pub centre: Point,
    pub radius: Size,
    pub material: Material,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Plane {
    pub point: Point,
    pub normal: Direction,
    pub material: Material,
    pub checker: Option<Checker>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Checker {
    pub albedo: Colour,
    pub size: Size,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Material {
    pub albedo: Colour,
    #[serde(default)]
    pub emission: Colour,
    pub reflection: Option<Reflection>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reflection {
    pub reflectance: Colour,
    /// Of a glossy lobe; a mirror has none.
    pub exponent: Option<Exponent>,
}

impl Scene {
    /// The effects that it calls for.
    pub fn effects(&self) -> Effects {
        let materials = self.spheres.iter().map(|sphere| &sphere.material);
        let mut materials = materials.chain(self.planes.iter().map(|plane| &plane.material));
        let glossy = materials
            .any(|material| material.reflection.as_ref().is_some_and(|r| r.exponent.is_some()));
        let called_for = |effect: &Effect| match effect {
            Effect::ThinLens => self.lens.is_some(),
            Effect::DiscLight => self.light.radius.is_some(),
            Effect::AmbientOcclusion => self.ambient.reach.is_some(),
            Effect::Glossy => glossy,
        };
        Effect::ALL.iter().copied().filter(called_for).collect()
    }
}
