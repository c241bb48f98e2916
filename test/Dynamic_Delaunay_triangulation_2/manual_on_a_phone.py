# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Whether every page of the built manual fits a screen that is 390 pixels wide.

    manual_on_a_phone.py CHROMIUM HTML

A page fits if it does not scroll to the side as a whole, and shows the link to the user manual. Frames of that width
show the pages, one after the other.
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

WIDTH = 390
WATCHER = """<!DOCTYPE html><pre id="widths"></pre><script>
const pages = PAGES;
async function look() {
  const frame = document.body.appendChild(document.createElement("iframe"));
  frame.style = "border: 0; height: 800px; width: WIDTHpx";
  let found = "";
  for (let page; (page = pages.pop());) {
    await new Promise(done => { frame.onload = done; frame.src = page; });
    const root = frame.contentDocument.documentElement;
    const link = root.querySelector('.tablist a[href="index.html"]');
    found += `${root.clientWidth} ${root.scrollWidth} ${link ? link.offsetWidth : 0} ${page}\\n`;
  }
  return found;
}
Promise.all([look(), look(), look(), look()]).then(
  all => document.getElementById("widths").textContent = all.join(""));
</script>"""


def main(chromium, directory):
    pages = sorted(path.resolve().as_uri() for path in pathlib.Path(directory).glob("*.html"))
    with tempfile.TemporaryDirectory() as folder:
        watcher = pathlib.Path(folder) / "watcher.html"
        watcher.write_text(WATCHER.replace("PAGES", json.dumps(pages)).replace("WIDTH", str(WIDTH)))
        shown = subprocess.run(
            [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars",
             "--allow-file-access-from-files", "--virtual-time-budget=3600000", f"--user-data-dir={folder}/profile",
             "--dump-dom", watcher.as_uri()], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True, check=True)
    widths = re.findall(r"^(\d+) (\d+) (\d+) .*/(.*)$", re.search("<pre.*?</pre>", shown.stdout, re.S)[0].replace(
        '<pre id="widths">', ""), re.M)
    if not pages or len(widths) != len(pages):
        sys.exit(f"{directory}: {len(widths)} of {len(pages)} pages could be looked at")
    found = [f"{page}: {there} pixels on a screen of {screen}" for screen, there, _, page in widths
             if int(screen) != WIDTH or int(there) > WIDTH]
    found += [f"{page}: no link to the user manual is seen" for _, _, link, page in widths if int(link) == 0]
    print("\n".join(sorted(found)) or f"{len(pages)} pages fit")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
