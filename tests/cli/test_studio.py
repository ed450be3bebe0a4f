"""yoke studio: who may ask, what can be reached, saving and conflicts; and the page in one file.
Run: YOKE=path/of/yoke python3 tests/cli/test_studio.py"""

import base64
import concurrent.futures
import http.client
import json
import os
import re
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import FOUR_BAR, YOKE, Case, Run

INDEX = """<!DOCTYPE html>
<html><head>
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'self'">
<link rel="stylesheet" href="studio.css">
<script src="studio.js" defer></script>
</head>
<body>
<p>Studio</p>
</body>
</html>
"""
SCRIPT = 'window.x = "</script><!--"; if (1 < 2) window.y = 1;\n'
PAGE = {"index.html": INDEX, "studio.css": "p { color: red }\n", "studio.js": SCRIPT, "worker.js": "self.postMessage(1)\n", "plot.js": "window.yokePlot = 1;\n", "film.js": "window.yokeFilm = 1;\n",
        "core.wasm": "\0asm core", "yoke.wasm": "\0asm yoke", "report.js": "a = '</script>';\n", "gallery/a.yaml": "name: </script>\n"}


def make_page(folder):
    for path, text in PAGE.items():
        place = os.path.join(folder, path)
        os.makedirs(os.path.dirname(place), exist_ok=True)
        with open(place, "w", encoding="utf-8") as file:
            file.write(text)


class Served:
    """A server for the time of a test."""

    def __init__(self, folder, *words, page=None):
        environment = {**os.environ, "YOKE_STUDIO": page or os.path.join(folder, "page"), "DISPLAY": "", "WAYLAND_DISPLAY": ""}
        self.process = subprocess.Popen([YOKE, "studio", *words], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        env=environment)
        line = self.process.stdout.readline()
        found = re.match(r"Studio: http://127\.0\.0\.1:(\d+)/\?token=([0-9a-f]{32})\n", line)
        assert found, line + (self.process.stderr.read() if not line else "")
        self.port, self.token = int(found[1]), found[2]

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.end()

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        code = self.process.wait(60)
        self.process.stdout.close()
        self.process.stderr.close()
        return code

    def ask(self, path="/", method="GET", body=None, **headers):
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        headers = {name.replace("_", "-"): value for name, value in headers.items()}
        connection.request(method, path, body=body, headers=headers)
        reply = connection.getresponse()
        reply.data = reply.read()
        connection.close()
        return reply

    def machine(self, method="GET", token=None, **more):
        return self.ask("/machine?token=" + (self.token if token is None else token), method, **more)


