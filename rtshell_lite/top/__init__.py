"""The live page of rttop."""
