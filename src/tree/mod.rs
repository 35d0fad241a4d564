//! Trees that grow through a space, [ARM-RRT] §3.2.
