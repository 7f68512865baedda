A component all of whose strings are hostile, and one that does not survive being asked in the wrong order.

world: hostile
world: fragile
world: linked
both: each ORB reads answers in its own way

Nothing that it says reaches the terminal as it is, or is executed:

  $ rtcat Hostile0.rtc | cut -c 1-100
  Hostile0.rtc  Inactive
    Category       a.b/c:\x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a
    Description    ]]><script>&amp;</rts:Components>%s{}
    Instance name  Hostile\x1b[31m/$(id):.\\日本語
    Type name      \x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a
    Vendor         日本語$(touch owned);`id`'"|&<>*?~ -rf
    Version        - : # !!python/object:os.system\x0a? [null, *a]
    Parent\x20\x20\x20\x20\x20\x20\x20\x20\x20 (esc)
    Type           Monolithic
   +Extra properties
  +Execution Context 0
  +DataOutPort: $(touch owned);`id`'"|&<>*?~ -rf
  +DataInPort: \x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a
  +DataInPort:\x20 (esc)
  +DataOutPort: plain
  +CorbaPort: ]]><script>&amp;</rts:Components>%s{}
  $ for level in '' -l -ll; do
  >     rtcat $level Hostile0.rtc
  > done | LC_ALL=C grep -c -e '[[:cntrl:]]' -e "$(printf '\302[\200-\237]')"
  0
  [1]
  $ rtcat -l Hostile0.rtc:plain | grep -A 2 Connected
   +Connected to  /localhost:$PORT/test.host_cxt/Hostile0.rtc:Hostile\x1b[31m\/$(id)\:.\\日本語.\x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a
  $ rtcat --json Hostile0.rtc | LC_ALL=C grep -c '^{[ -~]*}$'
  1
  $ rtcat --json Hostile0.rtc | python3 -c 'import json, sys
  > found = json.load(sys.stdin)
  > print(len(found["properties"]["long"]), found["properties"]["integer"], found["properties"]["real"], \
  >     found["properties"]["wide"])
  > print(repr(found["type_name"]))'
  65536 5 1.5 wide 日本
  '\x1b[2J\x1b]0;owned\x07\udc9b31m\r\n'
  $ ls

Its ports can be named as they are printed, whatever they are called:

  $ rtcat Hostile0.rtc | sed -n 's/^+[A-Za-z]*: //p' | sed 's,[:/],\\&,g; s,^,Hostile0.rtc:,' | grep -v ':$' |
  >     tr '\n' '\0' | xargs -0 rtcat
  +DataOutPort: $(touch owned);`id`'"|&<>*?~ -rf

  +DataInPort: \x1b[2J\x1b]0;owned\x07\x9b31m\x0d\x0a

  +DataOutPort: plain

  +CorbaPort: ]]><script>&amp;</rts:Components>%s{}

The component that a careless question ends:

  $ rtcat -ll Fragile0.rtc | grep -c Fragile0; ctl @fragile components
  5
  Fragile0
  $ rtcat --json Fragile0.rtc Fragile0.rtc:out Fragile0.rtc | wc -l; ctl @fragile components
  3
  Fragile0

It also survives being named as a far end, and losing its new peer:

  $ rtcon ConsoleOut0.rtc:in Fragile0.rtc:out; rtcat -ll ConsoleOut0.rtc | grep -c Fragile0.rtc:out
  1
  $ kill-mock linked; rtls -l Fragile0.rtc
  Inactive  1/0  0/0  1/0  0/0  Fragile0.rtc
  $ rtcat -l Fragile0.rtc | tail -n 1
    port.port_type                           DataOutPort
  $ ctl @fragile components
  Fragile0
