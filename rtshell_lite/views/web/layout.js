"use strict";
// Where boxes and lines are, in pixels: layers by layers, as rtshell_lite/views/layered/ puts them, in rows.
//
// A box has width, height, its layers, and the names of its ports, left and right; an edge source, target (numbers of
// boxes), out, into (ports) and service. Data flows from left to right.

const [BESIDE, BELOW, PASSING, MARGIN, LANE] = [70, 24, 6, 40, 10];
const [FAR, SWEEPS, RELAX] = [8, 5, 4];

// {items: where each box is, ways: for each edge the items that it passes, or the corners of its detour, width, height}.
// `page` is [width, height]; a larger picture has the same proportions. `isPart`: other boxes are not shown.
function arrange(boxes, edges, portOf, page, isPart) {
  const items = boxes.map((box, number) => newItem(number, box.width, box.height));
  const area = sum(items.map((item) => (item.width + BESIDE) * (item.height + BELOW)));
  const [wide, tall] = page.map((side) => side * Math.max(1, Math.sqrt(area / page[0] / page[1])));
  const used = new Set([].concat(...edges.map((edge) => [items[edge.source], items[edge.target]])));
  const columns = makeColumns(items, items.filter((item) => used.has(item)), boxes, edges, tall, isPart);
  columns.forEach((column, place) => column.forEach((item) => { item.column = place; }));
  const lines = edges.filter((edge) => items[edge.target].column !== items[edge.source].column + 1).length;
  const rows = makeRows(columns, lines * LANE, wide, tall / wide);
  const strip = makeStrip(items.filter((item) => !used.has(item)), boxes, wide);
  strip.forEach((column, place) => column.forEach((item) => Object.assign(item, {column: columns.length + place, row: rows.length})));
  if (strip.length) {
    rows.push(strip);
    columns.push(...strip);
  }
  const ways = edges.map((edge) => wayOf(edge, boxes, items, columns));
  sortColumns(columns);
  rows.forEach(putBelow);
  const turns = columns.map(() => ({"-1": [], "1": []}));
  const detours = edges.map((edge, place) => ways[place] || newDetour(edge, items, portOf, turns)).filter((way) => way.corners);
  const right = putOutside(detours, putBeside(rows, turns));
  const height = putRows(rows, detours);
  return {items, ways: ways.map((way) => way || detours.shift().corners), width: right + MARGIN, height};
}
function newItem(number, width, height) {
  return {number, width, height, space: number === null ? PASSING : BELOW, x: 0, y: 0, place: 0, column: 0, row: 0, before: [], after: []};
}
const sum = (values) => values.reduce((total, value) => total + value, 0);
const mean = (values, otherwise) => (values.length ? sum(values) / values.length : otherwise);

// Lists of items: a column for each layer that Python found (views/page_layers.py), or several where one is too tall. Where
// only a part is shown, layers are only the order: each item is in the first column after those of its sources.
function makeColumns(all, items, boxes, edges, tallest, isPart) {
  const layersOf = (item) => boxes[item.number].layers;
  const depth = Math.max(0, ...boxes.map((box) => box.layers.length));
  const compare = (a, b) => {
    const place = Array.from({length: depth}).findIndex((none, each) => (layersOf(a)[each] || 0) !== (layersOf(b)[each] || 0));
    return place < 0 ? 0 : (layersOf(a)[place] || 0) - (layersOf(b)[place] || 0);
  };
  const sources = new Map(items.map((item) => [item, []]));
  edges.forEach(({source, target}) => sources.get(all[target]).push(all[source]));
  const [columns, heights] = [[], []];
  let last = null;
  for (const item of items.slice().sort((a, b) => compare(a, b) || a.number - b.number)) {
    let place = last && compare(last, item) ? columns.length : Math.max(0, columns.length - 1);
    if (isPart) place = Math.max(0, ...sources.get(item).filter((source) => compare(source, item) < 0).map((source) => source.column + 1));
    while (isPart && heights[place] + item.height > tallest) place += 1;
    if (place === columns.length) [columns[place], heights[place]] = [[], 0];
    columns[place].push(item);
    heights[place] += item.height + item.space;
    last = Object.assign(item, {column: place});
  }
  return [].concat(...columns.map((column) => {
    const height = sum(column.map((item) => item.height + item.space));
    const size = Math.ceil(column.length / (height > 1.6 * tallest ? Math.ceil(height / tallest) : 1));
    return Array.from({length: Math.ceil(column.length / size)}, (none, part) => column.slice(part * size, (part + 1) * size));
  }));
}
// Columns of what is not connected, by name from left to right and then below.
function makeStrip(items, boxes, wide) {
  const sorted = items.slice().sort((a, b) => byName(boxes[a.number].heads[0], boxes[b.number].heads[0]) || a.number - b.number);
  const across = Math.max(1, Math.floor(wide / (Math.max(0, ...items.map((item) => item.width)) + BESIDE)));
  return Array.from({length: Math.min(across, items.length)}, (none, column) => sorted.filter((item, place) => place % across === column));
}

