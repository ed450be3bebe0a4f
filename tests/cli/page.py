"""Shared by the tests of reports: a page taken apart into tables, findings, formulas and pictures, and its units."""
import html.parser
import json
import math
import re

UNITS = {"": 1, "m": 1, "cm": 0.01, "mm": 1e-3, "in": 0.0254, "ft": 0.3048, "rad": 1, "deg": math.pi / 180, "rev": 2 * math.pi,
         "s": 1, "ms": 1e-3, "min": 60, "N": 1, "kN": 1e3, "lbf": 4.4482216152605, "J": 1, "kJ": 1e3, "rpm": math.pi / 30,
         "kg": 1, "g": 1e-3, "W": 1}
NUMBER = r"-?\d+\.?\d*(?:e[-+]?\d+)?"
AMOUNT = r"(%s)((?: [A-Za-z][A-Za-z*/^0-9]*)?)" % NUMBER


def size_of(unit):
    """In SI: `mm`, `N*mm`, `m/s^2`."""
    size = 1.0
    for sign, word, power in re.findall(r"([*/]?)([A-Za-z]+)(?:\^(\d))?", unit.strip()):
        size *= UNITS[word] ** ((-1 if sign == "/" else 1) * int(power or 1))
    return size


class Reader(html.parser.HTMLParser):
    """Tables by caption, findings as texts, formulas as what stands behind their last sign of equality."""

    def __init__(self, page):
        super().__init__()
        self.tables, self.findings, self.words, self.labels = {}, [], {}, []
        self.section, self.caption, self.rows, self.cell, self.text = "", "", [], None, ""
        self.feed(page)
        self.close()

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag == "section":
            self.section = values["id"]
            self.words[self.section] = ""
        if values.get("role") == "img":
            self.labels.append(values["aria-label"])
        if tag == "table":
            self.caption, self.rows = "", []
        if tag == "tr":
            self.rows.append([])
        if tag in ("caption", "th", "td", "li", "script"):
            self.text = ""

    def handle_data(self, data):
        self.text += data
        if self.section:
            self.words[self.section] += data

    def handle_endtag(self, tag):
        if tag == "caption":
            self.caption = self.text
        if tag in ("th", "td"):
            self.rows[-1].append(self.text)
        if tag == "table":
            self.tables[self.caption] = self.rows
        if tag == "li" and self.section == "findings":
            self.findings.append(self.text)
        if tag == "section":
            self.section = ""

    def table(self, beginning):
        """Rows as dictionaries by head, numbers in SI; [] where the page has none."""
        for caption, (head, *rows) in self.tables.items():
            if caption.startswith(beginning):
                heads = [re.fullmatch(r"(.*?)(?: \[(.*)\])?", cell).groups() for cell in head]
                return [{name: cell if unit is None and not re.fullmatch(NUMBER, cell) else
                         float(cell) * size_of(unit or "") if re.fullmatch(NUMBER, cell) else cell
                         for (name, unit), cell in zip(heads, row)} for row in rows]
        return []


def amount(match, k=1):
    return float(match.group(k)) * size_of(match.group(k + 1))


def data_of(page):
    found = re.search(r'<script type="application/json" id="data">(.*?)</script>', page, re.S)
    return json.loads(found.group(1)) if found else None
