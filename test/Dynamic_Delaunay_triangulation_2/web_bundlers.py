# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether bundlers take the npm package as their users do.

    web_bundlers.py PACKAGE NPM NODE CHROMIUM CHROMEDRIVER [BUNDLER...]

PACKAGE is the folder of which `npm pack` makes the package; all bundlers are tried unless some are named. Each bundler gets an empty folder, and there by npm this package
and itself, in the version that stands below. It bundles one program, which needs all three WebAssembly modules. What was
built runs in a folder of its own, in Chromium or Node.js, and has to prove its frames. Writes a table of the sizes of
what was built, and of when the first frame was there.
"""

import contextlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from npm_package import SETTINGS, opened_browser, pack, run, served_folder, title_of_page

PROGRAM = """IMPORT
const points = Float64Array.from({ length: 2000 }, (_, i) => (i * i * 7919) % 10007);

async function main() {
  const told = [];
  for (const options of [{ PLANE }, { cell: { a: [10007, 0], b: [0, 10007] }, PERIODIC }, { classifier: "random:0.5", ALL }]) {
    const triangulation = await Triangulation.create(points, options);
    triangulation.update(points.map((x, i) => x + Math.sin(i)));
    if (told.length === 0) told.push(Math.round(performance.now()));
    if (!triangulation.mend().certified) throw new Error("a frame is not certified");
    told.push(triangulation.edges().length);
  }
  return `told ${told.join(" ")}`;
}

const tell = text => { if (typeof document === "undefined") console.log(text); else document.title = text; };
main().then(tell, error => tell(`${error.name}: ${error.message}`));
"""

MODULES = {"PLANE": "dynamic_delaunay", "PERIODIC": "dynamic_delaunay_periodic", "ALL": "dynamic_delaunay_all"}

PAGE = """<!DOCTYPE html>
<meta charset="utf-8">
<link rel="icon" href="data:,">
<script type="module" src="SCRIPT"></script>
"""

WEBPACK = """import webpack from "webpack";

const build = target => ({
  mode: "production", entry: "./main.js", target, performance: { hints: false },
  output: { path: `${process.cwd()}/${target}`, filename: target === "web" ? "main.js" : "main.cjs" },
});
webpack([build("web"), build("node")], (error, stats) => {
  if (error || stats.hasErrors() || stats.hasWarnings()) {
    console.error(error ?? stats.toString());
    process.exit(1);
  }
});
"""

ROLLUP = """import resolve from "@rollup/plugin-node-resolve";
import { importMetaAssets } from "@web/rollup-plugin-import-meta-assets";

