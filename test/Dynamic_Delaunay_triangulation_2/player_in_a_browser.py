# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether the page that `run_scenario --html` writes plays a run in Chromium, on a desktop's screen and on a phone's.

    player_in_a_browser.py CHROMIUM RUN_SCENARIO [DIRECTORY]

Runs in the plane, in periodic space, with a heuristic classifier and of points that come and go are written, and opened in
frames of both widths. There the pages are scrubbed, played, zoomed and switched as a person does it. On each frame what
the page says of its number, of points and edges has to be what `--csv` and `--vtk` have, every change has to change the
picture, and nothing may be wider than the screen, or be written to the console. With a DIRECTORY pictures of the pages,
light and dark, are put there to be looked at.
"""

import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

SCREENS = {"desktop": (1280, 800), "phone": (390, 844)}
COMING_AND_GOING = "frame,id,x,y\n" + "".join(
    f"{100 + 5 * frame},p{i},{(i * 37 % 100) / 10 + 0.01 * frame * (i % 5)},{(i * 61 % 97) / 10}\n"
    for frame in range(12) for i in range(40 + frame) if (i + frame) % 11)
RUNS = {
    "plane": ["dam_break", "--points", "300", "--frames", "40"],
    "periodic": ["brownian_periodic", "--points", "200", "--frames", "12"],
    "heuristic": ["explosion", "--points", "300", "--frames", "30", "--classifier", "random:0.01"],
    "population": ["coming & <going>.csv"],
}

WATCHER = """<!DOCTYPE html><pre id="found"></pre><script>
const runs = RUNS, screens = SCREENS, faults = [];

async function look(name, expected, screen, [width, height]) {
  const frame = document.body.appendChild(document.createElement("iframe"));
  frame.style = `position: absolute; top: 0; left: 0; border: 0; width: ${width}px; height: ${height}px`;
  await new Promise(done => { frame.onload = done; frame.src = expected.timed; });
  const page = frame.contentDocument, window = frame.contentWindow, $ = id => page.getElementById(id);
  const drawing = () => new Promise(done => setTimeout(done, 50));
  await drawing();
  const check = (holds, text) => holds || faults.push(`${name} on a ${screen}: ${text}`);
  const drawn = () => $("picture").toDataURL();
  const pressed = key => page.body.dispatchEvent(new window.KeyboardEvent("keydown", { key, bubbles: true }));
  async function changes(text, act) {
    const before = drawn();
    act();
    await drawing();
    check(drawn() !== before, `${text} does not change the picture`);
  }
  const scrub = place => {
    $("slider").value = place;
    $("slider").dispatchEvent(new window.Event("input"));
  };

  check(page.title.includes(expected.title) && $("name").textContent.includes(expected.title), "its title is " + page.title);
  check(page.documentElement.scrollWidth <= width, `it is ${page.documentElement.scrollWidth} wide`);
  for (const part of page.querySelectorAll("button, select, label, output, p, h1, figcaption")) {
    const box = part.getBoundingClientRect();
    check(box.width === 0 || (box.left >= 0 && box.right <= width + 0.5), `"${part.textContent}" leaves the screen`);
    check(part.scrollWidth <= Math.ceil(box.width) + 1 || box.width === 0, `"${part.textContent}" is cut`);
  }
  const last = expected.frames.length - 1;
  check(Number($("slider").max) === last, `it has ${$("slider").max} frames after the first`);
  const order = [...expected.frames.keys()].map(k => k * 7 % (last + 1));
  for (const place of new Set([...order, last, 0])) { // to and fro
    scrub(place);
    const { number, points, edges, wrong, certified } = expected.frames[place], said = $("state").textContent;
    check($("shown").textContent.includes(`frame ${number} of ${expected.frames[last].number}`), $("shown").textContent);
    check(said.includes(`${points} points`) && said.includes(`${edges} edges`), `frame ${place} has ${points} points ` +
      `and ${edges} edges, not: ${said}`);
    check(said.includes("certified") === certified, `frame ${place}: ${said}`);
    check(said.includes("wrong") === wrong, `frame ${place}: ${said}`);
  }
  await changes("scrubbing", () => scrub(last));
  await changes("Home", () => pressed("Home"));
  await changes("End", () => pressed("End"));
  for (let k = 0; k !== 900 && $("told").hidden; ++k) { // until a point is near
    const at = { clientX: k % 30 / 30 * width, clientY: Math.floor(k / 30) / 30 * height };
    $("picture").dispatchEvent(new window.PointerEvent("pointermove", at));
  }
  check(RegExp(`^point ${expected.id} at `).test($("told").textContent), `it tells "${$("told").textContent}"`);
  await changes("the button back", () => $("back").click());
  scrub(last - 1);
  for (const layer of ["edges", "points", "voronoi", "circumcircles", "speeds"]) {
    await changes(layer, () => $("layer-" + layer).click());
    await changes(layer, () => $("layer-" + layer).click());
  }
  await changes("zoom", () => $("closer").click());
  await changes("dragging", () => {
    for (const [type, x] of [["pointerdown", 100], ["pointermove", 140], ["pointerup", 140]]) {
      $("picture").dispatchEvent(new window.PointerEvent(type, { pointerId: 1, button: 0, clientX: x, clientY: 150 }));
    }
  });
  await changes("Fit", () => $("fit").click());
  await changes("the theme", () => $("theme").click());
  $("theme").click();
  pressed("Home");
  pressed(" ");
  check($("play").textContent === "Pause", "space does not play");
  await new Promise(done => setTimeout(done, 500));
  check(Number($("slider").value) > 0, "playing shows no other frame");
  pressed(" ");
  const paused = $("slider").value;
  await new Promise(done => setTimeout(done, 300));
  check($("play").textContent === "Play" && $("slider").value === paused, "it does not pause");
  frame.remove();
}

