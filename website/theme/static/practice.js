// The form of a problem page: it asks website/browser/practice.py by the engine. Where there is
// no engine (without JavaScript or WebAssembly, from a file) the page stays as it was built.
const practiceFiles = new URL("../practice/", document.currentScript.src);
addEventListener("DOMContentLoaded", () => {
  const place = document.querySelector("div.practice"), files = practiceFiles;
  if (!place || !window.engine) return;
  const { file } = place.dataset, KEPT = "newton-euler.progress", NONE = '{"format": 1, "problems": {}}', MOST = 64 << 20; // bytes
  const call = async (name, args) => {
    if (place.dataset.ready && endsBefore !== engine.ends) await (restart ??= again().finally(() => (restart = undefined)));
    return engine.call(`practice.${name}`, { problem, ...args });
  };
  const kept = () => stored(KEPT), keep = (text) => store(KEPT, text);
  const static_ = document.querySelector(".statement");
  let { problem } = place.dataset, contents; // of a practice file of the reader's own
  let given, endsBefore, restart, number = 1; // the practice file; to which engine it was given; the set of numbers
  let last, note = ""; // the field used last; what the reader should know

  // -- parts of a page

  const { el, button, typeset } = engine;
  const math = (latex, display) =>
    el("span", { class: "math notranslate" }, display ? `\\[${latex}\\]` : `\\(${latex}\\)`);

  // the Markdown of the problems, made into elements: none of its text is ever read as HTML
  const INLINE = /\$\$([^$]+)\$\$|\$([^$]+)\$|`([^`]+)`|\*\*(.+?)\*\*|\*(.+?)\*|\[([^\]]+)\]\([^)]*\)|\\([\\`*_[\]#$|])/g;
  const inline = (text) => {
    const parts = [];
    let end = 0;
    for (const m of text.matchAll(INLINE)) {
      parts.push(text.slice(end, m.index));
      end = m.index + m[0].length;
      if (m[1] || m[2]) parts.push(math(m[1] || m[2], m[1]));
      else if (m[3]) parts.push(el("code", {}, m[3]));
      else if (m[4]) parts.push(el("strong", {}, ...inline(m[4])));
      else if (m[5]) parts.push(el("em", {}, ...inline(m[5])));
      else parts.push(...(m[6] ? inline(m[6]) : [m[7]]));
    }
    return [...parts, text.slice(end)];
  };
  const cells = (line, tag) =>
    el("tr", {}, ...line.trim().replace(/^\||\|$/g, "").split(/(?<!\\)\|(?![^$]*\$(?:[^$]*\$[^$]*\$)*[^$]*$)/)
      .map((cell) => el(tag, {}, ...inline(cell.trim()))));
  const block = (text) => {
    const lines = text.split("\n"), item = /^\s*(?:-|\d+\.)\s+/;
    if (lines[0].startsWith("|"))
      return el("div", { class: "table-wrapper" }, el("table", { class: "docutils" }, el("thead", {}, cells(lines[0], "th")),
        el("tbody", {}, ...lines.slice(2).map((line) => cells(line, "td")))));
    if (item.test(lines[0])) {
      const items = [];
      for (const line of lines) item.test(line) ? items.push(line.replace(item, "")) : (items[items.length - 1] += ` ${line.trim()}`);
      return el(/^\s*-/.test(lines[0]) ? "ul" : "ol", {}, ...items.map((x) => el("li", {}, ...inline(x))));
    }
    return el("p", {}, ...inline(lines.join(" ").replace(/^#+ /, "")));
  };
  const markdown = (text) => text.split(/\n\s*\n/).filter((part) => part.trim()).map((part) => block(part.replace(/^\n+|\s+$/g, "")));

  // a figure inside the page, where it follows the page's theme if it consists of shapes only
  const SHAPES = /^(svg|g|path|rect|circle|text|tspan)$/, LOADS = /^(on.*|.*href|style|src)$/i;
  const isShape = (e) => SHAPES.test(e.localName) && [...e.attributes].every(
    ({ name, value }) => !LOADS.test(name) && !/url\(|script:/i.test(value));
  const picture = (address, words) => {
    const [kind, data] = address.split(";base64,");
    if (kind === "data:image/svg+xml") {
      const text = new TextDecoder().decode(Uint8Array.from(atob(data), (c) => c.charCodeAt(0)));
      const svg = new DOMParser().parseFromString(text, "image/svg+xml").documentElement;
      if ([svg, ...svg.querySelectorAll("*")].every(isShape)) {
        svg.setAttribute("aria-label", words);
        return document.importNode(svg, true);
      }
    }
    return el("p", {}, el("img", { src: address, alt: words }));
  };

  // -- the form

  const status = el("p", { class: "visually-hidden", role: "status", "aria-live": "polite" });
  const body = el("div"), bar = el("progress", { max: 1, value: 0, "aria-label": gettext("loading the checker") });
  const say = (text) => { status.textContent = ""; setTimeout(() => (status.textContent = text), 30); };
  const failed = (error) => { say(error.message); body.prepend(el("p", { class: "verdict wrong" }, error.message)); };

  const inputs = (q, changed) => {
    if (q.of.length)
      return [el("select", { "aria-label": q.key, onchange: changed }, el("option", { value: "" }, gettext("choose")),
        ...q.of.map((word) => el("option", {}, word)))];
    return q.parts.map((part) => el("input", {
      type: "text", autocomplete: "off", autocapitalize: "off", spellcheck: "false", enterkeyhint: "done",
      "aria-label": [q.key, part].filter(Boolean).join(", "), "aria-describedby": `read-${q.key}`,
      oninput: changed, onfocus: ({ target }) => (last = target),
    }));
  };

  const field = (q) => {
    const read = el("span", { class: "read", id: `read-${q.key}` }), verdict = el("p", { class: "verdict" });
    let timer, turn = 0;
    const texts = () => fields.map((f) => f.value);
    const reading = async () => {
      const mine = ++turn, { latex, fault } = await call("read", { key: q.key, texts: texts() });
      if (mine !== turn) return;
      read.className = fault ? "read fault" : "read";
      read.replaceChildren(latex ? math(latex) : fault);
      if (latex) await typeset(read);
      read.tabIndex = read.scrollWidth > read.clientWidth ? 0 : -1; // the keyboard scrolls what is too wide
    };
    const fields = inputs(q, () => {
      verdict.className = "verdict";
      verdict.textContent = "";
      clearTimeout(timer);
      timer = setTimeout(() => reading().catch(failed), 120);
    });
    const unit = q.unit ? [gettext(", in "), math(q.unit.replace(/^\\ /, ""))] : [];
    const box = el("fieldset", { "data-key": q.key }, el("legend", {}, ...inline(q.means), ...(q.symbol && !q.of.length ? [", ", math(q.symbol)] : []), ...unit),
      el("div", { class: `parts of-${fields.length}` }, ...fields), read, verdict);
    const show = ({ verdict: found, text }) => {
      verdict.className = `verdict ${found}`;
      verdict.textContent = ({ right: "✓ ", wrong: "✗ " }[found] || "") + text;
      if (found === "unreadable") {
        read.textContent = "";
        clearTimeout(timer);
        turn += 1; // a reading that is due or under way would say the same again
      }
      for (const f of fields) f.setAttribute("aria-invalid", found !== "right");
    };
    return { q, box, texts, show };
  };

  const check = async (asked, all) => {
    const given = Object.fromEntries(asked.map((f) => [f.q.key, f.texts()]).filter(([, texts]) => texts.some((t) => t.trim())));
    if (!Object.keys(given).length) return say(gettext("Write a value first."));
    const { found, kept: text } = await call("check", { fields: given });
    keep(text);
    for (const f of asked) if (found[f.q.key]) f.show(found[f.q.key]);
    say(Object.entries(found).map(([key, { text }]) => `${key}: ${text}`).join(". "));
    if (all && asked.every((f) => found[f.q.key]?.verdict === "right")) await advise();
  };
  const form = (asked, text, all) =>
    el("form", { onsubmit: (event) => (event.preventDefault(), check(asked, all).catch(failed)) },
      ...asked.map((f) => f.box), el("button", { class: "primary" }, text));

  const next = el("p", { class: "next" });
  const advise = async () => {
    const titles = contents || (await fetched("index.json").then((found) => found.json()));
    const found = await engine.call("practice.advice", { titles, now: problem });
    const name = found.problem && `${found.problem} ${titles[found.problem][0]}`;
    const link = name && (contents ? button(name, () => open(found.problem)) :
      el("a", { href: new URL(`../problems/${found.problem.replace("/", "-")}.html`, files) }, name));
    next.replaceChildren(`${gettext("Next:")} `, ...(link ? [link, ". "] : []), found.sentence);
    say(`${gettext("Next:")} ${found.sentence}`);
  };

  const helped = async (name, where) => {
    const { text, kept: progress } = await call(name);
    keep(progress);
    where.replaceChildren(...markdown(text));
    await typeset(where);
    say(where.textContent.replace(/\s+/g, " ").slice(0, 300));
  };

  const insert = (name) => {
    const f = last || body.querySelector("input[type=text]");
    f.setRangeText(name, f.selectionStart, f.selectionEnd, "end");
    f.dispatchEvent(new Event("input"));
    f.focus();
  };

  const tooLarge = ({ name }) => new Error(gettext("{name} has more than {most} MB: not a practice file", { name, most: MOST >> 20 }));
  const progressBox = () => {
    const chosen = el("input", { type: "file", accept: ".json,application/json", class: "visually-hidden", tabindex: "-1",
      "aria-label": gettext("a file of progress"), onchange: async () => {
        try {
          const [blob] = chosen.files;
          if (blob.size > MOST) throw tooLarge(blob);
          const { kept: text } = await engine.call("practice.take_in", { progress: await blob.text() });
          keep(text);
          say((next.textContent = gettext("Your progress was loaded.")));
        } catch (error) { say(error.message); next.textContent = error.message; }
        chosen.value = "";
      } });
    const save = () => {
      const blob = new Blob([kept() || NONE], { type: "application/json" });
      const link = el("a", { href: URL.createObjectURL(blob), download: "practice.progress.json" });
      link.click();
    };
    return el("details", {}, el("summary", {}, gettext("Your progress")),
      el("p", {}, gettext("It stays in this browser. The file is the one that practice() keeps in a notebook: take it along, either way.")),
      button(gettext("Save as a file"), save, { class: "export" }), " ", button(gettext("Load a file"), () => chosen.click()), chosen);
  };

  const show = async (fresh) => {
    const asked = problem; // another may be chosen while this one is loading
    const p = await call("show", { new: fresh });
    if (problem !== asked) return;
    number = p.number;
    last = undefined;
    if (fresh || contents) {
      const [lead, ...rest] = markdown(p.text);
      const title = contents ? [el("h2", {}, `${p.id} ${p.title}`)] : [];
      static_.replaceChildren(...title, lead, ...(p.figure ? [picture(p.figure, p.words)] : []), ...rest);
      await typeset(static_);
      if (problem !== asked) return;
    }
    const answers = p.answers.map(field), steps = p.steps.map(field);
    const hint = el("div", { class: "reply" }), solved = el("div", { class: "reply" });
    const names = Object.entries(p.names).map(([name, x]) => button(name, () => insert(name), { class: "name", title: `${name} = ${x}` }));
    next.replaceChildren(note);
    note = "";
    body.replaceChildren(
      el("h2", {}, gettext("Your answer")),
      el("p", { class: "sets" }, `${gettext("Numbers {number} of {all}", { number: p.number, all: p.sets })}. `, ...(p.sets > 1 ? [button(gettext("New numbers"), () =>
        show(true).then(() => say(gettext("Numbers {number} of {all}", { number: p.number % p.sets + 1, all: p.sets }))).catch(failed))] : [])),
      el("p", { class: "names" }, `${gettext("Write numbers or formulas, as 2*sqrt(3).")} `, ...(names.length ? [`${gettext("Names:")} `, ...names] : [])),
      form(answers, gettext("Check"), true), next,
      el("p", { class: "help" }, ...(p.hints ? [button(gettext("Hint"), () => helped("hint", hint).catch(failed))] : []), " ",
        ...(p.solution ? [button(gettext("Solution"), () => helped("solution", solved).catch(failed))] : []), " ",
        button(gettext("What next?"), () => advise().catch(failed))),
      hint, solved,
      ...(steps.length ? [el("details", { class: "steps" }, el("summary", {}, gettext("Steps on the way, each checked by itself ({count})", { count: steps.length })),
        ...steps.map((f) => form([f], gettext("Check step"), false)))] : []),
      progressBox());
    await typeset(body);
  };

  const base64 = (blob) => new Promise((done) => {
    const reader = new FileReader();
    reader.onload = () => done(reader.result.slice(reader.result.indexOf(",") + 1));
    reader.readAsDataURL(blob);
  });
  const fetched = async (name) => {
    const found = await fetch(new URL(name, files)).catch(({ message }) => ({ status: message }));
    if (!found.ok) throw new Error(gettext("{needs} cannot be fetched: {error}", { needs: name, error: found.status }));
    return found;
  };
  const load = async (name, data) => {
    const found = await engine.call("practice.load", { name, data, language: document.documentElement.lang });
    given = [name, data];
    endsBefore = engine.ends;
    await engine.call("practice.take_in", { progress: kept() || NONE }).catch(setAside);
    return found;
  };
  // what this browser has kept cannot be read: no reason not to practise
  const setAside = ({ message }) => {
    say((note = message));
    store(`${KEPT}.damaged`, kept());
    keep("");
  };
  // a new engine gets the same file, and takes the numbers that the page shows
  const again = async () => {
    await load(...given);
    for (let n = 1; n < number; n += 1) await engine.call("practice.show", { problem, new: true });
  };
  const loading = () => body.replaceChildren(el("p", {}, `${gettext("Loading the checker:")} `, bar));
  engine.progress((part) => (bar.value = part));
  const begin = async () => {
    start.hidden = true;
    loading();
    store("newton-euler.practises", "yes");
    const found = await fetched(`${file}.practice`);
    fetched("index.json").catch(() => {}); // kept for when there is no network
    await load(file, await base64(await found.blob()));
    await show(false);
    place.dataset.ready = "yes";
  };

  // a reader's own practice file: it may come from anywhere, and the engine refuses any other file
  const take = async (blob) => {
    const { name } = blob;
    if (blob.size > MOST) throw tooLarge(blob);
    loading();
    contents = await load(name, await base64(blob));
    const list = el("select", { "aria-label": gettext("problem"), onchange: () => open(list.value) },
      ...Object.entries(contents).map(([id, [title]]) => el("option", { value: id }, `${id} ${title}`)));
    listed.replaceChildren(el("label", {}, `${gettext("Problems of {chapter}", { chapter: name })}: `, list));
    await open(list.value);
    place.dataset.ready = "yes";
  };
  const open = (id) => {
    problem = id;
    const list = listed.querySelector("select");
    if (list) list.value = id;
    return show(false).catch(refused);
  };
  // nothing that was shown before stays
  const refused = (error) => { body.replaceChildren(); static_.replaceChildren(); failed(error); };
  const listed = el("p");
  const chooser = () => {
    const input = el("input", { type: "file", onchange: () => {
      const [blob] = input.files;
      if (blob) take(blob).catch((error) => { listed.replaceChildren(); refused(error); });
    } });
    return [el("p", {}, el("label", {}, `${gettext("Practice file:")} `, input)), listed];
  };
  const run = () => begin().catch((error) => { body.replaceChildren(); start.hidden = false; failed(error); });
  const start = el("p", {}, button(gettext("Practise this problem"), run, { class: "primary" }),
    ` ${gettext("Answers and every step are checked here, with the reason where one is wrong. The checker (10 MB) is loaded once; nothing is sent.")}`);
  addEventListener("storage", ({ key, newValue }) =>
    key === KEPT && newValue && place.dataset.ready && engine.call("practice.take_in", { progress: newValue }).catch(() => {}));
  place.append(...(problem ? [start] : chooser()), body, status);
  place.hidden = false;
  if (problem && stored("newton-euler.practises")) run();
});
