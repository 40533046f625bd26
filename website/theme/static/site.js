// a page that was opened as a file may not read others: the search then shows titles without excerpts
if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;

// on paper all answers and code are unfolded, and films show their first picture
addEventListener("beforeprint", () => {
  for (const folded of document.querySelectorAll("details")) folded.open = true;
  for (const image of document.images) image.loading = "eager";
  for (const slider of document.querySelectorAll(".controls input[type=range]")) {
    slider.value = 0;
    slider.dispatchEvent(new Event("input"));
  }
});

// what this browser keeps; a private window keeps nothing
const stored = (key) => { try { return localStorage.getItem(key) || ""; } catch { return ""; } };
const store = (key, text) => { try { localStorage.setItem(key, text); } catch { /* private */ } };

// predictions: the first choice, number or sentence is kept in this browser and opens the answer
const PREDICTED = "newton-euler predictions";
// {key: [the number of the choice or what was typed, whether it was right]}; anything else in the
// browser's store is ignored
function readKept() {
  const isMade = (x) => Array.isArray(x) && /number|string/.test(typeof x[0]) && [true, false, null].includes(x[1]);
  try {
    return Object.fromEntries(Object.entries(JSON.parse(stored(PREDICTED)) || {}).filter(([, x]) => isMade(x)));
  } catch { return {}; }
}
let predicted = readKept();
const asked = [...document.querySelectorAll(".prediction")];
const equal = new Map(); // {key: how many questions before have it}; an equal one is another question
for (const { dataset } of asked) {
  const before = equal.get(dataset.key) || 0;
  equal.set(dataset.key, before + 1);
  if (before) dataset.key += `\n@ (${before + 1})`; // a question may end in "(2)"
}

function keep(key, prediction, right) {
  if (key in predicted) return;
  predicted = { ...readKept(), ...predicted, [key]: [prediction, right] }; // another tab may have kept some
  store(PREDICTED, JSON.stringify(predicted));
  count();
}

// what a number means: right, a known mistake, or neither
function numberMeans(form, text) {
  const bare = text.replace(form.dataset.unit, "").replace("\u2212", "-").trim();
  const x = bare === "" ? NaN : Number(bare), within = +form.dataset.within;
  const near = (value) => Math.abs(x - value) <= within;
  const mistakes = [...form.parentElement.querySelectorAll(".mistake")];
  return [isNaN(x) ? null : near(+form.dataset.answer), mistakes.find((p) => near(+p.dataset.value))];
}

function ask(prediction, key) {
  const choices = [...prediction.querySelectorAll(".choice")], form = prediction.querySelector("form");
  const open = (number) => {
    prediction.classList.add("made");
    for (const choice of choices) {
      const own = choice === choices[number];
      choice.classList.toggle("chosen", own);
      if (own || "right" in choice.dataset) choice.open = true;
    }
  };
  for (const [number, choice] of choices.entries())
    choice.firstChild.addEventListener("click", (event) => {
      if (key in predicted) return;
      event.preventDefault();
      keep(key, number, "right" in choice.dataset);
      open(predicted[key][0]);
    });
  const openAnswer = (kept) => {
    const text = String(kept);
    const [right, mistake] = numberMeans(form, text);
    form.firstChild.value = text;
    form.querySelector("button").hidden = form.firstChild.readOnly = true;
    prediction.classList.add("made", ...(right ? ["right"] : []));
    if (mistake) mistake.classList.add("chosen");
    prediction.querySelector(".answer").open = true;
  };
  if (form) {
    form.hidden = false;
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      const text = form.firstChild.value.trim();
      if (!text) return;
      keep(key, text, form.dataset.answer ? numberMeans(form, text)[0] : null);
      openAnswer(text);
    });
  }
  if (key in predicted) (form ? openAnswer : open)(predicted[key][0]);
}

const keyOf = (prediction) => prediction.dataset.key;
const wrong = () => asked.filter((prediction) => (predicted[keyOf(prediction)] || [])[1] === false);
const fresh = asked.map((prediction) => prediction.cloneNode(true));

