// Run by node, beside MathJax: reads [[formula in LaTeX, whether it is displayed] …], writes
// {formulas: [HTML …], glyphs: the outlines of letters, which the formulas use}
const shapes = ["input/tex-full", "output/svg", "adaptors/liteDOM", "a11y/assistive-mml"];
const asked = JSON.parse(require("fs").readFileSync(0));
const settings = { loader: { load: shapes }, svg: { fontCache: "global", scale: 0.93 }, tex: { tags: "none" } };
require(`${process.argv[2]}/es5/node-main.js`).init(settings).then(({ startup, tex2svg }) => {
  const html = (node) => startup.adaptor.outerHTML(node);
  const formulas = asked.map(([tex, display]) => html(tex2svg(tex, { display })));
  process.stdout.write(JSON.stringify({ formulas, glyphs: html(startup.output.fontCache.getCache()) }));
});
