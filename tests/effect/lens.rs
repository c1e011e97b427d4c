//! The thin lens.

use super::{COUNT, Float, assert_near, each_float, wide};
use hemidisc::arithmetic::Real;
use hemidisc::effect::{Polygon, ThinLens};
use hemidisc::map::Component;
use hemidisc::sequence::SobolOwen;
use hemidisc::{Concentric, Density, Error, Map};

/// All rays of a pixel meet in focus; elsewhere they fill the circle of confusion, and no more.
fn the_blur_is_the_circle_of_confusion<A: Float>() {
    let (radius, focus) = (0.25, 2.0);
    let lens = ThinLens::new(Concentric::<A>::new(), A::real(radius), A::real(focus)).unwrap();
    for distance in [0.5, 1.0, 2.0, 3.0, 10.0] {
        let expected: f64 = lens.circle_of_confusion(A::real(distance)).into();
        assert_near(expected, radius * f64::abs(1.0 - distance / focus), A::EPS, "radius");
        let mut widest = 0.0_f64;
        for i in 0..COUNT {
            let ray = lens.ray([A::real(0.5), A::real(-0.25)], SobolOwen::new(1).at(i));
            let ([o_x, o_y, o_z], [x, y, z]) = (wide(ray.origin), wide(ray.direction));
            assert_eq!((o_z, z), (0.0, 1.0));
            let blur = (o_x + distance * (x - 0.5), o_y + distance * (y + 0.25));
            widest = widest.max(blur.0.hypot(blur.1));
        }
        // 1 in 4096 points is within half of 1/4096 of the rim.
        let room = expected * 1e-3 + 4.0 * A::EPS;
        assert!(
            widest <= expected + 4.0 * A::EPS && widest >= expected - room,
            "{distance}: {widest}"
        );
    }
}

/// A lens of radius 0 is a pinhole to the last bit, for any aperture. So is one in focus at
/// infinity, except for the origins of its rays.
fn a_pinhole_is_exact<A: Float>() {
    let ahead = [A::real(0.3), A::real(-0.7)];
    let round = ThinLens::new(Concentric::<A>::new(), A::Real::ZERO, A::real(2.0)).unwrap();
    let blades = ThinLens::new(Polygon::<A, 5>::new(7), A::Real::ZERO, A::real(2.0)).unwrap();
    let far = A::real(f64::INFINITY);
    let parallel = ThinLens::new(Concentric::<A>::new(), A::Real::ONE, far).unwrap();
    for i in 0..100 {
        let uv = SobolOwen::new(2).at(i);
        for ray in [round.ray(ahead, uv), blades.ray(ahead, uv)] {
            assert_eq!(ray.origin, [A::Real::ZERO; 3]);
            assert_eq!(ray.direction, [ahead[0], ahead[1], A::Real::ONE]);
            assert!(ray.density.into() > 1e30 && ray.density.into().is_finite());
        }
        assert_eq!(parallel.ray(ahead, uv).direction, [ahead[0], ahead[1], A::Real::ONE]);
    }
}

/// Densities are 1 / (pi r^2) and that of a polygon, 2 / (n sin(2 pi / n) r^2).
fn densities_are_of_the_aperture<A: Float>() {
    let (radius, focus) = (A::real(0.5), A::real(1.0));
    let uv = [1 << 30, 3 << 29];
    let round = ThinLens::new(Concentric::<A>::new(), radius, focus).unwrap();
    let blades = ThinLens::new(Polygon::<A, 6>::new(0), radius, focus).unwrap();
    let expected = 4.0 / core::f64::consts::PI;
    assert_near(round.ray([focus; 2], uv).density.into(), expected, A::EPS, "round");
    let expected = 4.0 * 2.0 / (6.0 * f64::to_radians(60.0).sin());
    assert_near(
        blades.ray([focus; 2], uv).density.into(),
        expected,
        3e-10 + 4.0 * A::EPS,
        "blades",
    );
}

