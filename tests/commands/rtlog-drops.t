rtlog never makes a sender wait for a disk: what does not fit into memory is dropped, counted and reported.

world: senders 50 4000000
alone: the time that a sender takes
both: each ORB receives and sends values in its own way

Here the disk is a pipe whose reader is slow to begin; the component sends at its rate all the same:

  $ mkfifo slow; exec 9<> slow; (exec 9>&-; sleep 7; cat > copy) < slow & rtlog -t 6 -f slow Source0.rtc:block > told 2>&1; echo $?
  5
  $ grep -v much told | sed 's/[0-9][0-9]* /N /g' | uniq
  rtlog: Recording for 6.0s.
  rtlog: N messages dropped so far: they come faster than they can be written
  rtlog: N of N messages dropped
  $ exec 9>&-; wait; tail -n 1 told | sed 's/.*rtlog: //; s/ of.*//' > dropped
  $ rtlog -d --json -f copy | grep -c "\"counts\": {\"input0\": $(cat dropped)}"; rtlog -d -f copy | sed -n 's/Missing: .* (.*) until .* (.*): [0-9]* v/N v/p'
  1
  N values of input0: they came faster than they could be written
  $ ctl connectors Source0:block
