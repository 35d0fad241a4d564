//! `forage bench`.

mod bbob;
mod movingai;
mod tsplib;
