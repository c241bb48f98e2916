# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens the pages of the built manual, and says what a reader would stumble over.

    built_manual.py SOURCES HTML

Every page of the sources is a page of its own, with its first sentence; every link within the manual leads somewhere;
no command of Doxygen is shown instead of what it stands for; and where the reference, a concept or a further page
names a class of the package, that is a link.
"""

import html
import pathlib
import re
import sys

# Doxygen links to a list of nested classes at the top of a page, also if all of them are private.
DOXYGENS_OWN = {"#nested-classes"}
# What a checkpoint begins with.
WORDS_OF_FILES = {("DynamicDelaunayTriangulation2Checkpoints.html", "Dynamic_population_2")}
COMMAND = re.compile(r"\\(?:ref|cgal\w+|ingroup|link|anchor|page|section|subsection|snippet)\b.{0,40}")
CODE = re.compile(r"<pre.*?</pre>|<div class=\"fragment\">.*?</div><!-- fragment -->|<script.*?</script>", re.S)
PAGE = re.compile(r"\\page (\w+) [^\n]*\n(?:\\ingroup[^\n]*\n)?\n([^.]*?\.)", re.S)


def plain(text):
    return re.sub(r"\s+", " ", html.unescape(re.sub(r"<[^>]*>", "", text))).strip()


def classes(pages):
    names = set()
    for name in pages:
        match = re.fullmatch(r"(?:class|struct)CGAL_1_1(\w+)\.html", name)
        if match and "_1_1" not in match[1]:
            names.add(match[1].replace("__", "_"))
    return names


def missing_pages(sources, pages):
    for path in sorted(sources.glob("*.txt")):
        for name, sentence in PAGE.findall(path.read_text()):
            words = plain(re.sub(r"[`\\]|CGAL::|\(\)", "", sentence))[:60]
            text = pages.get(name + ".html", "")
            if words not in re.sub(r"CGAL::|\(\)", "", plain(text)):
                yield f"{name}.html: the page of {path.name} is missing, or its first sentence: {words}"


def dead_links(pages):
    anchors = {name: set(re.findall(r'(?:id|name)="([^"]+)"', text)) for name, text in pages.items()}
    for name, text in pages.items():
        for link in set(re.findall(r'href="([^"]+)"', text)) - DOXYGENS_OWN:
            target, _, anchor = html.unescape(link).partition("#")
            target = target or name
            if re.match(r"\w+:", link) or not target.endswith(".html"):
                continue
            if target not in pages or (anchor and anchor not in anchors[target]):
                yield f"{name}: a link leads nowhere: {link}"


def raw_commands(pages):
    for name, text in pages.items():
        if not name.endswith("-example.html"):
            for command in COMMAND.findall(html.unescape(re.sub(r"<[^>]*>", " ", CODE.sub("", text)))):
                yield f"{name}: a command is shown: {command}"


def names_without_links(pages):
    names = classes(pages)
    for name, text in pages.items():
        if not re.match(r"(?:class|struct)(?!CGAL)|group__|DynamicDelaunay", name):
            continue
        for code in re.findall(r"<code>([^<]*)</code>", text):
            if code.replace("CGAL::", "") in names and (name, code) not in WORDS_OF_FILES:
                yield f"{name}: not a link: {code}"


def main(sources, directory):
    pages = {path.name: path.read_text(errors="replace") for path in pathlib.Path(directory).glob("*.html")}
    if len(pages) < 50:
        sys.exit(f"{directory}: only {len(pages)} pages")
    checks = (missing_pages(pathlib.Path(sources), pages), dead_links(pages), raw_commands(pages),
              names_without_links(pages))
    found = sorted({finding for check in checks for finding in check})
    print("\n".join(found) or f"{len(pages)} pages are in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
