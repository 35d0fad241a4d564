//! `forage bench`.

mod barn;
mod bbob;
mod centre_bias;
mod movingai;
mod trees;
mod tsplib;
