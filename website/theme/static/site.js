// a page that was opened as a file may not read others: the search then shows titles without excerpts
if (location.protocol === "file:") DOCUMENTATION_OPTIONS.SHOW_SEARCH_SUMMARY = false;

// on paper all answers and all code are unfolded, and films stand at their first picture
addEventListener("beforeprint", () => {
  for (const folded of document.querySelectorAll("details")) folded.open = true;
  for (const slider of document.querySelectorAll(".controls input[type=range]")) {
    slider.value = 0;
    slider.dispatchEvent(new Event("input"));
  }
});

// the table of problems shows those that fit all that is asked for; without this script it shows all
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
    document.querySelector("p.chosen").textContent = `${count} of ${rows.length} problems`;
  };
  choose.addEventListener("input", show);
  choose.addEventListener("submit", (event) => event.preventDefault());
  choose.hidden = false;
  show();
}
