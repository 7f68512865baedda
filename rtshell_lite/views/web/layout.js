"use strict";
// Where boxes and lines are, in pixels: the layout of rtshell_lite/views/layout.py, which has the explanations.
//
// A box has width, height, and the names of its ports, left and right; an edge source, target (numbers of boxes),
// out, into (ports) and service. Data flows from left to right.

const [BESIDE, BELOW, PASSING, MARGIN, LANE] = [90, 24, 10, 40, 10];
const [FAR, SWEEPS, RELAX] = [8, 5, 4];

// {items: where each box is, ways: for each edge the items that it passes, or its detour, width, height}
function arrange(boxes, edges, portOf) {
  const items = boxes.map((box, number) => newItem(number, box.width, box.height));
  const columns = [];
  const ways = makeColumns(boxes, edges, items, columns);
  sortColumns(columns);
  putBelow(columns);
  const detours = edges.filter((edge, place) => !ways[place]);
  const sides = putBeside(columns, detours, items, portOf);
  const bottom = Math.max(0, ...items.map((item) => item.y + item.height)) + MARGIN / 2;
  const turns = makeTurns(detours, items, portOf, sides);
  let width = Math.max(0, ...items.map((item) => item.x + item.width));
  detours.forEach((edge, number) => {
    const [x, toX] = turns.get(edge);
    ways[edges.indexOf(edge)] = {x, lane: bottom + number * LANE, toX};
    width = Math.max(width, x, toX);
  });
  return {items, ways, width: width + MARGIN, height: bottom + detours.length * LANE + MARGIN / 2};
}

function newItem(number, width, height) {
  const space = number === null ? PASSING : BELOW;
  return {number, width, height, space, x: 0, y: 0, place: 0, column: 0, before: [], after: []};
}

// Numbers of the boxes, so that data flows downwards where it can.
function inOrder(count, edges) {
  const below = Array.from({length: count}, () => new Set());
  const left = new Array(count).fill(0);
  edges.filter((edge) => edge.source !== edge.target && !edge.service).forEach((edge) => below[edge.source].add(edge.target));
  below.forEach((targets) => targets.forEach((target) => { left[target] += 1; }));
  const waiting = new Set(left.keys());
  const ready = Array.from(left.keys()).filter((number) => !left[number]).reverse();
  const order = [];
  while (waiting.size) {
    const number = ready.length ? ready.pop() : waiting.values().next().value;
    if (!waiting.delete(number)) continue;
    order.push(number);
    for (const target of Array.from(below[number]).sort((a, b) => b - a)) {
      left[target] -= 1;
      if (!left[target]) ready.push(target);
    }
  }
  return order;
}

function makeColumns(boxes, edges, items, columns) {
  const order = inOrder(boxes.length, edges);
  const rank = [];
  order.forEach((number, place) => { rank[number] = place; });
  const sources = boxes.map(() => []);
  const used = new Set();
  for (const edge of edges) {
    used.add(edge.source).add(edge.target);
    if (rank[edge.source] < rank[edge.target]) sources[edge.target].push(edge.source);
  }
  for (const number of order) {
    for (const source of sources[number]) {
      items[number].column = Math.max(items[number].column, items[source].column + 1);
    }
    while (columns.length <= items[number].column) columns.push([]);
  }
  for (const number of order.filter((each) => used.has(each))) columns[items[number].column].push(items[number]);
  const alone = order.filter((each) => !used.has(each)); // one after the other into all columns
  while (columns.length < Math.ceil(Math.sqrt(alone.length / 3))) columns.push([]);
  alone.forEach((each, place) => {
    items[each].column = place % columns.length;
    columns[place % columns.length].push(items[each]);
  });
  return edges.map((edge) => wayOf(edge, boxes, items, rank, columns));
}

