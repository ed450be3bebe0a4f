"""Where the package yoke is installed: it serves Studio's page, whole, with its modules. Exit code 0: it does."""
import re
import signal
import subprocess
import urllib.request

server = subprocess.Popen(["yoke", "studio", "/usr/share/yoke/examples/four-bar.yaml", "--no-browser"], stdout=subprocess.PIPE, text=True)
try:
    root, token = re.match(r"Studio: (http://127\.0\.0\.1:\d+/)\?token=([0-9a-f]{32})\n", server.stdout.readline()).groups()
    page = urllib.request.urlopen(root + "?token=" + token).read().decode()
    assert "<html" in page, page[:200]
    for name in "studio.js", "studio.css", "core.wasm", "yoke.wasm", "report.js":
        assert len(urllib.request.urlopen(root + name).read()) > 1000, name
    machine = urllib.request.urlopen(root + "machine?token=" + token).read().decode()
    assert "Four-bar" in machine and "coupler" in machine, machine[:200]
finally:
    server.send_signal(signal.SIGINT)
assert server.wait(30) in (0, 130)
print("Studio's page: served")
