"""Shell commands for OpenRTM-aist robots: inspect, connect, configure and start RT Components."""

__version__ = "1.0.0"
