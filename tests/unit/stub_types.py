"""Run by test_idl as a program: the types of the stubs that omniidl made of a file, in the portable form, as
JSON.

usage: stub_types.py DIRECTORY MODULE
"""
import importlib
import json
import sys

import omniORB
from rtshell_lite.giop import descriptors
from rtshell_lite.data import type_json

KINDS = (descriptors.STRUCT, descriptors.UNION, descriptors.ENUM, descriptors.ALIAS)


def main(directory, module):
    before = set(omniORB.typeMapping)
    sys.path.insert(0, directory)
    importlib.import_module(module)
    found = {}
    for type_id in set(omniORB.typeMapping) - before:
        descriptor = omniORB.typeMapping[type_id]
        if descriptors.kind(descriptor) in KINDS:
            found[type_id] = type_json.plain(descriptors.adopted(descriptor, omniORB.typeMapping.get))
    json.dump(found, sys.stdout, sort_keys=True)


if __name__ == "__main__":
    main(*sys.argv[1:])
