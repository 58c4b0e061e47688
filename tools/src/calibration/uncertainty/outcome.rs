//! How an inference ended.

use super::posterior::Posterior;

/// How it ended.
pub enum Outcome {
    /// With a posterior, and what it tells.
    Posterior(Box<Posterior>, String),
    /// Without one, and why.
    Refused(String),
    /// By the user.
    Interrupted,
}
