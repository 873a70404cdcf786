#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Checks charts and pages for what no golden file says of itself.

usage: charts_test.py FILE...

Of an SVG file: it is well-formed, has a title and a description that it refers to, ids that are
unique, numbers that are numbers, and texts that lie inside and not on each other. Of an HTML file:
tags are closed in order, ids are unique and references lead somewhere, pictures have alternatives,
tables have captions and headers, headings skip no level, and nothing is loaded from elsewhere.
`self_test` breaks a sound file in each of these ways first.
"""

import os
import re
import sys
import xml.etree.ElementTree as ElementTree
from html.parser import HTMLParser

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "architecture"))
from report import report  # noqa: E402 (it stands in another folder)

SVG = "{http://www.w3.org/2000/svg}"
# Widths of letters in units of the font's size, as in DejaVu Sans, the widest of the common fonts.
NARROW, LETTER = 0.36, 0.63
NARROW_LETTERS = set(" .,;:'|()ijlftr")
BOLD = 1.1
# Above and below the base line, without the gap between lines.
ABOVE, BELOW = 0.76, 0.2
VOID = {"meta", "img", "br", "hr", "input", "link"}


def text_box(text):
    """left, top, right, bottom of a <text> element."""
    size = float(text.get("font-size"))
    x, y = float(text.get("x")), float(text.get("y"))
    width = size * sum(NARROW if c in NARROW_LETTERS else LETTER for c in text.text or "")
    if text.get("font-weight") == "bold":
        width *= BOLD
    before = {"middle": width / 2, "end": width}.get(text.get("text-anchor"), 0)
    turned = text.get("transform")
    if turned is None:
        return x - before, y - ABOVE * size, x - before + width, y + BELOW * size
    if turned != f"rotate(-90 {text.get('x')} {text.get('y')})":
        raise ValueError(f"'{text.text}' is turned by {turned}")
    return x - ABOVE * size, y + before - width, x + BELOW * size, y + before


def check_svg_tree(root):
    ids = [element.get("id") for element in root.iter() if element.get("id")]
    for repeated in sorted({i for i in ids if ids.count(i) > 1}):
        yield f"id {repeated} is there twice"
    for name in (root.get("aria-labelledby") or "").split():
        if name not in ids:
            yield f"refers to {name}, which is not there"
    for tag in ("title", "desc"):
        element = root.find(SVG + tag)
        if element is None or not (element.text or "").strip():
            yield f"has no {tag}"
        elif element.get("id") not in (root.get("aria-labelledby") or "").split():
            yield f"its {tag} is not referred to"
    try:
        left, top, width, height = (float(number) for number in root.get("viewBox", "").split())
    except ValueError:
        yield "its viewBox is not four numbers"
        return
    paper = root.find(SVG + "rect")
    if paper is None or paper.get("width") != root.get("width"):
        yield "has no paper of its own"
    for element in root.iter():
        for name, value in element.attrib.items():
            if name in ("x", "y", "x1", "x2", "y1", "y2", "cx", "cy", "r", "width", "height") and \
                    not re.fullmatch(r"-?\d+(\.\d+)?", value):
                yield f"{name}=\"{value}\" is not a number"
    texts = [(text.text, text_box(text)) for text in root.iter(SVG + "text") if text.text]
    for i, (words, box) in enumerate(texts):
        if box[0] < left or box[1] < top or box[2] > left + width or box[3] > top + height:
            yield f"'{words}' leaves the picture"
        for others, other in texts[:i]:
            if box[0] < other[2] and other[0] < box[2] and box[1] < other[3] and other[1] < box[3]:
                yield f"'{others}' and '{words}' lie on each other"


def check_svg(text):
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        yield f"is not well-formed: {error}"
        return
    if root.tag != SVG + "svg":
        yield f"is a {root.tag}"
    yield from check_svg_tree(root)


class Page(HTMLParser):
    """What the checks of a page ask for."""

    def __init__(self):
        super().__init__()
        self.open, self.problems, self.ids, self.references, self.levels = [], [], [], [], []
        self.tables = []

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        if tag not in VOID:
            self.open.append(tag)
        if "id" in attributes:
            self.ids.append(attributes["id"])
        self.references += (attributes.get("aria-labelledby") or "").split()
        self.note_address(attributes)
        if tag == "img" and not attributes.get("alt"):
            self.problems.append("a picture has no alternative")
        if tag == "table":
            self.tables.append({"caption": 0, "col": 0, "row": 0})
        if tag == "caption":
            self.tables[-1]["caption"] += 1
        if tag == "th":
            scope = attributes.get("scope")
            if scope not in ("col", "row"):
                self.problems.append("a header of a table has no scope")
            else:
                self.tables[-1][scope] += 1
        if re.fullmatch("h[1-6]", tag):
            self.levels.append(int(tag[1]))

    def note_address(self, attributes):
        for name in ("src", "href", "data", "xlink:href"):
            value = attributes.get(name)
            if value is None:
                continue
            if value.startswith("#"):
                self.references.append(value[1:])
            elif not value.startswith("data:"):
                self.problems.append(f"{name}=\"{value}\" leads elsewhere")

    def handle_startendtag(self, tag, attrs):
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag):
        if not self.open or self.open[-1] != tag:
            self.problems.append(f"</{tag}> closes {self.open[-1:] or 'nothing'}")
        else:
            self.open.pop()


def check_html(text):
    page = Page()
    page.feed(text)
    page.close()
    yield from page.problems
    if page.open:
        yield f"never closes {page.open}"
    for repeated in sorted({i for i in page.ids if page.ids.count(i) > 1}):
        yield f"id {repeated} is there twice"
    for name in page.references:
        if name not in page.ids:
            yield f"refers to {name}, which is not there"
    for table in page.tables:
        if table["caption"] != 1 or not table["col"] or not table["row"]:
            yield f"a table has so many captions and headers: {table}"
    if page.levels[:1] != [1] or any(b > a + 1 for a, b in zip(page.levels, page.levels[1:])):
        yield f"headings have the levels {page.levels}"
    if "<script" in text or "url(" in text or "@import" in text:
        yield "has a script, or styles that load something"
    for svg in re.findall(r"<svg.*?</svg>", text, re.DOTALL):
        yield from check_svg(svg)


SOUND_SVG = """<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 100 50" width="100" height="50"
role="img" aria-labelledby="a b"><title id="a">t</title><desc id="b">d</desc>
<rect x="0" y="0" width="100" height="50"/><text x="5" y="20" font-size="10">one</text>
<text x="90" y="20" font-size="10" text-anchor="end">two</text>
<text x="50" y="45" font-size="10" transform="rotate(-90 50 45)">up</text></svg>"""
SOUND_HTML = f"""<!DOCTYPE html><html><head><meta charset="utf-8"></head><body><h1>a</h1>
<a href="#c">c</a><h2 id="c">b</h2><img src="data:," alt="x"><table><caption>c</caption>
<tr><th scope="col">a</th></tr><tr><th scope="row">b</th></tr></table>{SOUND_SVG}</body></html>"""
BREAKS = (
    (check_svg, SOUND_SVG, "</text>", "", "is not well-formed"),
    (check_svg, SOUND_SVG, "</title>", "</title><g id=\"a\"/>", "id a is there twice"),
    (check_svg, SOUND_SVG, "\"a b\"", "\"a b c\"", "refers to c"),
    (check_svg, SOUND_SVG, "d</desc>", "</desc>", "has no desc"),
    (check_svg, SOUND_SVG, "\"a b\"", "\"b\"", "its title is not referred to"),
    (check_svg, SOUND_SVG, "0 0 100 50", "0 0 nan", "its viewBox"),
    (check_svg, SOUND_SVG, "y=\"0\" width=\"100\"", "y=\"0\" width=\"9\"", "has no paper"),
    (check_svg, SOUND_SVG, "<rect x=\"0\"", "<rect x=\"nan\"", "x=\"nan\" is not a number"),
    (check_svg, SOUND_SVG, "x=\"5\" y=\"20\"", "x=\"85\" y=\"20\"", "'one' leaves the picture"),
    (check_svg, SOUND_SVG, "x=\"5\" y=\"20\"", "x=\"70\" y=\"25\"", "'one' and 'two' lie"),
    (check_svg, SOUND_SVG, "x=\"5\" y=\"20\"", "x=\"40\" y=\"40\"", "'one' and 'up' lie"),
    (check_html, SOUND_HTML, "</h2>", "</h1>", "</h1> closes"),
    (check_html, SOUND_HTML, "</body></html>", "", "never closes"),
    (check_html, SOUND_HTML, "<h1>", "<h1 id=\"c\">", "id c is there twice"),
    (check_html, SOUND_HTML, "#c", "#d", "refers to d"),
    (check_html, SOUND_HTML, " alt=\"x\"", "", "a picture has no alternative"),
    (check_html, SOUND_HTML, "<caption>c</caption>", "", "a table has so many"),
    (check_html, SOUND_HTML, " scope=\"row\"", "", "a header of a table has no scope"),
    (check_html, SOUND_HTML, "h2", "h3", "headings have the levels"),
    (check_html, SOUND_HTML, "data:,", "https://a.b", "src=\"https://a.b\" leads elsewhere"),
    (check_html, SOUND_HTML, "<h1>", "<script></script><h1>", "has a script"),
    (check_html, SOUND_HTML, "x=\"5\" y=\"20\"", "x=\"85\" y=\"20\"", "'one' leaves the picture"),
)


def self_test():
    for check, sound in ((check_svg, SOUND_SVG), (check_html, SOUND_HTML)):
        for problem in check(sound):
            yield f"a sound file {problem}"
    for check, sound, before, after, problem in BREAKS:
        found = list(check(sound.replace(before, after)))
        if not any(line.startswith(problem) for line in found):
            yield f"with '{after}' for '{before}' the checks find {found}, not '{problem}'"


def check_file(path):
    with open(path, encoding="utf-8") as file:
        text = file.read()
    for problem in (check_html if path.endswith(".html") else check_svg)(text):
        yield f"{path}: {problem}"


def main():
    files = sys.argv[1:]
    checks = [("self-test", self_test())]
    checks += [(os.path.basename(path), check_file(path)) for path in files]
    checks.append(("files", [] if files else ["no files were named"]))
    return report(checks)


if __name__ == "__main__":
    sys.exit(main())
