// what is wrong on a page, once its formulas are set
const wrong = [], done = arguments[0];
const typeset = window.MathJax && MathJax.startup ? MathJax.startup.promise : Promise.resolve();
typeset.then(() => {
  for (const f of document.querySelectorAll(".math"))
    if (!f.querySelector("mjx-container")) wrong.push("not typeset: " + f.textContent.slice(0, 80));
  for (const e of document.querySelectorAll("mjx-merror, [data-mjx-error], [data-mml-node=merror]"))
    wrong.push("error in a formula: " + e.closest(".math").textContent.slice(0, 200));
  const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  for (let t = texts.nextNode(); t; t = texts.nextNode()) {
    if (t.parentElement.closest("pre, code, script, style, mjx-container")) continue;
    if (/\$\s*$/.test(t.data) && t.nextSibling?.matches?.(".math")) wrong.push("dollars about a formula: " + t.data.slice(-80));
    if (/\$[^$]+\$|\\tag|\\\(|\\\[|\\frac|\\boldsymbol/.test(t.data)) wrong.push("raw: " + t.data.slice(0, 80));
  }
  for (const i of document.images) {
    if (!i.alt.trim()) wrong.push("no alternative text: " + i.src.slice(0, 80));
    if (i.loading != "lazy" && !(i.complete && i.naturalWidth)) wrong.push("not shown: " + i.src.slice(0, 80));
  }
  done(wrong);
}).catch(e => done(["MathJax: " + e]));
