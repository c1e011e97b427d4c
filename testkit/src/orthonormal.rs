//! How far three axes are from an orthonormal, right-handed basis.

/// The largest deviation of a frame about a unit vector, in units of half an ulp of 1.
pub const LARGEST: f64 = 8.0;

pub fn dot<R: Copy + Into<f64>>(a: [R; 3], b: [R; 3]) -> f64 {
    a.into_iter().zip(b).map(|(a, b)| a.into() * b.into()).sum()
}

/// The largest deviation of the axes' Gram matrix from the identity, and of their determinant
/// from +1; NaN if an axis has one.
pub fn deviation<R: Copy + Into<f64>>(axes: [[R; 3]; 3]) -> f64 {
    let [x, y, z] = axes.map(|axis| axis.map(Into::into));
    let cross = [x[1] * y[2] - x[2] * y[1], x[2] * y[0] - x[0] * y[2], x[0] * y[1] - x[1] * y[0]];
    let handed = dot(cross, z) - 1.0;
    let units = [x, y, z].map(|axis| dot(axis, axis) - 1.0);
    let angles = [dot(x, y), dot(y, z), dot(z, x)];
    let all = units.into_iter().chain(angles).chain([handed]);
    all.fold(0.0, |worst, d| {
        // NaN propagates.
        if d.abs() <= worst || worst.is_nan() { worst } else { d.abs() }
    })
}
