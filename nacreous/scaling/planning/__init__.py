"""Before the answers: designs, simulated studies, the next pair to ask."""
