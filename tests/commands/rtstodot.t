rtstodot draws a system in the language of Graphviz.

server: composites
world: linked
world: services
world: these ConsoleOut:ConsoleOut1 ConsoleIn:ConsoleIn1 ConfigSample
world: composite --nameserver localhost:$PORT2

From a file, in either form, or from stdin:

  $ rtcryo > a.xml; rtcryo -y > a.yaml
  rtcryo: 5 components without connections left out; --all saves them, too
  rtcryo: 5 components without connections left out; --all saves them, too
  $ rtstodot a.xml | tee a.dot
  digraph rtsprofile {
    rankdir=LR;
    node [shape=Mrecord];
    ConsoleIn0 [label="{{}|ConsoleIn0|{<out>out}}"];
    ConsoleOut0 [label="{{<in>in}|ConsoleOut0|{}}"];
    ConsoleIn0:out -> ConsoleOut0:in;
  }
  $ rtstodot a.yaml | cmp - a.dot
  $ rtstodot < a.yaml | head -2; rtstodot - < a.xml | head -2
  digraph rtsprofile {
    rankdir=LR;
  digraph rtsprofile {
    rankdir=LR;
  $ rtstodot -x a.xml | tail -2; rtstodot -y a.yaml | tail -2
    ConsoleIn0:out -> ConsoleOut0:in;
  }
    ConsoleIn0:out -> ConsoleOut0:in;
  }

Service connections, more than two ends, components without connections:

  $ rtcon MyServiceConsumer0.rtc:MyService MyServiceProvider0.rtc:MyService
  $ rtcon ConsoleIn1.rtc:out ConsoleOut1.rtc:in ConsoleOut0.rtc:in
  $ rtcryo --all > b.xml; rtstodot b.xml
  digraph rtsprofile {
    rankdir=LR;
    node [shape=Mrecord];
    ConfigSample0 [label="{{}|ConfigSample0|{}}"];
    ConsoleIn0 [label="{{}|ConsoleIn0|{<out>out}}"];
    ConsoleIn1 [label="{{}|ConsoleIn1|{<out>out}}"];
    ConsoleOut0 [label="{{<in>in}|ConsoleOut0|{}}"];
    ConsoleOut1 [label="{{<in>in}|ConsoleOut1|{}}"];
    MyServiceConsumer0 [label="{{}|MyServiceConsumer0|{<MyService>MyService}}"];
    MyServiceProvider0 [label="{{<MyService>MyService}|MyServiceProvider0|{}}"];
    ConsoleIn0:out -> ConsoleOut0:in;
    ConsoleIn1:out -> ConsoleOut1:in;
    ConsoleIn1:out -> ConsoleOut0:in;
    MyServiceConsumer0:MyService -> MyServiceProvider0:MyService [arrowhead="odot"];
  }

Composites are boxes around their members; a port that a composite exports belongs to the member:

  $ c=/localhost:$PORT2/test.host_cxt
  $ rtcon $c/Sensor0.rtc:out $c/Controller0.rtc:in
  $ rtcon $c/composite0.rtc:Motor0.out $c/composite0.rtc:Sensor0.in
  $ rtcryo localhost:$PORT2 | rtstodot
  digraph rtsprofile {
    rankdir=LR;
    node [shape=Mrecord];
    Controller0 [label="{{<in>in}|Controller0|{}}"];
    Motor0 [label="{{}|Motor0|{<out>out}}"];
    Sensor0 [label="{{<in>in}|Sensor0|{<out>out}}"];
    subgraph cluster_composite0 {
      label="composite0";
      Controller0;
      Motor0;
      Sensor0;
    }
    Motor0:out -> Sensor0:in;
    Sensor0:out -> Controller0:in;
  }

