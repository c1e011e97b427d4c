#![allow(dead_code)]
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

fn main() {
    let view = View::new([96, 64]);
    let only: Option<usize> = std::env::args().nth(1).and_then(|a| a.parse().ok());
    if let Some(only) = only {
        for seed in 0..std::env::args().nth(2).map_or(8, |a| a.parse().unwrap()) {
            let p = picture::render(&view, SOURCES[only].1, seed, 16, &mut || ());
            std::hint::black_box(p);
        }
        return;
    }
    let refer = picture::render(&view, SOURCES[3].1, 99, 1024, &mut || ());
    for count in [1, 16, 64] {
        let all = sources(&view, count, &refer, &mut || ());
        let fastest = all[0].nanoseconds.min(all[1].nanoseconds);
        for ((name, _), m) in SOURCES.iter().zip(all) {
            println!("{name:16} {count:4} {:7.1} {:.3} {:.5}", m.nanoseconds, m.nanoseconds / fastest, m.error);
        }
    }
}
