//! The door to image.
