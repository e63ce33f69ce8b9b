//! Meshes that files had before, by what they were made of and how finely.
//!
//! Geometry is the same where it is the same allocation: an incremental session gives a definition that
//! no edit touched the very value that it had. What is known is held, so that no address ever comes to mean
//! something else.

use std::{
    collections::BTreeMap,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use super::Subject;
use crate::{
    kernel::{GeomError, Mesh, Surface, TessellationOptions},
    limits::work,
};

/// Vertices that are kept in all, some hundred bytes each with their triangles. What would need more is made
/// anew each time, so that remembering never takes what the work itself needs.
const MOST_VERTICES: usize = 2_000_000;

/// The addresses of the geometry in its order, and the bits of tolerance, angle and weld.
type MeshKey = (Vec<usize>, [u64; 3]);

/// The meshes that the files of a run had, for its other files and for those of the next run. Clones are one
/// memory. No byte of a file depends on it.
#[derive(Clone, Debug, Default)]
pub struct MeshMemory(Arc<Mutex<MemoryState>>);

#[derive(Debug, Default)]
struct MemoryState {
    known: BTreeMap<MeshKey, KnownMeshes>,
    n_recalled: u64,
}

/// The meshes of one key.
#[derive(Debug)]
struct KnownMeshes {
    meshes: Vec<Arc<Mesh>>,
    is_used: bool,
    /// The geometry, whose addresses are the key.
    _held: Vec<Subject>,
}

impl MeshMemory {
    /// The memory for a run that begins: what no file of the run before used is forgotten, unless that wrote
    /// none, as one with errors.
    pub(crate) fn begin(&self) -> Self {
        let mut state = self.lock();
        if state.known.values().any(|known| known.is_used) {
            state.known.retain(|_, known| std::mem::take(&mut known.is_used));
        }
        drop(state);
        self.clone()
    }

    /// How many times meshes were there already.
    #[cfg(test)]
    pub(crate) fn n_recalled(&self) -> u64 {
        self.lock().n_recalled
    }

    /// The meshes of these subjects, made together within the limits, if nobody made them before.
    ///
    /// # Errors
    /// Those of `make`.
    pub(super) fn recall(
        &self,
        subjects: &[&Subject],
        limits: &TessellationOptions,
        make: impl FnOnce() -> Result<Vec<Mesh>, GeomError>,
    ) -> Result<Vec<Arc<Mesh>>, GeomError> {
        let places: Option<Vec<usize>> = subjects.iter().map(|subject| address(subject)).collect();
        let fineness = [limits.tolerance, limits.angle, limits.weld].map(f64::to_bits);
        let key = places.map(|places| (places, fineness));
        if let Some(meshes) = key.as_ref().and_then(|key| self.known(key)) {
            return Ok(meshes);
        }
        let meshes: Vec<Arc<Mesh>> = make()?.into_iter().map(Arc::new).collect();
        // What work that was ended left is no mesh.
        if let Some(key) = key.filter(|_| work::ended().is_none()) {
            let held = subjects.iter().map(|&subject| subject.clone()).collect();
            self.keep(key, KnownMeshes { meshes: meshes.clone(), is_used: true, _held: held });
        }
        Ok(meshes)
    }

    fn known(&self, key: &MeshKey) -> Option<Vec<Arc<Mesh>>> {
        let mut state = self.lock();
        let known = state.known.get_mut(key)?;
        known.is_used = true;
        let meshes = known.meshes.clone();
        state.n_recalled += 1;
        Some(meshes)
    }

    fn keep(&self, key: MeshKey, made: KnownMeshes) {
        let mut state = self.lock();
        let n_new = made.n_vertices();
        let fits = |state: &MemoryState| {
            let n_known: usize = state.known.values().map(KnownMeshes::n_vertices).sum();
            n_known + n_new <= MOST_VERTICES
        };
        if !fits(&state) {
            state.known.retain(|_, known| known.is_used);
        }
        if fits(&state) {
            state.known.insert(key, made);
        }
    }

    fn lock(&self) -> MutexGuard<'_, MemoryState> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl KnownMeshes {
    fn n_vertices(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.n_vertices()).sum()
    }
}

/// Where the geometry lies that a mesh is made of.
fn address(subject: &Subject) -> Option<usize> {
    Some(match subject {
        Subject::Surface(Surface::Nurbs(surface)) => Arc::as_ptr(surface).addr(),
        Subject::Surface(Surface::Parametric(surface)) => Arc::as_ptr(surface).addr(),
        Subject::Region(region) => Arc::as_ptr(region).addr(),
        Subject::Face(face) => Arc::as_ptr(face).addr(),
        Subject::Solid(solid) => Arc::as_ptr(solid).addr(),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::super::{Format, Job, PNG};
    use crate::{
        session::{Event, PictureContent, Session},
        value::NoFiles,
    };

    /// A run, the bytes of its files and of a picture, and how often meshes were there already.
    fn written(session: &Session, text: &str) -> (Vec<Vec<u8>>, u64) {
        let report = session.run("demo", text.as_bytes(), &NoFiles, &[]);
        assert!(report.diagnostics.is_empty(), "{:?}", report.diagnostics);
        let before = report.meshes.n_recalled();
        let files = report.events.iter().filter_map(|event| match event {
            Event::File(file) => Some((file.format, &file.job)),
            _ => None,
        });
        let picture = session.picture(&report, &PictureContent::new([40, 30]), &PNG);
        let picture = picture.expect("there is geometry");
        let bytes = |(format, job): (&'static Format, &Job)| {
            let mut bytes = Vec::new();
            (format.write)(job, &mut bytes).expect("a vector takes everything");
            bytes
        };
        let all = files.chain([(&PNG, &picture)]).map(bytes).collect();
        (all, report.meshes.n_recalled() - before)
    }

    const SHELLS: &str = "surface ball = sphere((0, 0, 0), 5)\n\
        surface wave = parametric((u, v) => (u, v, sin(u*1rad)), 0..3, 0..1)\n\
        mesh hole = grid_mesh(ball, 4, 4)\n\
        export ball, wave, hole to \"a.obj\"\n\
        export ball, wave, hole to \"a.stl\"\n";

    #[test]
    fn files_of_one_run_share_meshes_and_the_next_run_has_those_of_what_is_as_it_was() {
        let session = Session::default().incremental();
        let (first, recalled) = written(&session, SHELLS);
        assert_eq!(recalled, 1, "the second file has the meshes of the first");
        let edited = format!("{SHELLS}export ball to \"b.ply\"\nlet more = 1\n");
        // The function of `wave` is evaluated anew; the picture draws each surface alone.
        let (second, recalled) = written(&session, &edited);
        assert_eq!(recalled, 2, "the second file, and the ball of the picture");
        assert_eq!(second[..2], first[..2]);
        let (fresh, _) = written(&Session::default(), &edited);
        assert!(second == fresh, "no byte depends on what was there");
        let (_, recalled) = written(&session, &edited.replace("let more = 1", "let more = 2"));
        assert_eq!(recalled, 3, "and the ball of the third file");
    }

    #[test]
    fn what_no_file_had_is_forgotten() {
        let session = Session::default().incremental();
        for i in 0..30 {
            let text = format!("surface s = sphere((0, 0), 5 + {i})\nexport s to \"s.stl\"");
            let _ = written(&session, &text);
            let memory = session.run("demo", text.as_bytes(), &NoFiles, &[]).meshes;
            assert!(memory.lock().known.len() <= 2);
        }
    }
}
