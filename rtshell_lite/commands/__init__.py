"""Where the commands are in an installation: setup.py and --unpack put the files of bin/ here, as modules.

So Python keeps their bytecode. To compile `rtls` took a sixth of its time.
"""
