//! Lengths in a scene, checked, as `const fn` on f32 and f64: a radius, a distance, a position.

macro_rules! lengths {
    ($float:ident) => {
        pub mod $float {
            use crate::error::Error;

            /// A radius, at least 0, of a finite area.
            ///
            /// # Errors
            /// [`Error::Radius`] for any other number.
            pub const fn radius(radius: $float) -> Result<$float, Error> {
                let area = radius * radius / core::$float::consts::FRAC_1_PI;
                if radius >= 0.0 && area.is_finite() {
                    Ok(radius)
                } else {
                    Err(Error::Radius { value: radius as f64 })
                }
            }

            /// A distance above 0, infinity included.
            ///
            /// # Errors
            /// [`Error::Distance`] for any other number.
            pub const fn distance(distance: $float) -> Result<$float, Error> {
                if distance > 0.0 {
                    Ok(distance)
                } else {
                    Err(Error::Distance { value: distance as f64 })
                }
            }

            /// The reciprocal of the focal distance of a lens, at most MAX.
            ///
            /// # Errors
            /// Those of [`radius`] and [`distance`], and [`Error::Distance`] where radius /
            /// distance is not finite.
            pub const fn nearness(radius: $float, focal_distance: $float) -> Result<$float, Error> {
                let radius = match self::radius(radius) {
                    Ok(radius) => radius,
                    Err(error) => return Err(error),
                };
                let reciprocal = match distance(focal_distance) {
                    Ok(distance) => 1.0 / distance,
                    Err(error) => return Err(error),
                };
                let nearness = if reciprocal.is_finite() { reciprocal } else { $float::MAX };
                if (radius * nearness).is_finite() {
                    Ok(nearness)
                } else {
                    Err(Error::Distance { value: focal_distance as f64 })
                }
            }

            /// The centre of a disc whose rim has finite coordinates.
            ///
            /// # Errors
            /// Those of [`radius`], and [`Error::Position`] for a component that is not finite, or
            /// is not on the rim.
            pub const fn centre(centre: [$float; 3], radius: $float) -> Result<[$float; 3], Error> {
                let radius = match self::radius(radius) {
                    Ok(radius) => radius,
                    Err(error) => return Err(error),
                };
                let mut axis = 0;
                while axis < 3 {
                    // Twice, because the sums round.
                    if !(centre[axis].abs() + radius + radius).is_finite() {
                        return Err(Error::Position { value: centre[axis] as f64 });
                    }
                    axis += 1;
                }
                Ok(centre)
            }

            /// |x n_x| + |y n_y| + |z n_z|: the scale of the rounding error of a dot product.
            #[inline]
            pub const fn size(point: [$float; 3], normal: [$float; 3]) -> $float {
                (point[0] * normal[0]).abs()
                    + (point[1] * normal[1]).abs()
                    + (point[2] * normal[2]).abs()
            }
        }
    };
}
lengths!(f32);
lengths!(f64);
