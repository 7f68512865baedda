rtstodot --html writes a page for a browser. What a browser makes of it is in tests/waiting/test_page_browser.py.

world: linked
world: these ConfigSample
world: hostile --context h.host_cxt/%n.rtc

Of what is running, connected or not, with what rtcat -ll shows, and configuration sets:

  $ rtact ConsoleIn0.rtc
  $ rtstodot --live --html page.html .; grep -o '<title>[^<]*' page.html
  <title>/localhost:$PORT/test.host_cxt
  $ has page.html '"name":"ConsoleIn0"' '"state":"Active"' '"name":"ConfigSample0"' '"Owner","ConsoleIn0"' \
  >     'Configuration set mode1 (active)'
  $ has page.html '"port.port_type","DataOutPort"' '"dataport.interface_type","corba_cdr"' \
  >     '"path":"/localhost:[0-9]*/test.host_cxt/ConsoleOut0.rtc"'

Of a file, of a part, to stdout; a page needs no terminal and no other file:

  $ rtcryo . > a.xml
  rtcryo: 1 component without connections left out; --all saves them, too
  $ rtstodot --html page.html a.xml; has page.html '"name":"ConsoleIn0"' 'Kind","PERIODIC' '<h1>a.xml</h1>'
  $ grep -c '"state"' page.html
  0
  [1]
  $ rtstodot --html page.html --live a.xml; has page.html '"state":"Active"' '"state":"Inactive"'
  $ rtstodot --html - a.xml --not 'ConsoleOut*' | grep -o '"name":"Console[^"]*"'
  "name":"ConsoleIn0"
  $ grep -E -c '(src|href)=' page.html
  0
  [1]

What fails is in it as failed:

  $ rtstodot --live --html page.html . ./Gone0.rtc
  rtstodot: /localhost:*/test.host_cxt/Gone0.rtc: no such path (glob)
  [5]
  $ has page.html '"level":"fail"' 'no such path' '"name":"ConsoleIn0"'

Nothing that a component says becomes markup:

  $ rtstodot --live --html page.html ../h.host_cxt
  $ grep -c '<script' page.html
  2
  $ grep -c '</script' page.html
  2
  $ has page.html 'u003cscript'

Files are written whole, or not at all; wrong usage:

  $ rtstodot --html nowhere/page.html a.xml
  rtstodot: nowhere/page.html: No such file or directory
  [1]
  $ rtstodot --html page.html --svg a.xml
  rtstodot: only one of --dot, --svg, --html and --text or --ascii can be drawn (see --help)
  [2]
  $ rtstodot --html page.html --open nothing a.xml
  rtstodot: --open: no such group by none: nothing (nothing is folded)
  [3]
