// a search names chapters before functions of the engine in whose names the word stands
var Scorer = {
  objNameMatch: 11, objPartialMatch: 1, objPrio: {}, objPrioDefault: 0,
  title: 15, partialTitle: 7, term: 5, partialTerm: 2,
};