// Lists of columns that follow one another: as many as give this width, or the proportions of the page.
function makeRows(columns, lanes, width, proportion) {
  const sizes = columns.map((items) => [Math.max(...items.map((item) => item.width)) + BESIDE, sum(items.map((item) => item.height + item.space))]);
  const total = sum(sizes.map((size) => size[0]));
  let [best, starts] = [Infinity, []];
  for (let count = 1; count <= columns.length; count += 1 + Math.floor(count / 10)) {
    const found = breaks(sizes, total / count + total / columns.length / 2); // one row may be half a column wider than the others
    const wider = Math.log((total + 2 * lanes) / count / Math.max(width, (found.height + lanes) / proportion));
    if (Math.max(2 * wider, -wider) < best) [best, starts] = [Math.max(2 * wider, -wider), found.starts];
  }
  const rows = starts.map((start, place) => columns.slice(start, starts[place + 1]));
  rows.forEach((row, place) => [].concat(...row).forEach((item) => { item.row = place; }));
  return rows;
}
// The first column of each row, if rows are that wide, and the height of them all.
function breaks(sizes, width) {
  let [starts, height, x, tall] = [[], 0, Infinity, 0];
  sizes.forEach(([wide, high], place) => {
    if (x + wide > width) {
      starts.push(place);
      height += tall + MARGIN;
      [x, tall] = [0, 0];
    }
    [x, tall] = [x + wide, Math.max(tall, high)];
  });
  return {starts, height: height + tall};
}

function wayOf(edge, boxes, items, columns) {
  const [source, target] = [items[edge.source], items[edge.target]];
  if (source.column >= target.column || source.row !== target.row || target.column - source.column > FAR) return null;
  const [rights, lefts] = [boxes[edge.source].right, boxes[edge.target].left];
  if (!rights.includes(edge.out) || !lefts.includes(edge.into)) return null;
  const way = [];
  for (let column = source.column + 1; column < target.column; column += 1) {
    way.push(newItem(null, 0, 0));
    columns[column].push(way[way.length - 1]);
  }
  const stops = [source, ...way, target];
  const height = (ports, port) => (ports.indexOf(port) + 1) / (ports.length + 1); // where on a box, from 0 to 1
  const at = [height(rights, edge.out), ...way.map(() => 0.5), height(lefts, edge.into)];
  for (let place = 0; place + 1 < stops.length; place += 1) {
    stops[place].after.push([stops[place + 1], at[place + 1], at[place]]);
    stops[place + 1].before.push([stops[place], at[place], at[place + 1]]);
  }
  return way;
}

// Each box near its neighbours in the columns beside it: lines that would cross then mostly do not.
function sortColumns(columns) {
  const number = (items) => items.forEach((item, place) => { item.place = place; });
  const sort = (items, side) => {
    for (const item of items) item.key = mean(item[side].map(([other, at]) => other.place + at), item.place);
    number(items.sort((a, b) => a.key - b.key || a.place - b.place));
  };
  columns.forEach(number);
  for (let sweep = 0; sweep < SWEEPS; sweep += 1) {
    columns.slice(1).forEach((items) => sort(items, "before"));
    columns.slice(0, -1).reverse().forEach((items) => sort(items, "after"));
  }
}

