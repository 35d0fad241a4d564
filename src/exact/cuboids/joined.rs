//! Whether there is a way at all.

use crate::geometry::Cuboid;

/// Whether a point can get from one end to the other among the insides of cuboids. The planes of all faces divide the
/// workspace into cells, each free or inside a cuboid; the ends are joined if their cells are, through common faces.
pub(super) fn joined(workspace: &Cuboid, ends: [[f64; 3]; 2], cuboids: &[Cuboid]) -> bool {
    let planes: [Vec<f64>; 3] = std::array::from_fn(|axis| {
        let within = workspace.min[axis]..=workspace.max[axis];
        let faces = cuboids.iter().flat_map(|cuboid| [cuboid.min[axis], cuboid.max[axis]]).filter(|face| within.contains(face));
        let mut planes: Vec<f64> = faces.chain([workspace.min[axis], workspace.max[axis]]).collect();
        crate::math::sort_numbers(&mut planes);
        planes.dedup();
        planes
    });
    let count: [usize; 3] = std::array::from_fn(|axis| planes[axis].len() - 1);
    let number = |[x, y, z]: [usize; 3]| (z * count[1] + y) * count[0] + x;
    let middle = |cell: [usize; 3]| std::array::from_fn(|axis| f64::midpoint(planes[axis][cell[axis]], planes[axis][cell[axis] + 1]));
    let touches = |cell: [usize; 3], point: [f64; 3]| {
        (0..3).all(|axis| planes[axis][cell[axis]] <= point[axis] && point[axis] <= planes[axis][cell[axis] + 1])
    };
    let all = || {
        let [nx, ny, nz] = count;
        (0..nz).flat_map(move |z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])))
    };
    let mut closed: Vec<bool> = all().map(|cell| cuboids.iter().any(|cuboid| cuboid.contains(middle(cell)))).collect();
    let mut open: Vec<[usize; 3]> = all().filter(|&cell| touches(cell, ends[0]) && !closed[number(cell)]).collect();
    open.iter().for_each(|&cell| closed[number(cell)] = true);
    while let Some(cell) = open.pop() {
        if touches(cell, ends[1]) {
            return true;
        }
        for axis in 0..3 {
            for by in [usize::MAX, 1] {
                let mut next = cell;
                next[axis] = cell[axis].wrapping_add(by);
                if next[axis] < count[axis] && !closed[number(next)] {
                    closed[number(next)] = true;
                    open.push(next);
                }
            }
        }
    }
    false
}
