//! Paths: from the lens, off what they meet, to the sky. And the pixels of a tile.

use crate::camera::Camera;
use crate::scene::{Ray, Scene, sky};
use crate::source::{Request, Source};
use crate::vector::{Vector, product};
use std::ops::Range;

/// Surfaces that a path meets at most.
const SURFACES: u32 = 16;

/// Pixels along the side of a tile.
const SIDE: u32 = 8;

/// Pixels of a tile.
pub(crate) const PIXELS: usize = (SIDE * SIDE) as usize;

/// What is seen, and from where.
#[derive(Clone, Debug)]
pub(crate) struct View {
    scene: Scene,
    camera: Camera,
    size: [u32; 2],
}

impl View {
    pub(crate) fn new(size: [u32; 2]) -> Self {
        Self { scene: Scene::new(), camera: Camera::new(size), size }
    }

    pub(crate) const fn size(&self) -> [u32; 2] {
        self.size
    }

    /// By rows from the top left.
    pub(crate) fn tiles(&self) -> Range<u32> {
        let [across, down] = self.size.map(|pixels| pixels.div_ceil(SIDE));
        0..across * down
    }

    /// The pixel at a place of a tile, if it is in the picture. In Morton's order, for samples have
    /// that order.
    #[inline]
    pub(crate) fn pixel(&self, tile: u32, place: u32) -> Option<[u32; 2]> {
        let [width, height] = self.size;
        let across = width.div_ceil(SIDE);
        let every_other = |bits: u32| bits & 1 | bits >> 1 & 2 | bits >> 2 & 4;
        let x = SIDE * (tile % across) + every_other(place);
        let y = SIDE * (tile / across) + every_other(place >> 1);
        (x < width && y < height).then_some([x, y])
    }
}

/// [`tile`] of a source.
pub(crate) type Tile = fn(&View, &Request, u32) -> [Vector; PIXELS];

/// The sums of `count` samples of each pixel of a tile, those from the request's first on.
pub(crate) fn tile<S: Source>(view: &View, request: &Request, count: u32) -> [Vector; PIXELS] {
    let mut source = S::new(request);
    let mut sums = [[0.0; 3]; PIXELS];
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
