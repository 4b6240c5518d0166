//! The door to nacre.
