// Print what the packages of the package index read in a file of MCAP: a line of JSON a message. NODE_PATH names where they are.
const fs = require("fs");
const {McapIndexedReader} = require("@mcap/core");
const {parse} = require("@foxglove/rosmsg");
const {MessageReader: RosReader} = require("@foxglove/rosmsg2-serialization");
const {parseIDL} = require("@foxglove/omgidl-parser");
const {MessageReader: IdlReader} = require("@foxglove/omgidl-serialization");

class File {
  constructor(name) { this.fd = fs.openSync(name); this.length = fs.fstatSync(this.fd).size; }
  async size() { return BigInt(this.length); }
  async read(offset, length) {
    const octets = Buffer.alloc(Number(length));
    fs.readSync(this.fd, octets, 0, Number(length), Number(offset));
    return new Uint8Array(octets.buffer, octets.byteOffset, octets.length);
  }
}

// Wide text is refused, and unions that hold nothing, or are switched by 64 bits.
function read(made, data) {
  try {
    return made.readMessage(data);
  } catch (error) {
    if (/'wstring' types are not supported|No matching case/.test(String(error))) return null;
    throw error;
  }
}

function plain(key, value) {
  if (typeof value === "bigint") return {big: value.toString()};
  if (typeof value === "number" && !Number.isFinite(value)) return {odd: String(value)};
  if (ArrayBuffer.isView(value)) return Array.from(value);
  return value;
}

async function main() {
  const reader = await McapIndexedReader.Initialize({readable: new File(process.argv[2]), validateCrcs: true});
  const readers = new Map();
  for (const channel of reader.channelsById.values()) {
    const schema = reader.schemasById.get(channel.schemaId);
    if (schema == undefined) continue;
    const text = new TextDecoder().decode(schema.data);
    if (schema.encoding === "ros2msg") readers.set(channel.id, new RosReader(parse(text, {ros2: true})));
    if (schema.encoding === "omgidl") readers.set(channel.id, new IdlReader(schema.name, parseIDL(text)));
  }
  for await (const message of reader.readMessages({validateCrcs: true})) {
    const made = readers.get(message.channelId);
    const topic = reader.channelsById.get(message.channelId).topic;
    console.log(JSON.stringify({topic, value: made ? read(made, message.data) : null, size: message.data.length}, plain));
  }
}

main().catch((error) => { console.error(error); process.exit(1); });
