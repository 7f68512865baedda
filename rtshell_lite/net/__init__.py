"""What everything waits on: one loop for tasks, timers, sockets, threads and signals."""
