rtstodot draws parts of systems, and folds what is large.

server: rates
world: robot
world: these ConsoleIn:Alone0 --context else.host_cxt/%n.rtc

What is at or below a path; a path alone is looked up in the running system:

  $ rtstodot --text $RTCSH_CWD | head -3
  ┌────────────────────────┐
  │ Hokuyo_AIST0  Inactive │
  │                 ranges ├─┐
  $ rtcryo -q -o robot.rtsys
  $ rtstodot --ascii robot.rtsys Clusterer0.rtc Hokuyo_AIST0.rtc
  +--------------+
  | Hokuyo_AIST0 |
  |       ranges +-+
  +--------------+ |
  | Clusterer0   | |
  | ranges       |<+
  +--------------+
  $ rtstodot --ascii $RTCSH_CWD/Motor0.rtc
  +------------------+
  | Motor0  Inactive |
  +------------------+
  $ rtstodot robot.rtsys nothing.rtc
  rtstodot: /localhost:$PORT/test.host_cxt/nothing.rtc: no such path
  [3]
  $ rtstodot --live nothing.rtc
  rtstodot: /localhost:$PORT/test.host_cxt/nothing.rtc: no such path
  [3]

An empty drawing says why it is empty:

  $ rtstodot --live --text ../else.host_cxt
  rtstodot: nothing to draw: no component is connected; rtls -R lists what is there

Neighbourhoods, by connections, with the data or against it:

  $ rtstodot --ascii --around Motor0.rtc --upstream robot.rtsys
  +-------------+
  | Controller0 |
  |         out +-+
  +-------------+ |
  | Motor0      | |
  | in          |<+
  +-------------+
  $ rtstodot --live --around Motor0.rtc --hops 2 --downstream | grep -e '->'
    Controller0:out -> Motor0:in;
    Motor0:out -> Sensor0:in;
    Sensor0:out -> Controller0:in;
  $ rtstodot --live --around Motor0.rtc --hops 0 | grep label
    Motor0 [label="{{}|Motor0|{}}", style=filled, fillcolor=lightblue];
  $ rtstodot --live --around Nothing0.rtc
  rtstodot: nothing to draw: no component at or below /localhost:$PORT/test.host_cxt/Nothing0.rtc
  [1]
  $ rtstodot --text --around /localhost:$PORT/Motor0.rtc robot.rtsys
  rtstodot: nothing to draw: no component at or below /localhost:$PORT/Motor0.rtc; did you mean /localhost:$PORT/test.host_cxt/Motor0.rtc?
  [1]
  $ rtstodot --hops -1 robot.rtsys
  rtstodot: --hops takes a number from 0 up (see --help)
  [2]
  $ rtstodot --upstream --downstream robot.rtsys
  rtstodot: --upstream does not go with --downstream (see --help)
  [2]
  $ rtstodot --hops 2 robot.rtsys
  rtstodot: --hops, --upstream and --downstream are for --around, --state and --broken (see --help)
  [2]

By state, by what rtdoctor reports, without some:

  $ rtstodot --state error
  rtstodot: nothing to draw: no component is in the state Error
  [1]
  $ rtact Sensor0.rtc; ctl @robot error Controller0
  $ rtstodot --ascii --state error
  +--------------------+
  | Controller0  Error |
  | in                 |<+
  |                out +-|-+
  +--------------------+ | |
  | Motor0  Inactive   | | |
  | in                 |<|-+
  |                out +-|-+
  +--------------------+ | |
  | Sensor0  Active    | | |
  | in                 |<|-+
  |                out +-+
  +--------------------+
  $ rtstodot --broken | grep fillcolor
    Controller0 [label="{{<in>in}|Controller0|{<out>out}}", style=filled, fillcolor=salmon];
    Motor0 [label="{{<in>in}|Motor0|{<out>out}}", style=filled, fillcolor=lightblue];
    Sensor0 [label="{{<in>in}|Sensor0|{<out>out}}", style=filled, fillcolor=palegreen];
  $ rtstodot --live --not 'Sensor*' --not '/*/Motor0.rtc' | grep label
    Clusterer0 [label="{{<ranges>ranges}|Clusterer0|{}}", style=filled, fillcolor=lightblue];
    Controller0 [label="{{}|Controller0|{}}", style=filled, fillcolor=salmon];
    Hokuyo_AIST0 [label="{{}|Hokuyo_AIST0|{<ranges>ranges}}", style=filled, fillcolor=lightblue];

Groups:

  $ rtstodot --ascii --live --group directory
  +--------------------------------+
  | /localhost:$PORT/test.host_cxt |
  | 5 components                   |
  | 3 Inactive, 1 Active, 1 Error  |
  +--------------------------------+

What is asked for by name is not folded:

  $ rtstodot --ascii --live --group directory --around Motor0.rtc
  +--------------------------------+
  | /localhost:$PORT/test.host_cxt |
  | 2 components                   |
  | 1 Active, 1 Error              |
  | from Motor0                    |<+
  |                           data +-|-+
  +--------------------------------+ | |
  | Motor0  Inactive               | | |
  | in                             |<|-+
  |                            out +-+
  +--------------------------------+