export default { input: "main.js", output: { dir: "dist", format: "es" }, plugins: [resolve(), importMetaAssets()] };
"""


def program(imports='import { Triangulation } from "dynamic-delaunay";'):
    text = PROGRAM.replace("IMPORT", imports)
    for word in MODULES:
        text = text.replace(f", {word} ", " ").replace(f" {word} ", "")
    return text


def program_with_modules():
    """One that gets the WebAssembly modules by imports, and passes them on."""
    lines = ['import { Triangulation } from "dynamic-delaunay";']
    text = PROGRAM
    for word, name in MODULES.items():
        lines.append(f'import {name} from "dynamic-delaunay/{name}.wasm";')
        text = text.replace(f"{word} ", f"wasm: {name} ")
    return text.replace("IMPORT", "\n".join(lines))


class Trial:
    """An empty folder with the package and what else npm installs."""

    def __init__(self, tools, folder):
        self.tools = tools
        self.folder = folder
        folder.mkdir()
        self.write("package.json", '{ "private": true, "type": "module" }')

    def write(self, name, text):
        (self.folder / name).write_text(text)

    def install(self, *packages):
        command = [self.tools.npm, "install", "--prefer-offline", "--fetch-retries=1", "--fetch-timeout=60000", *SETTINGS,
                   self.tools.packed, *packages]
        try:
            finished = subprocess.run(command, cwd=self.folder, text=True, capture_output=True, timeout=240)
            said, is_installed = finished.stdout + finished.stderr, finished.returncode == 0
        except subprocess.TimeoutExpired:
            said, is_installed = "npm has not ended within four minutes", False
        if not is_installed:
            sys.exit(f"npm could not install {' '.join(packages)}, for which this test needs npm's registry:\n{said}")

    def build(self, *command, may_warn=False):
        """Runs a program of npm's in the folder, which has nothing to warn of."""
        said = run(self.folder / "node_modules/.bin" / command[0], *command[1:], folder=self.folder)
        if not may_warn and re.search("warn", said, re.I):
            sys.exit(f"{' '.join(command)}\n{said}")

    def alone(self, built):
        """What was built, moved where nothing else of the folder is."""
        return shutil.copytree(self.folder / built, self.folder.parent / f"{self.folder.name} {built}")

    def in_node(self, script, folder=None):
        return run(self.tools.node, script, folder=folder or self.folder).strip()

    def in_chromium(self, folder, script="main.js"):
        (folder / "index.html").write_text(PAGE.replace("SCRIPT", script))
        with served_folder(folder) as address:
            return title_of_page(self.tools.browser, f"{address}/index.html", r"told [\d ]+")

    @contextlib.contextmanager
    def served_by(self, *command):
        """The address of a server, when it has named it."""
        log = self.folder / "server.log"
        with log.open("w") as output:
            process = subprocess.Popen([self.folder / "node_modules/.bin" / command[0], *command[1:]], cwd=self.folder,
                                       stdout=output, stderr=subprocess.STDOUT, env={**os.environ, "NO_COLOR": "1"})
        try:
            for _ in range(600):
                named = re.search(r"http://127\.0\.0\.1:\d+", log.read_text())
                if named or process.poll() is not None:
                    break
                time.sleep(0.1)
            if not named:
                sys.exit(f"{' '.join(command)} names no address:\n{log.read_text()}")
            yield named.group()
        finally:
            process.terminate()
            process.wait(30)

    def at_server(self, *command):
        with self.served_by(*command, "--host", "127.0.0.1") as address:
            return title_of_page(self.tools.browser, f"{address}/", r"told [\d ]+")


# Each of these yields rows: the name, the folder that was built if there is one, and what the program has told.

def plain_node(trial):
    trial.install()
    trial.write("main.mjs", program())
    yield "Node.js, import", None, trial.in_node("main.mjs")
    if trial.tools.node_version >= (20, 19):
        trial.write("main.cjs", program('const { Triangulation } = require("dynamic-delaunay");'))
        yield "Node.js, require()", None, trial.in_node("main.cjs").splitlines()[0]


def vite(trial, version):
    trial.install(f"vite@{version}")
    trial.write("main.js", program())
    trial.write("index.html", PAGE.replace("SCRIPT", "/main.js"))
    yield f"vite {version}, dev", None, trial.at_server("vite")
    trial.build("vite", "build")
    yield f"vite {version}, build and preview", trial.folder / "dist", trial.at_server("vite", "preview")


def vite_7(trial):
    return vite(trial, "7.3.8")


def vite_8(trial):
    return vite(trial, "8.3.8")


def webpack(trial):
    trial.install("webpack@5.113.0")
    trial.write("main.js", program())
    trial.write("build.mjs", WEBPACK)
    trial.in_node("build.mjs")
    web, node = trial.alone("web"), trial.alone("node")
    yield "webpack 5.113.0, browser", web, trial.in_chromium(web)
    yield "webpack 5.113.0, Node.js", node, trial.in_node("main.cjs", node)


def rollup(trial):
    trial.install("rollup@4.68.8", "@rollup/plugin-node-resolve@16.0.3", "@web/rollup-plugin-import-meta-assets@2.3.3")
    trial.write("main.js", program())
    trial.write("rollup.config.mjs", ROLLUP)
    trial.build("rollup", "--config", "--silent")
    built = trial.alone("dist")
    (built / "package.json").write_text('{ "type": "module" }')
    yield "rollup 4.68.8, Node.js", built, trial.in_node("main.js", built)
    yield "rollup 4.68.8, browser", built, trial.in_chromium(built)


