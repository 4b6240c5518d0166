"""The chapters of a report, one module each: `chapter(study, words)` gives its HTML."""
