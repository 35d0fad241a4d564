//! `forage bench`.

mod bbob;
mod movingai;
