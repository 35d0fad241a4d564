//! The figures of [WCPSO](forage#papers) Table 2, as text with the digits that are printed.

/// A row: the function's number in the paper, the scene, how many variables, and best, mean and standard deviation of `pso`, `cpso`,
/// `wpso` and `wcpso`, in the table's order.
pub struct Row {
    /// `f1` to `f5`.
    pub name: &'static str,
    /// The scene that ships.
    pub scene: &'static str,
    /// How many variables.
    pub dimension: usize,
    /// Best, mean, standard deviation of each planner.
    pub results: [[&'static str; 3]; 4],
}

/// The planners, in the table's order.
pub const PLANNERS: [&str; 4] = ["pso", "cpso", "wpso", "wcpso"];

/// Runs a row and planner.
pub const RUNS: u64 = 50;

/// [WCPSO](forage#papers) Table 2: 60 particles, 1000 iterations.
pub const TABLE_2: [Row; 8] = [
    Row {
        name: "f1",
        scene: "matyas",
        dimension: 2,
        results: [
            ["3.367003e-11", "6.866457e-9", "6.526707e-9"],
            ["3.349513e-128", "1.247232e-122", "2.162511e-122"],
            ["4.241170e-148", "2.394071e-143", "6.439900e-143"],
            ["4.919436e-158", "5.177476e-156", "8.201372e-156"],
        ],
    },
    Row {
        name: "f2",
        scene: "egg-crate",
        dimension: 2,
        results: [
            ["7.099393e-8", "1.682432e-6", "1.636995e-6"],
            ["4.116178e-123", "5.193652e-119", "7.600374e-119"],
            ["2.549862e-145", "3.597628e-142", "1.007399e-141"],
            ["2.871693e-156", "1.721477e-152", "3.081619e-152"],
        ],
    },
    Row {
        name: "f3",
        scene: "sphere-2",
        dimension: 2,
        results: [
            ["3.701933e-93", "1.395884e-88", "3.450040e-88"],
            ["4.499851e-123", "1.439152e-120", "2.587367e-120"],
            ["2.461082e-144", "2.562167e-142", "6.002556e-142"],
            ["5.538497e-157", "1.131121e-153", "2.553881e-153"],
        ],
    },
    Row {
        name: "f3",
        scene: "sphere",
        dimension: 10,
        results: [
            ["2.869000e-12", "6.149297e-4", "2.296402e-3"],
            ["5.083069e-19", "4.537087e-14", "1.182370e-13"],
            ["1.696671e-19", "1.103658e-14", "3.114989e-14"],
            ["5.350331e-22", "2.929482e-17", "3.203834e-17"],
        ],
    },
    Row { name: "f4", scene: "rosenbrock-2", dimension: 2, results: [["0", "0", "0"], ["0", "0", "0"], ["0", "0", "0"], ["0", "0", "0"]] },
    Row {
        name: "f4",
        scene: "rosenbrock",
        dimension: 10,
        results: [
            ["2.136403", "6.277601", "2.077086"],
            ["1.600037", "3.482057", "1.584136"],
            ["9.506901e-2", "3.972730", "2.757420"],
            ["1.166357e-2", "1.807747", "1.022275"],
        ],
    },
    Row {
        name: "f5",
        scene: "ackley-2",
        dimension: 2,
        results: [
            ["8.881784e-16", "8.881784e-16", "0"],
            ["8.881784e-16", "8.881784e-16", "0"],
            ["8.881784e-16", "8.881784e-16", "0"],
            ["8.881784e-16", "8.881784e-16", "0"],
        ],
    },
    Row {
        name: "f5",
        scene: "ackley",
        dimension: 10,
        results: [
            ["3.253477e-9", "0.3731386", "0.6930378"],
            ["2.234583e-9", "6.212239e-5", "1.754376e-4"],
            ["2.216271e-11", "0.2064128", "0.5817738"],
            ["3.574474e-11", "1.493499e-9", "1.896008e-9"],
        ],
    },
];

/// §3.2.3: the shortest path without a collision.
pub const SHORTEST: &str = "12.141590";

/// §3.2.3: runs of each planner.
pub const PATH_RUNS: u64 = 10;
