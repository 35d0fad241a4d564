//! Trees against hand-computed steps, and what must hold for every one.
