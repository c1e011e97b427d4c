//! Where the points of a sample come from.

use hemidisc::effect::{AmbientOcclusion, BelowHorizon, DiscLight, Glossy, ThinLens};
use hemidisc::sequence::{InDomain, Sequence};
use hemidisc::{Concentric, Domain, Frame, LibmF64, Sampler};
use std::cell::RefCell;
use std::collections::HashSet;
use testkit::tracer::{Camera, Finish, Material, Plane, Renderer, Sky, Source, Sphere};

thread_local! {
    /// The domains that were drawn from.
    static NOTED: RefCell<Vec<u32>> = const { RefCell::new(Vec::new()) };
}

/// A family that notes its domains.
struct Noted;

/// Points near the middle of the square.
#[derive(Clone, Copy)]
struct Middle;

impl InDomain for Noted {
    type Size = ();
    type Sequence = Middle;

    fn in_domain(domain: Domain, (): ()) -> Middle {
        NOTED.with_borrow_mut(|noted| noted.push(domain.seed()));
        Middle
    }
}

impl Sequence for Middle {
    fn size(&self) -> Option<u32> {
        None
    }

    fn at(&self, index: u32) -> [u32; 2] {
        [index ^ 1 << 31, 1 << 31]
    }
}

/// Each pixel of a frame in a domain of its own.
struct Frames(Domain);

impl Source for Frames {
    type Family = Noted;

    fn sampler(&self, [x, y]: [u32; 2], sample: u32) -> Sampler<Noted> {
        Sampler::of(self.0.pixel(x, y), (), sample)
    }
}

/// The camera's, of which the lens's points are the second pair, those of the other effects, and
/// those of the light and of occlusion where the reflection ends.
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
        source: Frames(Domain::new(3)),
    };
    for (x, index) in [(0, 0), (0, 1), (1, 0)] {
        renderer.row([x, 0], index..index + 1, &mut [[0.0; 3]]);
    }
    let noted = NOTED.take();
    // The camera's first pair is drawn twice.
    assert_eq!(noted.len(), 3 * 8);
    let distinct: HashSet<_> = noted.iter().collect();
    // Two samples of a pixel share theirs, and two pixels share none.
    assert_eq!(noted[..8], noted[8..16]);
    assert_eq!(distinct.len(), 2 * 7);
}
