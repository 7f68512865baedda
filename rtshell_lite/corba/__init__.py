"""The only door to an ORB: references, deadlines, many calls at once, answers and exceptions as plain values and errors."""
