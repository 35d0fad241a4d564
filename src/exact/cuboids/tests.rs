use super::*;
use crate::kernel::rng::Stream;

const WORKSPACE: Cuboid = Cuboid { min: [-0.3, -0.2, 0.0], max: [1.2, 1.1, 0.7] };
const START: [f64; 3] = [-0.2, 0.022, 0.05];
const GOAL: [f64; 3] = [0.9, 0.7, 0.3];
/// A room of 4 × 3 × 2.
const ROOM: Cuboid = Cuboid { min: [0.0; 3], max: [4.0, 3.0, 2.0] };

fn cuboid(min: [f64; 3], max: [f64; 3]) -> Cuboid {
    Cuboid { min, max }
}

/// The shortest path, checked: it joins the ends, stays inside, touches nothing and is as long as it says.
fn shortest(workspace: &Cuboid, [start, goal]: [[f64; 3]; 2], cuboids: &[Cuboid]) -> Option<Exact> {
    let exact = match shortest_among_cuboids(workspace, start, goal, cuboids) {
        AmongCuboids::Found(exact) => exact,
        AmongCuboids::NoWay => return None,
        AmongCuboids::NotComputed => panic!("{cuboids:?}"),
    };
    let path = &exact.tip_path;
    assert_eq!((path.first(), path.last()), (Some(&start), Some(&goal)));
    assert!(path.iter().all(|&point| workspace.contains(point)), "{path:?}");
    assert!(path.windows(2).all(|w| !cuboids.iter().any(|cuboid| cuboid.meets(w[0], w[1]))), "{path:?} {cuboids:?}");
    assert_eq!(exact.length, length_in_space(path));
    assert!(exact.length >= length_in_space(&[start, goal]));
    assert!(exact.path.is_empty() && exact.order.is_empty() && !exact.stored);
    Some(exact)
}

fn length(workspace: &Cuboid, ends: [[f64; 3]; 2], cuboids: &[Cuboid]) -> Option<f64> {
    shortest(workspace, ends, cuboids).map(|exact| exact.length)
}

/// An independent answer, from above: Dijkstra over points on edges of slightly larger cuboids, `n` pieces an edge.
fn by_graph(workspace: &Cuboid, [start, goal]: [[f64; 3]; 2], cuboids: &[Cuboid], n: usize) -> f64 {
    let mut nodes = vec![start, goal];
    for cuboid in cuboids {
        let grown = grow(cuboid, 1e-7);
        for (axis, corner) in (0..3).flat_map(|axis| (0..4).map(move |corner| (axis, corner))) {
            let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
            let mut at = [0.0; 3];
            at[u] = if corner & 1 == 0 { grown.min[u] } else { grown.max[u] };
            at[v] = if corner & 2 == 0 { grown.min[v] } else { grown.max[v] };
            let (from, to) = (grown.min[axis].max(workspace.min[axis]), grown.max[axis].min(workspace.max[axis]));
            for i in 0..=n {
                at[axis] = if i == n { to } else { from + (to - from) * i as f64 / n as f64 };
                if workspace.contains(at) && !cuboids.iter().any(|cuboid| cuboid.contains(at)) {
                    nodes.push(at);
                }
            }
        }
    }
    let mut best = vec![f64::INFINITY; nodes.len()];
    let mut done = vec![false; nodes.len()];
    best[0] = 0.0;
    loop {
        let next = (0..nodes.len()).filter(|&i| !done[i] && best[i].is_finite()).min_by(|&a, &b| best[a].total_cmp(&best[b]));
        match next {
            None => return f64::INFINITY,
            Some(1) => return best[1],
            Some(u) => {
                done[u] = true;
                for v in 0..nodes.len() {
                    let reached = best[u] + length_in_space(&[nodes[u], nodes[v]]);
                    if reached < best[v] && !cuboids.iter().any(|cuboid| cuboid.meets(nodes[u], nodes[v])) {
                        best[v] = reached;
                    }
                }
            }
        }
    }
}

/// Random cuboids, and ends that touch none of them.
fn random(seed: u64, n: usize) -> ([[f64; 3]; 2], Vec<Cuboid>) {
    let mut rng = Stream::new(seed, n as u64);
    let mut point = || std::array::from_fn(|i| rng.between(WORKSPACE.min[i], WORKSPACE.max[i]));
    let mut ends: [[f64; 3]; 2] = [point(), point()];
    (ends[0][0], ends[1][0]) = (WORKSPACE.min[0], WORKSPACE.max[0]);
    let centers: Vec<[f64; 3]> = (0..n).map(|_| point()).collect();
    let mut cuboids = Vec::new();
    for center in centers {
        // Every other one stands on the floor.
        let half: [f64; 3] = std::array::from_fn(|_| rng.between(0.1, 0.35));
        let mut found = cuboid(std::array::from_fn(|i| center[i] - half[i]), std::array::from_fn(|i| center[i] + half[i]));
        if rng.below(2) == 0 {
            found.min[2] = 0.0;
        }
        if ends.iter().all(|&end| !found.contains(end)) {
            cuboids.push(found);
        }
    }
    (ends, cuboids)
}