function putBelow(columns) {
  for (const items of columns) stack(items, items.map(() => 0));
  for (let round = 0; round < RELAX; round += 1) {
    columns.slice(1).forEach((items) => stack(items, items.map((item) => wantedY(item, item.before))));
    columns.slice(0, -1).reverse().forEach((items) => stack(items, items.map((item) => wantedY(item, item.after))));
  }
  const items = [].concat(...columns);
  const top = Math.min(...items.map((item) => item.y));
  items.forEach((item) => { item.y -= top; });
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

// A line that passes between rows, or below the last one: see the class of that name in layered/lines.py. It turns up or down
// beside columns: `turns` has for each column, and each side of it, the lines that do so.
function newDetour(edge, items, portOf, turns) {
  const [from, to] = [items[edge.source].row, items[edge.target].row];
  const lanes = [to < from ? from - 1 : from, from < to ? to - 1 : to];
  if (lanes[0] === lanes[1]) lanes.pop();
  const corners = new Array(1 + 2 * lanes.length).fill(0);
  [[items[edge.source], edge.out, 0], [items[edge.target], edge.into, corners.length - 1]].forEach(([item, port, corner]) => {
    const {y, side} = portOf(item, port);
    const isUp = lanes[corner && lanes.length - 1] < item.row;
    turns[item.column][side].push({order: isUp ? 1e9 + y : -y, put: (x) => { corners[corner] = x; }});
  });
  return {lanes, corners};
}

// Set x of all items, and where lines turn beside them, those nearest that cross fewest; returns where the widest row ends.
function putBeside(rows, turns) {
  let column = 0;
  return Math.max(0, ...rows.map((row, number) => row.reduce((left, items) => {
    const [before, after] = [-1, 1].map((side) => turns[column][side].sort((a, b) => a.order - b.order));
    const width = Math.ceil(Math.max(...items.map((item) => item.width)) / LANE) * LANE;
    const x = left + before.length * LANE;
    before.forEach(({put}, track) => put(x - (track + 1) * LANE));
    after.forEach(({put}, track) => put(x + width + (track + 1) * LANE));
    items.forEach((item) => Object.assign(item, {x, width}));
    column += 1;
    return x + width + after.length * LANE + BESIDE;
  }, MARGIN + number % 2 * LANE / 2) - BESIDE)); // rows that face each other have no track in common
}

// Set where lines with two lanes change from one to the other, right of x; returns where that ends.
function putOutside(detours, x) {
  const far = detours.filter(({lanes}) => lanes.length > 1).sort((a, b) => Math.abs(a.lanes[0] - a.lanes[1]) - Math.abs(b.lanes[0] - b.lanes[1]));
  far.forEach(({corners}, place) => { corners[2] = x + (place + 1) * LANE; });
  return x + far.length * LANE;
}

// Set y of all items, rows below each other, and of lanes between them, the shortest first; returns the height of it all.
function putRows(rows, detours) {
  const found = rows.map(() => []);
  for (const {lanes, corners} of detours) {
    lanes.forEach((row, place) => found[row].push({length: Math.abs(corners[2 * place] - corners[2 * place + 2]),
                                                   put: (y) => { corners[2 * place + 1] = y; }}));
  }
  return rows.reduce((top, row, place) => {
    const items = [].concat(...row);
    items.forEach((item) => { item.y += top; });
    const bottom = Math.max(...items.map((item) => item.y + item.height)) + MARGIN / 2;
    found[place].sort((a, b) => a.length - b.length).forEach(({put}, lane) => put(bottom + lane * LANE));
    return bottom + found[place].length * LANE + MARGIN / 2;
  }, MARGIN);
}
