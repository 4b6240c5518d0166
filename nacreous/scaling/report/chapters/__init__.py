"""The chapters of a report, one module each: `chapter(analysis, words)` gives its HTML."""
