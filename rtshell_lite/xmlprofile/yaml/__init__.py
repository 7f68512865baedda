"""RtsProfile files in YAML: text to nodes (reader, document, scalars), nodes to the model and back (form),
data to text (writer).
"""
