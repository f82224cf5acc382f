//! The Pareto front: entries that no other beats in both time and error.

/// The indices of the undominated (time, error), quickest first.
pub fn front(points: &[[f64; 2]]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|a, b| points[*a].partial_cmp(&points[*b]).unwrap());
    let mut least = f64::INFINITY;
    order.retain(|i| {
        let is_better = points[*i][1] < least;
        least = least.min(points[*i][1]);
        is_better
    });
    order
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keeps_who_is_unbeaten() {
        let points = [[3.0, 1.0], [1.0, 3.0], [2.0, 4.0], [2.5, 2.0], [3.0, 2.0]];
        assert_eq!(front(&points), [1, 3, 0]);
    }
}
