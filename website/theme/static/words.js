// a sentence in the page's language with its values: gettext("… {n} …", { n }); a page in another
// language than English is built with its sentences, WORDS, in front of this line
const gettext = (text, values = {}) =>
  ((typeof WORDS === "object" && WORDS[text]) || text).replace(/\{(\w+)\}/g, (whole, name) => values[name] ?? whole);
