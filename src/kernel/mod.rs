//! NURBS geometry. Knows nothing of scripts, spans or files.
