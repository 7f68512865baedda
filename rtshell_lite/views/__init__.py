"""What commands print of a component, a manager, a directory, a value, a system:
text, JSON, manuals, graphs.
"""
