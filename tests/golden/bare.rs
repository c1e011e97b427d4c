//! A renderer that never had an effect: a pinhole, a light at a point, plain ambient light and mirrors.
//!
//! What a [`Renderer`] without effects is compared with: bit for bit on the host, in instructions and bytes of flash
//! on the boards.

use super::tracer::{
    Finish, Hit, Mirror, Pinhole, PointLight, Points, Ray, Renderer, Unoccluded, Vector,
};
use core::ops::Range;
use hemidisc::Domain;
use hemidisc::arithmetic::{Real, Root};

/// A scene without an effect.
pub type Scene<'a, A, P> = Renderer<'a, A, Pinhole, PointLight<A>, Unoccluded, Mirror, P>;

/// As [`Renderer::row`].
pub fn row<A: Root>(
    scene: &Scene<'_, A, impl Points>,
    [x, y]: [u32; 2],
    samples: Range<u32>,
    sums: &mut [Vector<A>],
) {
    for (x, pixel) in (x..).zip(sums) {
        let filter = Domain::new(scene.seed).pixel(x, y).child(0);
        for index in samples.clone() {
            let within = A::square(scene.points.point(filter, index));
            let [ahead_x, ahead_y] = scene.camera.image_point([x, y], within);
            let ray = scene.camera.ray([A::Real::ZERO; 3], [ahead_x, ahead_y, A::Real::ONE]);
            let seen = radiance(scene, &ray);
            *pixel = core::array::from_fn(|i| pixel[i] + seen[i]);
        }
    }
}

fn radiance<A: Root>(scene: &Scene<'_, A, impl Points>, ray: &Ray<A>) -> Vector<A> {
    let Some(hit) = nearest(scene, ray) else { return scene.sky.along(ray.direction) };
    let own = lit(scene, &hit);
    let (Finish::Mirror(reflectance) | Finish::Glossy(reflectance, Mirror)) = hit.material.finish
    else {
        return own;
    };
    let height = dot(ray.direction, hit.normal);
    let mirrored = core::array::from_fn(|i| ray.direction[i] + -(height + height) * hit.normal[i]);
    let ray = above(&hit, mirrored);
    let seen = match nearest(scene, &ray) {
        Some(hit) => lit(scene, &hit),
        None => scene.sky.along(ray.direction),
    };
    core::array::from_fn(|i| own[i] + reflectance[i] * seen[i])
}

fn lit<A: Root>(scene: &Scene<'_, A, impl Points>, hit: &Hit<'_, A, Mirror>) -> Vector<A> {
    let light = &scene.light;
    let to_light: Vector<A> = core::array::from_fn(|i| light.position[i] - hit.point[i]);
    let square = dot(to_light, to_light);
    let mut share = A::Real::ZERO;
    if square > A::Real::ONE / A::Real::MAX && square.finite() {
        let distance = A::sqrt(square);
        let direction = to_light.map(|component| component / distance);
        let cosine = -dot(direction, light.normal);
        if cosine > A::Real::ZERO || light.two_sided {
            let facing = cosine.magnitude() / square * dot(direction, hit.normal);
            let visible = facing * A::Real::FRAC_1_PI;
            if visible > A::Real::ZERO && clear(scene, &above(hit, direction), distance) {
                share = visible;
            }
        }
    }
    core::array::from_fn(|i| {
        let arriving = share * scene.intensity[i] + scene.ambient[i];
        hit.material.emission[i] + hit.albedo[i] * arriving
    })
}

/// The first surface along a ray.
fn nearest<'a, A: Root>(
    scene: &Scene<'a, A, impl Points>,
    ray: &Ray<A>,
) -> Option<Hit<'a, A, Mirror>> {
    let mut found = (A::Real::MAX, None);
    for sphere in scene.spheres {
        if let Some(distance) = sphere.meets(ray).filter(|distance| *distance < found.0) {
            found = (distance, Some(sphere.hit(ray, distance)));
        }
    }
    for plane in scene.planes {
        if let Some(distance) = plane.meets(ray).filter(|distance| *distance < found.0) {
            found = (distance, Some(plane.hit(ray, distance)));
        }
    }
    found.1
}

/// Whether nothing is met before a distance.
fn clear<A: Root>(scene: &Scene<'_, A, impl Points>, ray: &Ray<A>, distance: A::Real) -> bool {
    let before = |met: Option<A::Real>| met.is_some_and(|met| met < distance);
    !scene.spheres.iter().any(|sphere| before(sphere.meets(ray)))
        && !scene.planes.iter().any(|plane| before(plane.meets(ray)))
}

fn above<A: Root>(hit: &Hit<'_, A, Mirror>, direction: Vector<A>) -> Ray<A> {
    let above = A::sqrt(A::Real::EPSILON);
    Ray { origin: core::array::from_fn(|i| hit.point[i] + above * hit.normal[i]), direction }
}

fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
