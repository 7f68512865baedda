// The page of a system: list, map, details. What the system says goes into text nodes only. views/page.py has the fields of `data`.
const DEFAULTS = {path: null, state: null, missing: false, composite: null, parts: [], ports: [], why: ""};
let [data, ALL, troubles, connectionsOf, membersOf, texts] = []; // see load()
const SVG = "http://www.w3.org/2000/svg";
const SHAPES = new Set(["svg", "g", "rect", "text", "path", "title"]);
const SYMBOLS = {Active: "\u25cf", Inactive: "\u25cb", Error: "\u2716", Created: "\u25cc", Unknown: "?"};
const WORST = ["Error", "Unknown"]; // states that are counted first
const [CELL, ROW] = [8.5, 20]; // pixels: a character, a line of text
const LONGEST = 44; // characters of a name on the map
const view = {around: null, hops: 1, way: "both", broken: false, kind: "auto", scale: 1, selected: null, group: null, opened: new Map(), folders: new Map()};
let picture = null; // what fold() made, with the elements on the map

function load(found) {
  data = Object.assign(found, {boxes: found.boxes.map((box) => Object.assign({}, DEFAULTS, box)),
                               rows: found.rows.map((rows) => rows.map((pair) => found.pairs[pair]))});
  ALL = data.boxes.map((box, number) => number);
  [troubles, connectionsOf, texts] = [ALL.map(() => []), ALL.map(() => []), []]; // findings of each component; what is searched
  data.connections.forEach((connection) => new Set(connection.ends.map((end) => end[0])).forEach(
    (end) => connectionsOf[end].push(connection)));
  membersOf = [];
  data.groups.forEach((group, number) => { // what is in a group comes before it
    membersOf.push([].concat(...childrenOf(number).map((child) => (child < 0 ? membersOf[-1 - child] : child))));
  });
  data.findings.filter(({box, level}) => box !== null && ["fail", "warn"].includes(level)).forEach(
    (finding) => troubles[finding.box].push(finding));
}

const element = (id) => document.getElementById(id);
const plural = (number, noun) => `${number} ${noun}${number === 1 ? "" : "s"}`;
const isBroken = (number) => troubles[number].length > 0 || data.boxes[number].missing ||
  ["Error", "Unknown"].includes(data.boxes[number].state);
const byName = new Intl.Collator("en", {numeric: true}).compare;
const inListOrder = (numbers) => numbers.slice().sort((a, b) => isBroken(b) - isBroken(a) ||
  (data.boxes[b].state === "Error") - (data.boxes[a].state === "Error") || byName(data.boxes[a].name, data.boxes[b].name) || a - b);

