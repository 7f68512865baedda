"""Serve Echoes::All of tests/data/idl/valid/echoes.idl with stubs that omniidl has made in DIRECTORY; prints
its reference.

echo_provider.py DIRECTORY        ends with its standard input
"""
import importlib
import os
import sys


def servant(Echoes, POA):
    """An object of which each operation returns what it is given."""
    class All(POA.All):
        def _get_state(self):
            return self.state

        def _set_state(self, value):
            self.state = value

        def _get_paint(self):
            return Echoes.BLUE

        def take_larger(self, given):
            pass

        def plainly(self):
            raise Echoes.Plain()

        def fully(self, what, choice, value):
            raise Echoes.Full(what, choice, value, 7)

    def echo(self, a, b):
        return a, b, a
    for name in All._omni_op_d:
        if not hasattr(All, name):
            setattr(All, name, echo)
    return All()


def main(directory):
    sys.path.insert(0, directory)
    from omniORB import CORBA
    orb = CORBA.ORB_init(["provider", "-ORBendPoint", "giop:tcp:127.0.0.1:"], CORBA.ORB_ID)
    poa = orb.resolve_initial_references("RootPOA")
    made = servant(*map(importlib.import_module, ("Echoes", "Echoes__POA")))
    poa._get_the_POAManager().activate()
    print(orb.object_to_string(made._this()), flush=True)
    sys.stdin.read()
    os._exit(0)


if __name__ == "__main__":
    main(sys.argv[1])
