// The list beside the map: a tree by directory, and the search.
const LISTED = 60; // components of a list whose folders are open

function matches(number, wanted) {
  if (texts[number] === undefined) {
    const {name, path, state, process, parts, ports} = data.boxes[number];
    const more = [process, ports.map((port) => port[0]), parts.map((part) => data.rows[part[1]])];
    texts[number] = JSON.stringify([name, path, state, more]).toLowerCase();
  }
  return wanted.toLowerCase().split(/\s+/).every((word) => texts[number].includes(JSON.stringify(word).slice(1, -1)));
}
// A tree: what is broken first, then all by directory. Returns what is found, in the order in which it is wanted.
function showList() {
  const wanted = element("search").value;
  const found = ALL.filter((number) => matches(number, wanted));
  const [shown, broken] = [new Set(found), inListOrder(found.filter(isBroken))];
  const isOpen = found.length <= LISTED || wanted !== "" && found.length < ALL.length;
  const inside = (number, key, level) => {
    const folders = groupsIn(number, key).sort((a, b) => byName(a.name, b.name)).map((group) => {
      const members = membersOf[group.number].filter((member) => shown.has(member));
      return members.length ? folder(group.key, group.name, members, level, isOpen, () => inside(group.number, group.key, level + 1)) : null;
    });
    const alone = childrenOf(number).filter((child) => shown.has(child)).sort((a, b) => byName(data.boxes[a].name, data.boxes[b].name) || a - b);
    return [...folders.filter(Boolean), ...alone.map((child) => entry(child, data.boxes[child].name, level))];
  };
  const trouble = broken.length ? [folder("broken", "\u26a0 Broken", broken, 1, true, () => broken.map((number) => entry(number, nameOf(number), 2)))] : [];
  fill(element("list"), ...trouble, ...inside(data.trees[data.kinds.indexOf("directory")], "", 1));
  element("found").textContent = `${found.length} of ${plural(ALL.length, "component")}${data.common ? `, all in ${data.common}` : ""}`;
  return inListOrder(found);
}
const entry = (number, name, level) => make("li", {role: "none"}, componentButton(number, `${SYMBOLS[data.boxes[number].state] || ""} ${name}${
  troubles[number].length ? " \u26a0" : ""}`, {role: "treeitem", "aria-level": level}));
// A folder of the list, with counts by state; its entries are made when it is opened.
function folder(key, name, members, level, isOpen, entries) {
  const isShown = view.folders.has(key) ? view.folders.get(key) : isOpen;
  const toggleIt = (event) => {
    view.folders.set(key, !isShown);
    const other = folder(key, name, members, level, isOpen, entries);
    event.currentTarget.parentElement.replaceWith(other);
    other.firstChild.focus();
  };
  const words = `${isShown ? "\u25be" : "\u25b8"} ${name} `;
  const states = counts(members).map((state) => state.split(" ").slice(0, 2).join(""));
  const more = {class: members.some(isBroken) ? "folder broken" : "folder", role: "treeitem", "aria-level": level, "aria-expanded": isShown,
                title: [plural(members.length, "component"), ...counts(members)].join(", ")};
  const head = make("button", Object.assign({type: "button", click: toggleIt}, more), words, make("span", {}, [members.length, ...states].join(" ")));
  return make("li", {role: "none"}, head, ...(isShown ? [make("ul", {role: "group"}, ...entries())] : []));
}
// Arrows go through the list, open and close folders.
function pressedInList(event) {
  const entries = Array.from(element("list").querySelectorAll("button"));
  const at = entries.indexOf(document.activeElement);
  const steps = {ArrowDown: at + 1, ArrowUp: at - 1, Home: 0, End: entries.length - 1};
  if (at < 0 || !(event.key in steps || ["ArrowLeft", "ArrowRight"].includes(event.key))) return;
  event.preventDefault();
  const state = entries[at].getAttribute("aria-expanded");
  if (event.key in steps) entries[Math.min(entries.length - 1, Math.max(0, steps[event.key]))].focus();
  else if (state === (event.key === "ArrowLeft" ? "true" : "false")) entries[at].click();
  else if (event.key === "ArrowLeft") (entries[at].closest("ul").parentElement.querySelector("button") || entries[at]).focus();
}
// A button that selects a component.
function componentButton(number, words, more) {
  const {name, state, path} = data.boxes[number];
  const all = Object.assign({class: isBroken(number) ? "link broken" : "link", title: path || ""}, more);
  return Object.assign(button(words || `${SYMBOLS[state] || ""} ${name}`, (event) => select(event.currentTarget.number), all), {number});
}
