"use strict";
// Where boxes, frames and lines are, in pixels. Python has found rows, columns and an order for what each group is made of
// (views/page_groups.py). Here it is stacked, with opened groups as frames, as large as what is in them; lines are led between.
//
// A node is a box, {width, height}, or a frame, {rows, top, side}; each has a home, its y in its row if all groups are closed, and its
// usual size, about, by which rows are broken: what a person opens stays in its row. A row is {columns, channels, lanes}, a column {items: nodes from above, gaps: the lines that pass above each item and below all}.
// There is a channel before each column and after the last one: the lines that turn there beside the column on the left, [1], and
// on the right, [0]. Lines leave and enter nodes on side 0, the left one, or 1; they turn where they do both on the same side.

const [TITLE, PAD, BESIDE, GAP, LANE, MARGIN] = [34, 24, 84, 24, 8, 28];
const [LEAST, EDGE] = [24, 44]; // of a channel: for curves, and in all of the first one; in the rest is room for what is opened
const PITCH = 3; // the least distance of lines that pass between two boxes
const WIDER = 1.4; // times the width of the page, before columns become several rows

// Place all that is in a frame. Edges are {source, target: nodes}; endOf(edge, 0 or 1) is the {x, y, side} of an end; each edge gets
// its hops, from stop to stop. `page` is [width, height]. `isPart`: other boxes are not shown.
function arrange(root, edges, endOf, page, isPart) {
  if (isPart) edges.forEach(noteSource);
  prepare(root, page, isPart);
  place(root);
  putSlots(edges);
  edges.forEach((edge) => { edge.hops = route(edge, endOf); });
  place(root);
  edges.forEach((edge) => edge.hops.forEach(({from, to}) => [from, to].forEach((stop) => stop.edge && Object.assign(stop, endOf(edge, stop.end)))));
  putLines(root);
  putTurns(root);
}
const largest = (values, least = 0) => values.reduce((most, value) => Math.max(most, value), least);
const sum = (values) => values.reduce((total, value) => total + value, 0);

// The nodes that hold both ends of an edge, in the innermost frame that holds them both.
function ways({source, target}) {
  const [near, far] = [source, target].map((node) => {
    const path = [node];
    while (path[path.length - 1].parent) path.push(path[path.length - 1].parent);
    return path;
  });
  const common = near.slice(1).find((frame) => far.includes(frame, 1));
  return [near, far].map((path) => path.slice(0, path.indexOf(common, 1)));
}
function noteSource(edge) {
  const [from, to] = ways(edge).map((path) => path[path.length - 1]);
  if (from === to) return;
  to.sources.push(from);
  [from, to].forEach((node) => { node.isJoined = true; });
}

// ---- rows and columns
function prepare(frame, page, isPart) {
  if (isPart) frame.rows = shortRows([].concat(...frame.rows.map((row) => [].concat(...row))), page);
  const area = sum([].concat(...frame.rows).map((column) => widthOf(column) * heightOf(column)));
  const tall = Math.max(page[1], Math.sqrt(area * page[1] / page[0]));
  frame.rows = frame.rows.map((columns) => [].concat(...columns.map((column) => divided(column, area, tall))));
  const wide = WIDER * Math.max(page[0], Math.sqrt(area * page[0] / page[1]));
  frame.rows = [].concat(...frame.rows.map((columns) => broken(columns, wide))).map((columns) => ({
    columns: columns.map((items) => ({items, gaps: [...items.map(() => []), []]})),
    channels: [...columns.map(() => [[], []]), [[], []]],
    lanes: [],
  }));
  frame.outside = [];
  frame.rows.forEach((row, number) => {
    row.number = number;
    row.isCentred = isPart;
    const top = isPart ? 0 : Math.min(...[].concat(...row.columns.map(({items}) => items.map((item) => item.home))));
    row.columns.forEach(({items}, column) => items.forEach((item) => {
      Object.assign(item, {row, column, home: isPart ? 0 : item.home - top});
      if (item.rows) prepare(item, page, isPart);
    }));
  });
}
const widthOf = (items) => largest(items.map((item) => item.usual[0])) + BESIDE;

