//! Meshes that files had before, by what they were made of and how finely.
//!
//! Geometry is the same where it is the same allocation: an incremental session gives a definition that
//! no edit touched the very value that it had. What is known is held, so that no address ever comes to mean
//! something else. Functions of the script are made anew in each run; they are known by the identity of
//! their definition.

use std::{
    collections::BTreeMap,
    convert::Infallible,
    sync::{Arc, Mutex, MutexGuard, PoisonError},
};

use super::{Item, Subject};
use crate::{
    kernel::{GeomError, Mesh, Surface, TessellationOptions},
    limits::work,
};

/// Vertices that are kept in all, some hundred bytes each with their triangles. What would need more is made
/// anew each time, so that remembering never takes what the work itself needs.
const MOST_VERTICES: usize = 2_000_000;

/// What a mesh is made of.
#[derive(Debug, PartialEq, Eq, PartialOrd, Ord)]
enum GeometryKey {
    /// Where it lies in memory.
    Place(usize),
    /// The identity of a definition's value, and the name of what is a part of it.
    Result(u64, String),
}

/// Geometry in its order, and the bits of tolerance, angle and weld.
type MeshKey = (Vec<GeometryKey>, [u64; 3]);

/// The meshes that the files of a run had, for its other files and for those of the next run. Clones are one
/// memory. No byte of a file depends on it.
#[derive(Clone, Debug, Default)]
pub struct MeshMemory(Arc<Mutex<MeshMemoryState>>);

#[derive(Debug, Default)]
struct MeshMemoryState {
    known: BTreeMap<MeshKey, KnownMeshes>,
    n_recalled: u64,
}

/// The meshes of one key.
#[derive(Debug)]
struct KnownMeshes {
    meshes: Vec<Arc<Mesh>>,
    is_used: bool,
    /// The steps that they took.
    n_steps: u64,
    /// The geometry, whose addresses are in the key.
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

    /// Forgets every mesh.
    pub(crate) fn forget(&self) {
        self.lock().known.clear();
    }

    /// How many times meshes were there already.
    #[cfg(test)]
    pub(crate) fn n_recalled(&self) -> u64 {
        self.lock().n_recalled
    }

    /// The meshes of these items, made together within the limits, if nobody made them before.
    ///
    /// # Errors
    /// Those of `make`.
    pub(super) fn of_items(
        &self,
        items: &[&Item],
        limits: &TessellationOptions,
        make: impl FnOnce() -> Result<Vec<Mesh>, GeomError>,
    ) -> Result<Vec<Arc<Mesh>>, GeomError> {
        let geometry: Option<Vec<GeometryKey>> = items.iter().map(|item| key_of(item)).collect();
        let fineness = [limits.tolerance, limits.angle, limits.weld].map(f64::to_bits);
        let held = || items.iter().map(|item| item.subject.clone()).collect();
        let make = || Ok(make()?.into_iter().map(Arc::new).collect());
        self.recall(geometry.map(|geometry| (geometry, fineness)), held, make)
    }

    /// What `turn` makes of these meshes, if it did not before.
    pub(super) fn turned(
        &self,
        meshes: &[Arc<Mesh>],
        turn: impl FnOnce() -> Vec<Arc<Mesh>>,
    ) -> Vec<Arc<Mesh>> {
        let place = |mesh: &Arc<Mesh>| GeometryKey::Place(Arc::as_ptr(mesh).addr());
        let key = (meshes.iter().map(place).collect(), [0; 3]);
        let held = || meshes.iter().cloned().map(Subject::Mesh).collect();
        let Ok(turned) = self.recall(Some(key), held, || Ok::<_, Infallible>(turn()));
        turned
    }

    fn recall<E>(
        &self,
        key: Option<MeshKey>,
        held: impl FnOnce() -> Vec<Subject>,
        make: impl FnOnce() -> Result<Vec<Arc<Mesh>>, E>,
    ) -> Result<Vec<Arc<Mesh>>, E> {
        if let Some(meshes) = key.as_ref().and_then(|key| self.known(key)) {
            return Ok(meshes);
        }
        let n_before = work::done().steps;
        let meshes = make()?;
        let n_steps = work::done().steps - n_before;
        // What work that was ended left is no mesh.
        if let Some(key) = key.filter(|_| work::ended().is_none()) {
            let meshes = meshes.clone();
            self.keep(key, KnownMeshes { meshes, is_used: true, n_steps, _held: held() });
        }
        Ok(meshes)
    }

    fn known(&self, key: &MeshKey) -> Option<Vec<Arc<Mesh>>> {
        let mut state = self.lock();
        let known = state.known.get_mut(key)?;
        known.is_used = true;
        let meshes = known.meshes.clone();
        let n_steps = known.n_steps;
        state.n_recalled += 1;
        drop(state);
        // A ceiling is crossed, or not, whatever was made before; whoever wrote under it tells.
        let _ = (0..n_steps).all(|_| work::goes_on(1));
        Some(meshes)
    }

    fn keep(&self, key: MeshKey, made: KnownMeshes) {
        let mut state = self.lock();
        let n_new = made.n_vertices();
        let fits = |state: &MeshMemoryState| {
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

    fn lock(&self) -> MutexGuard<'_, MeshMemoryState> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl KnownMeshes {
    fn n_vertices(&self) -> usize {
        self.meshes.iter().map(|mesh| mesh.n_vertices()).sum()
    }
}

/// By what the geometry is known that a mesh is made of.
fn key_of(item: &Item) -> Option<GeometryKey> {
    Some(match (&item.subject, item.identity) {
        (Subject::Surface(Surface::Parametric(_)), Some(result)) => {
            GeometryKey::Result(result, item.name.clone())
        }
        (Subject::Surface(Surface::Parametric(surface)), None) => place(surface),
        (Subject::Surface(Surface::Nurbs(surface)), _) => place(surface),
        (Subject::Region(region), _) => place(region),
        (Subject::Face(face), _) => place(face),
        (Subject::Solid(solid), _) => place(solid),
        _ => return None,
    })
}

fn place<T>(geometry: &Arc<T>) -> GeometryKey {
    GeometryKey::Place(Arc::as_ptr(geometry).addr())
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
        assert_eq!(recalled, 2, "the second file has the meshes of the first, and how they face");
        let edited = format!("{SHELLS}export ball to \"b.ply\"\nlet more = 1\n");
        // The picture draws each surface alone.
        let (second, recalled) = written(&session, &edited);
        assert_eq!(recalled, 6, "both files and the picture, `wave` too, which is evaluated anew");
        assert_eq!(second[..2], first[..2]);
        let (fresh, _) = written(&Session::default(), &edited);
        assert!(second == fresh, "no byte depends on what was there");
        let (_, recalled) = written(&session, &edited.replace("let more = 1", "let more = 2"));
        assert_eq!(recalled, 8, "and the third file");
        let (bent, _) = written(&session, &edited.replace("sin(u*1rad)", "sin(u*2rad)"));
        assert!(bent[0] != second[0] && bent[2] == second[2], "a new function is a new surface");
    }

    #[test]
    fn what_no_file_had_is_forgotten() {
        let session = Session::default().incremental();
        for i in 0..30 {
            let text = format!("surface s = sphere((0, 0), 5 + {i})\nexport s to \"s.stl\"");
            let _ = written(&session, &text);
            let memory = session.run("demo", text.as_bytes(), &NoFiles, &[]).meshes;
            assert!(
                memory.lock().known.len() <= 3,
                "meshes of the file, how they face, and those of the picture"
            );
        }
    }
}
