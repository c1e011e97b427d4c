//! Where the points of a sample come from.

use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, ThinLens};
use hemidisc::{Concentric, Domain, Frame, LibmF64};
use std::cell::RefCell;
use std::collections::HashSet;
use testkit::tracer::{Camera, Finish, Material, Plane, Points, Renderer, Sky, Sphere};

/// Notes the domains that it is asked for.
#[derive(Default)]
struct Noted(RefCell<Vec<u32>>);

impl Points for Noted {
    fn point(&self, domain: Domain, index: u32) -> [u32; 2] {
        self.0.borrow_mut().push(domain.seed());
        [index ^ 1 << 31, 1 << 31]
    }
}

/// The filter's, those of the four effects, and those of the light and of occlusion where the
/// reflection ends.
#[test]
fn each_use_of_points_has_a_domain_of_its_own() {
    let finish = Finish::Glossy([1.0; 3], Glossy::<LibmF64>::new(1e4, BelowHorizon::Flip).unwrap());
    let material = Material { albedo: [0.5; 3], emission: [0.0; 3], finish };
    let behind = Frame::new([0.0, 0.0, -1.0]).unwrap();
    let renderer = Renderer {
        camera: Camera::new([0.0; 3], [0.0, 0.0, -1.0], 0.01, [1, 1]).unwrap(),
        lens: ThinLens::new(Concentric::<LibmF64>::new(), 0.01, 2.0).unwrap(),
        light: DiscLight::<LibmF64>::new([0.0, 0.0, 1.0], behind, 0.1).unwrap(),
        intensity: [1.0; 3],
        ambient: [1.0; 3],
        occlusion: AmbientOcclusion::<LibmF64>::new(1.0).unwrap(),
        sky: Sky { horizon: [0.0; 3], zenith: [0.0; 3] },
        spheres: &[Sphere { centre: [0.0, 0.0, -3.0], radius: 1.0, material }],
        planes: &[Plane { point: [0.0, 0.0, 2.0], frame: behind, material, checker: None }],
        points: Noted::default(),
        seed: 3,
    };
    for (x, index) in [(0, 0), (0, 1), (1, 0)] {
        renderer.row([x, 0], index..index + 1, &mut [[0.0; 3]]);
    }
    let noted = renderer.points.0.into_inner();
    assert_eq!(noted.len(), 3 * 7);
    let distinct: HashSet<_> = noted.iter().collect();
    // Two samples of a pixel share theirs, and two pixels share none.
    assert_eq!(noted[..7], noted[7..14]);
    assert_eq!(distinct.len(), 2 * 7);
}
