"""Log files of rtlog: messages as they came, in a file that survives crashes.

The format. Numbers are little-endian, without padding. A file is a magic word and blocks:

    file    89 'RTLOG' 0D 0A, then blocks up to the end
    block   kind (1 octet: H, R or I), length of the body (uint32), CRC-32 of kind, length and body (uint32), body
    H       header: JSON, ASCII: {"created": ns, "program": "rtlog 0.1.0", "channels": [channel, …]}
              channel: {"name": …, "type": "IDL:RTC/TimedLong:1.0", "typecode": hex or null, "sources": [path, …]}
    R       record: number (uint64, from 0), time of arrival (int64, ns since the epoch), channel (uint16, counted from 0
              in the last header before), flags (1 octet; 1: little-endian), then the message: plain CDR of the type,
              aligned to its own start, as OpenRTM::InPortCdr::put carries it
    I       index: JSON, ASCII: {"next": number, "first": ns, "last": ns, "counts": {channel's name: records},
              "headers": [offset, …], "points": [[number, offset, latest arrival before it], …]},
              then where this block begins (uint64) and 'rtlogend'

A reader trusts nothing: it compares a length with the file before it reads, and verifies a checksum before it uses a block. A
file is only written at its end; messages go to the operating system at once (a kill -9 loses milliseconds) and to the disk
every few seconds (which a power failure loses). Half a record at the end is reported and left out. The index is optional: it
is written at the regular end, and used only if the file agrees with it; else the whole file is read. Appending cuts off the
index, or a torn end, and adds another header. A typecode is what datatypes.Type.to_bytes returns: no IDL is needed to read it.

Modules: blocks.py has the frame that writer.py writes and reader.py reads; recorder.py feeds a writer or textlog.py; simpkl.py
reads rtshell's logs with pickles.py; decode.py says what entries mean, play.py sends them.
"""
