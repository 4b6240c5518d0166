"""Scales of groups, of sets and of attributes, people as clusters."""