// An element with these attributes (functions are listeners) and children (what is no element becomes a text node).
function make(tag, attributes, ...children) {
  const made = SHAPES.has(tag) ? document.createElementNS(SVG, tag) : document.createElement(tag);
  for (const name of Object.keys(attributes)) {
    const value = attributes[name];
    if (typeof value === "function") made.addEventListener(name, value);
    else if (value !== null) made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}
const fill = (parent, ...children) => { parent.textContent = ""; parent.append(...children); };
const button = (words, click, more) => make("button", Object.assign({type: "button", click}, more), words);

// ---- which components, in which groups
// These components and those that connections lead to, over as many as `hops` of them.
function neighbours(numbers, hops, way) {
  const reached = new Set(numbers);
  for (let hop = 0; hop < hops; hop += 1) {
    for (const number of Array.from(reached)) {
      for (const {ends} of connectionsOf[number]) {
        if (way !== "upstream" && ends[0][0] === number) ends.forEach((end) => reached.add(end[0]));
        if (way !== "downstream" && ends[0][0] !== number) reached.add(ends[0][0]);
      }
    }
  }
  return ALL.filter((number) => reached.has(number));
}
function shownNumbers() {
  if (view.around !== null) return neighbours([view.around], view.hops, view.way);
  return view.broken ? neighbours(ALL.filter(isBroken), 1, "both") : ALL;
}

// {root, boxes, frames, at: the place of each component's box}: what is seen of these components. Groups of a kind are one box each, or
// frames, down to a depth or as `opened` has it; a group of which one component is shown is that component.
function fold(numbers, kind, depth, opened) {
  const found = {boxes: [], frames: [], at: new Map(), kind};
  const shown = new Set(numbers);
  const add = (members, group) => {
    members.forEach((member) => found.at.set(member, found.boxes.length));
    const box = {members, group, sources: [], left: [], right: [], lines: [0, 0]};
    found.boxes.push(box);
    return box;
  };
  const node = (child, above, level) => {
    if (child >= 0) return shown.has(child) ? add([child], null) : null;
    const members = membersOf[-1 - child].filter((member) => shown.has(member));
    if (members.length < 2) return members.length ? add(members, null) : null;
    const group = groupOf(child, above);
    const isOpen = opened.has(group.key) ? opened.get(group.key) : level < depth;
    return isOpen ? frame(-1 - child, group, members, level + 1) : add(members, group);
  };
  const frame = (number, group, members, level) => {
    const made = {group, members, sources: [], top: TITLE, side: PAD, least: 0};
    if (level) found.frames.push(made);
    made.rows = data.groups[number][3].map((row) => row.map((column) => {
      const items = [];
      for (let place = 0; place < column.length; place += 2) {
        const item = node(column[place], group.key, level);
        if (item) items.push(Object.assign(item, {home: column[place + 1], usual: usualSize(column[place], depth - level), parent: made}));
      }
      return items;
    }).filter((items) => items.length)).filter((row) => row.length);
    return made;
  };
  found.root = Object.assign(frame(data.trees[kind], {key: ""}, numbers, 0), {top: MARGIN, side: MARGIN});
  return found;
}
// About the size of a box, or of a group with all groups open down to this depth.
function usualSize(child, depth) {
  if (child >= 0 || depth < 1) return child >= 0 ? [140, 90] : [260, 80];
  const rows = data.groups[-1 - child][3].map((row) => row.map((column) => column.filter((inner, place) => place % 2 === 0).map(
    (inner) => usualSize(inner, depth - 1))).map((sizes) => [largest(sizes.map((size) => size[0])) + BESIDE, sum(sizes.map((size) => size[1] + GAP))]));
  return [largest(rows.map((row) => sum(row.map((size) => size[0])))), sum(rows.map((row) => largest(row.map((size) => size[1]))))];
}
// How many boxes there are if groups are open down to this depth.
function countAt(child, depth, shown) {
  if (child >= 0) return shown.has(child) ? 1 : 0;
  const inside = membersOf[-1 - child].filter((member) => shown.has(member)).length;
  if (inside < 2 || depth < 1) return Math.min(inside, 1);
  return sum(childrenOf(-1 - child).map((inner) => countAt(inner, depth - 1, shown)));
}
const childrenOf = (number) => [].concat(...data.groups[number][3].map((row) => [].concat(...row.map((column) => column.filter((child, place) => place % 2 === 0)))));
// A group by its number as a child; its key has those of the groups around it.
function groupOf(child, above) {
  const [kind, full, label] = data.groups[-1 - child];
  return {number: -1 - child, key: `${above}\n${kind}:${full}`, kind: data.kinds[kind], name: label || full, full};
}
const groupsIn = (number, above) => childrenOf(number).filter((child) => child < 0).map((child) => groupOf(child, above));

// [kind, depth]: the first kind of groups that leaves no more boxes than a person can overlook; groups that are open at first.
function chooseKind(numbers) {
  const shown = new Set(numbers);
  const count = (kind, depth) => countAt(-1 - data.trees[kind], depth, shown);
  const fits = data.order.find((kind) => count(kind, 1) <= data.most);
  const kind = fits === undefined ? data.order[data.order.length - 1] : fits;
  let depth = 0;
  while (depth < 4 && count(kind, depth + 2) <= data.most) depth += 1;
  return [kind, depth];
}

// The lines between boxes, for which they get ports; parallel ones to or from a group are one.
function connect({boxes, at}) {
  const lines = new Map();
  for (const {ends, service} of data.connections) {
    const [from, out] = [at.get(ends[0][0]), ends[0][1]];
    for (const [number, port] of ends.slice(1)) {
      const to = at.get(number);
      if (from === undefined || to === undefined) continue;
      const folded = boxes[from].group || boxes[to].group;
      if (folded && from === to) continue;
      const key = folded ? `${from} ${to} ${service}` : JSON.stringify([from, out, to, port, service]);
      if (!lines.has(key)) lines.set(key, {from, to, source: boxes[from], target: boxes[to], service, folded, slots: [0, 0], pairs: []});
      lines.get(key).pairs.push([out, port]);
    }
  }
  const edges = Array.from(lines.values());
  edges.forEach((edge) => [edge.source, edge.target].forEach((box, end) => {
    const ports = Array.from(new Set(edge.pairs.map((pair) => pair[end])));
    const port = ports.length === 1 ? ports[0] : `${ports.length} ports`;
    edge[end ? "into" : "out"] = port;
    if (box.group) box.lines[1 - end] += 1;
    else if (!box.left.includes(port) && !box.right.includes(port)) box[end ? "left" : "right"].push(port);
  }));
  return edges;
}
// Where an edge begins (end 0) or ends (1): at a port, on a group in the order of what it leads to.
function endOf(edge, end) {
  const [box, port] = [end ? edge.target : edge.source, end ? edge.into : edge.out];
  const side = box.group ? 1 - end : Number(box.right.includes(port));
  const row = box.heads.length + (side ? box.right : box.left).indexOf(port);
  const y = box.group ? Math.round(box.height * (edge.slots[end] + 1) / (box.lines[side] + 1)) : row * ROW + 15;
  return {x: box.x + side * box.width, y: box.y + y, side};
}

// ---- words on the map
const nameOf = (number) => data.boxes[number].label || data.boxes[number].name;
const boxName = (box) => (box.group ? box.group.name : nameOf(box.members[0]));
const short = (words) => (words.length > LONGEST ? `${words.slice(0, LONGEST - 1)}\u2026` : words);
const cells = (words) => Array.from(words).reduce((sum, letter) => sum + (letter.codePointAt(0) < 0x1100 ? 1 : 2), 0);
const stateWords = (state) => `${SYMBOLS[state] || "?"} ${state}`;

function counts(numbers) {
  const states = new Map();
  numbers.map((number) => data.boxes[number].state).filter(Boolean).forEach((state) => states.set(state, (states.get(state) || 0) + 1));
  const rank = (state) => WORST.indexOf(state) + 1 || WORST.length + 1;
  const order = Array.from(states.keys()).sort((a, b) => rank(a) - rank(b) || states.get(b) - states.get(a));
  return order.map((state) => stateWords(state).replace(" ", ` ${states.get(state)} `));
}

// The lines at the top of a box.
function heads(box) {
  const broken = box.members.filter(isBroken).length;
  const size = plural(box.members.length, "component") + (broken ? `, \u26a0 ${broken} broken` : "");
  if (box.group) return [short(boxName(box)), size, ...counts(box.members)];
  const {state, missing, composite} = data.boxes[box.members[0]];
  const words = [state === null ? "" : stateWords(state), missing ? "not in the profile" : "",
                 troubles[box.members[0]].length ? `\u26a0 ${plural(troubles[box.members[0]].length, "finding")}` : "",
                 composite === null || box.parent.group.kind === "composite" ? "" : `in ${short(data.boxes[composite].name)}`].filter(Boolean).join("  ");
  return [short(boxName(box)), words].filter(Boolean);
}
function classOf(box) {
  const states = new Set(box.members.map((number) => data.boxes[number].state));
  const state = states.size === 1 ? Array.from(states)[0] : null;
  return `box ${SYMBOLS[state] ? state : "none"}${box.group ? " group" : ""}${box.members.some(isBroken) ? " broken" : ""}`;
}

// ---- the map
// What is seen of these components, drawn for a page of this width and height, in pixels.
function paint(numbers, [kind, depth], opened, page) {
  const found = fold(numbers, kind, depth, opened);
  const {root, boxes, frames} = found;
  const edges = connect(found);
  for (const box of boxes) {
    box.heads = heads(box);
    const [left, right] = [box.left, box.right].map((ports) => largest(ports.map((port) => cells(short(port)))));
    box.least = Math.ceil((Math.max(left + right + 3, ...box.heads.map(cells)) + 2) * CELL) + (box.group ? 48 : 0);
    box.width = box.least;
    box.height = (box.heads.length + Math.max(box.left.length, box.right.length)) * ROW + ROW / 2;
    if (box.group) box.height = Math.max(box.height, (Math.max(...box.lines) + 1) * 14);
  }
  frames.forEach((frame) => { frame.least = Math.ceil((cells(titleOf(frame)) + 5) * CELL); });
  arrange(root, edges, endOf, page, numbers.length < ALL.length);
  const {width, height} = root;
  const svg = make("svg", {viewBox: `0 0 ${width} ${height}`, role: "group", "aria-label": "map of the system"});
  svg.append(...frames.map(drawFrame), ...edges.map(drawLine), ...boxes.map(drawBox), ...edges.filter((edge) => edge.pairs.length > 1).map(drawNumber));
  return Object.assign(found, {edges, svg, width, height, room: {x: 0, y: 0, width, height}});
}
// Draw what is seen now, around the same point.
function draw() {
  const center = picture ? centerOfMap() : [0, 0];
  replaceMap();
  lookAt(...center);
}
function replaceMap() {
  const numbers = shownNumbers();
  const kind = view.kind === "auto" ? chooseKind(numbers) : [data.kinds.indexOf(view.kind), 0];
  picture = paint(numbers, kind, view.opened, pageOfScreen());
  if (picture.boxes.length) picture.boxes[0].shape.setAttribute("tabindex", "0");
  resize();
  mark();
  fill(element("map"), picture.svg);
  showControls();
}

function drawLine(edge) {
  const [from, to] = [edge.source, edge.target].map(boxName);
  const number = edge.pairs.length > 1 ? `${edge.pairs.length} connections, ` : "";
  edge.shape = make("path", {d: pathOf(edge), class: edge.service ? "line service" : "line", "marker-end": edge.service ? "url(#dot)" : "url(#arrow)"},
                    make("title", {}, `${number}${from}:${edge.out} to ${to}:${edge.into}`));
  return edge.shape;
}
// How many connections a line is, where it leaves a group or comes to one.
function drawNumber(edge) {
  const {x, y, side} = endOf(edge, edge.source.group ? 0 : 1);
  return make("text", {x: x + (side ? 5 : -12), y: y - 3, "text-anchor": side ? "start" : "end", class: "number"}, `${edge.pairs.length}`);
}
const titleOf = ({group, members}) => [short(group.name), plural(members.length, "component"), ...counts(members)].join(" \u00b7 ");
// A button on the map that opens a group, or closes it: + or −.
function toggle({group, x, y}, isOpen) {
  const words = `${isOpen ? "close" : "open"} ${group.name}`;
  return make("g", {class: "toggle", role: "button", tabindex: "-1", "aria-label": words, click: (event) => { event.stopPropagation(); setOpen(group.key, !isOpen); }},
              make("rect", {x: x + 5, y: y + 5, width: 22, height: 22, rx: 3}),
              make("path", {d: `M${x + 10},${y + 16} h12${isOpen ? "" : ` M${x + 16},${y + 10} v12`}`}));
}
function drawFrame(frame) {
  const {x, y, width, height} = frame;
  const broken = frame.members.some(isBroken) ? " broken" : "";
  frame.shape = make("g", {class: `frame${broken}`, role: "button", tabindex: "-1", "aria-label": titleOf(frame), click: () => choose(frame),
                           dblclick: () => setOpen(frame.group.key, false), keydown: (event) => pressed(event, frame)},
                     make("rect", {x, y, width, height, rx: 7}), make("rect", {x, y, width, height: TITLE - 4, rx: 7, class: "bar"}),
                     make("text", {x: x + 34, y: y + 21, class: "title"}, titleOf(frame)), toggle(frame, true));
  return frame.shape;
}
function drawBox(box) {
  const {x, y, width, height} = box;
  const connected = box.group ? "group" : plural(connectionsOf[box.members[0]].length, "connection");
  const lines = box.heads.map((words, row) => make("text", {x: x + width / 2, y: y + row * ROW + 19, "text-anchor": "middle", class: row ? "" : "name"}, words));
  [box.left, box.right].forEach((ports, side) => ports.forEach((port, row) => {
    const at = {x: x + (side ? width - 7 : 7), y: y + (box.heads.length + row) * ROW + 20, "text-anchor": side ? "end" : "start"};
    lines.push(make("text", at, short(port)));
  }));
  if (box.group) lines.push(toggle(box, false));
  box.shape = make("g", {role: "button", tabindex: "-1", class: classOf(box), click: () => choose(box),
                         dblclick: () => box.group && setOpen(box.group.key, true), keydown: (event) => pressed(event, box),
                         "aria-label": [boxName(box), ...box.heads.slice(1), connected].join(", ")},
                   make("rect", {x, y, width, height, rx: 5}),
                   make("path", {d: `M${x - 5},${y - 5} h${width + 10} v${height + 10} h${-width - 10} z`, class: "halo"}), ...lines);
  return box.shape;
}

// Show which box is selected, which lines are its own, and what is searched for: that and what is around it is as always.
function mark() {
  const wanted = element("search").value;
  const frame = picture.frames.find(({group}) => group.key === view.group);
  const own = frame ? undefined : picture.boxes[picture.at.get(view.selected)];
  const isHit = (box) => box.members.some((number) => matches(number, wanted));
  const clear = new Set(wanted === "" || view.around !== null ? picture.boxes : picture.boxes.filter(isHit));
  const hits = new Set(clear);
  const isSilent = (box) => box.members.every((number) => data.boxes[number].state === "Unknown");
  for (const {shape, source, target} of picture.edges) {
    if (hits.has(source)) clear.add(target);
    if (hits.has(target)) clear.add(source);
    shape.classList.toggle("on", source === own || target === own);
    shape.classList.toggle("unsure", isSilent(source) || isSilent(target)); // what does not answer may have no connection any more
  }
  for (const box of picture.boxes) {
    box.shape.classList.toggle("selected", box === own);
    box.shape.classList.toggle("hit", wanted !== "" && hits.has(box) && view.around === null);
    box.shape.classList.toggle("dim", hits.size > 0 && !clear.has(box));
  }
  picture.frames.forEach((each) => each.shape.classList.toggle("selected", each === frame));
  picture.svg.classList.toggle("some", picture.edges.some(({shape}) => shape.classList.contains("on")));
}

// Show the map larger or smaller, around the same point.
function zoom(scale) {
  const center = centerOfMap();
  view.scale = Math.min(3, Math.max(0.03, scale));
  resize();
  lookAt(...center);
}
function resize() {
  const {svg, room} = picture;
  ["width", "height"].forEach((side) => svg.setAttribute(side, room[side] * view.scale));
  svg.setAttribute("viewBox", `${room.x} ${room.y} ${room.width} ${room.height}`);
}
function centerOfMap() {
  const [map, {room}] = [element("map"), picture];
  return [(map.scrollLeft + map.clientWidth / 2) / view.scale + room.x, (map.scrollTop + map.clientHeight / 2) / view.scale + room.y];
}
function lookAt(x, y) {
  const [map, {room}] = [element("map"), picture];
  map.scrollTo((x - room.x) * view.scale - map.clientWidth / 2, (y - room.y) * view.scale - map.clientHeight / 2);
}

// What a map may be large, so that its text is read easily when all of it is seen.
const pageOfScreen = () => [element("map").clientWidth, element("map").clientHeight].map((side) => Math.max(side, 300) / 0.8);
// Zoom so that everything is seen, but not smaller than `least`.
function fit(least) {
  const map = element("map");
  zoom(Math.max(least, Math.min(1.25, (map.clientWidth - 4) / picture.width, (map.clientHeight - 4) / picture.height)));
}

// ---- what a person does
// Draw with these changes of the view.
function change(more) {
  Object.assign(view, more);
  draw();
  fit(0.65);
  lookAtSelected();
}
// Where the map is larger than the screen: at what is selected, or is broken.
function lookAtSelected() {
  const box = picture.boxes.find((each) => (view.selected === null ? each.members.some(isBroken) : each.members.includes(view.selected)));
  if (box) lookAt(box.x + box.width / 2, box.y + box.height / 2);
}
const nodeOf = (key) => picture.boxes.concat(picture.frames).find(({group}) => group && group.key === key);
// Open a group, or close it: its corner stays where it is on the screen.
function setOpen(key, isOpen) {
  const [map, sides] = [element("map"), ["x", "y"]];
  const where = ({room}) => sides.map((side) => (nodeOf(key)[side] - room[side]) * view.scale);
  const [wide, high] = [map.clientWidth, map.clientHeight]; // read once: it costs a layout
  const onScreen = where(picture).map((side, place) => side - [map.scrollLeft, map.scrollTop][place]);
  view.opened.set(key, isOpen);
  replaceMap();
  const {room} = picture;
  let goal = where(picture).map((side, place) => side - onScreen[place]);
  // a map that has become smaller keeps room for that
  [room.x, room.y] = goal.map((side) => Math.min(0, side / view.scale));
  goal = goal.map((side) => Math.max(0, side));
  room.width = Math.max(picture.width - room.x, (goal[0] + wide + 1) / view.scale);
  room.height = Math.max(picture.height - room.y, (goal[1] + high + 1) / view.scale);
  resize();
  map.scrollTo(...goal);
  choose(nodeOf(key));
}
function choose(node) {
  if (!node.group) return select(node.members[0]);
  Object.assign(view, {selected: node.members[0], group: node.group.key});
  return showGroup(node);
}

// Select a component: it is shown as a box of its own, and its details.
function select(number) {
  Object.assign(view, {selected: number, group: null});
  if (!shownNumbers().includes(number)) Object.assign(view, {around: null, broken: false});
  draw();
  while (picture.boxes[picture.at.get(number)].group) {
    view.opened.set(picture.boxes[picture.at.get(number)].group.key, true);
    draw();
  }
  showComponent(number);
  lookAtSelected();
}

// Keys on a box: Enter shows or opens it, arrows go to the next one.
function pressed(event, box) {
  const step = {ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1}[event.key];
  if (event.key !== "Enter" && event.key !== " " && !step) return;
  event.preventDefault();
  const nodes = picture.boxes.concat(picture.frames);
  const next = nodes[nodes.indexOf(box) + step];
  if (next) next.shape.focus();
  else if (!step && box.group && view.selected === box.members[0]) setOpen(box.group.key, !box.rows);
  else if (!step) choose(box);
}

// ---- details
function showDetails(title, ...children) {
  fill(element("details"), button("\u00d7", clear, {class: "close", "aria-label": "close"}), make("h2", {}, title), ...children);
  element("details").scrollTop = 0;
  element("page").classList.add("chosen");
  element("status").textContent = title;
  mark();
}
function clear() {
  Object.assign(view, {selected: null, group: null});
  const size = `${plural(ALL.length, "component")}, ${plural(data.connections.length, "connection")}`;
  fill(element("details"), make("h2", {}, data.title), ...[data.what, size, counts(ALL).join(", ")].map((line) => make("p", {}, line)),
       ...showFindings(data.findings.filter((found) => found.level !== "ok")),
       ...data.plots.map(([title, svg]) => folded(title, make("img", {alt: title, title: "Click to enlarge it, elsewhere to shrink it", tabindex: 0, src: `data:image/svg+xml;base64,${svg}`}), true)), ...data.sections.map(([title, text]) => folded(title, make("pre", {}, text))));
  element("page").classList.remove("chosen");
  element("page").classList.toggle("report", data.sections.length > 0);
  element("status").textContent = "";
  mark();
}
function showGroup({group, members, rows}) {
  const list = inListOrder(members).map((number) => make("li", {}, componentButton(number)));
  showDetails(group.name, make("p", {}, `${group.kind} ${group.full}`), make("p", {}, [plural(members.length, "component"), ...counts(members)].join(", ")),
              button(rows ? "Close" : "Open", () => setOpen(group.key, !rows)), make("ul", {}, ...list));
}
const nowWords = ({state, why}) => [state, why].filter(Boolean).join(": ");
function showComponent(number) {
  const {name, path, missing, parts, ports} = data.boxes[number];
  const groups = picture.frames.filter((frame) => frame.members.includes(number));
  showDetails(name, ...[path, missing ? "not in the profile" : ""].filter(Boolean).map((line) => make("p", {}, line)),
              make("p", {id: "now"}, nowWords(data.boxes[number])),
              button("Around this", () => change({around: view.selected, hops: 1})),
              ...groups.map(({group}) => button(`Close ${short(group.name)}`, () => setOpen(group.key, false))), ...showFindings(troubles[number]),
              make("h3", {}, plural(connectionsOf[number].length, "connection")),
              ...connectionsOf[number].map((connection) => showConnection(connection, number)), ...showCommands(data.boxes[number]),
              ...parts.map(([heading, rows]) => folded(heading, table(data.rows[rows]), true)),
              ...ports.map(([port, kind, rows]) => folded(`${kind} ${port}`, table(data.rows[rows]))));
}

function showFindings(found) { // a remedy is a command line, or words
  return found.map(({level, path, message, remedy, box}) => make(
    "div", {class: `finding ${level}`}, make("p", {}, `${level}: `, box === null ? path : componentButton(box, path), ` ${message}`),
    /^(rt|unset )/.test(remedy) ? copied(remedy) : make("p", {}, remedy && `try: ${remedy}`)));
}
const folded = (heading, content, isOpen) => make("details", {open: isOpen ? "" : null}, make("summary", {}, heading), content);
const table = (rows) => make("table", {}, ...rows.map(([name, value]) => make("tr", {}, make("th", {scope: "row"}, name),
                                                                            make("td", {}, value))));

// A connection of a component: buttons for the other ends, and what is known of it.
function showConnection(connection, number) {
  const own = connection.ends.findIndex((end) => end[0] === number);
  const others = connection.ends.filter((end, place) => place !== own);
  const rows = [["name", connection.name], ["id", connection.id], ...data.rows[connection.rows]];
  return make("div", {class: "connection"}, `${connection.ends[own][1]} ${own ? "\u2190" : "\u2192"} `,
              ...others.map(([other, port]) => componentButton(other, `${short(data.boxes[other].name)}:${port}`)),
              folded("more", make("div", {}, table(rows), ...connectionCommands(connection).map(copied))));
}

// ---- command lines
const word = (words) => (/^[\w@%+=:,./-]+$/.test(words) ? words : `'${words.replace(/'/g, `'"'"'`)}'`); // for a shell
function connectionCommands({ends}) {
  if (ends.length < 2 || ends.some(([number]) => !data.boxes[number].path)) return [];
  const ports = ends.map(([number, port]) => word(`${data.boxes[number].path}:${port}`)).join(" ");
  return [`rtdis ${ports}`, `rtcon ${ports}`];
}
function showCommands({path, state, ports}) {
  if (!path) return [];
  const changes = {Active: ["rtdeact"], Inactive: ["rtact"], Error: ["rtreset"]}[state] || ["rtact", "rtdeact", "rtreset"];
  const lines = ["rtcat -ll", "rtdoctor", "rtconf", ...changes].map((command) => `${command} ${word(path)}`);
  const out = ports.filter(([, kind]) => kind === "DataOutPort").map(([port]) => `rtprint ${word(`${path}:${port}`)}`);
  return [folded("Commands", make("div", {}, ...lines.concat(out).map(copied)), true)];
}

// A command line, and a button that copies it.
function copied(line) {
  const copy = (event) => {
    const field = document.body.appendChild(make("textarea", {readonly: ""}, line));
    field.select();
    element("status").textContent = document.execCommand("copy") ? "copied" : "select it, and copy it by hand";
    document.body.removeChild(field);
    event.target.focus();
  };
  return make("div", {class: "command"}, make("code", {}, line), button("Copy", copy, {"aria-label": `copy ${line}`}));
}

// ---- controls
function showControls() {
  element("broken").checked = view.broken;
  ["kind", "hops", "way"].forEach((id) => { element(id).value = view[id]; });
  element("kind").options[0].textContent = `automatic (${data.kinds[picture.kind]})`;
  element("around").hidden = view.around === null;
  if (view.around !== null) element("center").textContent = short(data.boxes[view.around].name);
}

function listen() {
  const on = (id, event, then) => element(id).addEventListener(event, then);
  on("search", "input", () => { view.folders.clear(); showList(); mark(); });
  on("list", "keydown", pressedInList);
  on("print", "click", () => window.print());
  on("search", "keydown", (event) => { if (event.key === "Enter" && showList().length) select(showList()[0]); });
  on("broken", "change", (event) => change({broken: event.target.checked, around: null}));
  on("kind", "change", (event) => change({kind: event.target.value, opened: new Map()}));
  ["hops", "way"].forEach((id) => on(id, "change", (event) => change({[id]: event.target.value})));
  on("everything", "click", () => change({around: null}));
  [["closer", 1.25], ["farther", 0.8]].forEach(([id, times]) => on(id, "click", () => zoom(view.scale * times)));
  on("fit", "click", () => fit(0));
  on("names", "click", () => element("page").classList.toggle("listed"));
  on("map", "mousedown", drag);
  on("map", "wheel", (event) => {
    if (!event.ctrlKey) return;
    event.preventDefault();
    zoom(view.scale * Math.exp(-event.deltaY / 200));
  });
  
  window.addEventListener("beforeprint", putSheets);
  window.addEventListener("afterprint", () => fill(element("sheets")));
  document.addEventListener("keydown", (event) => {
    if (event.key === "Escape") clear();
    if (event.key !== "/" || event.target.tagName === "INPUT") return;
    event.preventDefault();
    element("search").focus();
  });
}

// Move the map with the mouse, as its scroll bars do.
function drag(event) {
  const map = element("map");
  if (event.button || event.target.closest(".box") || event.clientX > map.getBoundingClientRect().left + map.clientWidth) return;
  event.preventDefault(); // it would select the text on its way
  const move = (now) => { map.scrollLeft -= now.movementX; map.scrollTop -= now.movementY; };
  document.addEventListener("mousemove", move);
  document.addEventListener("mouseup", () => document.removeEventListener("mousemove", move), {once: true});
}

// Open the group of this name, and those around it, in the group of a number.
function openFrames(number, above, name) {
  return groupsIn(number, above).some((group) => {
    if (group.full !== name && !openFrames(group.number, group.key, name)) return false;
    return view.opened.set(group.key, true);
  });
}
function start() {
  load(JSON.parse(element("system").textContent));
  Object.assign(view, {kind: data.kind || "auto"});
  data.open.forEach((name) => openFrames(data.trees[view.kind === "auto" ? chooseKind(ALL)[0] : data.kinds.indexOf(view.kind)], "", name));
  ["auto", ...data.kinds].forEach((kind) => element("kind").appendChild(make("option", {value: kind}, kind)));
  listen();
  change({});
  showList();
  clear();
}
start();
