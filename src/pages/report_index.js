// The page of many programs: a table whose rows lead to pages of their own.
"use strict";

showReportHead();
const table = new ReportTable(byId("table"), pageData);
document.documentElement.dataset.ready = "";