class Folder(Case):
    """A folder with a page and a machine, for each test."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="yoke-studio-")
        make_page(os.path.join(self.folder, "page"))
        self.file = os.path.join(self.folder, "four-bar.yaml")
        with open(self.file, "w", encoding="utf-8") as file:
            file.write(FOUR_BAR)

    def tearDown(self):
        shutil.rmtree(self.folder)

    def read(self):
        with open(self.file, encoding="utf-8") as file:
            return file.read()

    def write(self, text):
        with open(self.file, "w", encoding="utf-8") as file:
            file.write(text)

    def serve(self, *words):
        return Served(self.folder, *(words or [self.file]))


class Server(Folder):
    """yoke studio FILE."""

    def test_the_page_and_its_files(self):
        with self.serve() as server:
            for path, text in PAGE.items():
                reply = server.ask("/" + path)
                self.assertEqual((reply.status, reply.data.decode()), (200, text), path)
            root = server.ask("/?token=" + server.token)
            self.assertEqual(root.data.decode(), INDEX)
            self.assertEqual(root.headers["Content-Type"], "text/html; charset=utf-8")
            self.assertEqual(server.ask("/core.wasm").headers["Content-Type"], "application/wasm")
            policy = root.headers["Content-Security-Policy"]
            self.assertIn("default-src 'none'", policy)
            self.assertIn("frame-ancestors 'none'", policy)
            self.assertEqual(root.headers["X-Content-Type-Options"], "nosniff")
            self.assertIsNone(root.headers["Access-Control-Allow-Origin"])

    def test_nothing_else_can_be_reached(self):
        secret = os.path.join(self.folder, "secret.txt")
        with open(secret, "w", encoding="utf-8") as file:
            file.write("secret")
        os.symlink(self.folder, os.path.join(self.folder, "page", ".up"))
        with self.serve() as server:
            for path in ["/../secret.txt", "/..%2fsecret.txt", "/%2e%2e/secret.txt", "/gallery/../../secret.txt", "//etc/passwd", "/etc/passwd",
                         "/.up/secret.txt", "/index.html/", "/four-bar.yaml", "/" + "a" * 3000, "/four-bar.yaml%00.js", "/\\..\\secret.txt",
                         "/gallery", "/gallery/"]:
                reply = server.ask(path)
                self.assertIn(reply.status, (400, 404, 414), path)
                self.assertNotIn(b"secret\n", reply.data + b"\n")
            self.assertEqual(server.ask("/", "POST", body="x").status, 405)
            self.assertEqual(server.machine("DELETE").status, 405)

    def test_only_the_token_opens_the_machine(self):
        with self.serve() as server:
            wrong = ("0" if server.token[0] != "0" else "1") + server.token[1:]
            for token in ["", "0", wrong, server.token[:-1], server.token + "0", server.token.upper() + "x"]:
                self.assertEqual(server.machine(token=token).status, 403, token)
                self.assertEqual(server.machine("PUT", token=token, body="x", If_Match="none").status, 403)
            self.assertEqual(server.ask("/machine").status, 403)
            self.assertEqual(self.read(), FOUR_BAR)
        with self.serve() as other:
            self.assertNotEqual(other.token, server.token)

    def test_no_other_name_and_no_other_page(self):
        with self.serve() as server:
            port = server.port
            for host in ["evil.example", f"evil.example:{port}", "127.0.0.1", f"127.0.0.1:{port + 1}", f"localhost.evil.example:{port}",
                         f"127.0.0.1:{port}.evil.example", "", f"0.0.0.0:{port}"]:
                self.assertEqual(server.machine(Host=host).status, 403, host)
            self.assertEqual(server.machine(Host=f"localhost:{port}").status, 200)
            for origin in ["http://evil.example", "null", f"https://127.0.0.1:{port}", f"http://127.0.0.1:{port + 1}", "file://"]:
                self.assertEqual(server.machine(Origin=origin).status, 403, origin)
                self.assertEqual(server.machine("PUT", body="x", If_Match="none", Origin=origin).status, 403)
            self.assertEqual(server.machine(Origin=f"http://127.0.0.1:{port}").status, 200)
            for site, status in [("cross-site", 403), ("same-site", 403), ("same-origin", 200), ("none", 200)]:
                self.assertEqual(server.machine(Sec_Fetch_Site=site).status, status, site)
            self.assertEqual(self.read(), FOUR_BAR)

    def test_it_listens_on_the_loopback_alone(self):
        with self.serve() as server:
            places = set()
            for table in ("/proc/net/tcp", "/proc/net/tcp6"):
                with open(table, encoding="ascii") as file:
                    rows = [line.split() for line in file][1:]
                places |= {row[1] for row in rows if row[3] == "0A" and row[1].endswith(f":{server.port:04X}")}  # 0A: listening
            self.assertEqual(places, {f"0100007F:{server.port:04X}"})

    def test_saves_whole_and_tells_conflicts(self):
        os.chmod(self.file, 0o640)
        with self.serve() as server:
            first = json.loads(server.machine().data)
            self.assertEqual((first["name"], first["text"]), ("four-bar.yaml", FOUR_BAR))
            self.assertEqual(server.machine(If_None_Match=first["version"]).status, 304)
            text = FOUR_BAR.replace("a: 40", "a: 41 # größer")
            saved = server.machine("PUT", body=text.encode(), If_Match=first["version"])
            self.assertEqual(saved.status, 200)
            self.assertEqual(self.read(), text)
            self.assertEqual(os.stat(self.file).st_mode & 0o777, 0o640)
            second = json.loads(saved.data)["version"]
            self.assertEqual(json.loads(server.machine().data)["version"], second)
            stale = server.machine("PUT", body=b"lost", If_Match=first["version"])
            self.assertEqual((stale.status, json.loads(stale.data)["text"]), (409, text))
            self.write("name: by another editor\n")
            self.assertEqual(server.machine(If_None_Match=second).status, 200)
            conflict = server.machine("PUT", body=text.encode(), If_Match=second)
            self.assertEqual((conflict.status, json.loads(conflict.data)["text"]), (409, "name: by another editor\n"))
            self.assertEqual(self.read(), "name: by another editor\n")
            self.assertEqual(server.machine("PUT", body=b"x").status, 428)
            self.assertEqual(sorted(os.listdir(self.folder)), ["four-bar.yaml", "page"])

    def test_a_file_that_is_not_there_yet(self):
        self.file = os.path.join(self.folder, "new.yaml")
        with self.serve() as server:
            first = json.loads(server.machine().data)
            self.assertEqual((first["name"], first["text"], first["version"]), ("new.yaml", "", "none"))
            self.assertFalse(os.path.exists(self.file))
            self.assertEqual(server.machine("PUT", body=b"name: new\n", If_Match="none").status, 200)
            self.assertEqual(self.read(), "name: new\n")
            os.remove(self.file)
            again = server.machine("PUT", body=b"name: newer\n", If_Match="0" * 16)
            self.assertEqual(again.status, 409)

    def test_what_cannot_be_saved_is_told(self):
        missing = os.path.join(self.folder, "no", "such.yaml")
        with self.serve(missing) as server:
            reply = server.machine("PUT", body=b"name: x\n", If_Match="none")
            self.assertEqual(reply.status, 500)
            self.assertIn("folder does not exist", json.loads(reply.data)["error"])
        with self.serve() as server:
            version = json.loads(server.machine().data)["version"]
            reply = server.machine("PUT", body=b"#" * (9 << 20), If_Match=version)
            self.assertEqual(reply.status, 413)
            self.assertEqual(self.read(), FOUR_BAR)
        with self.serve("--port", str(self.free_port())) as server:
            self.assertEqual(server.machine().status, 404)

    def free_port(self):
        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            return probe.getsockname()[1]

    def test_slow_and_broken_clients_hold_nobody_up(self):
        with self.serve() as server:
            slow = []
            for words in [b"GET / HT", b"PUT /machine?token=" + server.token.encode() + b" HTTP/1.1\r\nHost: 127.0.0.1:%d\r\nIf-Match: x\r\n"
                          b"Content-Length: 100\r\n\r\nhalf" % server.port, b"\xff\x00\r\n\r\n", b""] * 8:
                client = socket.create_connection(("127.0.0.1", server.port))
                client.sendall(words)
                slow.append(client)
            self.assertEqual(server.machine().status, 200)
            self.assertEqual(self.read(), FOUR_BAR)
            for client in slow:
                client.close()
            self.assertEqual(server.machine().status, 200)

    def test_many_connections(self):
        with self.serve() as server:
            with concurrent.futures.ThreadPoolExecutor(16) as pool:
                statuses = list(pool.map(lambda _: server.machine().status, range(1000)))
            self.assertEqual(statuses, [200] * 1000)
            held = []
            try:
                for _ in range(1000):
                    held.append(socket.create_connection(("127.0.0.1", server.port), timeout=5))
            except OSError:
                pass  # no more are taken
            for client in held:
                client.close()
            self.assertEqual(server.machine().status, 200)

    def test_ends_with_a_signal(self):
        for how in (signal.SIGINT, signal.SIGTERM):
            with self.serve() as server:
                with socket.create_connection(("127.0.0.1", server.port)):
                    self.assertEqual(server.end(how), 0)

    def test_what_is_wrong_is_said_before(self):
        page = {"YOKE_STUDIO": os.path.join(self.folder, "page")}
        with self.serve() as server:
            taken = Run("studio", "--port", str(server.port), "--no-browser", env=page)
        self.assertEqual(taken.code, 2)
        self.assertIn("E0722", taken.err)
        for words, code in [(["--port", "70000"], "E0805"), (["-"], "E0805"), ([self.folder], "E0132"), (["--steps", "3"], "E0803")]:
            run = Run("studio", *words, env=page)
            self.assertEqual((run.code, run.out), (2, ""), words)
            self.assertRegex(run.err, r"E0\d{3}", code)
        none = Run("studio", self.file, env={"YOKE_STUDIO": self.folder})
        self.assertEqual(none.code, 2)
        self.assertIn("E0720", none.err)

    def test_a_plugin_that_cannot_be_loaded_is_not_called_missing(self):
        """A copy of the command, alone in a folder, and beside a file that is no library."""
        alone = shutil.copy(YOKE, os.path.join(self.folder, "alone"))
        said = []
        for content in (None, "no library"):
            if content:
                with open(os.path.join(self.folder, "yoke-http.so"), "w", encoding="utf-8") as file:
                    file.write(content)
            run = subprocess.run([alone, "studio", self.file, "--no-browser"], capture_output=True, encoding="utf-8", check=False,
                                 timeout=120, env={**os.environ, "YOKE_STUDIO": os.path.join(self.folder, "page")})
            self.assertEqual((run.returncode, run.stdout), (2, ""), run.stderr)
            said.append(run.stderr)
        self.assertIn("is missing", said[0])
        self.assertIn("cannot be loaded: ", said[1])
        self.assertIn("yoke-http.so", said[1])

    def test_a_long_body_without_the_token_is_dropped(self):
        with self.serve() as server:
            for token, status in (("0", 403), (None, 413)):
                reply = server.machine("PUT", token=token, body="x" * 9_000_000, If_Match="none")
                self.assertEqual(reply.status, status)
            self.assertEqual(self.read(), FOUR_BAR)


class OnePage(Folder):
    """yoke studio FILE -o page.html."""

    def page(self, *words):
        out = os.path.join(self.folder, "out.html")
        run = Run("studio", *words, "-o", out, env={"YOKE_STUDIO": os.path.join(self.folder, "page")})
        self.assertEqual((run.code, run.out, run.err), (0, "", ""))
        with open(out, encoding="utf-8") as file:
            return file.read()

    def test_holds_everything_and_fetches_nothing(self):
        html = self.page(self.file)
        self.assertNotRegex(html, r'(src|href)="(?!data:)')
        for path in ("core.wasm", "yoke.wasm", "worker.js", "report.js"):
            inside = re.search(r'<script type="[^"]*" id="%s">([^<]*)</script>' % re.escape(path), html)[1]
            self.assertEqual(base64.b64decode(inside, validate=True).decode(), PAGE[path])
        data = json.loads(re.search(r'id="yoke-data">(.*?)</script>', html, re.S)[1])
        self.assertEqual(data["machine"], {"name": "four-bar.yaml", "text": FOUR_BAR})
        self.assertEqual(data["files"], {"gallery/a.yaml": PAGE["gallery/a.yaml"]})
        self.assertIn("<style>\np { color: red }", html)
        self.assertIn('"<\\/script><\\!--"; if (1 < 2)', html)
        for later in ("window.yokePlot = 1;", "window.yokeFilm = 1;"):
            self.assertLess(html.index(later), html.index("window.x = "))
        nonces = set(re.findall(r"nonce[=-][\"]?([0-9a-f]{32})", html))
        self.assertEqual(len(nonces), 1)
        self.assertNotIn("script-src 'self'", html)
        self.assertEqual(html.count("</script>"), html.count("<script"))

    def test_a_hostile_machine_stays_text(self):
        text = "name: \"</script><script>alert(1)</script><!--\"\n"
        self.write(text)
        html = self.page(self.file)
        self.assertNotIn("alert(1)</script>", html)
        data = json.loads(re.search(r'id="yoke-data">(.*?)</script>', html, re.S)[1])
        self.assertEqual(data["machine"]["text"], text)

    def test_without_a_machine(self):
        data = json.loads(re.search(r'id="yoke-data">(.*?)</script>', self.page(), re.S)[1])
        self.assertIsNone(data["machine"])

    def test_a_page_that_lacks_a_part(self):
        os.remove(os.path.join(self.folder, "page", "core.wasm"))
        out = os.path.join(self.folder, "out.html")
        run = Run("studio", self.file, "-o", out, env={"YOKE_STUDIO": os.path.join(self.folder, "page")})
        self.assertEqual(run.code, 2)
        self.assertIn("core.wasm", run.err)
        self.assertFalse(os.path.exists(out))


if __name__ == "__main__":
    if not os.path.exists(os.path.join(os.path.dirname(YOKE), "yoke-http.so")):
        Server = None  # built without libmicrohttpd
    unittest.main()