function wayOf(edge, boxes, items, rank, columns) {
  const first = items[edge.source].column;
  const last = items[edge.target].column;
  if (rank[edge.source] >= rank[edge.target] || last - first > FAR) return null;
  const way = [];
  for (let column = first + 1; column < last; column += 1) {
    const passing = newItem(null, 0, 0);
    passing.column = column;
    columns[column].push(passing);
    way.push(passing);
  }
  const stops = [items[edge.source], ...way, items[edge.target]];
  const at = [rowOf(boxes[edge.source].right, edge.out), ...way.map(() => 0.5), rowOf(boxes[edge.target].left, edge.into)];
  for (let place = 0; place + 1 < stops.length; place += 1) {
    stops[place].after.push([stops[place + 1], at[place + 1], at[place]]);
    stops[place + 1].before.push([stops[place], at[place], at[place + 1]]);
  }
  return way;
}

// Where on a box, from 0 to 1, one of its ports is.
const rowOf = (ports, port) => (ports.includes(port) ? (ports.indexOf(port) + 1) / (ports.length + 1) : 0.5);

// Each box near its neighbours in the columns beside it: lines that would cross then mostly do not.
function sortColumns(columns) {
  columns.forEach(numberItems);
  for (let sweep = 0; sweep < SWEEPS; sweep += 1) {
    columns.slice(1).forEach((items) => sortItems(items, "before"));
    columns.slice(0, -1).reverse().forEach((items) => sortItems(items, "after"));
  }
}

const numberItems = (items) => items.forEach((item, place) => { item.place = place; });

function sortItems(items, side) {
  for (const item of items) item.key = mean(item[side].map(([other, at]) => other.place + at), item.place);
  numberItems(items.sort((a, b) => a.key - b.key || a.place - b.place));
}

const mean = (values, otherwise) => (values.length ? values.reduce((sum, value) => sum + value, 0) / values.length : otherwise);

function putBelow(columns) {
  for (const items of columns) stack(items, items.map(() => 0));
  for (let round = 0; round < RELAX; round += 1) {
    columns.slice(1).forEach((items) => stack(items, items.map((item) => wantedY(item, item.before))));
    columns.slice(0, -1).reverse().forEach((items) => stack(items, items.map((item) => wantedY(item, item.after))));
  }
  const top = Math.min(...columns.map((items) => items.reduce((least, item) => Math.min(least, item.y), Infinity)));
  for (const items of columns) items.forEach((item) => { item.y += MARGIN - top; });
}

// The y at which the lines of an item are straight, on the average.
const wantedY = (item, lines) => mean(lines.map(([other, at, here]) => other.y + at * other.height - here * item.height), item.y);

function stack(items, wanted) {
  let free = -Infinity;
  items.forEach((item, place) => {
    item.y = Math.max(wanted[place], free);
    free = item.y + item.height + item.space;
  });
  const shift = mean(items.map((item, place) => wanted[place] - item.y), 0);
  for (const item of items) item.y = Math.round(item.y + shift);
}

const bothEnds = (edge, items, portOf) => [[edge.source, edge.out], [edge.target, edge.into]].map(
  ([number, port]) => ({item: items[number], side: portOf(items[number], port).side}));

function putBeside(columns, detours, items, portOf) {
  const turning = new Array(columns.length + 1).fill(0); // lines that turn before the first column, between columns, and after the last
  for (const edge of detours) {
    for (const {item, side} of bothEnds(edge, items, portOf)) turning[side > 0 ? item.column + 1 : item.column] += 1;
  }
  let x = MARGIN + turning[0] * LANE;
  return columns.map((items, place) => {
    const width = items.reduce((most, item) => Math.max(most, item.width), 0);
    for (const item of items) {
      item.x = x;
      if (item.number === null) item.width = width;
    }
    const sides = [x, x + width];
    x += width + BESIDE + turning[place + 1] * LANE;
    return sides;
  });
}

// Where a line that passes below turns beside its source and its target: each on a track of its own.
function makeTurns(detours, items, portOf, sides) {
  const turned = new Map();
  const turns = new Map();
  for (const edge of detours) {
    turns.set(edge, bothEnds(edge, items, portOf).map(({item, side}) => {
      const key = item.column * side + side / 2;
      turned.set(key, (turned.get(key) || 0) + 1);
      return sides[item.column][side > 0 ? 1 : 0] + side * turned.get(key) * LANE;
    }));
  }
  return turns;
}
