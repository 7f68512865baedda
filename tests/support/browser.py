"""A headless Chromium, driven through its DevTools protocol on a pair of pipes (--remote-debugging-pipe).

chromium = browser.Browser()
page = chromium.open("/tmp/page.html")
page.run("document.title")
"""
import base64
import fcntl
import json
import os
import select
import shutil
import signal
import subprocess
import tempfile
import time

import worlds

NAMES = ("chromium", "chromium-browser", "google-chrome")
OPTIONS = ["--headless", "--no-sandbox", "--disable-gpu", "--remote-debugging-pipe", "--no-first-run",
           "--disable-extensions", "--disable-component-update", "--disable-background-networking",
           "--disable-sync"]


def program():
    """The path of a Chromium, None if there is none."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Failed(Exception):
    """What the browser answers to what it cannot do, or throws."""


class Browser:
    def __init__(self):
        self.home = tempfile.mkdtemp()
        words = [program()] + OPTIONS + ["--user-data-dir=" + self.home, "about:blank"]
        own_in, its_out = os.pipe()
        its_in, own_out = os.pipe()
        far = [fcntl.fcntl(end, fcntl.F_DUPFD_CLOEXEC, 10) for end in (its_in, its_out)]

        def place():
            """It reads commands from descriptor 3, and writes to 4."""
            os.dup2(far[0], 3)
            os.dup2(far[1], 4)

        self.process = subprocess.Popen(
            words,
            pass_fds=(3, 4), preexec_fn=place, start_new_session=True, env=dict(os.environ, HOME=self.home),
            stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
        )
        for end in [its_in, its_out] + far:
            os.close(end)
        self.reading = own_in
        self.writing = own_out
        self.rest = b""
        self.count = 0
        self.events = []

    def close(self):
        os.close(self.writing)
        os.close(self.reading)
        try:
            os.killpg(self.process.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
        self.process.wait()
        shutil.rmtree(self.home, ignore_errors=True)

    def call(self, method, session=None, **parameters):
        """The result of a method of the protocol; events that come before it are kept."""
        self.count += 1
        message = {"id": self.count, "method": method, "params": parameters}
        if session:
            message["sessionId"] = session
        data = json.dumps(message).encode() + b"\0"
        while data:
            data = data[os.write(self.writing, data):]
        number = self.count
        while True:
            answer = self.receive(method)
            if answer.get("id") != number:
                self.events.append(answer)
            elif "error" in answer:
                raise Failed("%s: %s" % (method, answer["error"]))
            else:
                return answer["result"]

    def receive(self, what):
        end = time.monotonic() + worlds.LIMIT
        while b"\0" not in self.rest:
            ready, _, _ = select.select([self.reading], [], [], max(0, end - time.monotonic()))
            data = os.read(self.reading, 1 << 20) if ready else b""
            if not data:
                raise Failed("no answer to %s" % what)
            self.rest += data
        message, _, self.rest = self.rest.partition(b"\0")
        return json.loads(message.decode())

    def open(self, path, width=1200, height=800, dark=False):
        """A Page that shows a file, as soon as it has loaded."""
        return self.show("file://" + os.path.abspath(path), width, height, dark)

    def show(self, address, width=1200, height=800, dark=False):
        """A Page that shows what is at an address, as soon as it has loaded."""
        target = self.call("Target.createTarget", url="about:blank")["targetId"]
        session = self.call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        page = Page(self, session)
        for domain in "Page", "Runtime", "Log", "Network":
            page.call(domain + ".enable")
        page.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1,
                  mobile=width < 500)
        scheme = {"name": "prefers-color-scheme", "value": "dark" if dark else "light"}
        page.call("Emulation.setEmulatedMedia", features=[scheme])
        page.call("Page.navigate", url=address)
        page.event("Page.loadEventFired")
        return page


class Page:
    def __init__(self, browser, session):
        self.browser = browser
        self.session = session

    def call(self, method, **parameters):
        return self.browser.call(method, self.session, **parameters)

    def named(self, method):
        """The parameters of all events of this page with this name, so far."""
        return [event["params"] for event in self.browser.events
                if event.get("sessionId") == self.session and event["method"] == method]

    def event(self, method):
        """Wait for the first event of this name."""
        while not self.named(method):
            self.browser.events.append(self.browser.receive(method))
        return self.named(method)[0]

    def run(self, expression):
        """The value of an expression in the page, after its promise if it is one. Raises Failed with what it
        throws.
        """
        found = self.call("Runtime.evaluate", expression=expression, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in found:
            raise Failed(json.dumps(found["exceptionDetails"]))
        return found["result"].get("value")

    def click(self, x, y):
        for kind in "mousePressed", "mouseReleased":
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def press(self, key, text=""):
        self.call("Input.dispatchKeyEvent", type="keyDown", key=key, text=text)
        self.call("Input.dispatchKeyEvent", type="keyUp", key=key)

    def wait(self, expression):
        """Wait until an expression in the page is true; returns it."""
        return worlds.eventually(lambda: self.run(expression), expression)

    def close(self):
        self.call("Page.close")

    def type(self, text):
        self.call("Input.insertText", text=text)

    def complaints(self):
        """What the console has: errors, warnings, exceptions, what the Content-Security-Policy refused."""
        return ([entry["entry"]["text"] for entry in self.named("Log.entryAdded")] +
                [json.dumps(thrown["exceptionDetails"]) for thrown in self.named("Runtime.exceptionThrown")] +
                [json.dumps(said["args"]) for said in self.named("Runtime.consoleAPICalled")])

    def requests(self):
        """The addresses that it has asked for."""
        return [sent["request"]["url"] for sent in self.named("Network.requestWillBeSent")]

    def printed(self):
        """The bytes of a PDF of the page."""
        return base64.b64decode(self.call("Page.printToPDF", preferCSSPageSize=True)["data"])
