"""rttop --serve with browsers, real ones and others: if one of these fails, somebody sees what is not so,
does what only looking was meant for, or costs the robot calls.
"""
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import tempfile
import time
import unittest
import urllib.error
import urllib.request

import browser
import processes
import running
import worlds
from worlds import Server, World, eventually

ONCE = "a browser is the same for every Python"
COMMANDS = os.path.dirname(shutil.which("rttop") or os.path.join(processes.ROOT, "bin", "rttop"))
LOOKS = 5 * 2.0  # a second: at each of five components, at 2 Hz

NAMES = "[...document.querySelectorAll('.box .name')].map(each => each.textContent)"
DETAILS = "document.getElementById('details').textContent"
BOX = "[...document.querySelectorAll('.box')].find(each => each.querySelector('.name').textContent === '%s')"


def setUpModule():
    worlds.start_name_server()
    World.robot = World("robot")
    World.error = World("error")


def tearDownModule():
    for world in World.robot, World.error:
        world.close()
    Server.stop()


class Served(unittest.TestCase):
    """An rttop --serve."""

    def setUp(self):
        self.home = tempfile.mkdtemp()
        self.addCleanup(shutil.rmtree, self.home)

    def start(self, *words):
        self.top = "/localhost:%d/test.host_cxt" % Server.port
        more = {
            "RTCTREE_NAMESERVERS": "localhost:%d" % Server.port,
            "RTCSH_CWD": self.top,
            "RTSHELL_TIMEOUT": ("1"),
        }
        self.process = running.start(
            ["rttop", "-r", "5"] + list(words),
            self.home,
            more,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
        )
        self.addCleanup(self.stop)
        self.address = self.process.stdout.readline().decode().strip()

    def stop(self):
        self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        self.process.stderr.close()

    def status(self, address=None, **headers):
        """The HTTP status of a request."""
        request = urllib.request.Request(address or self.address, headers=headers)
        try:
            with urllib.request.urlopen(request, timeout=worlds.LIMIT) as answer:
                return answer.status
        except urllib.error.HTTPError as e:
            with e:
                return e.code

    def events(self):
        """A file of the events that a browser hears."""
        host, port = re.match(r"http://(.*):(\d+)/", self.address).groups()
        made = socket.create_connection((host, int(port)), worlds.LIMIT)
        self.addCleanup(made.close)
        made.sendall(
            (
                "GET %sevents?none HTTP/1.1\r\nHost: %s\r\n\r\n"
                % (self.address[len("http://%s:%s" % (host, port)) :], host)
            ).encode()
        )
        file = made.makefile("rb")
        self.addCleanup(file.close)
        return file

    def hears(self, file, is_so):
        """Read events until is_so({name of a component: [state, words]}, [connections])."""
        found = {"boxes": [], "connections": []}
        now = {}
        while not is_so(
            {box["name"]: now.get(str(number), [None, ""]) for number, box in enumerate(found["boxes"])},
            found["connections"],
        ):
            line = file.readline().decode()
            self.assertTrue(line, "the stream has ended")
            if line.startswith("event: "):
                data = next(each for each in iter(file.readline, b"") if each.startswith(b"data: "))
                data = json.loads(data.decode()[len("data: "):])
                if line == "event: system\n":
                    found = data
                    now = data["now"]
                else:
                    now.update(data)

    def rt(self, *words):
        environment = dict(worlds.ENVIRONMENT, RTCSH_CWD=self.top)
        subprocess.check_call([os.path.join(COMMANDS, words[0])] + list(words[1:]), env=environment)