/// At infinity a pinhole is sharp, a lens in focus there has its own radius, and any other lens the
/// largest number. What overflows on the way does not show.
fn confusion_is_known_everywhere<A: Float>() {
    let lens = |radius, focus| ThinLens::new(Concentric::<A>::new(), radius, focus).unwrap();
    let [far, most] = [A::Real::ONE / A::Real::ZERO, A::Real::MAX];
    let least = A::Real::MIN_POSITIVE;
    let distances = [A::Real::ZERO, least, A::Real::ONE, most, far];
    for distance in distances {
        for focus in [least, A::Real::ONE, most, far] {
            assert_eq!(lens(A::Real::ZERO, focus).circle_of_confusion(distance), A::Real::ZERO);
        }
        assert_eq!(lens(A::Real::TWO, far).circle_of_confusion(distance), A::Real::TWO);
    }
    for radius in [least, A::Real::ONE] {
        for focus in [A::Real::ONE, most] {
            assert_eq!(lens(radius, focus).circle_of_confusion(far), most, "{radius:?}");
        }
    }
    // r d / f where r / f underflows, and where d / f overflows.
    let large = A::Real::ONE / least;
    let blur: f64 = lens(least, large * A::Real::HALF).circle_of_confusion(large).into();
    assert_near(blur / least.into(), 1.0, A::EPS, "small slope");
    let blur: f64 = lens(least, least).circle_of_confusion(large * A::Real::HALF).into();
    assert_near(blur / large.into(), 0.5, A::EPS, "large ratio");
}

fn bad_lenses_are_refused<A: Float>() {
    let lens =
        |radius, focus| ThinLens::new(Concentric::<A>::new(), A::real(radius), A::real(focus));
    for radius in [-1.0, f64::NAN, f64::INFINITY] {
        assert!(matches!(lens(radius, 1.0), Err(Error::Radius { .. })), "{radius}");
    }
    for focus in [0.0, -1.0, f64::NAN] {
        assert!(matches!(lens(1.0, focus), Err(Error::Distance { .. })), "{focus}");
    }
    let pinhole = lens(0.0, 1.0).unwrap();
    assert_eq!(pinhole.circle_of_confusion(A::Real::MAX), A::Real::ZERO);
    // A ray's slope, r / f, must be finite.
    let least = A::Real::ONE / A::Real::MAX;
    let refused = ThinLens::new(Concentric::<A>::new(), A::Real::FOUR, least);
    assert_eq!(refused, Err(Error::Distance { value: least.into() }));
    // As large as can be, its density is a number above 0.
    let largest = A::real((A::Real::MAX.into() / 4.0).sqrt());
    let wide = ThinLens::new(Concentric::<A>::new(), largest, A::Real::MAX).unwrap();
    assert!(wide.ray([A::Real::ZERO; 2], [0, 7]).density.into() > 0.0);
    assert!(ThinLens::new(Concentric::<A>::new(), A::Real::MAX, A::Real::MAX).is_err());
    let steep = ThinLens::new(Concentric::<A>::new(), A::Real::HALF, least).unwrap();
    assert_eq!(steep.circle_of_confusion(A::Real::MAX), A::Real::MAX);
    assert!(
        steep.ray([A::Real::ZERO; 2], [0, 7]).direction.into_iter().all(|x| x.into().is_finite())
    );
}

/// An aperture that counts what a ray asks of it.
#[derive(Clone, Copy)]
struct Counted<'a, M>(M, &'a core::cell::Cell<u32>);

impl<M: Map> Map for Counted<'_, M> {
    type Point = M::Point;

    fn sample(&self, uv: [u32; 2]) -> M::Point {
        self.0.sample(uv)
    }
}

impl<M: Density> Density for Counted<'_, M> {
    fn density(&self, point: M::Point) -> Component<M> {
        self.1.set(self.1.get() + 1);
        self.0.density(point)
    }

    fn sample_with_density(&self, uv: [u32; 2]) -> (M::Point, Component<M>) {
        self.0.sample_with_density(uv)
    }
}

/// A ray looks for no density of a point: of a polygon that would be a search of its blades.
fn a_ray_takes_the_density_of_the_sample<A: Float>() {
    let searches = core::cell::Cell::new(0);
    let blades = Counted(Polygon::<A, 16>::new(5), &searches);
    let lens = ThinLens::new(blades, A::Real::ONE, A::Real::ONE).unwrap();
    for i in 0..1000 {
        let uv = SobolOwen::new(2).at(i);
        let density = lens.ray([A::Real::ZERO; 2], uv).density;
        let expected = blades.0.density(blades.0.sample(uv));
        assert_near((density / expected).into(), 1.0, 4.0 * A::EPS.min(1e-6), "density");
    }
    assert_eq!(searches.get(), 0);
}

each_float!(
    the_blur_is_the_circle_of_confusion a_pinhole_is_exact densities_are_of_the_aperture
    confusion_is_known_everywhere bad_lenses_are_refused a_ray_takes_the_density_of_the_sample
);
