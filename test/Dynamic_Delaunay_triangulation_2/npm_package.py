# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether the npm package can be used by its name, where nothing else is.

    npm_package.py PACKAGE NPM NODE TSC CHROMIUM CHROMEDRIVER

PACKAGE is the folder of which `npm pack` makes the package. It is installed in an empty folder, without a network. There a
program of Node.js and a page in Chromium import it by its name, and have to prove their frames; its own example has to run;
tsc has to accept a program by the package's types, and to refuse one that is wrong.
"""

import contextlib
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import threading

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings" / "web"))
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
const pairs: [number, number][] = [[0, 0], [1, 0]];
const rows = await Triangulation.create(pairs, { wasm: new URL("file:///dynamic_delaunay.wasm") });
rows.remove(4), rows.remove(new Set([4])), rows.remove(Int32Array.of(4)), rows.boundedCells({ domain: pairs });
rows.neighbors(), rows[Symbol.dispose]();
const said = (error: unknown) => error instanceof DynamicDelaunayError ? error.details.id ?? error.name : undefined;
export { report, said, shifts };
"""

# As TypeScript finds it by the package's exports.
TYPED_BUNDLE = """import { Triangulation } from "dynamic-delaunay";
import wasm from "dynamic-delaunay/dynamic_delaunay_all.wasm";
await Triangulation.create([], { wasm });
await Triangulation.choices({ wasm });
"""

REFUSED = """import { Triangulation } from "dynamic-delaunay";
await Triangulation.create([], { colour: 1 });
await Triangulation.create(["0", "1"]);
(await Triangulation.create()).report.flip;
(await Triangulation.create()).isCertified = true;
new Triangulation();
await Triangulation.create("0011");
(await Triangulation.create()).remove("4");
(await Triangulation.create()).boundedCells({ Radius: 3 });
await Triangulation.create([], { wasm: 7 });
"""


SETTINGS = "--no-update-notifier", "--no-audit", "--no-fund", "--ignore-scripts"


def run(*command, folder, is_refused=False, timeout=300):
    """What a command writes, which has to succeed, or to fail if it is refused."""
    words = [*map(str, command)]
    try:
        finished = subprocess.run(words, cwd=folder, text=True, capture_output=True, timeout=timeout)
    except subprocess.TimeoutExpired:
        sys.exit(f"{' '.join(words)}\nhas not ended within {timeout} seconds")
    if (finished.returncode == 0) == is_refused:
        said = "\n".join(line[:500] for line in (finished.stdout + finished.stderr).splitlines())  # not a whole bundle
        sys.exit(f"{' '.join(words)}\n{said}")
    return finished.stdout + finished.stderr


def pack(npm, package, folder):
    """Makes the package; the name of its file, and its size."""
    packed, = json.loads(run(npm, "pack", "--json", "--loglevel=error", "--pack-destination", folder, *SETTINGS, package, folder=folder))
    return packed["filename"], packed["size"]


def install(npm, package, folder):
    """Packs the folder, and installs what comes of it."""
    filename, size = pack(npm, package, folder)
    run(npm, "install", "--offline", *SETTINGS, f"./{filename}", folder=folder)
    installed = folder / "node_modules/dynamic-delaunay"
    names = sorted(path.name for path in installed.iterdir())
    expected = sorted({"LICENSE", "README.md", "package.json", *json.loads((installed / "package.json").read_text())["files"]})
    if names != expected:
        sys.exit(f"the package has {names}, not {expected}")
    print(f"{filename} has {size} bytes")


def checks_types(tsc, folder):
    # As Node.js and as bundlers look for a package's types.
    for module, resolution in ("node16", "node16"), ("esnext", "node"):
        options = ("--strict", "--noEmit", "--target", "es2022", "--lib", "es2022,dom",
                   "--module", module, "--moduleResolution", resolution)
        (folder / "typed.mts").write_text(TYPED)
        run(tsc, *options, "typed.mts", folder=folder)
        if module == "node16":
            (folder / "bundle.mts").write_text(TYPED_BUNDLE)
            run(tsc, *options, "bundle.mts", folder=folder)
        (folder / "refused.mts").write_text(REFUSED)
        said = run(tsc, *options, "refused.mts", folder=folder, is_refused=True)
        if set(re.findall(r"^\S*\(\d+|^\S+", said, re.M)) != {f"refused.mts({line}" for line in range(2, 11)}:
            sys.exit(f"each line but the first is wrong, not what tsc says:\n{said}")


@contextlib.contextmanager
def opened_browser(chromium, driver):
    from selenium import webdriver
    from selenium.webdriver.chrome.service import Service

    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    for option in "--headless=new", "--no-sandbox", "--disable-3d-apis":
        options.add_argument(option)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(driver), options=options)
    try:
        yield browser
    finally:
        browser.quit()


def title_of_page(browser, address, ending="done"):
    """The title of a page when it has such an ending or names an error, and what the browser complains of."""
    from selenium.common.exceptions import TimeoutException
    from selenium.webdriver.support.ui import WebDriverWait

    complaints = []

    def is_over(_):
        complaints.extend(entry["message"] for entry in browser.get_log("browser") if entry["level"] in ("SEVERE", "WARNING"))
        return complaints or re.search(f"(?:{ending})$|[Ee]rror", browser.title)

    browser.get(address)
    try:
        WebDriverWait(browser, 60).until(is_over)
    except TimeoutException:
        complaints.append("nothing more has happened within a minute")
    return " ".join([browser.title, *complaints])


@contextlib.contextmanager
def served_folder(folder):
    with server(folder) as served:
        threading.Thread(target=served.serve_forever, daemon=True).start()
        try:
            yield f"http://127.0.0.1:{served.server_port}"
        finally:
            served.shutdown()


def main(package, npm, node, tsc, chromium, driver):
    with tempfile.TemporaryDirectory() as path:
        folder = pathlib.Path(path)
        install(npm, package, folder)
        (folder / "program.mjs").write_text(PROGRAM)
        told = run(node, "program.mjs", folder=folder).split()
        checks_types(tsc, folder)
        (folder / "index.html").write_text(PAGE)
        with opened_browser(chromium, driver) as browser, served_folder(folder) as address:
            title = title_of_page(browser, f"{address}/index.html")
            if title.split(",") != [*told, "done"]:
                sys.exit(f"the page says '{title}', the program {told}")
            title = title_of_page(browser, f"{address}/node_modules/dynamic-delaunay/example.html", "Delaunay: true")
            if title != "Delaunay: true":
                sys.exit(f"the example says '{title}'")
    print("a program, a page and the example import it, and its types are right")


if __name__ == "__main__":
    main(*sys.argv[1:])
