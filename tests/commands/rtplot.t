rtplot plots numbers over time: of logs, and of ports.

world: senders 100 12
world: these ConsoleIn

A log that somebody else wrote, of six numbers and a state:

  $ base64 -d << END | gzip -d > other.mcap
  > H4sIAAAAAAACA+v0dXYMMODlYpRkQABBIM5NTizQLagsycjP0zfUM9MzYOtlhMmnLN+87QEvjE6Fipu/veYEomF85n1Q5YxgA4tK
  > kvVzi9P1QzJzU1N88vPS2UGC+cVGQMEZUHmQnEJJLldmXomxkUJKYkmigrJCokJeaW5SahGXLZUBl2+wu5UCzF6uUoitxanJMGYe
  > iM0iDfcGIwMHkNaHOKeYGchOTikCe1UeqoaJgRVIBpcklqRyARlZxfl5xckZqbmJTEBedS2LFFwdEwMbyKxikFIWqFKQDKsa3Dps
  > gQ0SfgG0mRUqyy4GVy6ApNwMqpstCGbMqX+PwPrb5ntsBdJaUPE0kZIlIBrGR7cepg3J+pdQ69mxKJ8yU24LmvJXUOV8WJTHmUSh
  > K38NVS6KRbnG+anoyt9AlctgUf4p8yK68rdQ5cog5WbwyAADaMjAlFcr5eanpCpZKSiVJ+ZkK+koKOWkphcD+dGGOgpGsbXsYXDb
  > AlBCigElKPRhfKhf42B8qGd6YXyoa/egRywTJGKhrnsNFeVnQcqvwySnEZ2LiMiRROQ0bidYUCMpRQAm5NwHDX0RsKVscBWwzMXh
  > xYC9bNSCik6DquQCG3AAypNHsg5WasJojhAG7Dn3PlRBNJSGuMmKGeammVBWHZLhsNwNo/kEYSnnKFT1ewY0GZYt0BTmji7D/Rsq
  > 440uw+EGLZY2oMtwfWNlQAFwGV50GSYRKAPmNJiCk5qWhp3Q6goADruKmrcGAAA=
  > END
  $ export TZ=UTC COLUMNS=60; rtplot -f other.mcap --ascii numbers
  /numbers
  * data  min 0  max 35  last 35
     |                                                     ***
     |                                               ******
     |                                          *****
     |                                    ******
  20 |                            ********
     |                    ********
     |              ******
     |         *****
     |   ******
   0 |***
     ++---------------------+---------------------+-----------
      0                     2                     4 s
  0 is 2001-09-09 01:46:40.000
  $ rtplot ./other.mcap --ascii numbers | head -n 1
  /numbers
  $ rtplot -f other.mcap numbers.data
  /numbers.data
  ⠤⠤ data  min 0  max 35  last 35
     |                                                   ⣀⡠⠔⠒⠉
     |                                             ⢀⣀⠤⠒⠊⠉
     |                                        ⣀⡠⠔⠒⠉⠁
     |                                  ⢀⣀⠤⠒⠊⠉
  20 |                            ⣀⡠⠤⠔⠒⠉⠁
     |                     ⢀⣀⠤⠔⠒⠊⠉
     |                ⣀⡠⠤⠒⠉⠁
     |          ⢀⣀⠤⠔⠊⠉
     |     ⣀⡠⠤⠒⠉⠁
   0 |⣀⠤⠔⠊⠉
     ++---------------------+---------------------+-----------
      0                     2                     4 s
  0 is 2001-09-09 01:46:40.000
  $ rtplot -f other.mcap --ascii numbers.data state.legs[0:2]
  /numbers.data
  * data  min 0  max 35  last 35
      |                                    ****
      |                             *******
      |                          ***
   20 |                   *******
      |              *****
      |          ****
      |     *****
    0 |*****
  /state.legs[0:2]
  * legs[0]  min 1  max 1  last 1
  + legs[1]  min 2  max 2  last 2
  2.0 |                                                      +
      |
      |
  1.5 |
      |
      |
      |
  1.0 |                                                      *
      ++--------------+---------------+--------------+--------
       0              2               4              6 s
  0 is 2001-09-09 01:46:40.000
  $ rtplot -f other.mcap --ascii --rate -e 1000000002 /numbers
  /numbers, values per second
  * rate  min 1  max 1  last 1
  1.1 |
      |
      |
      |
      |
  1.0 |*******************************************************
      |
      |
      |
  0.9 |
      ++--------------------------+--------------------------+
       0                         500 ms
  0 is 2001-09-09 01:46:41.000
  $ rtplot -f other.mcap --ascii --delay numbers | head -n 2
  /numbers, seconds from timestamp to arrival  (x 1e9)
  * delay  min 999999000  max 999999000  last 999999000

A channel is called by its port, too, where that is one:

  $ rtlog -q -f two.mcap -i -e 3 Source0.rtc:number
  $ for name in number Source0.rtc:number.data input0; do rtplot -f two.mcap --ascii $name | head -n 1; done
  input0
  input0.data
  input0
  $ rtlog -q --append -f two.mcap -i -e 3 Source0.rtc:number.again; rtplot -f two.mcap number.data
  rtplot: number: is one of 2 channels: input0, again; which one?
  [3]

