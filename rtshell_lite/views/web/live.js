// The page of rttop --serve: takes what its server sends, and shows it where a person looks, types or clicks already.

// Take [state, words] of components, by number.
function takeStates(now) {
  for (const number of Object.keys(now)) {
    const box = data.boxes[number];
    const was = isBroken(number);
    [box.state, box.why] = now[number];
    texts[number] = undefined;
    if (!was && isBroken(number)) element("status").textContent = `${box.name}: ${stateWords(box.state)}`;
  }
}

// Put new words into the boxes on the map; false where they need other boxes.
function reword() {
  const found = picture.boxes.map(heads);
  const fits = (words, place) => words.length === picture.boxes[place].heads.length &&
    words.every((line) => (cells(line) + 1) * CELL <= picture.boxes[place].width);
  if (!found.every(fits) || picture.frames.some((frame) => (cells(titleOf(frame)) + 5) * CELL > frame.width)) return false;
  found.forEach((words, place) => {
    const box = picture.boxes[place];
    box.heads = words;
    box.shape.setAttribute("class", classOf(box));
    box.shape.querySelectorAll("text").forEach((line, row) => { if (row < words.length) line.textContent = words[row]; });
  });
  for (const frame of picture.frames) {
    frame.shape.querySelector(".title").textContent = titleOf(frame);
    frame.shape.setAttribute("class", `frame${frame.members.some(isBroken) ? " broken" : ""}`);
  }
  mark();
  return true;
}

// How to draw the map again: what a person has under the keyboard stays there, and what was seen whole is so again.
function redraw() {
  const isWhole = () => ["Width", "Height"].every((side) => element("map")[`scroll${side}`] <= element("map")[`client${side}`]);
  const wasWhole = isWhole();
  const focused = picture.boxes.find((box) => box.shape === document.activeElement);
  const path = focused ? data.boxes[focused.members[0]].path : null;
  return () => {
    draw();
    const number = path === null ? -1 : data.boxes.findIndex((box) => box.path === path);
    if (number >= 0 && picture.at.has(number)) picture.boxes[picture.at.get(number)].shape.focus({preventScroll: true});
    if (wasWhole && !isWhole()) fit(0.65);
  };
}

// What stands beside the map, unless a person is at it with the keyboard.
function showBeside() {
  const isFree = (id) => !element(id).contains(document.activeElement);
  if (isFree("list")) showList();
  const now = element("now");
  if (now) now.textContent = nowWords(data.boxes[view.selected]);
  else if (isFree("details")) {
    const [top, said] = [element("details").scrollTop, element("status").textContent];
    if (view.selected === null) clear();
    else if (nodeOf(view.group)) showGroup(nodeOf(view.group));
    else clear();
    element("details").scrollTop = top;
    element("status").textContent = said;
  }
  renumber();
}

// Buttons lead to the components that they name, whose numbers may have changed.
function renumber() {
  const numbers = new Map(data.boxes.map(({path}, number) => [path, number]));
  document.querySelectorAll(".link").forEach((link) => {
    link.number = numbers.get(link.title);
    link.disabled = link.number === undefined;
    link.classList.toggle("broken", !link.disabled && isBroken(link.number));
  });
}

// Take a system of other components or connections.
function takeSystem(found) {
  const wasEmpty = !data.boxes.length;
  const paths = [view.selected, view.around].map((number) => (number === null ? null : data.boxes[number].path));
  const before = view.selected === null ? "" : textOf(view.selected);
  const again = redraw();
  load(found);
  const numbers = paths.map((path) => data.boxes.findIndex((box) => path !== null && box.path === path));
  [view.selected, view.around] = numbers.map((number) => (number < 0 ? null : number));
  takeStates(data.now);
  again();
  if (wasEmpty) fit(0.65);
  if (paths[0] !== null && view.selected === null) clear();
  else if (element("now") && textOf(view.selected) !== before) showComponent(view.selected);
  showBeside();
}

// All that is known of a component but its state, to see whether that is still the same.
function textOf(number) {
  const {name, path, parts, ports} = data.boxes[number];
  const rows = (each) => data.rows[each[each.length - 1]];
  const far = connectionsOf[number].map(({name: word, id, ends}) => [word, id, ends.map((end) => [data.boxes[end[0]].path, end[1]])]);
  return JSON.stringify([name, path, parts.map((each) => [each[0], rows(each)]), ports.map((each) => [each[0], each[1], rows(each)]), far]);
}

function hear() {
  const source = new EventSource(`events?${data.version}`);
  const say = (words, isWell) => {
    element("live").textContent = words;
    element("live").classList.toggle("lost", !isWell);
  };
  const on = (name, take) => source.addEventListener(name, (event) => {
    say("\u25cf live", true);
    take(JSON.parse(event.data));
  });
  on("system", takeSystem);
  on("states", (now) => {
    const again = redraw();
    takeStates(now);
    if (!reword()) again();
    showBeside();
  });
  source.onopen = () => say("\u25cf live", true);
  source.onerror = () => say(`not live since ${new Date().toLocaleTimeString()}: no answer`, false);
}

element("live").hidden = false;
takeStates(data.now);
change({});
showBeside();
hear();
