#!/usr/bin/env python3
"""Rows of benches into the tables of docs/speed.md. Usage: bench/table.py LINES PAGE

Lines: "row<TAB>task<TAB>by hand<TAB>ours<TAB>ratio<TAB>asked<TAB>difference", "peer<TAB>task<TAB>peer<TAB>time", and "scale<TAB>...". A
table of the page stands between <!-- NAME --> and <!-- end -->; a row of the same task (scale: machine and links) is replaced in its place, a new one added."""
import re
import sys

KEYS = {"row": 1, "peer": 2, "scale": 2}


def merge(table, kind, new):
    lines = table.strip("\n").split("\n")
    head, body = lines[:2], lines[2:]
    rows = {tuple(cell.strip() for cell in line.strip("|").split("|"))[:KEYS[kind]]: line for line in body}
    for cells in new:
        line = "| " + " | ".join(cells) + " |"
        rows[tuple(cells[:KEYS[kind]])] = line
    return "\n".join(head + list(rows.values())) + "\n"


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        lines = [line.rstrip("\n").split("\t") for line in file]
    with open(sys.argv[2], encoding="utf-8") as file:
        page = file.read()
    for kind in KEYS:
        new = [[cell.strip() or "-" for cell in line[1:]] for line in lines if line[0] == kind]
        pattern = re.compile(r"(<!-- %s -->\n)(.*?)(<!-- end -->)" % kind, re.S)
        page = pattern.sub(lambda m: m.group(1) + merge(m.group(2), kind, new) + m.group(3), page)
    with open(sys.argv[2], "w", encoding="utf-8") as file:
        file.write(page)


main()