// how many predictions above each tally were right, and the wrong ones among them, asked again
function count() {
  for (const tally of document.querySelectorAll(".prediction-tally")) {
    const above = asked.filter((p) => p.compareDocumentPosition(tally) & Node.DOCUMENT_POSITION_FOLLOWING);
    const made = above.map((p) => predicted[keyOf(p)]).filter(Boolean);
    const number = (right) => made.filter(([, was]) => was === right).length;
    tally.hidden = false;
    const counts = { made: made.length, all: above.length, right: number(true), wrong: number(false) };
    tally.textContent = made.length ? gettext("{made} of {all} predictions made: {right} right, {wrong} wrong.", counts)
      : gettext("{made} of {all} predictions made.", counts);
  }
  for (const again of document.querySelectorAll(".predictions-again")) {
    again.hidden = false;
    const missed = wrong().filter((p) => p.compareDocumentPosition(again) & Node.DOCUMENT_POSITION_FOLLOWING);
    for (const prediction of missed) {
      const key = `${keyOf(prediction)} (again)`;
      if ([...again.children].some((child) => child.dataset.key === key)) continue;
      const copy = fresh[asked.indexOf(prediction)].cloneNode(true);
      copy.dataset.key = key;
      again.append(copy);
      ask(copy, key);
    }
    again.classList.toggle("none", !again.children.length);
  }
}

for (const prediction of asked) ask(prediction, keyOf(prediction));
count();

// the table of problems shows those that fit everything chosen; without this script it shows all
const choose = document.querySelector("form.choose");
if (choose) {
  const rows = [...document.querySelectorAll("table.problems tbody tr")];
  const fits = {
    words: (row, text) => text.toLowerCase().split(/\s+/).every((word) => ` ${row.words}`.includes(` ${word}`)),
    section: (row, text) => row.section === text || row.section.split(".")[0] === text,
    kind: (row, text) => row.kind.split(" ").includes(text),
    equation: (row, text) => row.equation.split(" ").includes(text.replace(/[()]/g, "")),
    sheets: (row, text) => +row.sheets >= +text,
  };
  const show = () => {
    const asked = [...new FormData(choose)].map(([name, text]) => [name, text.trim()]).filter(([, text]) => text);
    let count = 0;
    for (const row of rows) {
      const fit = asked.every(([name, text]) => (fits[name] || ((data) => +data[name] <= +text))(row.dataset, text));
      row.hidden = !fit;
      count += fit;
    }
    document.querySelector("p.chosen").textContent = gettext("{count} of {all} problems", { count, all: rows.length });
  };
  choose.addEventListener("input", show);
  choose.addEventListener("submit", (event) => event.preventDefault());
  choose.hidden = false;
  show();
}

// for readers who do not see or point: the margin's headings have a level, a summary is named by its
// text, and the keyboard reaches what scrolls by itself
for (const caption of document.querySelectorAll(".caption[role=heading]")) caption.setAttribute("aria-level", "2");
for (const summary of document.querySelectorAll("summary[aria-label]")) summary.removeAttribute("aria-label");
const besideFormulas = (element) => {
  const copy = element.cloneNode(true);
  for (const formula of copy.querySelectorAll("mjx-container")) formula.remove();
  return copy.textContent.trim();
};
for (const summary of document.querySelectorAll("summary:has(mjx-container)"))
  if (!besideFormulas(summary)) summary.setAttribute("aria-label", summary.textContent.trim());
const reachable = () => {
  for (const e of document.querySelectorAll("article :is(pre, div.math, table.docutils, .table-wrapper, div.problems, .output, span.math mjx-container)"))
    if (e.scrollWidth > e.clientWidth || e.scrollHeight > e.clientHeight) e.tabIndex = 0;
};
addEventListener("load", () => Promise.resolve(window.MathJax?.startup?.promise).then(reachable));
addEventListener("resize", reachable);