class Robot(Served):
    """Without a browser."""

    def test_strangers_are_refused(self):
        self.start("--serve", "127.0.0.1:0")
        self.assertRegex(self.address, r"^http://127\.0\.0\.1:\d+/$")
        port = self.address.rsplit(":", 1)[1].strip("/")
        self.assertEqual(self.status(), 200)
        self.assertEqual(self.status(Host="localhost:" + port), 200)
        self.assertEqual(self.status(Host="localhost:9"), 200, "as through a tunnel of ssh")
        self.assertEqual(self.status(Origin=self.address[:-1]), 200)
        self.assertEqual(self.status(Host="attacker.example:" + port), 403)
        self.assertEqual(
            self.status(Host="attacker.example:" + port, Origin="http://attacker.example:" + port), 403
        )
        self.assertEqual(self.status(Origin="http://attacker.example"), 403)
        self.assertEqual(self.status(Origin="null"), 403)
        self.assertEqual(self.status(Origin="https://127.0.0.1:" + port), 403)
        self.assertEqual(self.status(self.address + "other"), 404)
        self.assertEqual(self.status(self.address + "../../etc/passwd"), 404)

    def test_others_need_the_token(self):
        """127.0.0.2 is this host's, too; so every address of this host serves as another one."""
        self.start("--serve", "0.0.0.0:0")
        self.assertRegex(self.address, r"^http://[0-9.]+:\d+/[0-9a-f]{32}/$")
        port, token = re.match(r".*:(\d+)/(\w+)/", self.address).groups()
        self.assertEqual(self.status(), 200)
        self.assertEqual(self.status("http://127.0.0.2:%s/%s/" % (port, token)), 200)
        wrong = token[:-1] + ("0" if token[-1] != "0" else "1")
        for path in (
            "/",
            "//",
            "/x",
            "/%s/" % wrong,
            "/%s/" % token[:-1],
            "/%s" % token.upper(),
            "/%s/events?x" % wrong,
        ):
            self.assertIn(self.status("http://127.0.0.2:%s%s" % (port, path)), (403, 404), path)
        self.assertEqual(self.status("http://127.0.0.2:%s/%s/" % (port, token), Host="attacker.example"), 403)

    def test_nothing_can_be_changed(self):
        self.start("--serve", "127.0.0.1:0")
        for method in "POST", "PUT", "DELETE", "OPTIONS", "PATCH":
            request = urllib.request.Request(self.address, method=method)
            with self.assertRaises(urllib.error.HTTPError) as caught:
                urllib.request.urlopen(request, timeout=worlds.LIMIT)
            caught.exception.close()
            self.assertEqual(caught.exception.code, 405)

    def test_it_is_live(self):
        """States, connections, components that come and go."""
        self.start("--serve", "127.0.0.1:0")
        file = self.events()
        self.hears(file, lambda states, lines: states.get("Motor0") == ["Inactive", ""] and len(lines) == 4)
        file = self.events()
        self.rt("rtact", "Motor0.rtc")
        self.addCleanup(self.rt, "rtdeact", "Motor0.rtc")
        self.hears(file, lambda states, _: states.get("Motor0", [""])[0] == "Active" and
                   states["Motor0"][1].startswith("Inactive to Active (seen at "))
        file = self.events()
        self.rt("rtdis", "Hokuyo_AIST0.rtc:ranges")
        self.addCleanup(self.rt, "rtcon", "Hokuyo_AIST0.rtc:ranges", "Clusterer0.rtc:ranges")
        self.hears(file, lambda _, lines: len(lines) == 3)
        file = self.events()
        world = World("these", "ConsoleIn:Late0")
        try:
            self.hears(file, lambda states, _: states.get("Late0", [""])[0] == "Inactive")
        finally:
            world.close()
        file = self.events()
        self.hears(file, lambda states, _: states.get("Late0", [""])[0] == "Unknown" and
                   "connection refused" in states["Late0"][1])
        file = self.events()
        self.rt("rtdel", "Late0.rtc")
        self.hears(file, lambda states, _: states and "Late0" not in states)

    def test_five_cost_no_more_than_one(self):
        counts = []
        for browsers in 1, 5:
            self.start("--serve", "127.0.0.1:0", "./Sensor0.rtc")
            files = [self.events() for _ in range(browsers)]
            for file in files:
                self.hears(file, lambda states, _: "Sensor0" in states)
                self.assertEqual(self.status(), 200)
            World.robot.ctl("reset")
            begun = time.monotonic()
            eventually(lambda: World.robot.count("get_component_state") >= 20, "looks")
            calls = World.robot.ctl("calls").split()
            counts.append((time.monotonic() - begun, dict(zip(calls[1::2], map(int, calls[::2])))))
            self.stop()
        for seconds, counted in counts:
            states = counted.pop("get_component_state")
            self.assertLessEqual(states, 2 * LOOKS * (1 + seconds))
            self.assertLessEqual(sum(counted.values()), 3 * states, counts)

    def test_it_ends(self):
        for number, status in (signal.SIGINT, 130), (signal.SIGTERM, 143):
            self.start("--serve", "127.0.0.1:0")
            file = self.events()
            file.readline()
            self.process.send_signal(number)
            self.assertEqual(self.process.wait(worlds.LIMIT), status)
            self.assertEqual(self.process.stderr.read(), b"")

    def test_a_port_alone(self):
        """It was taken for a name server, and the page was at another port."""
        for form in "%d", ":%d":
            with socket.socket() as free:
                free.bind(("127.0.0.1", 0))
                port = free.getsockname()[1]
            self.start("--serve", form % port)
            self.assertEqual(self.address, "http://127.0.0.1:%d/" % port)
            with urllib.request.urlopen(self.address, timeout=worlds.LIMIT) as answer:
                policy = answer.headers["Content-Security-Policy"]
                html = answer.read().decode()
            self.assertIn("frame-ancestors 'none'", policy)
            self.assertIn(policy.replace("; frame-ancestors 'none'", ""), html)

    def test_an_address_in_use(self):
        self.start("--serve", "127.0.0.1:0")
        port = self.address.rsplit(":", 1)[1].strip("/")
        self.start("--serve", "127.0.0.1:" + port)
        self.assertEqual(self.process.wait(worlds.LIMIT), 1)
        self.assertRegex(
            self.process.stderr.read().decode(), "^rttop: --serve 127.0.0.1:%s: .*in use\n$" % port
        )


