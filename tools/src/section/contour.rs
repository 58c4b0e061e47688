//! From values of triangles to regions of a value.

use super::Mesh;

/// Values at the nodes: means of the triangles that meet there, by their areas at rest.
pub fn nodal_means(mesh: &Mesh, of_triangles: &[f64]) -> Vec<f64> {
    let mut sums = vec![[0.0; 2]; mesh.reference.len()];
    for (nodes, value) in mesh.triangles.iter().zip(of_triangles) {
        let area = double_area(nodes.map(|node| mesh.reference[node]));
        for node in nodes {
            sums[*node][0] += area * value;
            sums[*node][1] += area;
        }
    }
    sums.into_iter().map(|[sum, area]| if area > 0.0 { sum / area } else { 0.0 }).collect()
}

fn double_area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// A corner of a triangle and the value there.
type Corner = ([f64; 2], f64);

/// The part of a triangle where the value, linear between its corners, is at least `level`: a polygon, or nothing.
pub fn region(corners: [Corner; 3], level: f64) -> Vec<[f64; 2]> {
    let mut polygon = Vec::with_capacity(4);
    for (index, (point, value)) in corners.into_iter().enumerate() {
        let (next, next_value) = corners[(index + 1) % 3];
        if value >= level {
            polygon.push(point);
        }
        if (value >= level) != (next_value >= level) {
            let part = (level - value) / (next_value - value);
            polygon.push([point[0] + part * (next[0] - point[0]), point[1] + part * (next[1] - point[1])]);
        }
    }
    polygon
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Twice the area of a polygon.
    fn area(polygon: &[[f64; 2]]) -> f64 {
        (0..polygon.len())
            .map(|i| (polygon[i], polygon[(i + 1) % polygon.len()]))
            .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
            .sum()
    }

    #[test]
    fn a_region_is_cut_where_the_value_is_reached() {
        // The value is x: what is left of the unit triangle beyond x = l is one of side 1 - l.
        let corners = [([0.0, 0.0], 0.0), ([1.0, 0.0], 1.0), ([0.0, 1.0], 0.0)];
        for level in [0.0, 0.25, 0.5, 1.0] {
            let left = 1.0 - level;
            assert!((area(&region(corners, level)) - left * left).abs() < 1e-12, "{level}");
        }
        assert!(region(corners, 1.1).is_empty());
    }
}
