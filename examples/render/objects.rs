//! Spheres, planes and what they are made of, in the numbers of an arithmetic.

use crate::render::description::{self as scene, Scene};
use crate::render::values::Exponent;
use hemidisc::Frame;
use hemidisc::arithmetic::{Arithmetic, Root};
use testkit::tracer::{Checker, Finish, Material, Plane, Sphere};

pub fn spheres<A: Root, G>(
    scene: &Scene,
    lobe: &impl Fn(Exponent) -> Result<G, String>,
) -> Result<Vec<Sphere<A, G>>, String> {
    let sphere = |(number, sphere): (usize, &scene::Sphere)| {
        let material = material::<A, G>(&sphere.material, lobe)
            .map_err(|wrong| format!("spheres[{number}].{wrong}"))?;
        let centre = vector::<A>(sphere.centre.0);
        Ok(Sphere { centre, radius: real::<A>(sphere.radius.0), material })
    };
    scene.spheres.iter().enumerate().map(sphere).collect()
}

pub fn planes<A: Root, G>(
    scene: &Scene,
    lobe: &impl Fn(Exponent) -> Result<G, String>,
) -> Result<Vec<Plane<A, G>>, String> {
    let plane = |(number, plane): (usize, &scene::Plane)| {
        let material = material::<A, G>(&plane.material, lobe)
            .map_err(|wrong| format!("planes[{number}].{wrong}"))?;
        let frame = Frame::normalized(vector::<A>(plane.normal.0))
            .map_err(|error| named::<A>(&format!("planes[{number}].normal"), error))?;
        let checker = plane.checker.as_ref().map(|checker| Checker {
            albedo: vector::<A>(checker.albedo.0),
            size: real::<A>(checker.size.0),
        });
        Ok(Plane { point: vector::<A>(plane.point.0), frame, material, checker })
    };
    scene.planes.iter().enumerate().map(plane).collect()
}

fn material<A: Root, G>(
    material: &scene::Material,
    lobe: &impl Fn(Exponent) -> Result<G, String>,
) -> Result<Material<A, G>, String> {
    let finish = match &material.reflection {
        None => Finish::Matte,
        Some(scene::Reflection { reflectance, exponent: None }) => {
            Finish::Mirror(vector::<A>(reflectance.0))
        }
        Some(scene::Reflection { reflectance, exponent: Some(exponent) }) => {
            let lobe = lobe(*exponent).map_err(|wrong| format!("material.reflection.{wrong}"))?;
            Finish::Glossy(vector::<A>(reflectance.0), lobe)
        }
    };
    let [albedo, emission] = [material.albedo.0, material.emission.0].map(vector::<A>);
    Ok(Material { albedo, emission, finish })
}

/// What a field's number, good in f64, is in the arithmetic.
pub fn named<A: Arithmetic>(field: &str, error: hemidisc::Error) -> String {
    format!("{field} in {}: {error}", A::NAME)
}

pub fn vector<A: Root>(numbers: [f64; 3]) -> [A::Real; 3] {
    numbers.map(real::<A>)
}

/// The number nearest to the one in the scene's text; that of every f64 is a number.
pub fn real<A: Root>(number: f64) -> A::Real {
    number.to_string().parse().unwrap_or_default()
}
