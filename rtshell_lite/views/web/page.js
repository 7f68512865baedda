// The page of a system: list, map, details. What the system says goes into text nodes only. views/page.py has the fields of `data`.
const DEFAULTS = {path: null, state: null, missing: false, composite: null, parts: [], ports: [], why: ""};
let [data, ALL, troubles, connectionsOf, texts] = []; // see load()
const SVG = "http://www.w3.org/2000/svg";
const SHAPES = new Set(["svg", "g", "rect", "text", "path", "title"]);
const SYMBOLS = {Active: "\u25cf", Inactive: "\u25cb", Error: "\u2716", Created: "\u25cc", Unknown: "?"};
const [CELL, ROW] = [8.5, 20]; // pixels: a character, a line of text
// characters of a name on the map, components in the list, sources that a group names (of more, the number)
const [LONGEST, LISTED, MOST_SOURCES] = [44, 300, 12];
const view = {around: null, hops: 1, way: "both", broken: false, kind: "auto", scale: 1, selected: null, opened: new Set()};
let picture = null; // what fold() made, with the elements on the map

function load(found) {
  data = Object.assign(found, {boxes: found.boxes.map((box) => Object.assign({}, DEFAULTS, box)),
                               rows: found.rows.map((rows) => rows.map((pair) => found.pairs[pair]))});
  ALL = data.boxes.map((box, number) => number);
  [troubles, connectionsOf, texts] = [ALL.map(() => []), ALL.map(() => []), []]; // findings of each component; what is searched
  data.connections.forEach((connection) => new Set(connection.ends.map((end) => end[0])).forEach(
    (end) => connectionsOf[end].push(connection)));
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

// {boxes, at: the place of each component's box, kind, shown: opened groups}: groups of a kind are one box each, but for
// opened ones. An opened group of many components shows its groups of a finer kind.
function fold(numbers, kind, opened) {
  const found = {boxes: [], at: new Map(), kind, shown: new Map()};
  const add = (members, group) => {
    members.forEach((member) => found.at.set(member, found.boxes.length));
    const layers = data.places[data.layers[kind][members[0]]];
    found.boxes.push({members, group, left: [], right: [], labels: new Map(), layers: group ? layers.slice(0, group.depth) : layers});
  };
  const put = (inside, level, above, depth) => groupsOf(inside, level).forEach((members, name) => {
    const key = `${above}/${level}:${name}`;
    if (members.length < 2) add(members, null);
    else if (!opened.has(key)) add(members, {key, name, depth});
    else {
      found.shown.set(key, {name, members});
      put(members, finerKind(members, level), key, depth + 1);
    }
  });
  put(numbers, kind, "", 1);
  return found;
}
function groupsOf(numbers, level) {
  const groups = new Map();
  for (const number of numbers) {
    const group = level ? data.boxes[number].groups[level - 1] : null;
    const name = group === null ? `\n${number}` : data.names[group];
    if (!groups.has(name)) groups.set(name, []);
    groups.get(name).push(number);
  }
  return groups;
}
function finerKind(members, level) {
  const isUseful = (kind) => kind < level && groupsOf(members, kind).size > 1 && groupsOf(members, kind).size < members.length;
  return (members.length > data.most && [3, 2, 1].find(isUseful)) || 0;
}

// The finest kind of groups that leaves no more boxes than a person can overlook.
function chooseKind(numbers) {
  const kind = data.kinds.findIndex((name, place) => fold(numbers, place, new Set()).boxes.length <= data.most);
  return kind < 0 ? data.kinds.length - 1 : kind;
}

// The lines between boxes, for which they get ports; parallel ones to or from a group are one.
function connect({boxes, at}) {
  const lines = new Map();
  const arriving = boxes.map(() => 0);
  for (const {ends, service} of data.connections) {
    const [source, out] = [at.get(ends[0][0]), ends[0][1]];
    for (const [number, port] of ends.slice(1)) {
      const target = at.get(number);
      if (source === undefined || target === undefined) continue;
      const folded = boxes[source].group || boxes[target].group;
      if (folded && source === target) continue;
      const key = JSON.stringify(folded ? [source, target, service] : [source, out, target, port, service]);
      if (!lines.has(key)) arriving[target] += 1;
      if (!lines.has(key)) lines.set(key, {source, target, service, pairs: []});
      lines.get(key).pairs.push([out, port]);
    }
  }
  lines.forEach((edge) => namePorts(edge, boxes[edge.source], boxes[edge.target], arriving[edge.target]));
  return Array.from(lines.values());
}
function namePorts(edge, source, target, arriving) {
  const word = edge.service ? "services" : "data";
  const onlyOne = (ports) => (new Set(ports).size === 1 ? ports[0] : `${new Set(ports).size} ports`);
  [edge.out, edge.into] = [0, 1].map((end) => onlyOne(edge.pairs.map((pair) => pair[end])));
  if (source.group) edge.out = word;
  const isJoined = target.group && arriving > MOST_SOURCES;
  if (isJoined) edge.into = word;
  else if (target.group) edge.into = `from ${boxName(source)}${edge.service ? " (services)" : ""}`;
  const count = (target.labels.get(edge.into) || 0) + edge.pairs.length;
  if (edge.pairs.length > 1 || isJoined) target.labels.set(edge.into, count);
  for (const [box, port, side] of [[source, edge.out, "right"], [target, edge.into, "left"]]) {
    if (!box.left.includes(port) && !box.right.includes(port)) box[side].push(port);
  }
}

// ---- words on the map
const boxName = (box) => (box.group ? box.group.name : data.boxes[box.members[0]].name);
const short = (words) => (words.length > LONGEST ? `${words.slice(0, LONGEST - 1)}\u2026` : words);
const portWords = (box, port) => short(port) + (box.labels.has(port) ? ` \u00d7${box.labels.get(port)}` : "");
const cells = (words) => Array.from(words).reduce((sum, letter) => sum + (letter.codePointAt(0) < 0x1100 ? 1 : 2), 0);
const stateWords = (state) => `${SYMBOLS[state] || "?"} ${state}`;

function counts(numbers) {
  const states = new Map();
  numbers.map((number) => data.boxes[number].state).filter(Boolean).forEach((state) => states.set(state, (states.get(state) || 0) + 1));
  const order = Array.from(states.keys()).sort((a, b) => (b === "Error") - (a === "Error") || states.get(b) - states.get(a));
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
                 composite === null ? "" : `in ${short(data.boxes[composite].name)}`].filter(Boolean).join("  ");
  return [short(boxName(box)), words].filter(Boolean);
}
function classOf(box) {
  const states = new Set(box.members.map((number) => data.boxes[number].state));
  const state = states.size === 1 ? Array.from(states)[0] : null;
  return `box ${SYMBOLS[state] ? state : "none"}${box.group ? " group" : ""}${box.members.some(isBroken) ? " broken" : ""}`;
}

