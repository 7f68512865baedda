"""Log files of rtlog: messages as they came, in files of MCAP, which others open, and which survive crashes.

A file has a header; a Metadata record `rtlog` (`created`: ns since the epoch); a Schema and a Channel record
for each stream; then chunks of at most about 1 MiB or 0.1 s, each with its checksum and message indexes; in
the end a summary with a checksum. Messages are plain CDR with its head of 4 octets, as
OpenRTM::InPortCdr::put carries it, or JSON. A channel's metadata: `type`, the id of its data type;
`description`, what datatypes.Type.to_bytes returns, so that no IDL is needed; `sources`, a JSON list of the
ports that it came from.

A reader trusts nothing: it compares a length with the file before it reads, and verifies a chunk's checksum
before it uses the messages. A file is only written at its end, a whole chunk at a time: a kill -9 loses 0.2
s, a power failure about 1 s. Half a chunk at the end is reported and left out. The summary is optional: it is
written at the regular end, and used only if the file agrees with it; else the file is searched for chunks.
Appending cuts off the summary, or a torn end.

Modules: mcap.py is the format, without I/O, and schemas.py describes types in it; writer.py and reader.py use
both, mend.py completes files. recording.py and flight.py connect to ports, recorder.py feeds a writer,
textlog.py or ring.py, of which incidents.py keeps what triggers.py reports; simpkl.py reads rtshell's logs
with pickles.py; decode.py says what entries mean, tables.py exports them, play.py sends them when pace.py
says so.
"""
