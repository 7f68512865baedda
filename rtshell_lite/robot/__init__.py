"""What is in the RTC Tree, what it answers, and what can be done with it:
components, ports, contexts, managers, names.
"""