const heightOf = (items) => sum(items.map((item) => item.usual[1] + GAP));

// Columns of a column that has most of an area and is taller than this: by turns, so each is beside the lines that pass.
function divided(items, area, tall) {
  const isTall = heightOf(items) > WIDER * tall && widthOf(items) * heightOf(items) > area / 2;
  const count = isTall ? Math.min(items.length, Math.ceil(heightOf(items) / tall)) : 1;
  if (count > 1) items.forEach((item) => { item.home = 0; });
  return Array.from({length: count}, (none, start) => items.filter((item, place) => place % count === start));
}

// Rows of about equal width, none much wider than this.
function broken(columns, wide) {
  const widths = columns.map(widthOf);
  const count = sum(widths) > wide ? Math.ceil(sum(widths) * WIDER / wide) : 1;
  const rows = [[]];
  let x = 0;
  columns.forEach((items, place) => {
    if (x > sum(widths) / count * rows.length - widths[place] / 2 && rows[rows.length - 1].length) rows.push([]);
    rows[rows.length - 1].push(items);
    x += widths[place];
  });
  return rows;
}

// The row of a part: each node is in the first column after those of its sources; then one of nodes that no lines join.
function shortRows(nodes, page) {
  const columns = [];
  const met = new Map();
  const alone = nodes.filter((node) => !node.isJoined);
  nodes.filter((node) => node.isJoined).forEach((node) => {
    const place = largest(node.sources.map((source) => (met.has(source) ? met.get(source) + 1 : 0)));
    met.set(node, place);
    if (!columns[place]) columns[place] = [];
    columns[place].push(node);
  });
  const across = Math.max(1, Math.floor(page[0] / widthOf(alone)));
  const strip = Array.from({length: Math.min(across, alone.length)}, (none, column) => alone.filter((node, place) => place % across === column));
  return [columns, strip].filter((row) => row.length);
}

// ---- stacking
// Tracks are multiples of 4, in every second row halfway between: so rows that face each other have none in common.
const pitch = (lines) => (lines.length > 5 ? LANE / 2 : LANE);
const tracks = (lines) => (lines.length ? lines.length * pitch(lines) + LANE / 2 : 0);
const need = (lines) => (lines.length ? (lines.length + 1) * PITCH : 0);

function place(root) {
  measure(root);
  move(root, 0, 0);
}
// Set the sizes of a frame and of all in it, and where that is from its corner.
function measure(frame) {
  let y = frame.top;
  frame.width = frame.least;
  for (const row of frame.rows) {
    y += row.lanes.length ? tracks(row.lanes) + GAP / 2 : 0;
    [row.y, row.bottom] = [y, y];
    let x = frame.side + row.number % 2 * LANE / 4;
    row.columns.forEach((column, number) => {
      x = putChannel(row.channels[number], x, number ? LEAST : 0, number ? BESIDE : EDGE);
      Object.assign(column, {x, row});
      putColumn(column);
      row.bottom = Math.max(row.bottom, column.bottom + need(column.gaps[column.items.length]));
      x += column.width;
    });
    x = putChannel(row.channels[row.columns.length], x, 0, 0);
    if (row.isCentred) {
      row.columns.forEach(({items, bottom}) => items.forEach((item) => { item.y += Math.floor((row.bottom - bottom) / 2); }));
    }
    frame.width = Math.max(frame.width, x + frame.side);
    y = row.bottom + GAP;
  }
  frame.across = frame.width - frame.side;
  frame.width += tracks(frame.outside);
  frame.height = Math.max(y - GAP, frame.top) + frame.side;
}
function putChannel(channel, x, least, usual) {
  const [left, right] = [tracks(channel[1]), tracks(channel[0])];
  const end = x + Math.max(usual, left + least + right);
  Object.assign(channel, {x, left: x + left, right: end - right, end});
  return end;
}
function putColumn(column) {
  const boxes = column.items.filter((item) => !item.rows);
  const wide = largest(boxes.map((box) => box.least));
  boxes.forEach((box) => { box.width = wide; });
  column.items.filter((item) => item.rows).forEach(measure);
  let free = column.row.y;
  column.items.forEach((item, number) => {
    item.x = column.x;
    item.y = Math.max(column.row.y + item.home, free + Math.max(number ? GAP : 0, need(column.gaps[number])));
    free = item.y + item.height;
  });
  column.width = Math.ceil(largest(column.items.map((item) => item.width)) / LANE) * LANE;
  column.bottom = free;
}
// Move a frame to x and y, and all in it along.
function move(frame, x, y) {
  Object.assign(frame, {x, y, across: frame.across + x});
  for (const row of frame.rows) {
    row.y += y;
    row.bottom += y;
    row.channels.forEach((channel) => ["x", "left", "right", "end"].forEach((side) => { channel[side] += x; }));
    for (const column of row.columns) {
      column.x += x;
      for (const item of column.items) {
        if (item.rows) move(item, item.x + x, item.y + y);
        else Object.assign(item, {x: item.x + x, y: item.y + y});
      }
    }
  }
}

