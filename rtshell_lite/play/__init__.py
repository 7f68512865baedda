"""Recordings played as components: name server, components, ports and contexts that others call, all served
by our own ORB.
"""
