"""OMG IDL files: modules, structs, unions, enums, typedefs, constants, exceptions and interfaces.

Of valuetypes, components and homes only the names are read. The preprocessor has includes, conditions,
macros, and the pragmas prefix, ID, version. Nothing is evaluated.

scanner.py cuts text into pieces, tokens.py makes tokens of them and preprocesses them, with conditions.py;
parser.py reads definitions, types.py types, exports.py operations and attributes, constants.py expressions;
scopes.py has the names. The results are descriptors (giop/descriptors.py), and interfaces.py. library.py
finds files in directories. OpenRTM's own IDL comes from tables, not from files: standard.py has its
interfaces, included.py what an #include of one of its files declares.
"""
