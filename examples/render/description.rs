//! A scene as its file describes it: lengths in any one unit, y up, colours linear RGB.
//!
//! An effect is called for by its field: `lens`, the light's `radius`, the ambient light's `reach`, a reflection's
//! `exponent`. Without it what is left is a pinhole, a light at a point, plain ambient light, a mirror.

use crate::effects::{Effect, Effects};
use crate::values::{Angle, Colour, Direction, Distance, Exponent, Point, Radius, Size};
use serde::Deserialize;

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Scene {
    pub(crate) camera: Camera,
    pub(crate) lens: Option<Lens>,
    pub(crate) light: Light,
    pub(crate) ambient: Ambient,
    pub(crate) sky: Sky,
    #[serde(default)]
    pub(crate) spheres: Vec<Sphere>,
    #[serde(default)]
    pub(crate) planes: Vec<Plane>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Camera {
    pub(crate) position: Point,
    pub(crate) ahead: Direction,
    /// From the bottom of the image to its top, in degrees.
    pub(crate) field_of_view: Angle,
}

/// Depth of field.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Lens {
    pub(crate) radius: Radius,
    pub(crate) focus: Distance,
    #[serde(default)]
    pub(crate) aperture: Aperture,
}

#[derive(Clone, Copy, Debug, Default, Deserialize)]
pub(crate) enum Aperture {
    #[default]
    Round,
    Hexagon,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Light {
    pub(crate) position: Point,
    /// Its axis.
    pub(crate) toward: Direction,
    /// Along the axis.
    pub(crate) intensity: Colour,
    #[serde(default)]
    pub(crate) two_sided: bool,
    /// Of a disc: soft shadows.
    pub(crate) radius: Option<Radius>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Ambient {
    pub(crate) colour: Colour,
    /// How far occlusion looks.
    pub(crate) reach: Option<Distance>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sky {
    pub(crate) horizon: Colour,
    pub(crate) zenith: Colour,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Sphere {
    pub(crate) centre: Point,
    pub(crate) radius: Size,
    pub(crate) material: Material,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Plane {
    pub(crate) point: Point,
    pub(crate) normal: Direction,
    pub(crate) material: Material,
    pub(crate) checker: Option<Checker>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Checker {
    pub(crate) albedo: Colour,
    pub(crate) size: Size,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Material {
    pub(crate) albedo: Colour,
    #[serde(default)]
    pub(crate) emission: Colour,
    pub(crate) reflection: Option<Reflection>,
}

#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Reflection {
    pub(crate) reflectance: Colour,
    /// Of a glossy lobe; a mirror has none.
    pub(crate) exponent: Option<Exponent>,
}

impl Scene {
    /// The effects that it calls for.
    pub(crate) fn effects(&self) -> Effects {
        let materials = self.spheres.iter().map(|sphere| &sphere.material);
        let mut materials = materials.chain(self.planes.iter().map(|plane| &plane.material));
        let glossy = materials
            .any(|material| material.reflection.as_ref().is_some_and(|r| r.exponent.is_some()));
        let called_for = |effect: &Effect| match effect {
            Effect::Lens => self.lens.is_some(),
            Effect::Light => self.light.radius.is_some(),
            Effect::Occlusion => self.ambient.reach.is_some(),
            Effect::Glossy => glossy,
        };
        Effect::ALL.into_iter().filter(called_for).collect()
    }
}
