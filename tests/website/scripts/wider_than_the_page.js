// what is wider than the page
const wide = document.documentElement.clientWidth, found = [];
for (const e of document.querySelectorAll("article :is(p, li, dl, div, details, form, fieldset, h1, h2, h3, img, svg)"))
  if (e.getBoundingClientRect().right > wide + 1 && !e.closest(".math, pre, table, .output, mjx-container"))
    found.push(e.tagName + "." + e.className + ": " + e.textContent.slice(0, 60));
if (document.documentElement.scrollWidth > wide) found.push("the page: " + document.documentElement.scrollWidth);
return found.slice(0, 5);