#[test]
fn the_two_reference_scenes_have_their_known_lengths() {
    let paper = length(&WORKSPACE, [START, GOAL], &[cuboid([0.25, 0.2, 0.0], [0.45, 0.48, 0.32])]).unwrap();
    assert!((paper - 1.351_621_003_511_669_6).abs() < 1e-11, "{paper}");
    let bench = length(&WORKSPACE, [START, GOAL], &[cuboid([0.2, 0.21, 0.0], [0.5, 0.51, 0.4])]).unwrap();
    assert!((bench - 1.3792).abs() < 5e-5, "{bench}");
}

#[test]
fn nothing_in_the_way_is_the_straight_line_to_the_last_bit() {
    let aside = [cuboid([0.25, 0.6, 0.0], [0.45, 0.9, 0.32])];
    for cuboids in [&[][..], &aside] {
        let exact = shortest(&WORKSPACE, [START, GOAL], cuboids).unwrap();
        assert_eq!((exact.length, exact.tip_path.len()), (1.316_124_614_160_832_5, 2));
    }
    assert_eq!(length(&WORKSPACE, [GOAL, GOAL], &aside), Some(0.0));
}

/// From (0, 1, 1) to (4, 1, 1) round a block 2 wide: over the top at height 2, or over an edge and the corner's face.
#[test]
fn lengths_that_can_be_worked_out_by_hand() {
    // A pillar from floor to ceiling is a plane problem: round its nearer corner at (1, 1.5) and (3, 1.5).
    let ends = [[0.0, 1.0, 1.0], [4.0, 1.0, 1.0]];
    let pillar = length(&ROOM, ends, &[cuboid([1.0, 0.0, 0.0], [3.0, 1.5, 2.0])]).unwrap();
    assert!((pillar - (2.0 + 2.0 * 1.25_f64.sqrt())).abs() < 1e-10, "{pillar}");
    // A wall of no great thickness, whose top is 0.5 above the ends: the same turned about the x-axis.
    let wall = length(&ROOM, ends, &[cuboid([1.0, 0.0, 0.0], [3.0, 3.0, 1.5])]).unwrap();
    assert!((wall - pillar).abs() < 1e-10, "{wall}");
    // Round the pillar upwards: unfolded, the way of the plane problem is a straight line's projection.
    let rising = length(&ROOM, [[0.0, 1.0, 0.0], [4.0, 1.0, 2.0]], &[cuboid([1.0, 0.0, 0.0], [3.0, 1.5, 2.0])]).unwrap();
    assert!((rising - (pillar * pillar + 4.0).sqrt()).abs() < 1e-10, "{rising}");
}

#[test]
fn it_is_never_longer_than_a_graph_and_the_same_both_ways() {
    let mut blocked = 0;
    for (seed, n) in (0..40).map(|seed| (seed, 1 + seed as usize % 5)) {
        let ([start, goal], cuboids) = random(seed, n);
        let Some(there) = shortest(&WORKSPACE, [start, goal], &cuboids) else {
            assert!(by_graph(&WORKSPACE, [start, goal], &cuboids, 8).is_infinite());
            continue;
        };
        let mut back = shortest(&WORKSPACE, [goal, start], &cuboids).unwrap();
        back.tip_path.reverse();
        assert_eq!(there.tip_path, back.tip_path);
        if there.tip_path.len() > 2 {
            let graph = by_graph(&WORKSPACE, [start, goal], &cuboids, 12);
            assert!(there.length <= graph + 1e-9 && graph < there.length * 1.02, "seed {seed}: {} {graph}", there.length);
            blocked += 1;
        }
    }
    assert!(blocked >= 10, "{blocked}");
}

