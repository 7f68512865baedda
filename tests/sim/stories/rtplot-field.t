rtplot ends as soon as a value shows that there is no such field.

world: senders 100 100

  $ rtact Source0.rtc
  $ rtplot -t 60 Source0.rtc:number.nope
  no values
  ! rtplot: nope: no such field: nope (there are: data, tm)
  [3] after 0.1 s
