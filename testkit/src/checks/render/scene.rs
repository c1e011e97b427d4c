//! Tiny scenes of any bytes, and the effects that they call for.
//!
//! Places are multiples of 1/256, so that what should not coincide often does, times a power of
//! two.

use super::super::roots::nearest;
use crate::arithmetics::{Exponent, Tested};
use crate::tracer::{
    Ambient, Camera, Checker, Counts, Finish, Lens, Material, Pinhole, Plane, Sky, Sphere,
    Unoccluded, Vector,
};
use arbitrary::Arbitrary;
use hemidisc::arithmetic::{Real, Root};
use hemidisc::effect::{AmbientOcclusion, BelowHorizon, Glossy, LensRay, Polygon, ThinLens};
use hemidisc::{Concentric, Error, Frame, Unit};

#[derive(Arbitrary, Debug)]
pub struct Scene {
    /// Of all lengths: a power of two.
    pub scale: i8,
    pub size: [u8; 2],
    pub samples: u8,
    pub seed: u32,
    position: Place,
    ahead: Place,
    slope: u8,
    lens: Option<(u8, u8, bool)>,
    pub lamp: Lamp,
    ambient: Colour,
    reach: Option<u8>,
    sky: [Colour; 2],
    spheres: [Option<(Place, u8, Surface)>; 2],
    planes: [Option<Wall>; 2],
}

/// A plane, perhaps chequered.
#[derive(Arbitrary, Clone, Copy, Debug)]
struct Wall {
    point: Place,
    normal: Place,
    surface: Surface,
    squares: Option<u8>,
}

type Place = [i16; 3];
type Colour = [u8; 3];

#[derive(Arbitrary, Clone, Copy, Debug)]
pub struct Lamp {
    position: Place,
    toward: Place,
    intensity: Colour,
    pub two_sided: bool,
    pub radius: Option<u8>,
}

#[derive(Arbitrary, Clone, Copy, Debug)]
struct Surface {
    albedo: Colour,
    emission: Colour,
    shine: Option<(Colour, Option<u16>, BelowHorizon)>,
}

/// A lens, or none.
#[derive(Clone, Copy, Debug)]
pub enum AnyLens<A: Root<Real: Real>> {
    Pinhole,
    Round(ThinLens<Concentric<A>, A::Real>),
    Blades(ThinLens<Polygon<A, 6>, A::Real>),
}

impl<A: Root<Real: Real>> Lens<A> for AnyLens<A> {
    fn ray(
        &self,
        centre: [A::Real; 2],
        draw: impl FnOnce() -> [u32; 2],
        counts: &mut Counts,
    ) -> LensRay<A::Real> {
        match self {
            Self::Pinhole => Lens::<A>::ray(&Pinhole, centre, draw, counts),
            Self::Round(lens) => Lens::<A>::ray(lens, centre, draw, counts),
            Self::Blades(lens) => Lens::<A>::ray(lens, centre, draw, counts),
        }
    }
}

/// Ambient light that may be hidden, or not.
#[derive(Clone, Copy, Debug)]
pub enum AnyAmbient<A: Root<Real: Real>> {
    Everywhere,
    Occluded(AmbientOcclusion<A>),
}

impl<A: Root<Real: Real>> Ambient<A> for AnyAmbient<A> {
    fn openness(
        &self,
        normal: Unit<A::Real>,
        meets: impl Fn(Vector<A>, A::Real) -> Option<A::Real>,
        draw: impl FnOnce() -> [u32; 2],
        counts: &mut Counts,
    ) -> A::Real {
        match self {
            Self::Everywhere => Ambient::<A>::openness(&Unoccluded, normal, meets, draw, counts),
            Self::Occluded(occlusion) => {
                Ambient::<A>::openness(occlusion, normal, meets, draw, counts)
            }
        }
    }
}

impl Scene {
    fn lengths<A: Tested, const N: usize>(&self, lengths: [f64; N]) -> [A::Real; N] {
        let unit = 2.0_f64.powi(i32::from(self.scale) / 2) / 256.0;
        nearest::<A, N>(lengths.map(|x| x * unit))
    }

    pub fn place<A: Tested>(&self, place: Place) -> [A::Real; 3] {
        self.lengths::<A, 3>(place.map(f64::from))
    }

    /// A length of up to a unit of the scene; never 0.
    fn length<A: Tested>(&self, length: u8) -> A::Real {
        let [length] = self.lengths::<A, 1>([f64::from(length) + 1.0]);
        length
    }

    pub fn radius<A: Tested>(&self, radius: u8) -> A::Real {
        let [radius] = self.lengths::<A, 1>([f64::from(radius)]);
        radius
    }

