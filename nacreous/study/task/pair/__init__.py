"""Two stimuli side by side, of which one is chosen: paired comparison."""
