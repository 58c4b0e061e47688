//! What the page in a browser shows: [`asked`] says which drop, [`mod@drop`] what is drawn of it, [`parameters`] which controls there
//! are, `html` puts the file together. All but the last is compiled for the browser, too (`tools/page`).

pub mod asked;
pub mod drop;
#[cfg(feature = "command-line")]
pub mod html;
pub mod parameters;
