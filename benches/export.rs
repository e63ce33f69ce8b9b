//! How fast files are made, without the disk: a mesh of two million triangles with normals.

use std::{
    io::{self, Write},
    sync::{Arc, OnceLock},
};

use divan::{Bencher, counter::BytesCount};
use glam::DVec3;
use virote::{
    export::{Format, Item, Job, Subject},
    kernel::{Grid, Mesh, NurbsSurface, grid_mesh},
};

fn main() {
    divan::main();
}

/// A bump of 1000 × 1000 cells.
fn mesh() -> Arc<Mesh> {
    static MESH: OnceLock<Arc<Mesh>> = OnceLock::new();
    let make = || {
        let place = |i: usize, j: usize| {
            DVec3::new(i as f64, j as f64, ((i * j) % 3) as f64 / std::f64::consts::PI)
        };
        let bump = NurbsSurface::bezier(&Grid::from_fn(4, 4, place)).expect("a surface");
        Arc::new(grid_mesh(&bump, 1000, 1000, usize::MAX, 1).expect("a mesh"))
    };
    Arc::clone(MESH.get_or_init(make))
}

/// Counts what is written.
struct Count(u64);

impl Write for Count {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0 += bytes.len() as u64;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

#[divan::bench(args = ["a.stl", "a.glb", "a.ply", "a.obj"], sample_count = 5, sample_size = 1)]
fn two_million_triangles(bencher: Bencher<'_, '_>, path: &str) {
    let job = Job { precision: 1e-6, ..Job::new(vec![Item::new("bump", Subject::Mesh(mesh()))]) };
    let format = Format::of_path(path).expect("a format");
    let write = |job: &Job| {
        let mut count = Count(0);
        (format.write)(job, &mut count).expect("it is written");
        count.0
    };
    let n_bytes = write(&job);
    bencher.counter(BytesCount::new(n_bytes)).bench(|| write(&job));
}