// ---- the map
// Draw it for a page of this width and height, in pixels.
function draw(page = pageOfScreen()) {
  const numbers = shownNumbers();
  const {boxes} = picture = fold(numbers, view.kind === "auto" ? chooseKind(numbers) : data.kinds.indexOf(view.kind), view.opened);
  const edges = connect(picture);
  for (const box of boxes) {
    box.heads = heads(box);
    const [left, right] = [box.left, box.right].map((side) => Math.max(0, ...side.map((port) => cells(portWords(box, port)))));
    box.width = Math.ceil((Math.max(left + right + 3, ...box.heads.map(cells)) + 2) * CELL);
    box.height = (box.heads.length + Math.max(box.left.length, box.right.length)) * ROW + ROW / 2;
  }
  const portOf = (item, port) => {
    const box = boxes[item.number];
    const side = box.right.includes(port) ? 1 : -1;
    const row = box.heads.length + (side > 0 ? box.right : box.left).indexOf(port);
    return {x: item.x + (side > 0 ? item.width : 0), y: item.y + row * ROW + 15, side};
  };
  const {items, ways, width, height} = arrange(boxes, edges, portOf, page, numbers.length < ALL.length);
  const svg = make("svg", {width: width * view.scale, height: height * view.scale, viewBox: `0 0 ${width} ${height}`,
                           role: "group", "aria-label": "map of the system"});
  Object.assign(picture, {edges, items, svg, width, height});
  edges.forEach((edge, place) => {
    const [from, to] = [edge.source, edge.target].map((number) => boxName(boxes[number]));
    const path = pathOf(portOf(items[edge.source], edge.out), portOf(items[edge.target], edge.into), ways[place]);
    edge.shape = make("path", {d: path, class: edge.service ? "line service" : "line",
                               "marker-end": edge.service ? "url(#dot)" : "url(#arrow)"}, make("title", {}, `${from}:${edge.out} to ${to}:${edge.into}`));
    svg.appendChild(edge.shape);
  });
  boxes.forEach((box, place) => svg.appendChild(drawBox(box, items[place], portOf)));
  fill(element("map"), svg);
  if (boxes.length) boxes[0].shape.setAttribute("tabindex", "0");
  zoom(view.scale);
  mark();
  showControls();
}

