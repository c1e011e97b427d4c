//! Paths: from the lens, off what they meet, to the sky.

use crate::camera::Camera;
use crate::scene::{Ray, Scene, sky};
use crate::source::{Request, Source};
use crate::vector::{Vector, product};
use std::ops::Range;

/// Surfaces that a path meets at most.
const SURFACES: u32 = 16;

/// What is seen, and from where.
#[derive(Clone, Debug)]
pub(crate) struct View {
    scene: Scene,
    camera: Camera,
    pub(crate) size: [u32; 2],
}

/// Adds samples of a row's pixels to sums: [`row`] of a source.
pub(crate) type Row = fn(&View, &Request, u32, &mut [Vector]);

impl View {
    pub(crate) fn new(size: [u32; 2]) -> Self {
        Self { scene: Scene::new(), camera: Camera::new(size), size }
    }

    pub(crate) fn rows(&self) -> Range<u32> {
        0..self.size[1]
    }
}

/// Adds `count` samples of each pixel of a row to the sums.
pub(crate) fn row<S: Source>(view: &View, request: &Request, count: u32, sums: &mut [Vector]) {
    let mut source = S::new(request);
    for (x, sum) in (0..).zip(sums) {
        source.pixel(x);
        for sample in 0..count {
            let [[dx, dy], lens] = source.begin(sample);
            let ray = view.camera.ray([x as f32 + dx, request.y as f32 + dy], lens);
            let light = radiance(&view.scene, ray, &mut source);
            sum.iter_mut().zip(light).for_each(|(sum, light)| *sum += light);
        }
    }
}

/// The light that arrives against a ray.
fn radiance<S: Source>(scene: &Scene, mut ray: Ray, source: &mut S) -> Vector {
    let mut left = [1.0; 3];
    for _ in 0..SURFACES {
        let Some(hit) = scene.hit(&ray) else { return product(left, sky(ray.direction)) };
        source.bounce();
        let Some((direction, colour)) = hit.material.scatter(&ray, &hit, source) else { break };
        left = product(left, colour);
        ray = Ray { origin: hit.point, direction };
    }
    [0.0; 3]
}