    pub fn camera<A: Root<Real: Real> + Tested>(&self, size: [u32; 2]) -> Result<Camera<A>, Error> {
        let slope = nearest::<A, 1>([(f64::from(self.slope) + 1.0) / 64.0])[0];
        Camera::new(self.place::<A>(self.position), self.place::<A>(self.ahead), slope, size)
    }

    pub fn lens<A: Root<Real: Real> + Tested>(&self) -> AnyLens<A> {
        let Some((radius, focus, round)) = self.lens else { return AnyLens::Pinhole };
        let (radius, focus) = (self.radius::<A>(radius), self.length::<A>(focus));
        if round {
            AnyLens::Round(ThinLens::new(Concentric::new(), radius, focus).unwrap())
        } else {
            AnyLens::Blades(ThinLens::new(Polygon::new(self.seed), radius, focus).unwrap())
        }
    }

    /// Whether the lens is a pinhole.
    pub fn is_sharp(&self) -> bool {
        self.lens.is_none_or(|(radius, ..)| radius == 0)
    }

    pub fn has_lens(&self) -> bool {
        self.lens.is_some()
    }

    pub fn has_occlusion(&self) -> bool {
        self.reach.is_some()
    }

    pub fn has_glossy(&self) -> bool {
        let spheres = self.spheres.iter().flatten().map(|(_, _, surface)| surface);
        let planes = self.planes.iter().flatten().map(|wall| &wall.surface);
        spheres.chain(planes).any(|surface| matches!(surface.shine, Some((_, Some(_), _))))
    }

    pub fn occlusion<A: Root<Real: Real> + Tested>(&self) -> AnyAmbient<A> {
        self.reach.map_or(AnyAmbient::Everywhere, |reach| {
            AnyAmbient::Occluded(AmbientOcclusion::new(self.length::<A>(reach)).unwrap())
        })
    }

    pub fn lamp<A: Root<Real: Real> + Tested>(&self) -> Result<(Vector<A>, Frame<A::Real>), Error> {
        let frame = Frame::normalized(self.place::<A>(self.lamp.toward))?;
        Ok((self.place::<A>(self.lamp.position), frame))
    }

    /// Of 1 unit of the scene's length away.
    pub fn intensity<A: Tested>(&self) -> [A::Real; 3] {
        colour::<A>(self.lamp.intensity)
    }

    pub fn ambient<A: Tested>(&self) -> [A::Real; 3] {
        colour::<A>(self.ambient)
    }

    pub fn sky<A: Tested>(&self) -> Sky<A> {
        let [horizon, zenith] = self.sky.map(colour::<A>);
        Sky { horizon, zenith }
    }

    pub fn spheres<A: Root<Real: Real> + Tested>(&self) -> Vec<Sphere<A, Glossy<A>>> {
        let sphere = |(centre, radius, surface)| Sphere {
            centre: self.place::<A>(centre),
            radius: self.length::<A>(radius),
            material: material::<A>(surface),
        };
        self.spheres.into_iter().flatten().map(sphere).collect()
    }

    pub fn planes<A: Root<Real: Real> + Tested>(&self) -> Vec<Plane<A, Glossy<A>>> {
        let plane = |wall: Wall| {
            // Without a direction there is no plane.
            let frame = Frame::normalized(self.place::<A>(wall.normal)).ok()?;
            let checker = wall.squares.map(|size| Checker {
                albedo: colour::<A>([40, 200, 90]),
                size: self.length::<A>(size),
            });
            let (point, material) = (self.place::<A>(wall.point), material::<A>(wall.surface));
            Some(Plane { point, frame, material, checker })
        };
        self.planes.into_iter().flatten().filter_map(plane).collect()
    }
}

fn colour<A: Tested>(colour: Colour) -> [A::Real; 3] {
    nearest::<A, 3>(colour.map(|x| f64::from(x) / 255.0))
}

fn material<A: Root<Real: Real> + Tested>(surface: Surface) -> Material<A, Glossy<A>> {
    let finish = match surface.shine {
        None => Finish::Matte,
        Some((reflectance, None, _)) => Finish::Mirror(colour::<A>(reflectance)),
        Some((reflectance, Some(exponent), below)) => {
            let exponent = A::Parameter::exactly(exponent.into()).unwrap();
            Finish::Glossy(colour::<A>(reflectance), Glossy::new(exponent, below).unwrap())
        }
    };
    let [albedo, emission] = [surface.albedo, surface.emission].map(colour::<A>);
    Material { albedo, emission, finish }
}
