"""Log files of rtlog: a robot's messages as they came, in a file that survives what happens to robots.

The format. Numbers are little-endian and follow each other without gaps. A file is a magic word and blocks:

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

Whoever reads trusts nothing: a length is compared with the file before it is read, a checksum is verified before a block
is used. A file is only ever written at its end, and given to the operating system at once (a kill -9 costs what was on
its way, milliseconds), and to the disk every few seconds (what a power failure costs). Then the end may be half a record:
it is reported, and left out. The index is a convenience: it comes with the regular end, it is believed only where the file
agrees, and whoever finds none reads through the file. To append to a file means to cut off its index, or its torn end,
and to go on with one more header. A typecode is what datatypes.Type.to_bytes gives: a log can be read without any IDL.

Modules: blocks.py is the frame, writer.py and reader.py are the two ends of it; recorder.py feeds a writer, textlog.py is
another one; simpkl.py reads rtshell's logs with pickles.py; meaning.py says what entries mean, play.py when each is due.
"""