(async () => {
  let looks = 0;
  try {
    for (const [name, expected] of Object.entries(runs)) {
      for (const [screen, size] of Object.entries(screens)) {
        await look(name, expected, screen, size);
        ++looks;
      }
    }
  } catch (error) {
    faults.push(error.stack);
  }
  document.getElementById("found").textContent = JSON.stringify([looks, faults]);
})();
</script>"""

VIEW = """<!DOCTYPE html><style>body {{ margin: 0 }}</style>
<iframe src="{page}" style="border: 0; width: {width}px; height: {height}px"></iframe><script>
document.querySelector("iframe").onload = event => {{
  const page = event.target.contentDocument;
  if (page.documentElement.dataset.theme !== "{theme}") page.getElementById("theme").click();
  for (const layer of {layers}) page.getElementById("layer-" + layer).click();
  const slider = page.getElementById("slider");
  slider.value = slider.max * 0.6;
  slider.dispatchEvent(new event.target.contentWindow.Event("input"));
}};</script>"""


def edges_of(grid):
    """The number of edges of the triangles of a VTK file: those across the sides of a cell are met at two places."""
    text = grid.read_text()

    def array(name):
        return re.search(rf'Name="{name}"[^>]*>(.*?)</DataArray>', text, re.S)[1].split()

    corners = [int(number) for number in array("connectivity")]
    if "CellSides" in text:
        return len(corners) // 2
    return len({tuple(sorted(pair)) for t in range(0, len(corners), 3)
                for pair in (corners[t:t + 2], corners[t + 1:t + 3], (corners[t], corners[t + 2]))})


def written(program, folder, name, arguments):
    page, table, grids = folder / f"{name}.html", folder / f"{name}.csv", folder / name
    subprocess.run([program, *arguments, "--quiet", "--every", "1", "--html", page, "--csv", table, "--vtk", grids],
                   cwd=folder, check=True)
    text = page.read_text()
    if re.search(r"(src|href)=\"(?!data:)|https?://(?!www\.w3\.org)", text):
        sys.exit(f"{name}: the page asks for other files")
    with open(table, newline="") as file:
        rows = [None, *csv.DictReader(file)]
    frames = []
    files = re.findall(r'file="(.+?)"', (grids / "frames.pvd").read_text())
    for row, file in zip(rows, files, strict=True):
        grid = grids / file
        content = grid.read_text()
        points = int(row["points"]) if row else int(re.search(r'NumberOfPoints="(\d+)"', content)[1])
        if not row and "CellSides" in content:
            points = int(rows[1]["points"])
        delaunay = re.search(r'Name="delaunay"[^>]*>(.*?)</DataArray>', content, re.S)[1].split()
        number = int(file.removeprefix("frame_").removesuffix(".vtu"))
        if row and int(row["frame"]) != number:
            sys.exit(f"{name}: {file} is of frame {row['frame']}")
        frames.append({"number": number, "points": points, "edges": edges_of(grid), "wrong": "0" in delaunay,
                       "certified": row["certified"] == "1" if row else True})
    return {"page": page.as_uri(), "timed": in_virtual_time(page).as_uri(), "frames": frames,
            "id": r"p\d+" if name == "population" else r"\d+", "title": "coming & <going>" if name == "population" else arguments[0]}


def in_virtual_time(page):
    """A copy of the page that draws by a timer from its beginning: in virtual time no screen asks for frames."""
    timer = "<script>requestAnimationFrame = draw => setTimeout(() => draw(performance.now()), 16);</script>"
    start, meta, rest = page.read_text().partition('<meta charset="utf-8">')
    if not meta:
        sys.exit(f"{page.name} has no place for a script before its own")
    copy = page.with_name("timed_" + page.name)
    copy.write_text(start + meta + timer + rest)
    return copy


def started(chromium, folder, page, *options):
    return subprocess.run(
        [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--allow-file-access-from-files",
         "--enable-logging=stderr", f"--user-data-dir={folder}/profile", *options, page.as_uri()],
        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, check=True)


def draw(chromium, folder, runs, directory):
    layers = {"plane": ["circumcircles"], "periodic": ["voronoi"], "heuristic": [], "population": ["speeds"]}
    for name, run in runs.items():
        for screen, (width, height) in SCREENS.items():
            for theme in "light", "dark":
                view = folder / "view.html"
                tall = height if screen == "desktop" else 1700
                view.write_text(VIEW.format(page=run["page"], width=width, height=tall, theme=theme,
                                            layers=json.dumps(layers[name])))
                started(chromium, folder, view, f"--window-size={width},{tall}", "--virtual-time-budget=4000",
                        f"--screenshot={directory}/{name}_{screen}_{theme}.png")


def main(chromium, program, directory=None):
    with tempfile.TemporaryDirectory() as path:
        folder = pathlib.Path(path)
        (folder / RUNS["population"][0]).write_text(COMING_AND_GOING)
        runs = {name: written(program, folder, name, arguments) for name, arguments in RUNS.items()}
        if not any(frame["wrong"] for frame in runs["heuristic"]["frames"]):
            sys.exit("the heuristic run has no wrong edge")
        if directory:
            draw(chromium, folder, runs, pathlib.Path(directory).resolve())
        watcher = folder / "watcher.html"
        watcher.write_text(WATCHER.replace("RUNS", json.dumps(runs)).replace("SCREENS", json.dumps(SCREENS)))
        # what WebGL draws is not there to be read
        shown = started(chromium, folder, watcher, "--disable-3d-apis", "--window-size=1300,900", "--virtual-time-budget=600000", "--dump-dom")
    faults = [line for line in shown.stderr.splitlines() if "CONSOLE" in line]
    found = re.search(r'<pre id="found">(.+?)</pre>', shown.stdout, re.S)
    looks, told = json.loads(found[1].replace("&lt;", "<").replace("&gt;", ">").replace("&amp;", "&")) if found else (0, [])
    if looks != len(RUNS) * len(SCREENS) and not told:
        faults.append(f"{looks} pages could be looked at, of {len(RUNS) * len(SCREENS)}")
    faults += told
    print("\n".join(faults) or f"{looks} pages play")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