def esbuild(trial):
    trial.install("esbuild@0.28.2")
    trial.write("plain.js", program())
    trial.write("passing.js", program_with_modules())

    def build(source, kind, script, *options):
        trial.build("esbuild", source, "--bundle", "--minify", "--log-level=warning", f"--outfile={kind}/{script}", *options,
                    may_warn="--format=esm" not in options)
        return trial.alone(kind)

    def copy_modules(built):
        for name in MODULES.values():
            shutil.copy(trial.folder / f"node_modules/dynamic-delaunay/{name}.wasm", built)
        return built

    built = copy_modules(build("plain.js", "copied", "main.js", "--format=esm"))
    yield "esbuild 0.28.2, browser, files copied", built, trial.in_chromium(built)
    built = build("passing.js", "addresses", "main.js", "--format=esm", "--loader:.wasm=file")
    yield "esbuild 0.28.2, browser, addresses", built, trial.in_chromium(built)
    built = build("passing.js", "bytes", "main.js", "--format=iife", "--loader:.wasm=binary")
    yield "esbuild 0.28.2, browser, bytes, IIFE", built, trial.in_chromium(built)
    built = copy_modules(build("plain.js", "node_copied", "main.mjs", "--format=esm", "--platform=node"))
    yield "esbuild 0.28.2, Node.js, files copied", built, trial.in_node("main.mjs", built)
    built = build("passing.js", "node_bytes", "main.cjs", "--format=cjs", "--platform=node", "--target=node18",
                  "--loader:.wasm=binary")
    yield "esbuild 0.28.2, Node.js, bytes, CommonJS", built, trial.in_node("main.cjs", built)
    built = build("plain.js", "node_refused", "main.cjs", "--format=cjs", "--platform=node")
    told = trial.in_node("main.cjs", built)
    if not re.match("ModuleError: .*import.meta.url.*give the option wasm", told):
        sys.exit(f"a bundle in CommonJS without the modules says '{told}'")


class Tools:
    def __init__(self, npm, node, browser, packed):
        self.npm, self.node, self.browser, self.packed = npm, node, browser, packed
        version = json.loads(run(node, "-p", "JSON.stringify(process.versions.node.split('.').map(Number))", folder="/"))
        self.node_version = tuple(version)


def size_of(built, *suffixes):
    return sum(path.stat().st_size for path in built.rglob("*") if path.suffix in suffixes)


def sizes(built):
    if not built:
        return ["", ""]
    return [f"{size_of(built, '.js', '.mjs', '.cjs') / 1000:.1f}", f"{size_of(built, '.wasm') / 1000:.1f}"]


def write_table(rows):
    widths = [max(map(len, column)) for column in zip(*rows)]
    for name, *numbers in rows:
        print("  ".join([name.ljust(widths[0]), *(text.rjust(width) for text, width in zip(numbers, widths[1:]))]))


BUNDLERS = {bundle.__name__: bundle for bundle in (plain_node, vite_7, vite_8, webpack, rollup, esbuild)}


def main(package, npm, node, chromium, driver, *names):
    rows, expected = [["", "scripts, kB", "modules, kB", "first frame, ms"]], None
    with tempfile.TemporaryDirectory() as path, opened_browser(chromium, driver) as browser:
        folder = pathlib.Path(path)
        tools = Tools(npm, node, browser, str(folder / pack(npm, package, folder)[0]))
        for bundle in [BUNDLERS[name] for name in names or BUNDLERS]:
            if bundle in (vite_7, vite_8) and tools.node_version < (20, 19):
                print(f"{bundle.__name__} needs Node.js 20.19, and is left out")
                continue
            for name, built, told in bundle(Trial(tools, folder / bundle.__name__)):
                found = re.fullmatch(r"told (\d+) (\d+ \d+ \d+)", told)
                if not found or found.group(2) != (expected or found.group(2)):
                    sys.exit(f"{name}: '{told}', where others found {expected} edges")
                expected = found.group(2)
                rows.append([name, *sizes(built), found.group(1)])
                print(f"{name}: {told}", flush=True)
    write_table(rows)


if __name__ == "__main__":
    main(*sys.argv[1:])
