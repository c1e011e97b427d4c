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

/// Sums of the pixels of a tile, in Morton's order.
pub(crate) type Sums = [Vector; SIDE * SIDE];
pub(crate) const SIDE: usize = 8;

/// [`tile`] of a source.
pub(crate) type Tile = fn(&View, &Request, u32) -> Sums;

impl View {
    pub(crate) fn new(size: [u32; 2]) -> Self {
        Self { scene: Scene::new(), camera: Camera::new(size), size }
    }

    pub(crate) fn tiles(&self) -> Range<u32> {
        let [x, y] = self.size.map(|s| s.div_ceil(SIDE as u32));
        0..x * y
    }

    pub(crate) fn pixel(&self, tile: u32, place: u32) -> Option<[u32; 2]> {
        let across = self.size[0].div_ceil(SIDE as u32);
        let every_other = |bits: u32| bits & 1 | bits >> 1 & 2 | bits >> 2 & 4;
        let pixel = [
            tile % across * SIDE as u32 + every_other(place),
            tile / across * SIDE as u32 + every_other(place >> 1),
        ];
        (pixel[0] < self.size[0] && pixel[1] < self.size[1]).then_some(pixel)
    }
}

/// The sums of `count` samples of each pixel of a tile.
pub(crate) fn tile<S: Source>(view: &View, request: &Request, count: u32) -> Sums {
    let mut source = S::new(request);
    let mut sums = [[0.0; 3]; SIDE * SIDE];
    for (place, sum) in (0..).zip(&mut sums) {
        let Some([x, y]) = view.pixel(request.tile, place) else { continue };
        source.pixel(x, y);
        for sample in request.first..request.first + count {
            let [[dx, dy], lens] = source.begin(sample);
            let ray = view.camera.ray([x as f32 + dx, y as f32 + dy], lens);
            let light = radiance(&view.scene, ray, &mut source);
            sum.iter_mut().zip(light).for_each(|(sum, light)| *sum += light);
        }
    }
    sums
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