--text draws in the terminal, data from top to bottom; --ascii does with less:

  $ rtstodot --text a.xml
  ┌─────────────┐
  │ ConsoleIn0  │
  │         out ├─┐
  ├─────────────┤ │
  │ ConsoleOut0 │ │
  │ in          │<┘
  └─────────────┘
  $ rtcryo | rtstodot --text
  rtcryo: 1 component without connections left out; --all saves them, too
  ┌────────────────────┐
  │ ConsoleIn0         │
  │                out ├─┐
  ├────────────────────┤ │
  │ ConsoleIn1         │ │
  │                out ├─│─┐
  ├────────────────────┤ │ │
  │ ConsoleOut0        │ │ │
  │ in                 │<┴─┤
  ├────────────────────┤   │
  │ ConsoleOut1        │   │
  │ in                 │<──┘
  ├────────────────────┤
  │ MyServiceConsumer0 │
  │          MyService ╞═╗
  ├────────────────────┤ ║
  │ MyServiceProvider0 │ ║
  │ MyService          │<╝
  └────────────────────┘
  $ rtcryo | rtstodot --ascii
  rtcryo: 1 component without connections left out; --all saves them, too
  +--------------------+
  | ConsoleIn0         |
  |                out +-+
  +--------------------+ |
  | ConsoleIn1         | |
  |                out +-|-+
  +--------------------+ | |
  | ConsoleOut0        | | |
  | in                 |<+-+
  +--------------------+   |
  | ConsoleOut1        |   |
  | in                 |<--+
  +--------------------+
  | MyServiceConsumer0 |
  |          MyService +=+
  +--------------------+ :
  | MyServiceProvider0 | :
  | MyService          |<+
  +--------------------+
  $ rtcryo localhost:$PORT2 | rtstodot --text
  ┌──────────────────────────────────────┐
  │ Motor0  (in composite0)              │
  │                                  out ├─┐
  ├──────────────────────────────────────┤ │
  │ Sensor0  (in composite0)             │ │
  │ in                                   │<┘
  │                                  out ├─┐
  ├──────────────────────────────────────┤ │
  │ Controller0  (in composite0)         │ │
  │ in                                   │<┘
  ├──────────────────────────────────────┤
  │ composite0                           │
  │ made of Controller0, Motor0, Sensor0 │
  └──────────────────────────────────────┘
  $ rtstodot --live --text a.xml
  ┌───────────────────────┐
  │ ConsoleIn0  Inactive  │
  │                   out ├─┐
  ├───────────────────────┤ │
  │ ConsoleOut0  Inactive │ │
  │ in                    │<┘
  └───────────────────────┘

