#!/usr/bin/python3
# SPDX-License-Identifier: MIT
"""Measures how smoothly pages play in Chromium, as JSON: tests/benchmark/page_speed.py BOXREEL [SCENE:LAYERS ...]

Each page plays for five seconds. How many frames a second were drawn, the longest time between two of
them, and the time of the page's own code for one [ms].
"""

import functools
import http.server
import json
import subprocess
import sys
import tempfile
import threading
from pathlib import Path

SCENES = ["pyramid:shapes,contacts", "tumbler:shapes,contacts,aabbs,centers",  # 1,011 and 1,505 shapes at the end
          "rain:shapes,contacts,aabbs,centers", "many-pyramids:shapes,joints,names"]
MEASURE = """
(async () => {
  const player = await opened, ends = [], costs = [];
  const draw = player.draw.bind(player);
  player.draw = () => {
    const begin = performance.now();
    draw();
    costs.push(performance.now() - begin);
  };
  const tick = now => { ends.push(now); requestAnimationFrame(tick); };
  player.play();
  requestAnimationFrame(tick);
  await new Promise(done => setTimeout(done, 5000));
  const shown = costs.length, gaps = ends.slice(1).map((end, i) => end - ends[i]).sort((a, b) => a - b);
  costs.sort((a, b) => a - b);
  let shapes = 0;
  for (const track of player.frame.tracks) shapes += track.form.items.length;
  fetch("/result", {method: "POST", body: JSON.stringify({
    shapes, framesPerSecond: 1000 * gaps.length / gaps.reduce((a, b) => a + b), drawn: shown,
    medianGap: gaps[gaps.length >> 1], longestGap: gaps[gaps.length - 1], medianCode: costs[costs.length >> 1]})});
})();
"""


class Pages(http.server.SimpleHTTPRequestHandler):
    """Serves a folder, and keeps what a page sends."""

    def do_POST(self):  # noqa: N802 (the name is http.server's)
        self.server.result = json.loads(self.rfile.read(int(self.headers["Content-Length"])))
        self.send_response(204)
        self.end_headers()
        self.server.done.set()

    def log_message(self, *_):
        pass


def measure(boxreel, scene, folder):
    """Returns the figures of a page."""
    scene, layers = scene.split(":")
    page = folder / "page.html"
    subprocess.run([boxreel, "record", scene, "--draw", layers, "-o", page, "--force", "--progress",
                    "none"], check=True)
    text = page.read_text("utf-8")
    page.write_text(text.replace("default-src 'none'", "default-src 'none'; connect-src 'self'").replace(
        "</body>", f"<script>{MEASURE}</script></body>"), "utf-8")
    server = http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Pages, directory=folder))
    server.done = threading.Event()
    threading.Thread(target=server.serve_forever, daemon=True).start()
    browser = subprocess.Popen(
        ["chromium", "--headless", "--no-sandbox", "--disable-gpu", "--window-size=1300,900",
         "--no-first-run", "--no-proxy-server", f"--user-data-dir={folder / 'profile'}", "--remote-debugging-port=0",
         f"http://127.0.0.1:{server.server_port}/page.html"], stderr=subprocess.DEVNULL, stdout=subprocess.DEVNULL)
    try:
        if not server.done.wait(60):
            sys.exit(f"page_speed.py: the page of '{scene}' sent nothing; open {page} in a browser")
    finally:
        browser.terminate()
        browser.wait()
        server.shutdown()
    return {"scene": scene, "layers": layers, "bytes": len(text), **server.result}


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit("page_speed.py: no program; run tests/benchmark/page_speed.py build/release/boxreel [SCENE:LAYERS ...]")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as work:
        print(json.dumps([measure(sys.argv[1], scene, Path(work)) for scene in sys.argv[2:] or SCENES], indent=1))
