"""RtsProfile files: a whole system of components and connections, in XML or YAML, as plain objects and back.
Needs no CORBA.

rtsprofile.py loads and writes them. model.py has the classes, made of fields.py; names.py and values.py say
how files spell names and values. XML: xml.py, escape.py for characters that it cannot hold, version01.py for
files of version 0.1. YAML: yaml/.
"""
