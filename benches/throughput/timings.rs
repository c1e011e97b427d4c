//! Criterion's timing of each fill in turn, compared with the last run.

use crate::buffers::{Coordinates, LARGE, SMALL, Visitor};
use crate::fills;
use benches::failure::Failure;
use criterion::{Criterion, Throughput};
use std::time::Duration;

pub(crate) fn run(coordinates: &Coordinates) -> Result<(), Failure> {
    // Hundreds of fills, so a second or less for each: a fill varies little.
    let criterion = Criterion::default()
        .without_plots()
        .sample_size(10)
        .nresamples(2000)
        .warm_up_time(Duration::from_millis(100))
        .measurement_time(Duration::from_millis(400));
    let mut timings = Timings { criterion: criterion.configure_from_args(), points: SMALL };
    fills::every(coordinates, timings.points, &mut timings)?;
    timings.points = LARGE;
    fills::every(coordinates, timings.points, &mut timings)?;
    timings.criterion.final_summary();
    Ok(())
}

struct Timings {
    criterion: Criterion,
    points: usize,
}

impl<'a> Visitor<'a> for Timings {
    fn fill<F: FnMut() + 'a>(&mut self, path: &str, make: impl FnOnce() -> F) {
        let mut group = self.criterion.benchmark_group(path);
        group.throughput(Throughput::Elements(self.points as u64));
        // Criterion calls back for each sample, and never for a fill that its filter excludes.
        let (mut make, mut made) = (Some(make), None);
        group.bench_function(self.points.to_string(), |bencher| {
            if let Some(make) = make.take() {
                made = Some(make());
            }
            if let Some(fill) = &mut made {
                bencher.iter(fill);
            }
        });
        group.finish();
    }
}
