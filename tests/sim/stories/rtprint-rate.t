rtprint -r looks at times, and prints the newest of what has come; --stats has figures each second.

world: senders 100 12

  $ rtprint -r 4 -n 3 Source0.rtc:number
  [0.3] 26
  [0.5] 51
  [0.8] 76
  [0] after 0.8 s
  $ rtprint -t 2.5 --stats Source0.rtc:number
  101 values, 100.0 Hz, gap 9.94/10/10 ms, jitter 0.0102 ms, 1.2 kB/s, age 0.0312 ms
  101 values, 100.0 Hz, gap 9.98/10/10 ms, jitter 0.00814 ms, 1.2 kB/s, age 0.0301 ms
  all in all: 250 values, 100.0 Hz, gap 9.94/10/10 ms, jitter 0.00885 ms, 1.2 kB/s, age 0.0302 ms
  [0] after 2.5 s
