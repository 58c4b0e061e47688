//! Every tolerance of these tests, with its reason.

/// Least and most of 200 intervals of 95 % that hold the truth: the 99.98 % range of a binomial with p = 0.95, so that a
/// correct interval fails in one of 5000 parameters.
pub const COVERED: std::ops::RangeInclusive<usize> = 177..=199;

/// The same of 100 intervals; all of them may hold it.
pub const COVERED_OF_100: std::ops::RangeInclusive<usize> = 86..=100;

/// A nonlinear fit linearises its interval; so much less may be covered, of 200, where the errors are a percent.
pub const LINEARISED: usize = 3;

/// Relative difference of a curve from a virtual specimen to the law that was put in, at the strains of a test: inertia of
/// the shortened test and the volume that a Poisson's ratio of 0.4995 lets the specimen lose, both of which the
/// verification of the virtual specimen measures.
pub const CLOSED_LOOP: f64 = 0.01;

/// Relative difference of coefficients of one law fitted to two readings of Treloar's drawings.
pub const DIGITISED: f64 = 0.02;

/// Relative difference of two stresses at a free stretch that both find to some last digits, of powers up to the 60th.
pub const FREE_STRETCH: f64 = 1e-9;