/// Faces in common planes, edges that touch and overlap, cuboids within each other: whatever whole numbers give.
#[test]
fn touching_and_overlapping_cuboids_are_nothing_special() {
    let (mut ways, mut none) = (0, 0);
    for seed in 0..60 {
        let mut rng = Stream::new(seed, 9);
        let n = 2 + rng.below(3);
        let mut cuboids = Vec::new();
        while cuboids.len() < n {
            let mut corner = || [rng.below(6), rng.below(5), rng.below(4)].map(|c| c as f64 - 1.0);
            let (a, b) = (corner(), corner());
            let found = cuboid(std::array::from_fn(|i| a[i].min(b[i])), std::array::from_fn(|i| a[i].max(b[i])));
            if (0..3).all(|i| found.min[i] < found.max[i]) {
                cuboids.push(found);
            }
        }
        let ends = [[0.5, 0.25, 0.5], [3.5, 2.5, 1.25]];
        cuboids.retain(|cuboid| ends.iter().all(|&end| !cuboid.contains(end)));
        let graph = by_graph(&ROOM, ends, &cuboids, 20);
        if let Some(length) = length(&ROOM, ends, &cuboids) {
            assert!(length <= graph + 1e-9 && graph < length * 1.03, "seed {seed}: {length} {graph} {cuboids:?}");
            ways += 1;
        } else {
            assert!(graph.is_infinite(), "seed {seed}: {graph}");
            none += 1;
        }
    }
    assert!(ways >= 30 && none >= 1, "{ways} {none}");
}

#[test]
fn there_is_no_way_between_faces_that_touch() {
    let whole = [cuboid([0.25, 0.2, 0.0], [0.45, 0.48, 0.32])];
    let halves = [cuboid([0.25, 0.2, 0.0], [0.45, 0.31, 0.32]), cuboid([0.25, 0.31, 0.0], [0.45, 0.48, 0.32])];
    let stacked = [cuboid([0.25, 0.2, 0.0], [0.45, 0.48, 0.05]), cuboid([0.25, 0.2, 0.05], [0.45, 0.48, 0.32]), whole[0]];
    let expected = length(&WORKSPACE, [START, GOAL], &whole).unwrap();
    for parts in [&halves[..], &stacked] {
        let found = length(&WORKSPACE, [START, GOAL], parts).unwrap();
        assert!((found - expected).abs() < 1e-10, "{found} {expected}");
    }
    // From wall to wall: over it only; up to the ceiling as well: not at all; but for a slit: through the slit.
    let ends = [[0.5, 1.0, 0.0], [3.5, 1.0, 0.0]];
    let over = length(&ROOM, ends, &[cuboid([1.0, 0.0, 0.0], [3.0, 3.0, 1.0])]).unwrap();
    assert!((over - (2.0 + 2.0 * 1.25_f64.sqrt())).abs() < 1e-10, "{over}");
    assert_eq!(length(&ROOM, ends, &[cuboid([1.0, 0.0, 0.0], [3.0, 3.0, 2.0])]), None);
    assert_eq!(length(&ROOM, ends, &[cuboid([1.0, -1.0, -1.0], [3.0, 5.0, 5.0])]), None);
    let slit = length(&ROOM, ends, &[cuboid([1.0, 0.0, 0.0], [3.0, 3.0, 2.0 - 1e-6])]).unwrap();
    assert!((slit - (2.0 + 2.0 * 4.25_f64.sqrt())).abs() < 1e-5, "{slit}");
}

#[test]
fn ends_beside_a_face_have_their_way_too() {
    let block = [cuboid([1.0, 0.0, 0.0], [3.0, 1.5, 2.0])];
    let near = 1.0 - f64::EPSILON;
    for x in [near, 1.0 - 1e-13, 1.0 - 1e-9] {
        let found = length(&ROOM, [[x, 0.5, 1.0], [3.5, 0.5, 1.0]], &block).unwrap();
        assert!((found - (3.0 + 1.25_f64.sqrt())).abs() < 1e-8, "{x}: {found}");
    }
}

#[test]
fn what_is_too_much_is_said() {
    let blocks: Vec<_> = (0..=MAX_EXACT_CUBOIDS).map(|i| cuboid([0.25, 0.2, 0.0], [0.45, 0.48, 0.3 + 0.01 * i as f64])).collect();
    assert_eq!(shortest_among_cuboids(&WORKSPACE, START, GOAL, &blocks), AmongCuboids::NotComputed);
    assert!(matches!(shortest_among_cuboids(&WORKSPACE, START, GOAL, &blocks[1..]), AmongCuboids::Found(_)));
    // Nothing in the way needs no search.
    let aside = vec![cuboid([0.25, 0.6, 0.0], [0.45, 0.9, 0.32]); 50];
    assert!(matches!(shortest_among_cuboids(&WORKSPACE, START, GOAL, &aside), AmongCuboids::Found(_)));
}
