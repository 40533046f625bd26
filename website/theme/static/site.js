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
