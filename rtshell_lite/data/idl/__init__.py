"""OMG IDL files, the part of them that describes data: modules, structs, unions, enums, typedefs and constants.

Interfaces, valuetypes, exceptions, components and homes are skipped; types within an interface are kept. Nothing of a file
is run. What is read of the preprocessor: includes, conditions, macros without parameters, and the pragmas prefix, ID, version.

Modules, in the order of a file's way: tokens.py (the preprocessor included), parser.py (definitions), types.py, constants.py
(expressions), scopes.py (names). What comes out are descriptors (descriptors.py).
"""
