rtlog never makes a sender wait for a disk: what does not fit into memory is dropped, counted and reported.

world: senders 50 4000000
alone: the time that a sender takes
both: each ORB receives and sends values in its own way

Here the disk is a pipe that nobody reads until something is dropped; the component goes on sending:

  $ mkfifo slow; exec 9<> slow
  $ rtlog -t 20 -f slow Source0.rtc:block > told 2>&1 & log=$!
  $ soon 'grep "dropped so far" told'
  $ (exec 9>&-; cat > copy) < slow & reader=$!
  $ rtdeact Source0.rtc; wait $log
  [5]
  $ grep -v much told | sed 's/[0-9][0-9]* /N /g' | uniq
  rtlog: Recording for 20.0s.
  rtlog: N messages dropped so far: they come faster than they can be written
  rtlog: N of N messages dropped
  $ exec 9>&-
  $ wait $reader
  $ tail -n 1 told | sed 's/.*rtlog: //; s/ of.*//' > dropped
  $ rtlog -d --json -f copy | grep -c "\"counts\": {\"input0\": $(cat dropped)}"
  1
  $ rtlog -d -f copy | sed -n 's/Missing: .* (.*) until .* (.*): [0-9]* v/N v/p'
  N values of input0: they came faster than they could be written
  $ ctl connectors Source0:block
