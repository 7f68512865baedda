rtdoc with components of every implementation: RtORB spells data types in its own way, and they are known all the same.

world: error --flavour cpp11 --context cpp11.host_cxt/%n.rtc
world: error --flavour cpp12 --context cpp12.host_cxt/%n.rtc
world: error --flavour cpp2 --context cpp2.host_cxt/%n.rtc
world: error --flavour java --context java.host_cxt/%n.rtc
world: error --flavour rtorb --context rtorb.host_cxt/%n.rtc

  $ for f in cpp2 cpp11 cpp12 java rtorb; do rtdoc -f rst ../$f.host_cxt/Err0.rtc | grep TimedLong; done
     "out", "DataOutPort", "IDL:RTC/TimedLong:1.0", ""
     "IDL:RTC/TimedLong:1.0", "tm: Time, data: long"
     "out", "DataOutPort", "IDL:RTC/TimedLong:1.0", ""
     "IDL:RTC/TimedLong:1.0", "tm: Time, data: long"
     "out", "DataOutPort", "IDL:RTC/TimedLong:1.0", ""
     "IDL:RTC/TimedLong:1.0", "tm: Time, data: long"
     "out", "DataOutPort", "IDL:RTC/TimedLong:1.0", ""
     "IDL:RTC/TimedLong:1.0", "tm: Time, data: long"
     "out", "DataOutPort", "TimedLong", ""
     "TimedLong", "tm: Time, data: long"