// ---- lines
// The ends on each side of a group are in the order of what they lead to.
function putSlots(edges) {
  const sides = new Map();
  edges.forEach((edge) => [edge.source, edge.target].forEach((box, end) => {
    if (!box.group) return;
    if (!sides.has(box)) sides.set(box, [[], []]);
    const other = end ? edge.source : edge.target;
    sides.get(box)[end].push({edge, end, y: other.y + other.height / 2});
  }));
  sides.forEach((ends) => ends.forEach((lines) => lines.sort((a, b) => a.y - b.y).forEach(({edge, end}, slot) => { edge.slots[end] = slot; })));
}

// The hops of an edge: out of the frames around its source, past the columns between, into the frames around its target.
function route(edge, endOf) {
  const hops = [];
  const [near, far] = ways(edge);
  const [start, end] = [0, 1].map((number) => endOf(edge, number));
  let [stop, channel, detour] = [{edge, end: 0, y: start.y, leaves: start.side}, null, null];
  const step = (to) => {
    const hop = Object.assign({from: stop, to, channel, turns: [], lanes: [], ys: []}, detour);
    if (!detour && stop.leaves === to.enters) turn(hop, channel[to.enters]);
    if (detour) [[channel, start], [detour.into, end]].forEach(([beside, {side}]) => turn(hop, beside[side]));
    hop.lanes.concat(hop.outside || []).forEach((lane) => lane.push(hop));
    hops.push(hop);
    [stop, detour] = [to, null];
  };
  // past columns of a row, from the channel of this number to that one
  const pass = (row, from, to) => {
    const enters = from < to ? 0 : 1;
    for (let number = from; number !== to; number += enters ? -1 : 1) {
      step(newPass(row.columns[number - enters], enters, stop.y, end.y));
      channel = row.channels[number + (enters ? -1 : 1)];
    }
  };
  near.forEach(({row, column}, place) => {
    channel = row.channels[column + start.side];
    if (place + 1 < near.length) pass(row, column + start.side, start.side ? row.columns.length : 0);
  });
  const [first, last] = [near[near.length - 1], far[far.length - 1]];
  if (first.row === last.row) pass(first.row, first.column + start.side, last.column + end.side);
  else detour = newDetour(first.row, last.row, last.row.channels[last.column + end.side]);
  far.slice(0, -1).reverse().forEach(({row, column}) => pass(row, end.side ? row.columns.length : 0, column + end.side));
  step({edge, end: 1, y: end.y, enters: end.side});
  return hops;
}
function turn(hop, list) {
  hop.turns.push({hop, x: 0});
  list.push(hop.turns[hop.turns.length - 1]);
}
// From a row to another one: by the lane above one of them, or by that beside each and outside of all rows between.
function newDetour(row, other, into) {
  const {rows, outside} = other.columns[0].items[0].parent;
  const isDown = row.number < other.number;
  const lanes = [rows[row.number + isDown].lanes, rows[other.number + !isDown].lanes];
  return lanes[0] === lanes[1] ? {into, isDown, lanes: [lanes[0]]} : {into, isDown, lanes, outside: [outside]};
}
// Past a column, where a line from this y to that one leads least astray.
function newPass(column, enters, y, target) {
  const {items, gaps, row} = column;
  let [best, least] = [null, Infinity];
  let above = row.y;
  items.concat(null).forEach((item, number) => {
    const below = item ? item.y : Math.max(row.bottom, above + 2 * LANE);
    const middle = below - above < 2 * LANE ? Math.min(below, above + LANE) : Math.min(Math.max(y, above + LANE), below - LANE);
    const cost = Math.abs(middle - y) + Math.abs(middle - target) / 2 + (number && item ? 0 : GAP);
    if (cost < least) [best, least] = [{column, enters, leaves: 1 - enters, number, y: middle, fromTop: middle - above}, cost];
    above = item ? item.y + item.height : 0;
  });
  gaps[best.number].push(best);
  return best;
}

