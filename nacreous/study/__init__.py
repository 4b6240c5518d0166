"""Studies: samples before people's eyes, and their answers kept."""
