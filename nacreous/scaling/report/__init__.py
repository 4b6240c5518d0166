"""An analysis of answers, and the report that tells of it in plain words."""
