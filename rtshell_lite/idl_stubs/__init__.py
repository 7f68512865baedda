"""OpenRTM's IDL: the .idl files, and the tables that say the same in Python, which `tools/stubs.py` writes.

giop/idl.py reads the tables; only they are installed. A user's IDL files may include ours
(data/idl/included.py).
"""
