What rtec --measure puts into a component is taken out again, however the command ends: by Ctrl-C, by kill, with the terminal.

world: senders 100 4
both: each ORB waits in its own way

  $ for signal in INT TERM HUP; do
  >     timeout -s $signal --foreground 1 rtec --measure 20 Source0.rtc > /dev/null && echo "ended by itself"
  >     ctl @senders connectors Source0:number
  > done
