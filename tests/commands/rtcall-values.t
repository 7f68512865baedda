Values that rtcall sends and prints, of every kind that IDL has.

world: these Robot
both: each ORB reads and writes values in its own way

  $ export RTSHELL_IDL="$MOCKS"; rtact --wait Robot0.rtc

  $ rtcall Robot0.rtc:svc aim '{"to": {"x": 1, "y": 2}}'
  {"_d": "MOVING", "to": {"x": 1.0, "y": 2.0}}
  $ rtcall Robot0.rtc:svc aim '{"_d": "BROKEN", "code": 7}'
  {"_d": "BROKEN", "code": 7}
  $ rtcall Robot0.rtc:svc follow '[{"name": "a", "goal": {"x": 1, "y": 2}, "mode": "MOVING"}]'
  [{"goal": {"x": 1.0, "y": 2.0}, "mode": "MOVING", "name": "a"}]
  $ rtcall Robot0.rtc:svc transposed '[[1, 2], [3, 4]]'
  [[1.0, 3.0], [2.0, 4.0]]
  $ rtcall Robot0.rtc:svc picture 5
  AAECAwQ=
  $ rtcall Robot0.rtc:svc sum -- -1 2 -3 4 -5 6 A
  68
  $ rtcall Robot0.rtc:svc wide '日本' abc
  日本abc
  $ rtcall Robot0.rtc:svc keep '{"_type": "long", "_value": 3}'
  {"_type": "long", "_value": 3}
  $ rtcall Robot0.rtc:svc keep \
  >     '{"_type": "Mock::Step", "_value": {"name": "a", "goal": {"x": 1, "y": 2}, "mode": "MOVING"}}'
  {"_type": "IDL:Mock/Step:1.0", "_value": {"goal": {"x": 1.0, "y": 2.0}, "mode": "MOVING", "name": "a"}}
  $ rtcall Robot0.rtc:svc keep '{"_type": "sequence<sequence<string>>", "_value": [["a"], []]}'
  {"_type": "sequence<sequence<string>>", "_value": [["a"], []]}
  $ rtcall Robot0.rtc:svc itself | sed 's/IOR:[0-9a-f]*/IOR/'
  {"_ior": "IOR", "_type": "IDL:Mock/Robot:1.0"}
  $ rtcall Robot0.rtc:svc friend "$(rtcall Robot0.rtc:svc itself)" | sed 's/IOR:[0-9a-f]*/IOR/'
  {"_ior": "IOR", "_type": "IDL:Mock/Robot:1.0"}
  $ rtcall Robot0.rtc:svc friend null
  null

On a terminal, JSON that is too long for a line has several, with numbers side by side; a text keeps its lines:

  $ terminal 60 rtcall Robot0.rtc:svc move_to 'Point(3, 4)' 0
  {"result": {"x": 3.0, "y": 4.0}, "distance": 5.0}
  $ terminal 40 rtcall Robot0.rtc:svc move_to 'Point(3, 4)' 0
  {
    "result": {"x": 3.0, "y": 4.0},
    "distance": 5.0
  }
  $ terminal 40 rtcall Robot0.rtc:svc turn "[$(seq -s, 10)]" true
  {
    "joints": [
      -1.0, -2.0, -3.0, -4.0, -5.0, -6.0,
      -7.0, -8.0, -9.0, -10.0
    ],
    "now": "MOVING"
  }
  $ terminal 40 rtcall Robot0.rtc:svc follow '[{"name": "日本", "goal": {"x": 1, "y": 2}, "mode": "MOVING"}]'
  [
    {
      "name": "日本",
      "goal": {"x": 1.0, "y": 2.0},
      "mode": "MOVING"
    }
  ]
  $ terminal 80 rtcall Robot0.rtc:svc move_to -t
  {"goal": {"x": 0.0, "y": 0.0}, "seconds": 0.0}
  $ terminal 80 rtcall Robot0.rtc:svc say "$(printf 'a\nb\033[31m')"
  a
  b\x1b[31m
