"""The RTC Tree as a FUSE file system, for rtmount:
the kernel's messages, the mount, the server, and the files.
"""