As SVG:

  $ rtplot -f other.mcap --svg a.svg numbers
  $ grep -c '<svg.*xmlns' a.svg
  1
  $ grep -o 'data: min[^<]*\|prefers-color-scheme: dark' a.svg
  prefers-color-scheme: dark
  data: min 0, max 35, last 35
  $ python3 -c 'import xml.dom.minidom; xml.dom.minidom.parse("a.svg")'
  $ rtplot -f other.mcap --svg - numbers | cmp - a.svg
  $ rtplot -f other.mcap --svg /none/a.svg numbers
  rtplot: /none/a.svg: No such file or directory
  [1]

What is not there:

  $ rtplot -f other.mcap numbers.foo
  rtplot: foo: no such field: foo (there are: data, tm)
  [3]
  $ rtplot -f other.mcap state.mode
  no values
  [1]
  $ rtplot -f other.mcap -s inf numbers
  rtplot: start or end out of bounds (see --help)
  [2]
  $ rtplot -f other.mcap nothing
  rtplot: other.mcap: no such channel: nothing (there are: /numbers, /state)
  [3]
  $ rtlog -q -f whole.mcap -t 1 --only '*:number' /localhost:$PORT/test.host_cxt/Source0.rtc
  $ rtplot -f whole.mcap Source0.numbers
  rtplot: whole.mcap: no such channel: Source0.numbers; did you mean /localhost:$PORT/test.host_cxt/Source0.rtc:number?
  [3]
  $ rtplot --svg -f other.mcap numbers
  rtplot: argument --svg: a file is expected before -f (./-f is one) (see --help)
  [2]
  $ rtplot --svg --help | head -1
  usage: rtplot [OPTION ...] [PATH:PORT[.FIELD] ...]
  $ rtplot -f other.mcap 'numbers.data['
  rtplot: data[: not a field; one is written data.joints[0:3]
  [2]
  $ rtplot -f other.mcap numbers.data[3]
  rtplot: data[3]: no such field: [3] (it is not a sequence)
  [3]
  $ rtplot -f none
  rtplot: none: No such file or directory
  [1]
  $ rtplot none.mcap numbers
  rtplot: none.mcap: No such file or directory
  [1]
  $ rtlog -q -f empty.mcap -t 0.3 ConsoleIn0.rtc:out; rtplot -f empty.mcap
  no values
  [1]
  $ rtlog -q -f one.mcap -i -e 50 ConsoleIn0.rtc:out.none Source0.rtc:number.some
  $ rtplot -f one.mcap --ascii | grep '^none\|^some'
  some

Live, until a signal or for some time; not on a terminal, the plot is printed at the end:

  $ plotted() {
  >     rtplot "$@" > out & pid=$!
  >     soon '[ -n "$(ctl connectors Source0:number)" ]'; sent=$(ctl sent Source0:number)
  >     soon '[ $(ctl sent Source0:number) -gt $((sent + 200)) ]'
  >     kill $pid; wait $pid
  >     echo $?
  >     sed 's/[0-9.]\{1,\}/N/g' out | head -n 2
  > }
  $ plotted --ascii Source0.rtc:number
  143
  /localhost:N/testNhost_cxt/SourceNrtc:number
  * data  min N  max N  last N
  $ plotted --svg live.svg Source0.rtc:number.data Source0.rtc:block.data[0]
  143
  $ grep -c '<path class="series' live.svg
  4
  $ COLUMNS=100; plotted --rate --ascii Source0.rtc:number
  143
  /localhost:N/testNhost_cxt/SourceNrtc:number, values per second
  * rate  min N  max N  last N
  $ COLUMNS=60; within 0.3-9 rtplot -t 0.3 ConsoleIn0.rtc:out
  no values
  $ terminal 60 rtplot Source0.rtc:number >page & pid=$!
  $ soon '[ $(grep -c "data  min" page) -gt 3 ]'; kill $pid
  $ soon '[ -z "$(ctl connectors Source0:number)" ]'
  $ rtplot -t 0.5 Source0.rtc:nothing
  rtplot: /localhost:$PORT/test.host_cxt/Source0.rtc: no such port: nothing (its ports: number, block)
  [3]
  $ rtplot -t 0.5 Gone0.rtc:out
  rtplot: /localhost:$PORT/test.host_cxt/Gone0.rtc: no such path
  [3]

Wrong usage:

  $ rtplot
  rtplot: nothing to plot: no port specified (see --help)
  [2]
  $ rtplot Source0.rtc
  rtplot: /localhost:$PORT/test.host_cxt/Source0.rtc: no port specified; it has /localhost:$PORT/test.host_cxt/Source0.rtc:number, /localhost:$PORT/test.host_cxt/Source0.rtc:block (see --help)
  [2]
  $ rtplot --rate --delay Source0.rtc:number
  rtplot: --rate and --delay exclude each other (see --help)
  [2]
  $ rtplot -s 5 Source0.rtc:number
  rtplot: -s and -e are for logs (see --help)
  [2]
  $ rtplot -f run.mcap -t 3
  rtplot: -t is for what runs; -s and -e are for logs (see --help)
  [2]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: -t 0.5 A:out
lasting: A:out
prepared: rtec Source0.rtc rate 200; rtact Source0.rtc; rtlog -q -f run.mcap -i -e 30 Source0.rtc:number.joints
examples: endless