@unittest.skipUnless(browser.program(), "needs Chromium (Debian's package chromium)")
class Browsers(Served):
    @classmethod
    def setUpClass(cls):
        cls.chromium = browser.Browser()

    @classmethod
    def tearDownClass(cls):
        cls.chromium.close()

    def open(self, **view):
        """The page in a browser; at the end it must have complained of nothing and asked nobody else."""
        page = self.chromium.show(self.address, **view)
        self.addCleanup(self.leave, page)
        page.wait("document.querySelectorAll('.box').length > 7")
        return page

    def leave(self, page):
        self.assertEqual(page.complaints(), [])
        self.assertEqual([each for each in page.requests() if not each.startswith(self.address)], [])
        page.close()

    def come_and_go(self, page, name):
        """A component comes, is on the page, and its process ends; its name stays until the test ends."""
        world = World("these", "ConsoleIn:" + name)
        try:
            page.wait(NAMES + ".includes('%s')" % name)
        finally:
            world.close()
        self.addCleanup(self.rt, "rtdel", name + ".rtc")

    def test_it_shows_what_changes(self):
        self.start("--serve", "127.0.0.1:0")
        page = self.open()
        page.wait("document.getElementById('live').textContent.includes('live')")
        page.run("document.getElementById('search').focus()")
        page.type("motor")
        page.press("Enter", "\r")
        page.wait(DETAILS + ".includes('Inactive')")
        self.rt("rtact", "Motor0.rtc")
        self.addCleanup(self.rt, "rtdeact", "Motor0.rtc")
        page.wait((BOX % "Motor0") + ".getAttribute('class') === 'box Active selected hit'")
        page.wait(DETAILS + ".includes('Active: Inactive to Active (seen at')")
        self.assertEqual(page.run("document.getElementById('search').value"), "motor")
        World.error.ctl("error", "Err0")
        self.addCleanup(self.rt, "rtreset", "Err0.rtc")
        page.wait((BOX % "Err0") + ".getAttribute('class').includes('Error broken')")
        page.wait("document.getElementById('status').textContent === 'Err0: ✖ Error'")
        page.press("Escape")
        World.robot.ctl("error", "Motor0")
        self.addCleanup(self.rt, "rtreset", "Motor0.rtc")
        page.wait("document.getElementById('status').textContent === 'Motor0: ✖ Error'")
        page.run("document.getElementById('search').value = ''; "
                 "document.getElementById('search').dispatchEvent(new Event('input'))")
        page.wait("document.querySelector('#list .link').textContent.includes('Broken0')")

    def test_selection_folds_and_focus_stay(self):
        """Selection, folded groups, focus, where the map is."""
        self.start("--serve", "127.0.0.1:0")
        page = self.open()
        page.run("select(data.boxes.findIndex(each => each.name === 'Controller0'))")
        page.run("document.querySelector('#details summary').click()")
        page.run((BOX % "Sensor0") + ".focus()")
        page.run("zoom(3); document.getElementById('map').scrollTo(77, 33)")
        where = (
            "[element('map').scrollLeft, element('map').scrollTop, document.querySelector('#details "
            "details').open]"
        )
        before = page.run(where)
        self.come_and_go(page, "More0")
        page.wait((BOX % "More0") + ".getAttribute('class').includes('Unknown')")
        self.assertEqual(page.run("document.activeElement.querySelector('.name').textContent"), "Sensor0")
        self.assertEqual(page.run("document.querySelector('#details h2').textContent"), "Controller0")
        self.assertEqual(page.run(where), before)

    def test_buttons_lead_where_they_say(self):
        """Also after components have come that are before theirs, and what was broken is well again."""
        self.start("--serve", "127.0.0.1:0")
        page = self.open()
        page.run("select(data.boxes.findIndex(each => each.name === 'Motor0'))")
        far = "document.querySelector('#details .connection button')"
        page.wait(far + " !== null")  # connections are asked for after states
        page.run(far + ".focus()")
        self.assertEqual(page.run(far + ".textContent"), "Controller0:out")
        World.robot.ctl("error", "Controller0")
        page.wait(far + ".className === 'link broken'")
        self.rt("rtreset", "Controller0.rtc")
        page.wait(far + ".className === 'link'")
        self.come_and_go(page, "Another0")
        self.assertEqual(page.run("document.activeElement.textContent"), "Controller0:out")
        page.run(far + ".click()")
        self.assertEqual(page.run("document.querySelector('#details h2').textContent"), "Controller0")

    def test_a_map_that_grows_is_seen_whole(self):
        """Unless a person has zoomed."""
        self.start("--serve", "127.0.0.1:0")
        page = self.open()
        whole = ("['Width', 'Height'].every(side => element('map')['scroll' + side] <= "
                 "element('map')['client' + side])")
        page.wait(whole)
        wide, high = page.run("[picture.width, picture.height]")
        names = ["Grown%d" % number for number in range(16)]
        world = World("these", *["ConsoleIn:" + name for name in names])
        self.addCleanup(self.rt, "rtdel", *[name + ".rtc" for name in names])
        self.addCleanup(world.close)
        page.wait(NAMES + ".filter(each => each.startsWith('Grown')).length === 16")
        page.wait(whole)
        self.assertGreater(page.run("picture.width * picture.height"), 1.5 * wide * high)

    def test_a_server_that_ends(self):
        self.start("--serve", "127.0.0.1:0")
        page = self.chromium.show(self.address)  # it may complain
        page.wait("document.getElementById('live').textContent.includes('live')")
        self.process.send_signal(signal.SIGINT)
        page.wait("document.getElementById('live').textContent.startsWith('not live since')")
        page.close()

    def test_hostile_strings_stay_text(self):
        """Components all of whose strings are hostile, among them <script>; also when one changes, and when
        it dies.
        """
        world = World("hostile", "--context", "h.host_cxt/%n.rtc")
        self.addCleanup(running.run, ["rtdel", "-z", "/localhost:%d/h.host_cxt" % Server.port], self.home)
        try:
            self.start("--serve", "127.0.0.1:0")
            page = self.open()
            page.wait("data.boxes.some((box) => (box.path || '').includes('h.host_cxt') && box.parts.length)")
            number = page.run("data.boxes.findIndex((box) => (box.path || '').includes('h.host_cxt') && "
                              "box.parts.length)")
            page.run("select(%d)" % number)
            self.assertIn("<script", page.run(DETAILS))
        finally:
            world.close()
        page.wait("data.boxes.some((box) => (box.path || '').includes('h.host_cxt') && box.state === "
                  "'Unknown')")
        self.assertEqual(
            page.run("[document.querySelectorAll('script').length, document.images.length]"), [2, 0]
        )

    def test_a_phone(self):
        self.start("--serve", "0.0.0.0:0")
        page = self.open(width=390, height=760, dark=True)
        page.wait("document.getElementById('live').offsetWidth > 0")
        self.assertLessEqual(page.run("document.documentElement.scrollWidth"), 390)


if __name__ == "__main__":
    unittest.main()
