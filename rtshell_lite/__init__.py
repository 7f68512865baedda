"""Shell commands for OpenRTM-aist robots: inspect, connect, configure and start RT Components."""

__version__ = "0.1.0"
