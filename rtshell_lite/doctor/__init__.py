"""What rtdoctor examines, and the remedies it prints:
here, servers, references, components, connections, managers, a profile.
"""
