//! The density of glossy reflection that is flipped at the horizon.

use super::super::{Float, assert_near, dot, wide};
use super::{TAU, UP, arriving, gloss, unit};
use hemidisc::effect::BelowHorizon;
use hemidisc::sequence::SobolOwen;

/// With `Flip` a density is the sum of two powers, for samples and for given directions alike: at
/// any incidence, for narrow lobes and wide ones, where an image is behind the lobe and where it is
/// too dim to be seen in the sum.
pub fn a_flipped_density_is_a_sum<A: Float>() {
    let up = unit::<A>(UP);
    for (degrees, e) in [0.0, 20.0, 40.0, 45.5, 55.0, 65.0, 75.0, 85.0, 89.9, 90.0_f64]
        .into_iter()
        .flat_map(|d| [0.25, 1.0, 5.0, 20.0, 50.0, 300.0, 1e4, 1e7].map(|e| (d, e)))
    {
        let down = unit::<A>(arriving(degrees.to_radians().sin()).0);
        let gloss = gloss::<A>(e, BelowHorizon::Flip);
        // In doubles, of the vectors as they are.
        let [a, n] = [down, up].map(|unit| wide(unit.get()));
        let mirror = [0, 1, 2].map(|i| a[i] - 2.0 * dot(a, n) * n[i]);
        let axis = mirror.map(|x| x / dot(mirror, mirror).sqrt());
        for i in 0..256 {
            let sample = gloss.sample(down, up, SobolOwen::new(14).at(i)).unwrap();
            let d: [f64; 3] = wide(sample.direction);
            let image = [d[0], d[1], -d[2]];
            let power = |direction: [f64; 3]| {
                // 1 - cos from the difference, whose digits a narrow lobe needs.
                let length = dot(direction, direction).sqrt();
                let away = [0, 1, 2].map(|i| direction[i] / length - axis[i]);
                let cosine = 1.0 - dot(away, away) / 2.0;
                if cosine > 0.0 { cosine.powf(e) } else { 0.0 }
            };
            let exact = (e + 1.0) / TAU * (power(d) + power(image));
            let given: f64 = gloss.density(down, up, sample.direction).into();
            // An edge at the lobe's own horizon, which rounding moves.
            let edge = [d, image].map(|v| dot(v, axis)).into_iter().any(|z| z.abs() < 0.02);
            if e < 1.0 && edge {
                continue;
            }
            // An eps of the direction counts e tan, tan at most 6 / sqrt e where it counts.
            let room = 4.0 * A::EPS * (10.0 + 6.0 * e.sqrt());
            let room = room.max(1e-10 * e.sqrt());
            for found in [sample.density.into(), given] {
                let what = format!("{degrees} {e} {sample:?}");
                assert_near(found / exact, 1.0, room, &what);
            }
        }
    }
}
