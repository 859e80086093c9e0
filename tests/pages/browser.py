"""Headless Chromium for tests of pages, by the DevTools protocol over a pipe; nothing but the standard library.

    with Browser() as browser:
        page = browser.open("/folder/page.html#x")
        page.wait("document.title === 'done'")
        page.click(120, 80)
        page.assert_clean()          # no message, no exception, no request but for the page itself
"""
import base64
import json
import os
import pathlib
import select
import shutil
import signal
import subprocess
import tempfile
import time

PATIENCE = 120.0  # seconds; the machine may be busy with other builds

FLAGS = [
    "--headless",
    "--no-sandbox",  # tests may run as root
    "--disable-gpu",
    "--disable-quic",
    "--disable-dev-shm-usage",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--hide-scrollbars",
    "--remote-debugging-pipe",
]


def find_chromium():
    """The program's path, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser") or shutil.which("google-chrome")


# The least contrast of any text on the page with the ground behind it (WCAG 2, relative luminance).
CONTRAST = """(() => {
    const channels = (color) => color.match(/[\\d.]+/g).map(Number);
    const luminance = (rgb) => {
        const [r, g, b] = rgb.slice(0, 3).map((v) => (v / 255 <= 0.04045 ? v / 255 / 12.92 : ((v / 255 + 0.055) / 1.055) ** 2.4));
        return 0.2126 * r + 0.7152 * g + 0.0722 * b;
    };
    const ground = (element) => {
        for (; element; element = element.parentElement) {
            const color = channels(getComputedStyle(element).backgroundColor);
            if (color.length === 3 || color[3] === 1) return color;
        }
        return [255, 255, 255];
    };
    let least = [Infinity];
    for (const element of document.querySelectorAll("body *:not(script, svg *)")) {
        if (![...element.childNodes].some((node) => node.nodeType === 3 && node.data.trim())) continue;
        const [a, b] = [luminance(channels(getComputedStyle(element).color)), luminance(ground(element))];
        const contrast = (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
        if (contrast < least[0]) least = [contrast, element.outerHTML.slice(0, 200)];
    }
    return least;
})()"""


class BrowserError(Exception):
    pass


class Browser:
    """One Chromium with a profile of its own. Messages are JSON texts that end with a zero byte, on its descriptors 3 and 4."""

    def __init__(self, width=1400, height=1000):
        self.size = f"--window-size={width},{height}"

    def __enter__(self):
        self.profile = tempfile.mkdtemp(prefix="raytrace_browser_")
        to_browser, self.to = os.pipe()
        self.of, from_browser = os.pipe()

        def descriptors():  # in the child: 3 to read from, 4 to write to
            spare = [os.dup(fd) for fd in (to_browser, from_browser)]
            high = [os.dup(fd) for fd in spare]
            os.dup2(high[0], 3)
            os.dup2(high[1], 4)
            os.set_inheritable(3, True)
            os.set_inheritable(4, True)

        command = [find_chromium(), *FLAGS, self.size, f"--user-data-dir={self.profile}", "about:blank"]
        self.log = open(os.path.join(self.profile, "stderr"), "w+")
        self.process = subprocess.Popen(command, preexec_fn=descriptors, close_fds=False, stdin=subprocess.DEVNULL,
                                        stdout=subprocess.DEVNULL, stderr=self.log, start_new_session=True)
        os.close(to_browser)
        os.close(from_browser)
        self.buffer = b""
        self.number = 0
        self.answers = {}
        self.listeners = {}  # of sessions
        return self

    def __exit__(self, *_):
        os.close(self.to)
        os.close(self.of)
        try:
            os.killpg(self.process.pid, signal.SIGKILL)  # the group that was made for it
        except ProcessLookupError:
            pass
        self.process.wait()
        self.log.close()
        shutil.rmtree(self.profile, ignore_errors=True)

    def receive(self, deadline):
        """Takes one message to where it belongs."""
        while b"\0" not in self.buffer:
            ready, _, _ = select.select([self.of], [], [], max(0.0, deadline - time.monotonic()))
            data = os.read(self.of, 1 << 16) if ready else b""
            if not data:
                self.log.seek(0)
                raise BrowserError("no answer from the browser: " + self.log.read()[-2000:])
            self.buffer += data
        text, self.buffer = self.buffer.split(b"\0", 1)
        message = json.loads(text)
        if "id" in message:
            self.answers[message["id"]] = message
        elif message.get("sessionId") in self.listeners:
            self.listeners[message["sessionId"]](message["method"], message["params"])

    def call(self, method, session=None, **parameters):
        self.number += 1
        number = self.number
        message = {"id": number, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.to, data):]
        deadline = time.monotonic() + PATIENCE
        while number not in self.answers:
            self.receive(deadline)
        answer = self.answers.pop(number)
        if "error" in answer:
            raise BrowserError(f"{method}: {answer['error']}")
        return answer["result"]

    def open(self, path, fragment="", media=None):
        """A new page that shows a file, loaded. `media` chooses features, e.g. {"prefers-color-scheme": "dark"}."""
        return Page(self, pathlib.Path(path).resolve().as_uri() + fragment, media or {})


class Page:
    def __init__(self, browser, url, media):
        self.browser, self.url = browser, url
        self.messages, self.requests, self.loaded = [], [], False
        target = browser.call("Target.createTarget", url="about:blank")["targetId"]
        self.session = browser.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        browser.listeners[self.session] = self.heard
        for domain in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{domain}.enable")
        features = [{"name": name, "value": value} for name, value in media.items()]
        self.call("Emulation.setEmulatedMedia", features=features)
        self.call("Page.bringToFront")  # keys go to the page in front
        self.call("Page.navigate", url=url)
        deadline = time.monotonic() + PATIENCE
        while not self.loaded:
            browser.receive(deadline)

    def heard(self, method, parameters):
        if method == "Runtime.consoleAPICalled":
            self.messages.append("console: " + " ".join(str(a.get("value", a.get("description"))) for a in parameters["args"]))
        elif method == "Runtime.exceptionThrown":
            details = parameters["exceptionDetails"]
            self.messages.append("exception: " + details.get("exception", {}).get("description", details["text"]))
        elif method == "Log.entryAdded":
            self.messages.append("log: " + parameters["entry"]["text"])
        elif method == "Network.requestWillBeSent":
            self.requests.append(parameters["request"]["url"])
        elif method == "Page.loadEventFired":
            self.loaded = True

    def call(self, method, **parameters):
        return self.browser.call(method, self.session, **parameters)

    def evaluate(self, expression):
        """Its value as JSON has it; a promise's once it is there. An exception in it is a BrowserError."""
        answer = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(f"{expression}: {answer['exceptionDetails'].get('exception', {}).get('description')}")
        return answer["result"].get("value")

    def wait(self, condition):
        """Until the expression is true, looked at once a frame by the page itself."""
        self.evaluate(f"""new Promise((resolve, reject) => {{
            const end = performance.now() + {PATIENCE / 2 * 1000};
            const look = () => (({condition}) ? resolve() : performance.now() > end ? reject(new Error("never true")) : setTimeout(look, 20));
            look();
        }})""")

    def box(self, selector):
        """left, top, width and height in the window, once they stay what they are; scrolled into it before."""
        return self.evaluate(f"""new Promise((resolve) => {{
            const element = document.querySelector({json.dumps(selector)});
            element.scrollIntoView({{ block: "nearest" }});
            const measure = () => {{
                const box = element.getBoundingClientRect();
                return [box.left, box.top, box.width, box.height];
            }};
            const settle = (before, frames) => requestAnimationFrame(() => {{
                const now = measure();
                const same = now.every((value, i) => value === before[i]);
                if (same && frames > 0) resolve(now);
                else settle(now, same ? 1 : 0);
            }});
            settle(measure(), 0);
        }})""")

    def mouse(self, kind, x, y, **more):
        self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)

    def move(self, x, y):
        self.mouse("mouseMoved", x, y)

    def click(self, x, y):
        self.move(x, y)
        for kind in ("mousePressed", "mouseReleased"):
            self.mouse(kind, x, y, button="left", clickCount=1)

    def click_on(self, selector):
        left, top, width, height = self.box(selector)
        self.click(left + width / 2, top + height / 2)

    def drag(self, x, y, to_x, to_y):
        self.move(x, y)
        self.mouse("mousePressed", x, y, button="left", clickCount=1)
        for step in range(1, 6):
            self.mouse("mouseMoved", x + (to_x - x) * step / 5, y + (to_y - y) * step / 5, button="left", buttons=1)
        self.mouse("mouseReleased", to_x, to_y, button="left", clickCount=1)

    def wheel(self, x, y, delta):
        self.mouse("mouseWheel", x, y, deltaX=0, deltaY=delta)

    def key(self, key, text=None):
        """Presses a key by its DOM name, e.g. "ArrowLeft" or "Tab"; `text` is what it types."""
        codes = {"Tab": 9, "Enter": 13, " ": 32, "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40}
        more = {"text": text} if text else {}
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, windowsVirtualKeyCode=codes.get(key, 0), **more)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key, windowsVirtualKeyCode=codes.get(key, 0))

    def tab_to(self, condition, most=100):
        """Presses Tab until the expression about the page is true."""
        for _ in range(most):
            if self.evaluate(condition):
                return
            self.key("Tab")
        raise BrowserError(f"{condition}: not reached by {most} times Tab")

    def resize(self, width, height):
        """As seen by the page, e.g. 320 pixels wide: a window of 1280 at 400 %."""
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def screenshot(self, path, whole=False):
        data = self.call("Page.captureScreenshot", captureBeyondViewport=whole)["data"]
        pathlib.Path(path).write_bytes(base64.b64decode(data))

    def least_contrast(self):
        """Of any text with its ground, and the element; 4.5 is wanted of ordinary text (WCAG 2)."""
        return self.evaluate(CONTRAST)

    def foreign_requests(self):
        """Everything asked for but the page itself and what it holds."""
        own = self.url.split("#")[0]
        return [url for url in self.requests if url.split("#")[0] != own and not url.startswith("data:")]

    def complaints(self):
        return self.messages + [f"request: {url}" for url in self.foreign_requests()]

    def assert_clean(self):
        if self.complaints():
            raise AssertionError("\n".join(self.complaints()))
