//! A renderer without effects: a pinhole, a light at a point, plain ambient light and mirrors.
//!
//! A [`Renderer`] without effects is compared with it: bit for bit on the host, in instructions and
//! bytes of flash on the boards. Both share the code that finds where rays end.

use crate::tracer::{
    Finish, Hit, Mirror, Pinhole, PointLight, Ray, Renderer, Source, Unoccluded, Vector,
};
use core::ops::Range;
use hemidisc::arithmetic::{Real, Root};

/// A scene without an effect.
pub type Scene<'a, A, P> = Renderer<'a, A, Pinhole, PointLight<A>, Unoccluded, Mirror, P>;

/// As [`Renderer::row`].
pub fn row<A: Root>(
    scene: &Scene<'_, A, impl Source>,
    [x, y]: [u32; 2],
    samples: Range<u32>,
    sums: &mut [Vector<A>],
) {
    for (x, pixel) in (x..).zip(sums) {
        for index in samples.clone() {
            let within = A::square(scene.source.sampler([x, y], index).child(0).pair());
            let [ahead_x, ahead_y] = scene.camera.image_point([x, y], within);
            let ray = scene.camera.ray([A::Real::ZERO; 3], [ahead_x, ahead_y, A::Real::ONE]);
            let seen = radiance(scene, &ray);
            *pixel = core::array::from_fn(|i| pixel[i] + seen[i]);
        }
    }
}

fn radiance<A: Root>(scene: &Scene<'_, A, impl Source>, ray: &Ray<A>) -> Vector<A> {
    let Some(hit) = scene.nearest(ray) else { return scene.sky.along(ray.direction) };
    let own = lit(scene, &hit);
    let (Finish::Mirror(reflectance) | Finish::Glossy(reflectance, Mirror)) = hit.material.finish
    else {
        return own;
    };
    let normal = hit.normal.get();
    let height = dot(ray.direction, normal);
    let mirrored = core::array::from_fn(|i| ray.direction[i] + -(height + height) * normal[i]);
    let ray = hit.leaving(mirrored);
    let seen = match scene.nearest(&ray) {
        Some(hit) => lit(scene, &hit),
        None => scene.sky.along(ray.direction),
    };
    core::array::from_fn(|i| own[i] + reflectance[i] * seen[i])
}

fn lit<A: Root>(scene: &Scene<'_, A, impl Source>, hit: &Hit<'_, A, Mirror>) -> Vector<A> {
    let light = &scene.light;
    let to_light: Vector<A> = core::array::from_fn(|i| light.position[i] - hit.point[i]);
    let square = dot(to_light, to_light);
    let mut share = A::Real::ZERO;
    if square >= A::Real::MIN_POSITIVE && square.finite() {
        let distance = A::sqrt(square);
        let direction = to_light.map(|component| component / distance);
        let away: Vector<A> = core::array::from_fn(|i| hit.point[i] + -light.position[i]);
        let normal = light.normal.get();
        let height = dot(away, normal);
        let size_of = |v: Vector<A>| dot(v.map(Real::magnitude), normal.map(Real::magnitude));
        let half_a_step = A::Real::EPSILON * A::Real::HALF;
        let given = size_of(light.position) * half_a_step + size_of(hit.point) * half_a_step;
        let rounding = given + size_of(away) * (A::Real::EPSILON * A::Real::TWO);
        let cosine = if height.magnitude() > rounding { height / distance } else { A::Real::ZERO };
        if cosine > A::Real::ZERO || light.two_sided {
            let facing = cosine.magnitude() / square * dot(direction, hit.normal.get());
            let visible = facing * A::Real::FRAC_1_PI;
            if visible > A::Real::ZERO && scene.meets(&hit.leaving(direction), distance).is_none() {
                share = visible;
            }
        }
    }
    core::array::from_fn(|i| {
        let arriving = share * scene.intensity[i] + scene.ambient[i];
        hit.material.emission[i] + hit.albedo[i] * arriving
    })
}

fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
