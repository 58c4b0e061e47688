//! Results as tables, sentences, CSV and JSON.

pub mod bands;
pub mod json;
pub mod material_summary;
pub mod mesh_quality;
pub mod subject;
pub mod table;
pub mod trace;
pub mod trace_comparison;
