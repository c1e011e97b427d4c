//! Which row is compared with which: calls with what they replace, parts with what they are made
//! of, small fills with long ones.

use crate::fills::LONG;

/// The paths that a row is compared with; both are without the end that names the measurement.
pub(crate) fn of(path: &str) -> Vec<String> {
    let parts: Vec<_> = path.split('/').collect();
    let peers: &[&str] = match parts[..] {
        ["map", "square", ..] => &["peer/square/-/unit"],
        ["map", "disc", "concentric", _] => &["peer/disc/concentric/pbrt"],
        ["map", "disc", "polar", _] => &["peer/disc/polar/pbrt"],
        ["map", "uniform", ..] => &["peer/uniform/polar/pbrt"],
        ["map", "cosine", "concentric", _] => &["peer/cosine/concentric/pbrt"],
        ["map", "cosine", "polar", _] => &["peer/cosine/polar/shirley"],
        ["map", "power", ..] => &["peer/power/polar/suffern"],
        ["density", "power", ..] => {
            &["peer/density/power/suffern", "peer/density/power/suffern-divided"]
        }
        ["sequence", _] => &["peer/pair/sobol_burley", "peer/pair/xoshiro128++"],
        ["pair", _] => &[
            "peer/pair/sobol_burley",
            "peer/pair/sobol_burley-4d",
            "peer/pair/small-rng",
            "peer/pair/xoshiro128++",
        ],
        ["lens", _] => &["peer/lens/small-rng-shirley", "peer/lens/xoshiro128++-shirley"],
        ["bounce", _] => &[
            "peer/bounce/small-rng-pbrt-duff",
            "peer/bounce/small-rng-shirley",
            "peer/bounce/small-rng-shirley-uniform",
            "peer/bounce/xoshiro128++-pbrt-duff",
            "peer/bounce/xoshiro128++-shirley",
            "peer/bounce/xoshiro128++-shirley-uniform",
        ],
        // What the effect adds to its map.
        ["effect", "lens" | "light", arithmetic] => {
            return vec![format!("map/disc/concentric/{arithmetic}")];
        }
        ["effect", "occlusion", arithmetic] => {
            return vec![format!("map/cosine/concentric/{arithmetic}")];
        }
        ["effect", ..] => &["peer/glossy/suffern", "peer/glossy/suffern-divided"],
        ["fill", points, map, disc, arithmetic] if points != LONG.to_string() => {
            return vec![format!("fill/{LONG}/{map}/{disc}/{arithmetic}")];
        }
        // The same pixels one at a time.
        ["row", ..] => &["screen/cosine"],
        _ => &[],
    };
    peers.iter().map(|peer| (*peer).to_owned()).collect()
}
