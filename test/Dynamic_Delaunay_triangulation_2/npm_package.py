# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether the npm package can be used by its name, where nothing else is.

    npm_package.py PACKAGE NPM NODE TSC CHROMIUM CHROMEDRIVER

PACKAGE is the folder of which `npm pack` makes the package. It is installed in an empty folder, without a network. There a
program of Node.js and a page in Chromium import it by its name, and have to prove their frames; tsc has to accept a program
by the package's types, and to refuse one that is wrong.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "page"))
from serve import server  # noqa: E402

PROGRAM = """import { Triangulation } from "dynamic-delaunay";

const points = Float64Array.from({ length: 2000 }, (_, i) => (i * i * 7919) % 10007);
for (const cell of [undefined, { a: [10007, 0], b: [0, 10007] }]) {
  const triangulation = await Triangulation.create(points, cell && { cell });
  const report = triangulation.update(points.map((x, i) => x + Math.sin(i)));
  if (!report.certified) throw new Error("a frame is not certified");
  console.log(triangulation.edges().length);
}
"""

PAGE = """<!DOCTYPE html>
<meta charset="utf-8">
<script type="importmap">{"imports": {"dynamic-delaunay": "./node_modules/dynamic-delaunay/dynamic_delaunay.mjs"}}</script>
<script type="module">
console.log = number => document.title += number + ",";
addEventListener("unhandledrejection", event => document.title = event.reason);
""" + PROGRAM + """document.title += "done";
</script>
"""

TYPED = """import { DynamicDelaunayError, Triangulation, type Cell, type Report } from "dynamic-delaunay";

const cell: Cell = { a: [1, 0], b: [0.2, 1] };
const triangulation: Triangulation = await Triangulation.create([0, 0, 0.3, 0.4], { cell, classifier: "circumcircle" });
const report: Report = triangulation.update(new Float64Array(4).fill(0.5));
const shifts: Int32Array = triangulation.edgesWithShifts().shifts;
const numbers: Record<string, number> = new DynamicDelaunayError().details;
export { numbers, report, shifts };
"""

REFUSED = """import { Triangulation } from "dynamic-delaunay";
await Triangulation.create([], { colour: 1 });
await Triangulation.create(["0", "1"]);
(await Triangulation.create()).report.flip;
(await Triangulation.create()).isCertified = true;
"""


def run(*command, folder, is_refused=False):
    finished = subprocess.run([*map(str, command)], cwd=folder, text=True, capture_output=True)
    if (finished.returncode == 0) == is_refused:
        sys.exit(f"{' '.join(map(str, command))}\n{finished.stdout}{finished.stderr}")
    return finished.stdout


def install(npm, package, folder):
    """Packs the folder, and installs what comes of it."""
    settings = "--no-update-notifier", "--no-audit", "--no-fund", "--ignore-scripts"
    packed, = json.loads(run(npm, "pack", "--json", "--pack-destination", folder, *settings, package, folder=folder))
    run(npm, "install", "--offline", *settings, f"./{packed['filename']}", folder=folder)
    installed = folder / "node_modules/dynamic-delaunay"
    names = sorted(path.name for path in installed.iterdir())
    expected = sorted({"LICENSE", "README.md", "package.json", *json.loads((installed / "package.json").read_text())["files"]})
    if names != expected:
        sys.exit(f"the package has {names}, not {expected}")
    print(f"{packed['filename']} has {packed['size']} bytes")


def checks_types(tsc, folder):
    # As Node.js and as bundlers look for a package's types.
    for module, resolution in ("node16", "node16"), ("esnext", "node"):
        options = ("--strict", "--noEmit", "--target", "es2022", "--lib", "es2022,dom",
                   "--module", module, "--moduleResolution", resolution)
        (folder / "typed.mts").write_text(TYPED)
        run(tsc, *options, "typed.mts", folder=folder)
        (folder / "refused.mts").write_text(REFUSED)
        said = run(tsc, *options, "refused.mts", folder=folder, is_refused=True)
        if set(re.findall(r"^\S*\(\d+|^\S+", said, re.M)) != {f"refused.mts({line}" for line in range(2, 6)}:
            sys.exit(f"each line but the first is wrong, not what tsc says:\n{said}")


def shown_in_browser(chromium, driver, folder):
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.support.ui import WebDriverWait

    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for option in "--headless=new", "--no-sandbox", "--disable-3d-apis":
        options.add_argument(option)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    (folder / "index.html").write_text(PAGE)
    with server(folder) as served:
        threading.Thread(target=served.serve_forever, daemon=True).start()
        browser = webdriver.Chrome(service=Service(driver), options=options)
        complaints = []

        def is_over(_):
            complaints.extend(entry["message"] for entry in browser.get_log("browser"))
            return complaints or re.search("done|[Ee]rror", browser.title)

        try:
            browser.get(f"http://127.0.0.1:{served.server_port}/index.html")
            WebDriverWait(browser, 60).until(is_over)
            return " ".join([browser.title, *complaints])
        finally:
            browser.quit()
            served.shutdown()


def main(package, npm, node, tsc, chromium, driver):
    with tempfile.TemporaryDirectory() as path:
        folder = pathlib.Path(path)
        install(npm, package, folder)
        (folder / "program.mjs").write_text(PROGRAM)
        told = run(node, "program.mjs", folder=folder).split()
        checks_types(tsc, folder)
        title = shown_in_browser(chromium, driver, folder)
        if title.split(",") != [*told, "done"]:
            sys.exit(f"the page says '{title}', the program {told}")
    print("a program and a page import it, and its types are right")


if __name__ == "__main__":
    main(*sys.argv[1:])
