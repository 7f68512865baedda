rtdoc prints the manual of a component: who made it, its ports, the types of its data, its configuration.

world: these ConsoleIn ConfigSample MyServiceProvider Motor

reStructuredText, laid out as rtshell does:

  $ rtdoc -f rst ConsoleIn0.rtc
  ConsoleIn
  =========
  Console input component

  :Vendor: Shinji Kurihara
  :Version: 1.0
  :Category: example

  Ports
  -----
  .. csv-table:: Ports
     :header: "Name", "Type", "DataType", "Description"
     :widths: 8, 8, 8, 26
  \x20\x20\x20 (esc)
     "out", "DataOutPort", "IDL:RTC/TimedLong:1.0", ""

  .. csv-table:: Data types
     :header: "DataType", "Members"
     :widths: 15, 35
  \x20\x20\x20 (esc)
     "IDL:RTC/TimedLong:1.0", "tm: Time, data: long"
   (esc)

A service port lists its interfaces:

  $ rtdoc --format=rst MyServiceProvider0.rtc
  MyServiceProvider
  =================
  MyService Provider Sample component

  :Vendor: Shinji Kurihara
  :Version: 1.0
  :Category: example

  Ports
  -----
  .. csv-table:: Ports
     :header: "Name", "Type", "DataType", "Description"
     :widths: 8, 8, 8, 26
  \x20\x20\x20 (esc)
     "MyService", "CorbaPort", "", ""

  .. csv-table:: Service interfaces
     :header: "Port", "Instance", "Type", "Polarity"
     :widths: 8, 14, 18, 10
  \x20\x20\x20 (esc)
     "MyService", "myservice0", "MyService", "Provided"
   (esc)

Parameters with constraints, widgets or types have columns for them:

  $ rtdoc -f rst ConfigSample0.rtc
  ConfigSample
  ============
  Configuration example component

  :Vendor: Shinji Kurihara
  :Version: 1.0
  :Category: example

  Configuration parameters
  ------------------------
  .. csv-table:: Configuration parameters
     :header: "Name", "Default", "Constraint", "Widget", "Description"
     :widths: 8, 8, 8, 8, 18
  \x20\x20\x20 (esc)
     "double_param0", "0.99", "0<=x<=100", "slider.0.1", ""
     "double_param1", "-0.99", "", "text", ""
     "int_param0", "0", "0<=x<=150", "slider.10", ""
     "int_param1", "1", "0<=x<=1000", "spin", ""
     "str_param0", "default", "(default,mode0,mode1,foo,bar,radio)", "radio", ""
     "str_param1", "default set in conf file", "", "text", ""
     "vector_param0", "0.0,0.1,0.2,0.3,0.4,0.5,0.6", "", "text", ""
   (esc)
  $ rtdoc -f rst Motor0.rtc | tail -8
  Configuration parameters
  ------------------------
  .. csv-table:: Configuration parameters
     :header: "Name", "Default", "Type", "Widget", "Description"
     :widths: 8, 8, 8, 8, 18
  \x20\x20\x20 (esc)
     "motor_id", "0", "int", "text", ""
   (esc)

-g adds a picture for Graphviz:

  $ rtdoc -f rst -g Motor0.rtc | sed -n '/digraph/,/^$/p;/rankdir/,/^$/p'
  .. digraph:: comp

     rankdir=LR;
     Motor [shape=Mrecord, label="Motor"];
     in [shape=plaintext, label="in"];
     in -> Motor;
     out [shape=plaintext, label="out"];
     Motor -> out;
   (esc)

