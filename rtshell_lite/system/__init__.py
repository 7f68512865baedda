"""Whole systems: read from robots, compared with RtsProfile files, and changed in steps."""
