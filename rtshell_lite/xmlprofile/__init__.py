"""RtsProfile files: a whole system of components and connections, in XML or YAML, as plain objects and back. Needs no CORBA.

rtsprofile.py loads and writes them. Both forms hold the same: model.py says what, fields.py what that is made of. Files spell names
as names.py has it, values as values.py. XML: xml.py, with characters that it cannot hold (escape.py) and files of version 0.1
(version01.py). YAML: the package yaml.
"""
