"""Whether a scale describes the answers, and whether people answer alike."""
