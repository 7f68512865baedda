"""What is known of the components of a robot, since when, and who told us: observers that they call, or
questions.
"""
