"""From the layers of a pearl to the way people judge its look."""
