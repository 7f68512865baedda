"""OpenRTM's IDL: the .idl files, the tables that say the same in Python, and the command that writes these
(generate.py).

giop/idl.py reads the tables; only they are installed. A user's IDL files may include ours
(data/idl/included.py).
"""
