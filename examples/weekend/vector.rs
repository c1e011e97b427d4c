//! Three components: points, directions and colours.

pub(crate) type Vector = [f32; 3];

pub(crate) fn dot(a: Vector, b: Vector) -> f32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

pub(crate) fn difference(a: Vector, b: Vector) -> Vector {
    core::array::from_fn(|i| a[i] - b[i])
}

/// Component by component: light on a surface of a colour.
pub(crate) fn product(a: Vector, b: Vector) -> Vector {
    core::array::from_fn(|i| a[i] * b[i])
}

pub(crate) fn scaled(k: f32, a: Vector) -> Vector {
    a.map(|component| k * component)
}

/// a + k b.
pub(crate) fn along(a: Vector, k: f32, b: Vector) -> Vector {
    core::array::from_fn(|i| a[i] + k * b[i])
}

pub(crate) fn unit(a: Vector) -> Vector {
    scaled(1.0 / dot(a, a).sqrt(), a)
}