A directory that is asked for is not folded, either; what a terminal has no columns for is cut, as a wrapped line would tear the
drawing apart:

  $ rtstodot --ascii --live --group directory --around . 2>&1 | grep -c components
  0
  [1]
  $ terminal 22 rtstodot --ascii --live --around Motor0.rtc | sed 's/ *$//'
  rtstodot: folded by host to fit 22 columns; --open GROUP shows one, --group none everything
  rtstodot: cut at 22 columns; with | less -RS all of it can be looked at
  +-------------------+
  | test              |
  | 2 components      |
  | 1 Active, 1 Error |
  | from Motor0       |<
  |              data +-
  +-------------------+
  | Motor0  Inactive  |
  | in                |<
  |               out +-
  +-------------------+

  $ rtstodot --ascii --live --group host --open test
  +------------------------+
  | Hokuyo_AIST0  Inactive |
  |                 ranges +-+
  +------------------------+ |
  | Clusterer0  Inactive   | |
  | ranges                 |<+
  +------------------------+
  | Controller0  Error     |
  | in                     |<+
  |                    out +-|-+
  +------------------------+ | |
  | Motor0  Inactive       | | |
  | in                     |<|-+
  |                    out +-|-+
  +------------------------+ | |
  | Sensor0  Active        | | |
  | in                     |<|-+
  |                    out +-+
  +------------------------+
  $ rtstodot --live --group process | grep label
    "Controller0 + 4" [label="{{}|Controller0\ +\ 4\ \ 5\ components\ \ 3\ Inactive,\ 1\ Active,\ 1\ Error|{}}", style=filled, fillcolor=salmon];
  $ rtstodot --live --group process --open 'Controller0 + 4' | grep -c label
  5
  $ endpoint=$(rtcat -ll Motor0.rtc | awk '$1 == "corba.endpoints" {print $2}')
  $ rtstodot --live --group process --open "$endpoint" | grep -c label
  5
  $ rtstodot --live --group process --open nobody
  rtstodot: --open: no such group by process: nobody (Controller0 + 4)
  [3]
  $ rtstodot --group kind robot.rtsys
  rtstodot: argument --group: not one of none, composite, process, directory, host: kind (see --help)
  [2]

Rates, where values are written:

  $ rtstodot --ascii --measure 0.3 --around Sensor0.rtc --downstream | grep -c 'out [0-9.]* Hz [+]-[+]$'
  1
  $ rtcat -l Sensor0.rtc:out | grep Connected
   +Connected to  /localhost:$PORT/test.host_cxt/Controller0.rtc:in

Formats exclude each other:

  $ rtstodot --dot --svg robot.rtsys
  rtstodot: only one of --dot, --svg, --html and --text or --ascii can be drawn (see --help)
  [2]

Connections to what does not answer are drawn, to a port that is not known: they may be gone. Where it is not clear whose port it
is, its process is drawn.

  $ mock these ConsoleIn:Near0 --context far.host_cxt/%n.rtc
  $ mock these ConsoleOut:Hung0 --context far.host_cxt/%n.rtc
  $ mock these ConsoleOut:Hung1 ConsoleOut:Hung2 --context far.host_cxt/%n.rtc
  $ rtcon ../far.host_cxt/Near0.rtc:out ../far.host_cxt/Hung0.rtc:in
  $ rtcon ../far.host_cxt/Near0.rtc:out ../far.host_cxt/Hung1.rtc:in
  $ hung() {
  >     ctl @these3 fail get_owned_contexts 1 HANG
  >     ctl @these4 fail get_owned_contexts 1 HANG
  >     ctl @these4 fail get_owned_contexts 2 HANG
  > }
  $ hung; rtstodot --live --timeout 2 --text ../far.host_cxt 2> said | sed 's/1:[0-9]*  /1:PORT  /'
  ┌──────────────────────────┐
  │ Near0  Inactive          │
  │                      out ├─┐
  ├──────────────────────────┤ │
  │ Hung0  Unknown           │ │
  │ not known                │<┤
  ├──────────────────────────┤ │
  │ 127.0.0.1:PORT  Unknown │ │
  │ not known                │<┘
  ├──────────────────────────┤
  │ Hung1  Unknown           │
  ├──────────────────────────┤
  │ Hung2  Unknown           │
  └──────────────────────────┘
  $ cat said
  rtstodot: /localhost:$PORT/far.host_cxt/Hung0.rtc: no answer within 2s
  rtstodot: /localhost:$PORT/far.host_cxt/Hung1.rtc: no answer within 2s
  rtstodot: /localhost:$PORT/far.host_cxt/Hung2.rtc: no answer within 2s
  $ hung; rtstodot --live --timeout 2 --dot ../far.host_cxt 2>/dev/null | grep -c 'not.* known'
  2
  $ hung; rtstodot --live --timeout 2 --svg ../far.host_cxt 2>/dev/null | grep -c 'not known'
  4
  $ ctl @these3 reset; ctl @these4 reset
