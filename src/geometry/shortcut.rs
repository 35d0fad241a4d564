//! Removing nodes that a path does not need.

/// A path without its redundant nodes: a node goes if its neighbours see each other, [ANTBAT] §3.1, again and again until
/// none goes. Ends stay. `sees` says whether the straight line between two points is free.
pub fn shortcut(path: &[[f64; 2]], sees: impl Fn([f64; 2], [f64; 2]) -> bool) -> Vec<[f64; 2]> {
    let mut kept: Vec<[f64; 2]> = Vec::with_capacity(path.len());
    let mut nodes = path.to_vec();
    loop {
        kept.clear();
        for (i, &node) in nodes.iter().enumerate() {
            let redundant = match (kept.last(), nodes.get(i + 1)) {
                (Some(&before), Some(&after)) => sees(before, after),
                _ => false,
            };
            if !redundant {
                kept.push(node);
            }
        }
        if kept.len() == nodes.len() {
            return kept;
        }
        std::mem::swap(&mut kept, &mut nodes);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_neighbours_see_past_goes_and_ends_stay() {
        let path = [[0.0, 0.0], [1.0, 0.0], [2.0, 0.0], [2.0, 1.0], [2.0, 2.0]];
        assert_eq!(shortcut(&path, |_, _| true), [path[0], path[4]]);
        assert_eq!(shortcut(&path, |_, _| false), path);
        // Straight lines only.
        assert_eq!(shortcut(&path, |a, b| a[0] == b[0] || a[1] == b[1]), [path[0], path[2], path[4]]);
        assert_eq!(shortcut(&path[..1], |_, _| true), path[..1]);
    }

    #[test]
    fn a_node_that_was_needed_goes_once_its_neighbours_have_changed() {
        // 0 does not see 2, so 1 stays at first; when 2 and 3 have gone, 0 sees what comes after 1.
        let path = [0.0, 1.0, 2.0, 3.0, 4.0].map(|x| [x, 0.0]);
        let sees = |a: [f64; 2], b: [f64; 2]| !(a[0] == 0.0 && b[0] == 2.0);
        assert_eq!(shortcut(&path, sees), [[0.0, 0.0], [4.0, 0.0]]);
    }
}
