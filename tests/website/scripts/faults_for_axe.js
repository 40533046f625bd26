// what axe finds, by one rule or by all
const [only, done] = arguments;
// after a change of theme, during which colours are in between
Promise.all(document.getAnimations().map((one) => one.finished.catch(() => 0)))
  .then(() => axe.run(document, {resultTypes: ["violations"], ...(only && {runOnly: [only]})}))
  .then(({violations}) => done(violations
    .filter((v) => ["serious", "critical"].includes(v.impact))
    .map((v) => `${v.id}: ${v.nodes.slice(0, 3).map((n) => n.target).join(" ")}`)));
