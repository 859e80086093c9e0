#!/usr/bin/env python3
"""The driver sees what it is there to see: messages, exceptions, requests; clicks and keys reach the page."""
import pathlib
import tempfile
import unittest

from browser import Browser, BrowserError, find_chromium

BAD = """<!DOCTYPE html><title>bad</title><img src="http://127.0.0.1:9/never.png"><script>
console.log("said");
setTimeout(() => { throw new Error("thrown"); });
fetch("data:text/plain,inside").then((answer) => answer.text()).then((text) => { document.title = text; });
</script>"""
GOOD = """<!DOCTYPE html><title>good</title><body><button style="position: fixed; left: 100px; top: 50px">x</button><script>
addEventListener("click", (event) => { document.title = event.target.tagName + (event.isTrusted ? " trusted" : ""); });
addEventListener("keydown", (event) => { document.title = event.key; });
addEventListener("wheel", (event) => { document.title = `wheel ${Math.sign(event.deltaY)}`; });
</script>"""


@unittest.skipUnless(find_chromium(), "no Chromium here: the pages are not looked at")
class BrowserTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.browser = Browser()
        self.enterContext(self.browser)

    def file(self, text):
        path = pathlib.Path(self.folder.name) / "page.html"
        path.write_text(text)
        return path

    def test_what_a_page_must_not_do_is_seen(self):
        page = self.browser.open(self.file(BAD))
        page.wait("document.title === 'inside'")
        self.assertIn("console: said", page.complaints())
        self.assertTrue(any("thrown" in text for text in page.complaints()), page.complaints())
        self.assertEqual(page.foreign_requests(), ["http://127.0.0.1:9/never.png"])
        self.assertRaises(AssertionError, page.assert_clean)

    def test_hands_reach_a_good_page(self):
        page = self.browser.open(self.file(GOOD))
        page.click_on("button")
        page.wait("document.title === 'BUTTON trusted'")
        page.key("ArrowLeft")
        page.wait("document.title === 'ArrowLeft'")
        page.wheel(10, 10, 120)
        page.wait("document.title === 'wheel 1'")
        page.assert_clean()

    def test_mistakes_in_expressions_are_reported(self):
        page = self.browser.open(self.file(GOOD))
        self.assertRaises(BrowserError, page.evaluate, "nothing.there")


if __name__ == "__main__":
    unittest.main()
