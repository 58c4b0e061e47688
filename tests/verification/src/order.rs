//! Orders of convergence.

/// Order of errors over sizes: the slope of the straight line through their logarithms, by least squares.
pub fn fitted(size: &[f64], error: &[f64]) -> f64 {
    let points: Vec<[f64; 2]> = size.iter().zip(error).map(|(s, e)| [s.ln(), e.abs().ln()]).collect();
    let mean = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64);
    let covariance: f64 = points.iter().map(|p| (p[0] - mean[0]) * (p[1] - mean[1])).sum();
    covariance / points.iter().map(|p| (p[0] - mean[0]).powi(2)).sum::<f64>()
}

/// The same over numbers of cells.
pub fn over_cells(cells: &[usize], error: &[f64]) -> f64 {
    fitted(&cells.iter().map(|n| 1.0 / *n as f64).collect::<Vec<_>>(), error)
}

/// Order of differences from the result at the last of the sizes, which are those before it: e = c (size^p - last^p).
pub fn against_last(size: &[f64], error: &[f64]) -> f64 {
    let last = size[size.len() - 1];
    let slope = |order: f64| {
        let gaps: Vec<f64> = size[..error.len()].iter().map(|s| s.powf(order) - last.powf(order)).collect();
        fitted(&gaps, error)
    };
    // The right order makes errors proportional to the gaps; the slope falls as the order rises.
    bisect(0.1, 10.0, |order| slope(order) > 1.0)
}

/// Where `below` turns from true to false.
fn bisect(mut low: f64, mut high: f64, below: impl Fn(f64) -> bool) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if below(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// The value at size zero and the order, from values at three sizes, coarsest first: value = limit + c size^order.
///
/// # Panics
/// If the three values do not settle, so that no order exists.
pub fn extrapolate(size: [f64; 3], value: [f64; 3]) -> (f64, f64) {
    let wanted = (value[0] - value[1]) / (value[1] - value[2]);
    assert!(wanted > 0.0, "{value:?} does not settle");
    let ratio = |order: f64| {
        let [a, b, c] = size.map(|s| s.powf(order));
        (a - b) / (b - c)
    };
    // The ratio of differences grows with the order.
    let order = bisect(1e-3, 20.0, |order| ratio(order) < wanted);
    let [_, b, c] = size.map(|s| s.powf(order));
    (value[2] - (value[1] - value[2]) * c / (b - c), order)
}
