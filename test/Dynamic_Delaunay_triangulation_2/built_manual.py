# Copyright (c) 2026 The Dynamic_Delaunay_triangulation_2 authors
# SPDX-License-Identifier: GPL-3.0-or-later

"""Opens the pages of the built manual, and says what a reader would stumble over.

    built_manual.py SOURCES HTML

Every page of the sources is a page of its own, with its first sentence, and is listed in the reference; every link
within the manual leads somewhere, and one to the user manual and one to the reference stand on every page; what a
page loads is beside it, and nothing comes from a network; no command of Doxygen, and no asterisk, is shown instead of
what it stands for; and where the user manual, the reference, a concept or a further page names a class of the package,
that is a link, as are all concepts, classes and macros in the list of the reference.
"""

import html
import pathlib
import re
import sys

# Doxygen links to a list of nested classes at the top of a page, also if all of them are private.
DOXYGENS_OWN = {"#nested-classes"}
# What a checkpoint begins with.
WORDS_OF_FILES = {("DynamicDelaunayTriangulation2Checkpoints.html", name)
                  for name in ("Dynamic_population_2", "Dynamic_population_3")}
REFERENCE = "group__PkgDynamicDelaunayTriangulation2Ref.html"
COMMAND = re.compile(r"\\(?:ref|cgal\w+|ingroup|link|anchor|page|section|subsection|snippet)\b.{0,40}")
CODE = re.compile(r"<pre.*?</pre>|<div class=\"fragment\">.*?</div><!-- fragment -->|<script.*?</script>", re.S)
# What is no text: code, formulas, and declarations, where an asterisk is a pointer
NO_TEXT = re.compile(
    CODE.pattern + r"|<code>.*?</code>|\\\(.*?\\\)|\\\[.*?\\\]|<td class=\"(?:mem|param).*?</td>", re.S)
LOADED = re.compile(r"<(?:script|img|iframe|object|embed|link)\b[^>]*?\b(?:src|data|href)=\"([^\"]*)\"", re.S)
LOADED_BY_STYLE = re.compile(r"(?:url\(|@import )\s*['\"]?([^'\")]+)")
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


def pages_without_way_back(pages):
    for name, text in pages.items():
        for target in ("index.html", REFERENCE):
            if f'<li><a href="{target}">' not in text and f'<li class="current"><a href="{target}">' not in text:
                yield f"{name}: no link to {target}"


def not_beside(directory, pages):
    styles = {path.name: path.read_text(errors="replace") for path in directory.glob("**/*.css")}
    loaded = {(name, link) for name, text in pages.items() for link in LOADED.findall(text)}
    loaded |= {(name, link) for name, text in styles.items() for link in LOADED_BY_STYLE.findall(text)}
    for name, link in loaded:
        if link.startswith(("data:", "javascript:")):
            continue
        folder = next(directory.glob(f"**/{name}")).parent
        if re.match(r"\w+:|/", link) or not (folder / html.unescape(link).partition("?")[0]).is_file():
            yield f"{name}: not beside the page: {link}"


def raw_commands(pages):
    for name, text in pages.items():
        if not name.endswith("-example.html"):
            for command in COMMAND.findall(html.unescape(re.sub(r"<[^>]*>", " ", CODE.sub("", text)))):
                yield f"{name}: a command is shown: {command}"


def raw_asterisks(pages):
    for name, text in pages.items():
        if not name.endswith(("-example.html", "_source.html")):
            for words in re.findall(r".{0,30}\*.{0,30}", plain(NO_TEXT.sub("", text))):
                yield f"{name}: an asterisk is shown: {words}"


def names_without_links(pages):
    names = classes(pages)
    for name, text in pages.items():
        if not re.match(r"(?:class|struct)(?!CGAL)|group__|DynamicDelaunay|index", name):
            continue
        for code in re.findall(r"<code>([^<]*)</code>", text):
            if code.replace("CGAL::", "") in names and (name, code) not in WORDS_OF_FILES:
                yield f"{name}: not a link: {code}"


def not_in_the_list(sources, pages):
    listed = pages[REFERENCE].partition("Classified reference pages")[2].partition("</div>")[0]
    targets = set(re.findall(r'href="([^"#]+)', listed))
    concepts = {"class" + path.stem.replace("_", "__") + ".html" for path in sources.glob("Concepts/*.h")}
    further = {name + ".html" for path in sources.glob("*.txt") for name, _ in PAGE.findall(path.read_text())}
    for page in concepts | further:
        if page not in targets:
            yield f"{REFERENCE}: not in its list: {page}"
    for item in re.findall(r"<li>(.*?)</li>", listed, re.S):
        name = plain(item).removeprefix("CGAL::").partition(",")[0]
        # Doxygen makes no links to enumerations and variables of a namespace without a page.
        if not re.match(r"\s*(?:<code>)?<a ", item) and f"</span>{name}</h2>" not in pages[REFERENCE]:
            yield f"{REFERENCE}: not a link: {plain(item)}"


def main(sources, directory):
    sources, directory = pathlib.Path(sources), pathlib.Path(directory)
    pages = {path.name: path.read_text(errors="replace") for path in directory.glob("*.html")}
    if len(pages) < 50:
        sys.exit(f"{directory}: only {len(pages)} pages")
    checks = (missing_pages(sources, pages), dead_links(pages), pages_without_way_back(pages),
              not_beside(directory, pages), raw_commands(pages), raw_asterisks(pages), names_without_links(pages),
              not_in_the_list(sources, pages))
    found = sorted({finding for check in checks for finding in check})
    print("\n".join(found) or f"{len(pages)} pages are in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