HTML is the default: one page that needs nothing else.

  $ rtdoc ConsoleIn0.rtc >page.html
  $ head -3 page.html
  <!DOCTYPE html>
  <html lang="en">
  <head>
  $ sed -n '/<body>/,$p' page.html
  <body>
  <h1>ConsoleIn</h1>
  <p>Console input component</p>
  <dl>
  <dt>Vendor</dt><dd>Shinji Kurihara</dd>
  <dt>Version</dt><dd>1.0</dd>
  <dt>Category</dt><dd>example</dd>
  </dl>
  <h2>Ports</h2>
  <table>
  <caption>Ports</caption>
  <tr><th>Name</th><th>Type</th><th>DataType</th><th>Description</th></tr>
  <tr><td>out</td><td>DataOutPort</td><td>IDL:RTC/TimedLong:1.0</td><td></td></tr>
  </table>
  <table>
  <caption>Data types</caption>
  <tr><th>DataType</th><th>Members</th></tr>
  <tr><td>IDL:RTC/TimedLong:1.0</td><td>tm: Time, data: long</td></tr>
  </table>
  </body>
  </html>
  $ rtdoc -g ConsoleIn0.rtc | sed -n '/<pre>/,/<.pre>/p'
  <pre>digraph comp {
    rankdir=LR;
    ConsoleIn [shape=Mrecord, label=&quot;ConsoleIn&quot;];
    out [shape=plaintext, label=&quot;out&quot;];
    ConsoleIn -&gt; out;
  }</pre>
  $ python3 -c '
  > import sys, xml.etree.ElementTree
  > page = xml.etree.ElementTree.fromstring(open("page.html").read().replace("<meta charset=\"utf-8\">", ""))
  > print([cell.text for cell in page.iter("td")][:3])'
  ['out', 'DataOutPort', 'IDL:RTC/TimedLong:1.0']

LaTeX:

  $ rtdoc -f latex MyServiceProvider0.rtc
  \documentclass{article}
  \usepackage[utf8]{inputenc}
  \usepackage[T1]{fontenc}
  \usepackage{longtable}
  \begin{document}
  \section*{MyServiceProvider}
  MyService Provider Sample component

  \begin{description}
  \item[Vendor] Shinji Kurihara
  \item[Version] 1.0
  \item[Category] example
  \end{description}
  \subsection*{Ports}
  \begin{longtable}{|p{0.14\textwidth}|p{0.14\textwidth}|p{0.14\textwidth}|p{0.47\textwidth}|}
  \hline
  Name & Type & DataType & Description \\ \hline
  MyService & CorbaPort &  &  \\ \hline
  \end{longtable}
  \begin{longtable}{|p{0.14\textwidth}|p{0.25\textwidth}|p{0.32\textwidth}|p{0.18\textwidth}|}
  \hline
  Port & Instance & Type & Polarity \\ \hline
  MyService & myservice0 & MyService & Provided \\ \hline
  \end{longtable}
  \end{document}

JSON:

  $ rtdoc --json Motor0.rtc | python3 -c '
  > import json, sys
  > manual = json.load(sys.stdin)
  > print(manual["title"], manual["fields"]["Category"], [section["key"] for section in manual["sections"]])'
  Motor example ['ports', 'config']

What is not there, or not a component:

  $ rtdoc Nope0.rtc
  rtdoc: /localhost:$PORT/test.host_cxt/Nope0.rtc: no such path
  [3]
  $ rtdoc ConsolIn0.rtc
  rtdoc: /localhost:$PORT/test.host_cxt/ConsolIn0.rtc: no such path; did you mean ConsoleIn0.rtc?
  [3]
  $ rtdoc ConsoleIn0.rtc:out
  rtdoc: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc:out: not a component (it is a port)
  [3]
  $ rtdoc ConsoleIn0.rtc/
  rtdoc: /localhost:$PORT/test.host_cxt/ConsoleIn0.rtc: not a directory (it is a component)
  [3]
  $ rtdoc .
  rtdoc: /localhost:$PORT/test.host_cxt: not a component (it is a directory)
  [3]
  $ rtdoc
  rtdoc: the following arguments are required: PATH (see --help)
  [2]
  $ rtdoc -f text ConsoleIn0.rtc
  rtdoc: argument -f/--format: not one of rst, html, latex: text (see --help)
  [2]
  $ rtdoc ConsoleIn0.rtc Motor0.rtc
  rtdoc: unrecognized arguments: Motor0.rtc (see --help)
  [2]
  $ rtdoc ConsoleIn0.rtc >/dev/full
  rtdoc: No space left on device
  [1]

A component that is hung, and one that is dead:

  $ hang these; rtdoc --timeout 4 Motor0.rtc
  rtdoc: /localhost:$PORT/test.host_cxt/Motor0.rtc: no answer within 4s
  [4]
  $ wake these
  $ kill-mock these; rtdoc Motor0.rtc
  rtdoc: /localhost:$PORT/test.host_cxt/Motor0.rtc: connection refused; its process is gone (zombie)
  [4]

What the tests that run all commands have to know of this one (see tests/support/invocations.py):

invocation: A
invocation: -f rst A
invocation: --json A
looking: A
examples: asking
