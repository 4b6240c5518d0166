//! The door to file.