function drawBox(box, item, portOf) {
  const connected = box.group ? "group" : plural(connectionsOf[box.members[0]].length, "connection");
  const lines = box.heads.map((words, row) => make("text", {x: item.x + item.width / 2, y: item.y + row * ROW + 19, "text-anchor": "middle",
                                                            class: row ? "" : "name"}, words));
  for (const port of box.left.concat(box.right)) {
    const {x, y, side} = portOf(item, port);
    lines.push(make("text", {x: x - 7 * side, y: y + 5, "text-anchor": side > 0 ? "end" : "start"}, portWords(box, port)));
  }
  box.shape = make("g", {role: "button", tabindex: "-1", class: classOf(box), click: () => choose(box),
                         dblclick: () => box.group && open(box.group.key), keydown: (event) => pressed(event, box),
                         "aria-label": [boxName(box), ...box.heads.slice(1), connected].join(", ")},
                   make("rect", {x: item.x, y: item.y, width: item.width, height: item.height, rx: 5}),
                   make("path", {d: `M${item.x - 6},${item.y - 6} h${item.width + 12} v${item.height + 12} h${-item.width - 12} z`, class: "halo"}), ...lines);
  return box.shape;
}

function pathOf(start, end, way) {
  let [begin, from] = [`M${start.x},${start.y}`, start];
  if (typeof way[0] === "number") return [...way, end.y, end.x].reduce((path, corner, place) => `${path} ${"HV"[place % 2]}${corner}`, begin);
  const curve = (to) => ` C${(from.x + to.x) / 2},${from.y} ${(from.x + to.x) / 2},${to.y} ${to.x},${to.y}`;
  const path = way.map(({x, y, width}) => {
    const line = `${curve({x, y})} H${x + width}`;
    from = {x: x + width, y};
    return line;
  });
  return begin + path.join("") + curve(end);
}

// Show which box is selected, which lines are its own, and what is searched for.
function mark() {
  const wanted = element("search").value;
  const place = picture.at.get(view.selected);
  picture.boxes.forEach((box, each) => {
    box.shape.classList.toggle("selected", each === place);
    box.shape.classList.toggle("dim", wanted !== "" && !box.members.some((number) => matches(number, wanted)));
  });
  const isSilent = (each) => picture.boxes[each].members.every((number) => data.boxes[number].state === "Unknown");
  for (const {shape, source, target} of picture.edges) {
    shape.classList.toggle("on", source === place || target === place);
    shape.classList.toggle("unsure", isSilent(source) || isSilent(target)); // what does not answer may have no connection any more
  }
  picture.svg.classList.toggle("some", place !== undefined);
}

// Show the map larger or smaller, around the same point.
function zoom(scale) {
  const map = element("map");
  const x = (map.scrollLeft + map.clientWidth / 2) / view.scale;
  const y = (map.scrollTop + map.clientHeight / 2) / view.scale;
  view.scale = Math.min(3, Math.max(0.03, scale));
  ["width", "height"].forEach((side) => picture.svg.setAttribute(side, picture[side] * view.scale));
  lookAt(x, y);
}
function lookAt(x, y) {
  const map = element("map");
  map.scrollTo(x * view.scale - map.clientWidth / 2, y * view.scale - map.clientHeight / 2);
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
  const isWanted = (box) => (view.selected === null ? box.members.some(isBroken) : box.members.includes(view.selected));
  const item = picture.items[picture.boxes.findIndex(isWanted)];
  if (item) lookAt(item.x + item.width / 2, item.y + item.height / 2);
}
const open = (key) => change({opened: new Set(view.opened).add(key)});
function shut(key) {
  change({opened: new Set(Array.from(view.opened).filter((other) => other !== key))});
  choose(picture.boxes[picture.at.get(view.selected)]);
}
function choose(box) {
  if (!box.group) return select(box.members[0]);
  view.selected = box.members[0];
  return showGroup(box);
}

