What rtcryo saves of the managers of a system is all that rtresurrect --create needs.

world: manager

  $ rtcon -i one ConsoleIn0.rtc:out ConsoleOut0.rtc:in
  $ rtcryo -o a.xml
  $ rtcryo -y -o a.yaml
  $ grep -o 'name="MANAGER".*' a.xml; grep -c 'name: MANAGER' a.yaml
  name="MANAGER" rtsExt:value="localhost:$PORT/test.host_cxt/manager.mgr"/>
  name="MANAGER" rtsExt:value="localhost:$PORT/test.host_cxt/manager.mgr"/>
  2
  $ again() {
  >     for c in ConsoleIn0 ConsoleOut0; do
  >         rtmgr -d $c manager.mgr
  >     done
  >     rtresurrect -q --create $1
  >     rtcryo | grep -v -e Date= -e REFERENCE > b.xml
  >     grep -v -e Date= -e REFERENCE a.xml | diff - b.xml
  > }
  $ again a.xml; again a.yaml

A manager that refuses to list its components keeps none of them from being saved:

  $ ctl fail get_components 1 NO_PERMISSION
  $ rtcryo -o c.xml
  rtcryo: /localhost:$PORT/test.host_cxt/manager.mgr: CORBA.NO_PERMISSION; which components it has made is not saved
  $ grep -c '"MANAGER"' c.xml
  0
  [1]
