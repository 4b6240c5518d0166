"""From counts to a scale: whether it exists, where it stands, how sure it is."""
