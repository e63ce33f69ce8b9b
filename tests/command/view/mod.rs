//! `virote view`: the page's server, asked as the page asks it.

mod attacks;
mod client;
mod files;
mod live;
mod places;
mod questions;
mod scene;
