//! The door to optics.
