// The map on paper: sheets that are drawn when a browser is about to print.
const SMALLEST = 12000; // square pixels of a component, and of what is around it
// width and height for the map on a sheet, in pixels; the least size of letters, 6 points, by that on the map
const [PAPERS, LEGIBLE] = [{A4: [1040, 640], A3: [1505, 965]}, 8 / 14];

// [title, picture] of each sheet: the whole map, if it can be read then; else an overview, and the groups one after the other.
function sheets() {
  const [numbers, size] = [shownNumbers(), PAPERS[element("paper").value]];
  const shown = new Set(numbers);
  const isLegible = ({width, height}) => Math.min(size[0] / width, size[1] / height) >= LEGIBLE;
  const [kind, depth] = view.kind === "auto" ? chooseKind(numbers) : [data.kinds.indexOf(view.kind), 0];
  const grouped = kind || data.order.find((other) => other && countAt(-1 - data.trees[other], 1, shown) <= data.most) || data.order[data.order.length - 1];
  if (numbers.length * SMALLEST * LEGIBLE * LEGIBLE < size[0] * size[1]) {
    const whole = paint(numbers, [kind, Infinity], new Map(), size);
    if (isLegible(whole)) return [[data.title, whole]];
  }
  const overviews = [kind ? depth : 0, 0].map((open) => paint(numbers, [grouped, open], new Map(), size));
  const found = [[`${data.title}: overview`, overviews.find(isLegible) || overviews[1]]];
  const add = (number, above, key) => groupsIn(number, key).forEach((group) => {
    const members = membersOf[group.number].filter((member) => shown.has(member));
    if (members.length < 2) return;
    const around = neighbours(members, 1, "both").filter((member) => shown.has(member));
    const [opened, inside] = [[...above, [group.key, true]], keysIn(group.number, group.key)];
    let sheet = paint(around, [grouped, 0], new Map([...opened, ...inside]), size);
    const isDivided = !isLegible(sheet) && inside.length > 0;
    if (isDivided) sheet = paint(around, [grouped, 0], new Map(opened), size);
    else if (!isLegible(sheet)) sheet = paint(members, [0, 0], new Map(), size);
    found.push([`${group.name}, and what is connected to it`, sheet]);
    if (isDivided) add(group.number, opened, group.key);
  });
  add(data.trees[grouped], [], "");
  return found;
}
// [key, true] of each group in a group.
const keysIn = (number, above) => [].concat(...groupsIn(number, above).map((group) => [[group.key, true], ...keysIn(group.number, group.key)]));
function putSheets() {
  const rules = document.styleSheets[0];
  const [paper, all] = [element("paper").value, sheets()];
  if (rules.cssRules[rules.cssRules.length - 1].type === CSSRule.PAGE_RULE) rules.deleteRule(rules.cssRules.length - 1);
  rules.insertRule(`@page { size: ${paper} landscape; margin: 10mm; }`, rules.cssRules.length);
  fill(element("sheets"), ...all.map(([title, {svg, width, height}], place) => {
    const scale = Math.min(1, PAPERS[paper][0] / width, PAPERS[paper][1] / height);
    svg.setAttribute("width", width * scale);
    svg.setAttribute("height", height * scale);
    const number = all.length > 1 ? `, sheet ${place + 1} of ${all.length}` : "";
    return make("section", {class: "sheet"}, make("h2", {}, title), make("p", {}, `${data.what}${number}`), svg, element("legend").cloneNode(true));
  }));
}
