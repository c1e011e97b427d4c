mod camera;
mod material;
mod measure;
mod path;
mod picture;
mod scene;
mod source;
mod vector;
use measure::*;
use path::View;
use std::fs::File;

fn main() {
    let big = View::new([360, 240]);
    let pics: Vec<_> =
        SOURCES.iter().map(|(_, row)| picture::render(&big, *row, 1, 16, &mut || ())).collect();
    let (size, pixels) = picture::side_by_side(&pics, big.size);
    examples::render::picture::png(&mut File::create("/tmp/w.png").unwrap(), size, &pixels)
        .unwrap();
    let view = View::new([96, 64]);
    let refer = picture::render(&view, SOURCES[2].1, 99, 1024, &mut || ());
    for count in COUNTS {
        let all = sources(&view, count, &refer, &mut || ());
        let fastest = all[0].nanoseconds.min(all[1].nanoseconds);
        for ((name, _), m) in SOURCES.iter().zip(all) {
            println!(
                "{name:16} {count:4} {:7.1} {:.3} {:.5} worth {:.2}",
                m.nanoseconds,
                m.nanoseconds / fastest,
                m.error,
                (all[0].error / m.error).powi(2)
            );
        }
    }
}
