//! As much of HTTP/1.1 as one page on this machine needs: a request a connection, all sizes bounded.

mod request;
mod response;

pub(super) use request::{HttpError, Request};
pub(super) use response::{Response, begin_stream};
