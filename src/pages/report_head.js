// What stands above the table of a report, and how texts of strangers are shown.
"use strict";

/** Control characters as their pictures, characters that turn the direction of text by their number; line ends and tabs stay. */
function visibleText(text) {
  return text.replace(/[\u0000-\u0008\u000b-\u001f\u007f-\u009f\u061c\u200b-\u200f\u2028-\u202e\u2060-\u2069\ufeff]/g, (char) => {
    const code = char.charCodeAt(0);
    if (code < 0x20) return String.fromCharCode(0x2400 + code);
    return code === 0x7f ? "␡" : `⟨${code.toString(16).padStart(4, "0")}⟩`;
  });
}

function showReportHead() {
  const { title, about, facts, notes, back } = pageData;
  document.title = visibleText(about ? `${title} · ${about}` : title);
  byId("head").append(
    back ? make("p", {}, make("a", { href: back.href }, `← ${back.text}`)) : "",
    make("div", { class: "top" },
      make("div", {}, make("h1", {}, visibleText(title)), make("p", {}, visibleText(about))),
      make("dl", { class: "summary" }, facts.map(([name, text]) => make("div", {}, make("dt", {}, name), make("dd", {}, visibleText(text))))),
    ),
    notes.length === 0 ? "" : make("ul", { class: "notes note" }, notes.map((text) => make("li", {}, visibleText(text)))),
  );
}
