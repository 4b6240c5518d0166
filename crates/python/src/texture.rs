//! The door to texture.
