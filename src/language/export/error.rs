//! Why a file cannot be written.

use std::io;

use thiserror::Error;

use super::ViewpointError;
use crate::{diag::Code, kernel::GeomError, limits::work::End};

/// Why a file cannot be written.
#[derive(Debug, Error)]
pub enum ExportError {
    /// The geometry has no answer to what the format needs.
    #[error("{name}: {source}")]
    Geometry {
        /// The item.
        name: String,
        /// What is wrong with it.
        source: GeomError,
    },
    /// The format has no place for a property of an item.
    #[error("{name} {problem}")]
    Unfit {
        /// The item.
        name: String,
        /// What about it, as the rest of a sentence.
        problem: String,
    },
    /// There is no view of the geometry as it was asked for.
    #[error(transparent)]
    Viewpoint(#[from] ViewpointError),
    /// More bytes than the ceiling.
    #[error("a file of more than {most} bytes")]
    TooLarge {
        /// The ceiling.
        most: u64,
    },
    /// Writing it takes more than it may, or nobody wants the file any more.
    #[error("the writing was ended")]
    Ended(End),
    /// The operating system refused.
    #[error(transparent)]
    Io(#[from] io::Error),
}

impl ExportError {
    /// The code of a finding that tells it.
    ///
    /// ```
    /// use virote_language::{diag::Code, export::ExportError};
    ///
    /// assert_eq!(ExportError::TooLarge { most: 100 }.code(), Code::TooLarge);
    /// ```
    #[must_use]
    pub fn code(&self) -> Code {
        match self {
            Self::Geometry { .. } | Self::Unfit { .. } | Self::Viewpoint(_) => Code::CannotExport,
            Self::TooLarge { .. } | Self::Ended(End::Steps | End::Memory) => Code::TooLarge,
            Self::Ended(End::Stopped) => Code::Stopped,
            Self::Io(_) => Code::CannotWrite,
        }
    }

    /// What went wrong, for a message about the file.
    #[must_use]
    pub fn reason(&self) -> String {
        match self {
            Self::Io(err) => io_reason(err),
            other => other.to_string(),
        }
    }
}

/// Why a file cannot be read or written, in the words of whoever reads a message.
#[must_use]
pub fn io_reason(err: &io::Error) -> String {
    match err.kind() {
        io::ErrorKind::NotFound => "there is no such file".to_owned(),
        io::ErrorKind::PermissionDenied => "permission denied".to_owned(),
        io::ErrorKind::NotADirectory => "a part of its path is a file, not a folder".to_owned(),
        _ => err.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::{io, io_reason};

    #[test]
    fn a_path_through_a_file_is_told_in_words() {
        let told = |kind: io::ErrorKind| io_reason(&io::Error::from(kind));
        assert_eq!(
            told(io::ErrorKind::NotADirectory),
            "a part of its path is a file, not a folder"
        );
        assert_eq!(told(io::ErrorKind::NotFound), "there is no such file");
    }
}
