"""What becomes of a change to a robot, a step of apply.py or an action of plan.py: its status, one of these
words, which people and programs read.
"""

DONE = "done"
ALREADY = "already"  # there was nothing to do
GONE = "gone"  # its component, which counts as stopped: nothing has to wait for it
FAILED = "failed"
UNCERTAIN = "uncertain"  # a call was lost, and the look after it, too
NOT_TRIED = "not tried"
UNDONE = "undone"
NOT_UNDONE = "not undone"
REACHED = (DONE, ALREADY, GONE)
