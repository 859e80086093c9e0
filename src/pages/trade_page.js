// The page of a trade: the report's table and pictures, with the plot above and the knobs below.
"use strict";

const { trade } = pageData;
const plot = new TradePlot(trade, (name) => table.select(pageData.rows.findIndex((row) => row.name === name)));
const showInFull = table.onSelect;
table.onSelect = (index) => {
  plot.mark(pageData.rows[index].name);
  showInFull(index);
};
plot.mark(table.selected === null ? null : pageData.rows[table.selected].name);
showSources(byId("sources"), trade);
showKnobs(byId("knobs"), trade);