// Select a component: it is shown as a box of its own, and its details.
function select(number) {
  view.selected = number;
  if (!shownNumbers().includes(number)) Object.assign(view, {around: null, broken: false});
  draw();
  while (picture.boxes[picture.at.get(number)].group) {
    view.opened.add(picture.boxes[picture.at.get(number)].group.key);
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
  const next = picture.boxes[picture.boxes.indexOf(box) + step];
  if (next) next.shape.focus();
  else if (!step && box.group && view.selected === box.members[0]) open(box.group.key);
  else if (!step) choose(box);
}

// ---- the list
function matches(number, wanted) {
  if (texts[number] === undefined) {
    const {name, path, state, groups, parts, ports} = data.boxes[number];
    const more = [groups.map((group) => data.names[group]), ports.map((port) => port[0]), parts.map((part) => data.rows[part[1]])];
    texts[number] = JSON.stringify([name, path, state, more]).toLowerCase();
  }
  return wanted.toLowerCase().split(/\s+/).every((word) => texts[number].includes(JSON.stringify(word).slice(1, -1)));
}
function showList() {
  const wanted = element("search").value;
  const found = inListOrder(ALL.filter((number) => matches(number, wanted)));
  fill(element("list"), ...found.slice(0, LISTED).map((number) => make("li", {}, componentButton(number))));
  const more = found.length > LISTED ? `, the first ${LISTED} of them listed` : "";
  element("found").textContent = `${found.length} of ${plural(ALL.length, "component")}${more}`;
  return found;
}
// A button that selects a component.
function componentButton(number, words) {
  const {name, state, path} = data.boxes[number];
  const more = {class: isBroken(number) ? "link broken" : "link", title: path || ""};
  const listed = `${SYMBOLS[state] || ""} ${name}${troubles[number].length ? " \u26a0" : ""}`;
  return Object.assign(button(words || listed, (event) => select(event.currentTarget.number), more), {number});
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
  view.selected = null;
  const size = `${plural(ALL.length, "component")}, ${plural(data.connections.length, "connection")}`;
  fill(element("details"), make("h2", {}, data.title), ...[data.what, size, counts(ALL).join(", ")].map((line) => make("p", {}, line)),
       ...data.plots.map(([title, svg]) => folded(title, make("img", {alt: title, title: "Click to enlarge it, elsewhere to shrink it", tabindex: 0, src: `data:image/svg+xml;base64,${svg}`}), true)),
       ...showFindings(data.findings.filter((found) => found.level !== "ok")), ...data.sections.map(([title, text]) => folded(title, make("pre", {}, text))));
  element("page").classList.remove("chosen");
  element("status").textContent = "";
  mark();
}
function showGroup(box) {
  const members = inListOrder(box.members).slice(0, LISTED).map((number) => make("li", {}, componentButton(number)));
  showDetails(box.group.name, make("p", {}, [plural(box.members.length, "component"), ...counts(box.members)].join(", ")),
              button("Open", () => open(box.group.key)), make("ul", {}, ...members));
}
const nowWords = ({state, why}) => [state, why].filter(Boolean).join(": ");
function showComponent(number) {
  const {name, path, missing, parts, ports} = data.boxes[number];
  const groups = Array.from(picture.shown).filter(([, group]) => group.members.includes(number));
  showDetails(name, ...[path, missing ? "not in the profile" : ""].filter(Boolean).map((line) => make("p", {}, line)),
              make("p", {id: "now"}, nowWords(data.boxes[number])),
              button("Around this", () => change({around: view.selected, hops: 1})),
              ...groups.map(([key, group]) => button(`Fold ${short(group.name)}`, () => shut(key))), ...showFindings(troubles[number]),
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
  on("search", "input", () => { showList(); mark(); });
  on("search", "keydown", (event) => { if (event.key === "Enter" && showList().length) select(showList()[0]); });
  on("broken", "change", (event) => change({broken: event.target.checked, around: null}));
  on("kind", "change", (event) => change({kind: event.target.value, opened: new Set()}));
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
  window.addEventListener("beforeprint", () => draw([1050, 620])); // a sheet of paper
  window.addEventListener("afterprint", () => draw());
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

function start() {
  load(JSON.parse(element("system").textContent));
  Object.assign(view, {kind: data.kind || "auto", opened: new Set(data.open.map((name) => `/${data.kinds.indexOf(data.kind)}:${name}`))});
  ["auto", ...data.kinds].forEach((kind) => element("kind").appendChild(make("option", {value: kind}, kind)));
  listen();
  change({});
  showList();
  clear();
}
start();
