"""Stands in for the package in a clone, since Python looks here first for bin/rtls; makes way for it."""

import os
import sys

del sys.modules[__name__]
sys.path[0] = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
__import__(__name__)