--svg makes a picture that any browser shows:

  $ rtstodot --svg --live a.xml | sed 's/<defs>.*/…/'
  <svg xmlns="http://www.w3.org/2000/svg" width="470" height="90" font-family="monospace" font-size="14">
  <style>@media (prefers-color-scheme: dark) { .page { fill: #1c1c1c } text { fill: #eee } rect, path { stroke: #ccc } marker path { fill: #ccc } .none { fill: #1c1c1c } .Inactive { fill: #2a4a6a } .Active { fill: #1f4d2b } .Error { fill: #8a2a22 } .Created, .Unknown { fill: #444 } }</style>
  …
  <rect class="page" width="100%" height="100%" fill="white"/>
  <rect class="Inactive" x="20" y="20" width="190" height="50" rx="5" fill="lightblue" stroke="black"/>
  <text x="115" y="39" text-anchor="middle">ConsoleIn0  Inactive</text>
  <text x="204" y="60" text-anchor="end">out</text>
  <rect class="Inactive" x="250" y="20" width="200" height="50" rx="5" fill="lightblue" stroke="black"/>
  <text x="350" y="39" text-anchor="middle">ConsoleOut0  Inactive</text>
  <text x="256" y="60" text-anchor="start">in</text>
  <path d="M210,55 H250" fill="none" stroke="black" marker-end="url(#arrow)"><title>ConsoleIn0:out to ConsoleOut0:in</title></path>
  </svg>
  $ rtstodot --svg --text a.xml
  rtstodot: only one of --dot, --svg, --html and --text or --ascii can be drawn (see --help)
  [2]

--live colours components by their states; without a file it draws what is running:

  $ rtact ConsoleIn0.rtc ConsoleOut0.rtc
  $ rtstodot --live a.xml
  digraph rtsprofile {
    rankdir=LR;
    node [shape=Mrecord];
    ConsoleIn0 [label="{{}|ConsoleIn0|{<out>out}}", style=filled, fillcolor=palegreen];
    ConsoleOut0 [label="{{<in>in}|ConsoleOut0|{}}", style=filled, fillcolor=palegreen];
    ConsoleIn0:out -> ConsoleOut0:in;
  }
  $ rtstodot --live | grep -c '\[label'
  6
  $ rtcryo --all | rtstodot --live - | grep fillcolor
    ConfigSample0 [label="{{}|ConfigSample0|{}}", style=filled, fillcolor=lightblue];
    ConsoleIn0 [label="{{}|ConsoleIn0|{<out>out}}", style=filled, fillcolor=palegreen];
    ConsoleIn1 [label="{{}|ConsoleIn1|{<out>out}}", style=filled, fillcolor=lightblue];
    ConsoleOut0 [label="{{<in>in}|ConsoleOut0|{}}", style=filled, fillcolor=palegreen];
    ConsoleOut1 [label="{{<in>in}|ConsoleOut1|{}}", style=filled, fillcolor=lightblue];
    MyServiceConsumer0 [label="{{}|MyServiceConsumer0|{<MyService>MyService}}", style=filled, fillcolor=lightblue];
    MyServiceProvider0 [label="{{<MyService>MyService}|MyServiceProvider0|{}}", style=filled, fillcolor=lightblue];

Without a file, and with a terminal for stdin, what is running is drawn, too:

  $ terminal 200 rtstodot | tail -4
    ConsoleIn1:out -> ConsoleOut1:in;
    ConsoleIn1:out -> ConsoleOut0:in;
    MyServiceConsumer0:MyService -> MyServiceProvider0:MyService [arrowhead="odot"];
  }

Not there any more, or not answering: grey, and told.

  $ rtexit --wait=5 MyServiceProvider0.rtc; hang linked
  $ within 1.9-6 rtstodot --live --timeout 2 b.xml | grep -v ' -> '
  rtstodot: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 2s
  rtstodot: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no answer within 2s
  rtstodot: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  digraph rtsprofile {
    rankdir=LR;
    node [shape=Mrecord];
    ConfigSample0 [label="{{}|ConfigSample0|{}}", style=filled, fillcolor=lightblue];
    ConsoleIn0 [label="{{}|ConsoleIn0|{<out>out}}", style=filled, fillcolor=lightgrey];
    ConsoleIn1 [label="{{}|ConsoleIn1|{<out>out}}", style=filled, fillcolor=lightblue];
    ConsoleOut0 [label="{{<in>in}|ConsoleOut0|{}}", style=filled, fillcolor=lightgrey];
    ConsoleOut1 [label="{{<in>in}|ConsoleOut1|{}}", style=filled, fillcolor=lightblue];
    MyServiceConsumer0 [label="{{}|MyServiceConsumer0|{<MyService>MyService}}", style=filled, fillcolor=lightblue];
    MyServiceProvider0 [label="{{<MyService>MyService}|MyServiceProvider0|{}}", style=filled, fillcolor=lightgrey];
  }
  $ within 1.9-6 rtstodot --live --timeout 2 b.xml >/dev/null
  rtstodot: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: no answer within 2s
  rtstodot: /localhost:$PORT/test.host_cxt/ConsoleOut0.rtc: no answer within 2s
  rtstodot: /localhost:$PORT/test.host_cxt/MyServiceProvider0.rtc: no such path; did you mean MyServiceConsumer0.rtc?
  [5]
  $ wake linked
  $ RTCTREE_NAMESERVERS=localhost:1 rtstodot --live
  rtstodot: /localhost:1: connection refused; is the name server running?
  [4]

Files that are not profiles, reported with line and column:

  $ rtstodot nofile
  rtstodot: nofile: No such file or directory
  [1]
  $ rtstodot --svg new.svg /localhost
  rtstodot: new.svg: no such file to draw; --svg prints the drawing: > new.svg (see --help)
  [2]
  $ rtstodot
  rtstodot: stdin is empty; --live draws what is running
  [1]
  $ rtstodot -
  rtstodot: -:1:1: the file is empty
  [1]
  $ echo '<a/>' > bad.xml; rtstodot bad.xml
  rtstodot: bad.xml:1:1: not an RtsProfile: its root element is "a"
  [1]
  $ printf '<rts:RtsProfile\n  oops' > torn.xml; rtstodot torn.xml
  rtstodot: torn.xml:1:1: unclosed token
  [1]
  $ printf 'rtsProfile:\n  id: [1\n' | rtstodot
  rtstodot: -:2:7: this bracket is never closed
  [1]
  $ rtstodot -y a.xml
  rtstodot: a.xml:1:1: not an RtsProfile: the key rtsProfile is missing
  [1]
  $ rtstodot a.xml b.xml
  rtstodot: /localhost:$PORT/test.host_cxt/b.xml: no such path
  [3]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: --live FILE
invocation: --live --text FILE
invocation: --live --svg FILE
looking: --live --text FILE
broken component: 5
examples: asking
