The file `state` of a component that takes part in the context of another one.

needs: fuse
world: these Mock:Sensor0 Mock:Motor0

  $ mkdir mnt
  $ rtmount mnt
  $ cd mnt/localhost:$PORT/test.host_cxt
  $ rtec Sensor0.rtc attach Motor0.rtc; rtact -e 1 Motor0.rtc
  $ cat Motor0.rtc/state
  Active
  $ echo Inactive >Motor0.rtc/state; cat Motor0.rtc/state
  Inactive
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Inactive Sensor0
  $ rtact -e 1 Motor0.rtc
  $ echo Active >Motor0.rtc/state
  $ rtec Motor0.rtc | awk '{print $1, $2, $6, $7}'
  0 0 Inactive Motor0
  1 1000 Active Sensor0
  $ cd; rtmount -u mnt
