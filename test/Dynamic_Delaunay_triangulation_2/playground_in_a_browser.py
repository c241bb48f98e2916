# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether the playground can be played with in Chromium, on a desktop's screen and on a phone's.

    playground_in_a_browser.py CHROMIUM CHROMEDRIVER SITE [DIRECTORY]

SITE is the folder that `./dev page` builds. Scenarios run, points are dragged, added and removed by mouse and finger, keys
are pressed, settings changed and links followed, as a person does it. Every frame of an exact classifier that is shown has
to be certified, and some are proved here once more, in rational numbers. Nothing may be wider than the screen or cut, or
be written to the console. With a DIRECTORY pictures of the pages, light and dark, are put there to be looked at, and how
many frames a second were drawn is told.
"""

import contextlib
import json
import pathlib
import sys
import tempfile
import threading
import time
from fractions import Fraction

from selenium import webdriver
from selenium.webdriver.chrome.service import Service

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bindings" / "web"))
from serve import server  # noqa: E402

SCREENS = {"desktop": (1280, 800), "phone": (390, 844)}
LINKS = {
    "dam_break": "", "explosion": "#scenario=explosion&layers=edges+points+speeds+changed+wrong",
    "spinning": "#scenario=spinning&layers=edges+points+voronoi", "static": "#scenario=static",
    "brownian": "#scenario=brownian&points=500&wind=1",
    "periodic": "#scenario=brownian&points=500&space=periodic&layers=edges+points+sets+voronoi+circumcircles",
    "slab": "#space=channel&points=500&wind=1", "pendulum": "#scenario=pendulum",
    "periodic_explosion": "#scenario=explosion&space=periodic&points=400",
    "cells": "#layers=points&cells=true&cellRadius=1.5&wallBelow=0.3&wallAbove=0.6",
    "periodic_cells": "#scenario=brownian&points=300&space=periodic&layers=points&cells=true&cellRadius=0.75",
    "heuristic": "#classifier=random&parameter=0.01&steps=8", "splice": "#repair=splice&policy=always_dynamic&padding=2",
}

# Notes each frame that comes.
WATCH = """
window.seen = { frames: 0, uncertified: 0 };
const heard = playground.heard.frame;
playground.heard.frame = frame => {
  if (frame.scene) {
    ++seen.frames;
    seen.uncertified += frame.state.isCertified ? 0 : 1;
  }
  heard(frame);
};"""

CUT = """
const [width] = arguments, faults = [];
if (document.documentElement.scrollWidth > width) {
  faults.push(`it is ${document.documentElement.scrollWidth} wide`);
}
for (const part of document.querySelectorAll("button, select, label, output, p, h1, h2, figcaption, legend")) {
  const box = part.getBoundingClientRect();
  if (box.width === 0 || part.closest(".unseen")) continue;
  if (box.left < 0 || box.right > width + 0.5) faults.push(`"${part.textContent}" leaves the screen`);
  if (part.scrollWidth > Math.ceil(box.width) + 1) faults.push(`"${part.textContent}" is cut`);
}
return faults;"""

# A point by number or a place of the plane in pixels of the window.
PLACE = """
const box = playground.picture.canvas.getBoundingClientRect(), { view, scene } = playground.picture;
const at = x => [box.left + view.x(x[0]), box.top + view.y(x[1])];
"""


class Page:
    """A page in the browser, and what is wrong with it."""

    def __init__(self, browser, address, faults, has_fingers):
        self.browser, self.address, self.faults, self.has_fingers = browser, address, faults, has_fingers
        self.name = ""
        self.is_pressed = False

    def run(self, script, *arguments):
        return self.browser.execute_script(script, *arguments)

    def check(self, holds, text):
        if not holds:
            self.faults.append(f"{self.name}: {text}")

    def until(self, condition, text, seconds=30):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.run(f"return {condition}"):
                return True
            time.sleep(0.05)
        self.check(False, f"{text} ({self.said()})")
        return False

    def said(self):
        return self.run("return ['state', 'refused'].map(id => document.getElementById(id)?.textContent).join(' ')")

    def open(self, name, link="", file="playground/index.html"):
        self.name = name
        self.browser.get("about:blank")
        self.browser.get(self.address + file + link)
        if file.startswith("playground/index"):
            self.run(WATCH)
            self.until("playground.state !== null && playground.choices !== null", "no scenario begins")

    def press(self, key):
        self.run("document.body.dispatchEvent(new KeyboardEvent('keydown', { key: arguments[0], bubbles: true }))", key)

    def press_at(self, x, y):
        """With a finger or the mouse, as the screen is."""
        self.point("touchStart", "mousePressed", x, y)

    def move_to(self, x, y):
        self.point("touchMove", "mouseMoved", x, y)

    def lift_at(self, x, y):
        self.point("touchEnd", "mouseReleased", x, y)

    def point(self, touch, mouse, x, y):
        if self.has_fingers:
            points = [] if touch == "touchEnd" else [{"x": x, "y": y}]
            self.browser.execute_cdp_cmd("Input.dispatchTouchEvent", {"type": touch, "touchPoints": points})
        else:
            self.is_pressed = mouse == "mousePressed" or (mouse == "mouseMoved" and self.is_pressed)
            self.browser.execute_cdp_cmd("Input.dispatchMouseEvent", {
                "type": mouse, "x": x, "y": y, "clickCount": 0 if mouse == "mouseMoved" else 1,
                "button": "none" if mouse == "mouseMoved" and not self.is_pressed else "left",
                "buttons": 1 if self.is_pressed else 0})

    def choose(self, name, value):
        self.run("""const field = document.getElementById(arguments[0]);
                    field.value = arguments[1];
                    field.dispatchEvent(new Event("input"));
                    field.dispatchEvent(new Event("change"));""", name, value)

    def steps(self):
        return self.run("return playground.state.step")

    def look(self, width):
        for fault in self.run(CUT, width):
            self.check(False, fault)

    def console(self):
        for entry in self.browser.get_log("browser"):
            self.check(False, "console: " + entry["message"])


@contextlib.contextmanager
def opened(chromium, driver, screen, downloads):
    options = webdriver.ChromeOptions()
    options.binary_location = chromium
    width, height = SCREENS[screen]
    # Without WebGL, which only the processor would draw here.
    for option in ("--headless=new", "--no-sandbox", "--hide-scrollbars", "--disable-3d-apis", f"--window-size={width},{height}"):
        options.add_argument(option)
    options.add_experimental_option("prefs", {"download.default_directory": str(downloads)})
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    browser = webdriver.Chrome(service=Service(driver), options=options)
    try:
        resize(browser, width, height)
        browser.execute_cdp_cmd("Emulation.setTouchEmulationEnabled", {"enabled": screen == "phone"})
        yield browser
    finally:
        browser.quit()


def resize(browser, width, height):
    browser.execute_cdp_cmd("Emulation.setDeviceMetricsOverride",
                            {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600})


def side_of_circle(a, b, c, d):
    """Positive if d is inside of the circle through a, b, c, which turn left (the determinant of Guibas and Stolfi)."""
    rows = [(p[0] - d[0], p[1] - d[1]) for p in (a, b, c)]
    squares = [x * x + y * y for x, y in rows]

    def cross(p, q):
        return p[0] * q[1] - p[1] * q[0]

    return squares[0] * cross(rows[1], rows[2]) + squares[1] * cross(rows[2], rows[0]) + squares[2] * cross(rows[0], rows[1])


def fault_of(positions, triangles):
    """Why these are not the Delaunay triangles of the points in the plane; None if they are."""
    points = [(Fraction(x), Fraction(y)) for x, y in zip(positions[::2], positions[1::2])]
    apexes, used = {}, set(triangles)
    for t in range(0, len(triangles), 3):
        i, j, k = triangles[t:t + 3]
        (ax, ay), (bx, by), (cx, cy) = points[i], points[j], points[k]
        if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) <= 0:
            return f"triangle {i} {j} {k} is not counterclockwise"
        for side, apex in (((i, j), k), ((j, k), i), ((k, i), j)):
            if side in apexes:
                return f"halfedge {side} is in two triangles"
            apexes[side] = apex
    if len(used) != len(points):
        return f"{len(points) - len(used)} points are in no triangle"
    border = [(i, j) for i, j in apexes if (j, i) not in apexes]
    if len(triangles) // 3 != 2 * len(points) - 2 - len(border):
        return "its faces do not fit its points (Euler)"
    after = dict(border)
    for i, j in border:
        k = after[j]
        (ax, ay), (bx, by), (cx, cy) = points[i], points[j], points[k]
        if (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0:
            return f"the hull is not convex at point {j}"
    for (i, j), k in apexes.items():
        if (j, i) in apexes and side_of_circle(points[i], points[j], points[k], points[apexes[j, i]]) > 0:
            return f"edge {i} {j} is not Delaunay"
    return None


def expect_delaunay(page):
    """Of the picture that is shown, in the plane."""
    positions, triangles = page.run("""const { positions, triangles } = playground.picture.scene;
                                       return [Array.from(positions), Array.from(triangles ?? [])];""")
    page.check(triangles, "there are no triangles")
    if triangles:
        fault = fault_of(positions, triangles)
        page.check(fault is None, fault)


def plays_every_scenario(page, width):
    for name, link in LINKS.items():
        page.open(name, link)
        if not page.until("seen.frames > 12 && playground.state.step > 12", "it does not run"):
            continue
        page.look(width)
        uncertified = page.run("return seen.uncertified")
        if name == "heuristic":
            page.until("playground.state.wrong > 0 && document.querySelector('#state b')", "no wrong edge is told")
        else:
            page.check(uncertified == 0, f"{uncertified} frames are not certified")
            page.check("certified Delaunay" in page.said(), "it does not say that it is certified")
        page.check(page.run("return document.getElementById('refused').hidden"), "something is refused: " + page.said())
        page.console()


def proves_its_pictures(page):
    for link in "#points=150&layers=edges+voronoi", "#scenario=brownian&points=150&layers=voronoi":
        page.open("proof", link)
        for steps in 3, 40:
            page.until(f"playground.state.step >= {steps}", "it does not run")
            expect_delaunay(page)
        page.console()


def drags_a_point(page):
    page.open("drag", "#scenario=static&gravity=0&layers=edges+points+voronoi")
    page.until("playground.state.step > 4", "it does not run")
    number, x, y = page.run(PLACE + """
        const { low, high } = playground.picture.view.fitted;
        const middle = at([low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2]);
        const number = playground.picture.nearestPoint(middle[0] - box.left, middle[1] - box.top, 100);
        return [number, ...at(scene.positions.slice(2 * number, 2 * number + 2))];""")
    page.press_at(x, y)
    for k in range(1, 9):
        page.move_to(x + 5 * k, y - 4 * k)
        time.sleep(0.03)
    distance = f"""(() => {{ {PLACE} const [x, y] = at(scene.positions.slice({2 * number}, {2 * number + 2}));
                       return Math.hypot(x - {x + 40}, y - {y - 32}); }})()"""
    page.until(f"{distance} < 25", "the point is not dragged")
    page.check(page.run("return playground.state.held") > 0, "it does not say that a point is held")
    page.lift_at(x + 40, y - 32)
    page.until("playground.state.held === 0", "the point is not let go")
    page.check(page.run("return seen.uncertified") == 0, "a frame is not certified while a point is dragged")
    expect_delaunay(page)
    page.console()


def moves_the_wall_of_cells(page, width):
    page.open("cells with borders", "#points=300&layers=points")
    page.press("b")
    page.until("playground.picture.scene.cellContacts?.length > 100", "b shows no cells with borders")
    page.choose("cell-radius", "2")
    page.press(" ")
    page.until("!playground.isWaiting && playground.arrived === null", "it does not rest")
    step = page.steps()
    right = """(({ cellBorders, outline }) =>
        Math.max(...cellBorders.filter((_, i) => i % 2 === 0)) / outline[1][0])(playground.picture.scene)"""
    for end, name in enumerate(("wallBelow", "wallAbove")):
        x, y, aim = page.run(PLACE + f"""
            const [side] = scene.outline[1];
            return [...at(scene.wall[{end}]), at([0.3 * side, 0])[0]];""")
        page.press_at(x, y)
        for share in (0.3, 0.6, 1):
            page.move_to(x + share * (aim - x), y)
        page.until(f"Math.abs(playground.settings.{name} - 0.3) < 0.02", f"the wall does not follow: {name}")
        page.lift_at(aim, y)
        page.check(f"{name}=0." in page.run("return location.hash"), "the link does not have the wall")
    page.until(f"{right} < 0.33", "the cells do not end at the wall")
    page.check(page.run("return playground.picture.scene.cellBorders.every(Number.isFinite)"), "a border is nowhere")
    page.check(page.steps() == step, "it plays while a wall is moved")
    page.check(page.run("return playground.state.held") == 0, "the wall's hand holds a point")
    page.look(width)
    page.press("b")
    page.until("playground.picture.scene.cellContacts === undefined", "b hides no cells")
    page.console()


def adds_and_removes_points(page):
    for link in "#scenario=brownian&points=200&layers=edges+points+voronoi", "#scenario=brownian&points=200&space=periodic", \
            "#points=200&gravity=0":
        page.open("add " + link, link)
        page.press("a")
        x, y = page.run(PLACE + "const { low, high } = view.fitted;"
                                "return at([0.3 * low[0] + 0.7 * high[0], 0.3 * low[1] + 0.7 * high[1]]);")
        page.press_at(x, y)
        page.move_to(x - 40, y)
        page.lift_at(x - 40, y)
        page.until("playground.state.points === 202", "two points are not added")
        page.press("x")
        x, y = page.run(PLACE + "return at(scene.positions.slice(20, 22));")
        page.press_at(x, y)
        page.lift_at(x, y)
        page.until("playground.state.points === 201", "no point is removed")
        step = page.steps()
        page.until(f"playground.state.step > {step + 10}", "it does not go on")
        page.check(page.run("return seen.uncertified") == 0, "a frame is not certified")
        page.check(page.run("return playground.state.points") == 201, "points are lost")
        if "periodic" not in link:
            missing = page.run("return playground.picture.scene.positions.filter(x => x !== x).length")
            page.check(missing == 2, f"{missing} coordinates are those of no point, not 2")
        page.choose("classifier", "safe_region")
        page.until("playground.accepted.classifier === 'safe_region'", "the classifier is not changed")
        page.until("playground.state.points === 201 && playground.state.isCertified",
                   "another classifier does not have the points")
        page.console()


def changes_the_method(page):
    page.open("method", "#steps=8")
    page.choose("classifier", "random")
    page.choose("parameter", "0.001")
    page.until("playground.accepted.parameter === 0.001", "the parameter is not taken")
    page.until("playground.state.wrong > 0", "a classifier that misses nearly all leaves no wrong edge")
    page.press("5")  # Voronoi cells, for which there are triangles
    # One scene: the next one may have been triangulated anew by the policy.
    if page.until("(window.caught = playground.picture.scene).triangles && caught.wrong.length > 0", "there are no triangles"):
        fault = fault_of(*page.run("return [[...caught.positions], [...caught.triangles]]"))
        page.check(fault is not None, "wrong edges are no fault")
    page.press(" ")
    page.press("a")
    x, y = page.run(PLACE + "return at(scene.outline[2].map(side => 0.7 * side));")
    page.press_at(x, y)
    page.lift_at(x, y)
    page.until("playground.state.points === 1009", "no point is added to what is not certified")
    page.press(" ")
    page.choose("parameter", "7")
    page.until("!document.getElementById('refused').hidden", "a probability of 7 is not refused")
    page.check(page.run("return playground.settings.parameter") == 0.001, "what was refused is kept")
    page.choose("classifier", "circumcircle")
    page.until("playground.accepted.classifier === 'circumcircle' && playground.state.isCertified", "it is not exact again")
    page.check(page.run("return document.getElementById('refused').hidden"), "it still says what was refused")
    page.choose("repair", "splice")
    page.choose("policy", "always_dynamic")
    page.until("playground.state.report?.padded > 0", "a splice pads nothing")
    page.choose("points", "0")
    page.check(page.run("return playground.settings.points") == 1008, "no points are taken")
    page.choose("space", "periodic")
    page.until("playground.picture.scene.cell?.isPeriodic[1]", "it is not periodic")
    page.console()


def obeys_keys(page):
    page.open("keys")
    page.until("playground.state.step > 10", "it does not run")
    page.press(" ")
    page.until("!playground.isWaiting && playground.arrived === null", "it does not rest")
    step = page.steps()
    time.sleep(0.3)
    page.check(page.steps() == step, "space does not pause")
    page.press("n")
    page.until(f"playground.state.step === {step + 1}", "n is not one step")
    page.press("ArrowRight")
    page.check(page.run("return playground.settings.wind") == 0.25, "an arrow makes no wind")
    page.press("ArrowDown")
    page.check(page.run("return playground.settings.gravity") == 0.75, "an arrow changes no gravity")
    page.press(" ")
    page.until(f"playground.state.step > {step + 60}", "space does not play")
    page.press("r")
    page.until(f"playground.state.step < {step}", "r does not reset")
    theme = page.run("return document.documentElement.dataset.theme")
    page.press("t")
    page.check(page.run("return document.documentElement.dataset.theme") != theme, "t leaves the theme")
    page.press("5")
    page.check(page.run("return playground.settings.layers.voronoi"), "5 shows no Voronoi cells")
    page.until("playground.picture.scene.triangles", "there are no triangles for the Voronoi cells")
    page.console()


def comes_back_by_its_link(page):
    page.open("link")
    for name, value in {"scenario": "spinning", "points": "300", "space": "periodic", "steps": "4", "gravity": "-0.5",
                        "wind": "0.75", "classifier": "point_distance", "parameter": "0.8", "padding": "3",
                        "repair": "flip", "policy": "key_frames:10"}.items():
        page.choose(name, value)
    page.run("for (const name of ['voronoi', 'sets']) document.getElementById('layer-' + name).click();")
    page.press("x")
    link, settings = page.run("return [location.hash, JSON.stringify(playground.settings)]")
    page.until("playground.accepted.policy === 'key_frames:10'", "it does not play these settings")
    page.open("link followed", link)
    followed = page.run("return JSON.stringify(playground.settings)")
    page.check(json.loads(followed) == json.loads(settings), f"{link} leads to {followed}, not {settings}")
    page.check(page.run("return location.hash") == link, "the link changes")
    shown = page.run("return ['scenario', 'points', 'space', 'classifier', 'parameter', 'repair', 'policy', 'wind']"
                     ".map(name => document.getElementById(name).value)")
    page.check(shown == ["spinning", "300", "periodic", "point_distance", "0.8", "flip", "key_frames:10", "0.75"], str(shown))
    page.open("link that is wrong", "#scenario=nothing&points=-3&space=moon&layers=edges&tool=axe&padding=1.5&wind=1e9")
    page.until("playground.state.step > 3", "it does not run")
    page.check(page.run("return location.hash && JSON.stringify([playground.settings.scenario, playground.settings.points])")
               == '["dam_break",1008]', "it takes what does not exist")
    page.console()


def saves_its_picture(page, downloads):
    page.open("save")
    page.until("playground.state.step > 3", "it does not run")
    page.press(" ")
    for kind, begin in ("svg", b"<svg xmlns"), ("png", b"\x89PNG"):
        page.browser.find_element("id", kind).click()
        end = time.monotonic() + 20
        while not (files := list(downloads.glob(f"*.{kind}"))) and time.monotonic() < end:
            time.sleep(0.1)
        page.check(files and files[0].read_bytes().startswith(begin), f"no {kind} is saved")
    page.console()


def balances_a_pendulum(page):
    page.open("pendulum in a hand", "#scenario=pendulum")
    page.until("playground.state.step > 3", "it does not run")
    x, y = page.run(PLACE + "return at(scene.marks[0]);")
    if page.has_fingers:
        page.press_at(x, y)
    page.move_to(x + 60, y)
    page.until(f"(() => {{ {PLACE} return Math.abs(at(scene.marks[0])[0] - {x + 60}) < 2; }})()", "the hand does not follow")
    before = page.run("return playground.picture.scene.marks[0][0]")
    page.press("ArrowLeft")
    page.until(f"playground.picture.scene.marks[0][0] < {before - 1}", "the arrow does not move the hand")
    page.check("upright for" in page.said(), "it does not say how long it stands")
    page.choose("steps", "8")
    page.until("playground.state.rod.isUpright === false", "it does not fall when the hand rests")
    page.console()


def explains(page, width):
    page.open("explained", file="playground/explained.html")
    page.until("window.explanation?.update", "nothing is drawn")
    page.look(width)
    for _ in range(5):
        told = page.run("return [...document.querySelectorAll('output')].map(output => output.textContent)")
        page.check(len(told) == 5 and all(told) and "certified Delaunay" in told[4] and "not certified" not in told[4], str(told))
        before = page.run("return [...document.querySelectorAll('canvas')].map(canvas => canvas.toDataURL())")
        page.check(len(set(before)) == 5, "two steps have one picture")
        fault = page.run("const { positions, triangles } = explanation.update; return [[...positions], [...triangles]]")
        page.check(fault_of(*fault) is None, str(fault_of(*fault)))
        page.run("document.getElementById('move').click()")
        after = page.run("return [...document.querySelectorAll('canvas')].map(canvas => canvas.toDataURL())")
        page.check(not set(before) & set(after), "the points have not moved")
    page.console()


def begins_with_a_list_of_pages(page, width):
    page.open("first page", file="index.html")
    page.look(width)
    page.console()
    links = page.run("return [...document.querySelectorAll('a')].map(link => link.getAttribute('href'))")
    page.check(len(links) == 3, f"it leads to {links}")
    for link in links:
        page.open(link, file=link)
        page.until("document.querySelector('h1, canvas, svg')", "there is nothing")
        time.sleep(0.5)
        page.console()


def moves_the_points_of_the_example(page):
    page.open("example", file="package/example.html")
    page.until("document.title === 'Delaunay: true'", "it is not certified")
    before = page.run("return document.getElementById('canvas').toDataURL()")
    page.until(f"document.getElementById('canvas').toDataURL() !== {json.dumps(before)}", "nothing moves")
    page.until("document.title === 'Delaunay: true'", "it is not certified any more")
    page.console()


def draw(page, screen, directory):
    width, height = SCREENS[screen]
    for name, link in {**LINKS, "large": "#scenario=brownian&points=10000&layers=edges+points+changed",
                       "large_periodic": "#scenario=brownian&points=10000&space=periodic"}.items():
        page.open(name, link)
        page.until("seen.frames > 150 || playground.state.step > 1200", "it does not run", 60)
        print(f"{screen}, {name}: {page.said()}")
        for theme in "light", "dark":
            page.run("if (document.documentElement.dataset.theme !== arguments[0]) playground.toggleTheme()", theme)
            resize(page.browser, width, height if width > 900 else page.run("return document.documentElement.scrollHeight"))
            time.sleep(0.5)
            page.browser.save_screenshot(f"{directory}/{name}_{screen}_{theme}.png")
            resize(page.browser, width, height)
    for theme in "light", "dark":
        page.open("explained", file="playground/explained.html")
        page.until("window.explanation?.update", "nothing is drawn")
        page.run("if (document.documentElement.dataset.theme !== arguments[0]) document.getElementById('theme').click()", theme)
        resize(page.browser, width, page.run("return document.documentElement.scrollHeight"))
        time.sleep(0.5)
        page.browser.save_screenshot(f"{directory}/explained_{screen}_{theme}.png")
        resize(page.browser, width, height)


def main(chromium, driver, site, directory=None):
    faults = []
    with server(site) as served, tempfile.TemporaryDirectory() as folder:
        threading.Thread(target=served.serve_forever, daemon=True).start()
        for screen, (width, _) in SCREENS.items():
            downloads = pathlib.Path(folder) / screen
            downloads.mkdir()
            with opened(chromium, driver, screen, downloads) as browser:
                page = Page(browser, f"http://127.0.0.1:{served.server_port}/", faults, screen == "phone")
                begins_with_a_list_of_pages(page, width)
                plays_every_scenario(page, width)
                proves_its_pictures(page)
                drags_a_point(page)
                moves_the_wall_of_cells(page, width)
                adds_and_removes_points(page)
                changes_the_method(page)
                obeys_keys(page)
                comes_back_by_its_link(page)
                saves_its_picture(page, downloads)
                balances_a_pendulum(page)
                explains(page, width)
                moves_the_points_of_the_example(page)
                if directory:
                    draw(page, screen, directory)
        served.shutdown()
    print("\n".join(faults) or "the playground can be played with")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
