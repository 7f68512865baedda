A manager takes the name of what exits out of the name server up to a second later: until then it is a zombie.

world: many 4

  $ rtexit Mock0.rtc
  $ rtexit Mock0.rtc
  ! rtexit: /robot/test.host_cxt/Mock0.rtc: zombie (the name is bound, but its object is gone)
  [4]
  $ rtexit --wait=0.1 Mock1.rtc
  ! rtexit: /robot/test.host_cxt/Mock1.rtc: has exited, but its name is still bound after 0.1s
  [4] after 0.1 s
  $ rtexit --wait Mock2.rtc
  [0] after 0.7 s
  $ sleep 2
  $ rtexit Mock0.rtc
  ! rtexit: /robot/test.host_cxt/Mock0.rtc: no such path; did you mean Mock3.rtc?
  [3]
