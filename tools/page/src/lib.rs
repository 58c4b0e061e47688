//! The kernel for a page in a browser: text in, text out.
//!
//! Compiled for WebAssembly it is what `softanvil page` and the report's page carry (`tools/page/build.sh`). A request is a JSON
//! object, of which `request` lists the kinds, and so is the answer. The page writes the request, and the bytes of a file if one
//! belongs to it, where `exports` makes room, and reads the answer there.

mod exports;
mod measured;
mod request;

pub use request::Session;
