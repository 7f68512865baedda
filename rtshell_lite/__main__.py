"""Run a command of rtshell_lite from a checkout, an installation or straight from a wheel file.

  python3 -m rtshell_lite COMMAND [ARGUMENT ...]
  python3 -m rtshell_lite demo [--port PORT]      a robot to play with, on this machine
  python3 -m rtshell_lite --unpack DIR [WHEEL ...]

For a robot without pip, copy the wheel (and one of omniORBpy) there, then:
  PYTHONPATH=rtshell_lite-X-py3-none-any.whl python3 -m rtshell_lite rtls -l
  PYTHONPATH=rtshell_lite-X-py3-none-any.whl python3 -m rtshell_lite --unpack /opt/rtshell
  jeteve_omniorb-*.whl
"""

import sys

# `python3 -m` looks for modules in the working directory first, even for those of Python itself; what is
# there may be anybody's. What Python has imported before it comes here cannot be helped (README, "Install").
is_safe = sys.flags.isolated or getattr(sys.flags, "safe_path", False)
if __name__ == "__main__" and not is_safe and sys.path:
    del sys.path[0]

from rtshell_lite import bytecode

if __name__ == "__main__":
    bytecode.keep()

from rtshell_lite import start

start.quietly(__name__)

from rtshell_lite import anywhere

if __name__ == "__main__":
    anywhere.main(__doc__ or "")  # None under PYTHONOPTIMIZE=2
