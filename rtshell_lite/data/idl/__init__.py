"""The data types of OMG IDL files: modules, structs, unions, enums, typedefs and constants.

Interfaces, valuetypes, exceptions, components and homes are skipped; types within an interface are read. The
preprocessor has includes, conditions, macros without parameters, and the pragmas prefix, ID, version. Nothing
is evaluated.

tokens.py reads tokens and preprocesses them; parser.py reads definitions, types.py types, constants.py
expressions; scopes.py has the names. The result are descriptors (giop/descriptors.py).
"""
