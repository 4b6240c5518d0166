"""Answers and counts from outside, checked once: files, tables, lists, matrices."""
