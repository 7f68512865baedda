rtdel of the name of what lives.

world: console
world: zombie 1 --context dead.host_cxt/%n.rtc

Where nobody can be asked, it deletes the name, and reports what is lost; -q and -f do not:

  $ rtdel ConsoleIn0.rtc
  rtdel: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: alive, with its connections, but no longer found by this name; a restart binds it again, or, by itself, naming.update.enable: YES in its rtc.conf
  $ rtls | grep ConsoleIn
  [1]
  $ rtdel ../dead.host_cxt/Mock0.rtc
  $ rtdel -f ConsoleOut0.rtc; rtls | grep ConsoleOut0
  [1]

On a terminal it asks:

  $ printf 'n\n' | terminal 400 rtdel ConsoleOut1.rtc
  n
  /localhost:*ConsoleOut1.rtc: alive, * (glob)
  Delete the name? [y/N]
  rtdel: /localhost:*/ConsoleOut1.rtc: left: it lives (glob)
  [1]
  $ rtls | grep -c ConsoleOut1
  1
  $ printf 'y\n' | terminal 400 rtdel ConsoleOut1.rtc
  y
  /localhost:*ConsoleOut1.rtc: alive, * (glob)
  Delete the name? [y/N]
  $ rtls | grep -c ConsoleOut1
  0
  [1]
