//! The door to colour.