// Set y of the lines in each gap and lane, and of all within.
function putLines(frame) {
  frame.outside.forEach((hop, number) => { hop.x = frame.across + (number + 1) * pitch(frame.outside); });
  for (const {columns, lanes, y} of frame.rows) {
    lanes.forEach((hop, number) => { hop.ys[hop.lanes.indexOf(lanes)] = y - GAP / 2 - (number + 1) * pitch(lanes); });
    for (const {items, gaps, row} of columns) {
      gaps.forEach((passes, number) => {
        const top = number ? items[number - 1].y + items[number - 1].height : row.y;
        putPasses(passes, top, number < items.length ? items[number].y : row.bottom);
      });
      items.filter((item) => item.rows).forEach(putLines);
    }
  }
}
// Set x of each turn.
function putTurns(frame) {
  for (const channel of [].concat(...frame.rows.map((row) => row.channels))) {
    channel.forEach((turns, isLeft) => turns.sort((a, b) => urgency(a) - urgency(b)).forEach((each, number) => {
      const far = (number + 1) * pitch(turns);
      each.x = isLeft ? channel.x + far : channel.end - far;
    }));
  }
  frame.rows.forEach(({columns}) => columns.forEach(({items}) => items.filter((item) => item.rows).forEach(putTurns)));
}
function putPasses(passes, top, bottom) {
  const step = Math.min(LANE, (bottom - top) / (passes.length + 1));
  passes.sort((a, b) => a.fromTop - b.fromTop);
  passes.forEach((pass, number) => { pass.y = Math.max(top + pass.fromTop, (number ? passes[number - 1].y : top) + step); });
  passes.forEach((pass, number) => { pass.y = Math.min(pass.y, bottom - step * (passes.length - number)); });
}
// Nearest to the column is what turns least; lines to other rows are outside of those.
function urgency({hop}) {
  const [y, other] = [hop.from.y, hop.to.y];
  return hop.lanes.length ? 1e6 + (hop.isDown ? -y : y) : Math.abs(y - other);
}

// The path of an edge.
function pathOf({hops}) {
  const xOf = (stop, side) => (stop.edge ? stop.x : stop.column.x + side * stop.column.width);
  let path = `M${xOf(hops[0].from)},${hops[0].from.y}`;
  for (const {from, to, channel, turns, lanes, ys, x} of hops) {
    if (lanes.length > 1) path += ` H${turns[0].x} V${ys[0]} H${x} V${ys[1]} H${turns[1].x} V${to.y}`;
    else if (lanes.length) path += ` H${turns[0].x} V${ys[0]} H${turns[1].x} V${to.y}`;
    else if (turns.length) path += ` H${turns[0].x} V${to.y}`;
    else if (from.y !== to.y) {
      const [left, right] = from.leaves ? [channel.left, channel.right] : [channel.right, channel.left];
      path += ` H${left} C${(left + right) / 2},${from.y} ${(left + right) / 2},${to.y} ${right},${to.y}`;
    }
    path += ` H${xOf(to, to.enters)}`;
  }
  return path;
}
