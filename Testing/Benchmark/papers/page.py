# SPDX-FileCopyrightText: Copyright (c) the PointSplatting authors
# SPDX-License-Identifier: BSD-3-Clause
"""One HTML page with its pictures in it, and all that was measured as JSON beside it."""
import base64
import html
import json
import math
import os
import tempfile

import numpy as np

from bench.charts import ticks
from drawing import save

STYLE = """body{font:15px/1.5 sans-serif;max-width:1150px;margin:2em auto;padding:0 1em;color:#222}
table{border-collapse:collapse;margin:.8em 0;font-size:14px}
td,th{border:1px solid #ccc;padding:.2em .6em;text-align:right}
td:first-child,th:first-child{text-align:left}th{background:#f3f3f3}
.paper{color:#777;font-style:italic}.differs{border-left:4px solid #d90;padding-left:.8em}
figure{display:inline-block;margin:.4em;vertical-align:top}figcaption{font-size:13px;color:#444}
img{max-width:520px;display:block}"""
COLOURS = ("#1e78dc", "#00a578", "#7828c8", "#d96c14", "#222", "#c81e28")
WIDTH, HEIGHT, LEFT, BOTTOM, RIGHT = 620, 320, 60, 45, 190


class Number:
    """What was measured here, and the text that a table shows of it: three digits, or `form`."""

    def __init__(self, value, form=None, unit=""):
        self.value = float(value)
        form = form or (",.0f" if abs(self.value) >= 100 else ".3g")
        self.text = f"{self.value:{form}}{unit}"


class Quoted:
    """What a paper says, to stand in a table."""

    def __init__(self, value):
        self.text = f"{value}"


class Section:
    """Texts, tables, pictures and charts, in the order in which they are added."""

    def __init__(self, name, title):
        self.name, self.title = name, title
        self.parts, self.rows, self.pictures_seen = [], [], 0

    def text(self, words):
        self.parts.append(f"<p>{html.escape(words)}</p>")

    def differs(self, words):
        """Where our values are other than the paper's, and why."""
        self.parts.append(f'<p class="differs">{html.escape(words)}</p>')

    def table(self, header, rows):
        """A cell is a text, a Number that was measured here, or a paper's Quoted."""
        lines = ["<table><tr>" + "".join(f"<th>{html.escape(h)}</th>" for h in header) + "</tr>"]
        for row in rows:
            cells = []
            for cell in row:
                text = html.escape(getattr(cell, "text", cell))
                style = ' class="paper"' if isinstance(cell, Quoted) else ""
                cells.append(f"<td{style}>{text}</td>")
            lines.append("<tr>" + "".join(cells) + "</tr>")
            numbers = {h: cell.value for h, cell in zip(header, row) if isinstance(cell, Number)}
            if numbers:
                self.rows.append({"row": row[0] if isinstance(row[0], str) else row[0].text,
                                  **numbers})
        self.parts.append("\n".join(lines) + "</table>")

    def pictures(self, named):
        """named: captions with [height, width, 3], 0 to 255, row 0 lowest."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "picture.png")
            for caption, picture in named:
                save(path, picture)
                with open(path, "rb") as file:
                    data = base64.b64encode(file.read()).decode("ascii")
                self.parts.append(
                    f'<figure><img alt="{html.escape(caption)}" src="data:image/png;base64,{data}">'
                    f"<figcaption>{html.escape(caption)}</figcaption></figure>")
                self.pictures_seen += 1

    def chart(self, x_title, y_title, series, log=True):
        """series: names with values x and y; log: both axes."""
        self.parts.append(chart(x_title, y_title, series, log))


def even_ticks(low, high):
    step = 10 ** math.floor(math.log10(high - low))
    step *= 1 if high - low > 4 * step else 0.5 if high - low > 2 * step else 0.25
    found = [step * i for i in range(math.floor(low / step), math.ceil(high / step) + 1)]
    return [value for value in found if low <= value <= high]


def chart(x_title, y_title, series, log):
    """As SVG."""
    def scaled(values):
        return np.log10(values) if log else np.asarray(values, float)

    marks = ticks if log else even_ticks
    ends, places = [], []
    for axis, (first, last) in enumerate(((LEFT, WIDTH - RIGHT), (HEIGHT - BOTTOM, 12))):
        values = scaled(np.concatenate([np.asarray(s[1 + axis], float) for s in series]))
        margin = 0.05 * (values.max() - values.min()) or 0.1
        low, high = values.min() - margin, values.max() + margin
        ends.append((10 ** low, 10 ** high) if log else (low, high))
        places.append(lambda v, low=low, high=high, first=first, last=last:
                      first + (scaled(v) - low) / (high - low) * (last - first))
    at_x, at_y = places
    out = [f'<svg width="{WIDTH}" height="{HEIGHT}" font-size="12" font-family="sans-serif">']
    for value in marks(*ends[0]):
        x = at_x(value)
        out.append(f'<path d="M{x:.1f} 12V{HEIGHT - BOTTOM}" stroke="#ddd"/><text x="{x:.1f}" '
                   f'y="{HEIGHT - BOTTOM + 16}" text-anchor="middle">{value:g}</text>')
    for value in marks(*ends[1]):
        y = at_y(value)
        out.append(f'<path d="M{LEFT} {y:.1f}H{WIDTH - RIGHT}" stroke="#ddd"/><text x="{LEFT - 5}" '
                   f'y="{y + 4:.1f}" text-anchor="end">{value:g}</text>')
    for i, (name, x, y) in enumerate(series):
        colour = COLOURS[i % len(COLOURS)]
        points = " ".join(f"{at_x(a):.1f},{at_y(b):.1f}" for a, b in zip(x, y))
        out.append(f'<polyline points="{points}" fill="none" stroke="{colour}" stroke-width="2"/>')
        out += [f'<circle cx="{at_x(a):.1f}" cy="{at_y(b):.1f}" r="3.5" fill="{colour}"/>'
                for a, b in zip(x, y)]
        out.append(f'<text x="{WIDTH - RIGHT + 12}" y="{24 + 18 * i}" fill="{colour}">'
                   f"{html.escape(name)}</text>")
    middle = (HEIGHT - BOTTOM) / 2
    out.append(f'<text x="{(LEFT + WIDTH - RIGHT) / 2}" y="{HEIGHT - 8}" text-anchor="middle">'
               f'{html.escape(x_title)}</text><text transform="translate(14 {middle}) rotate(-90)" '
               f'text-anchor="middle">{html.escape(y_title)}</text></svg>')
    return "".join(out)


class Page:
    def __init__(self, folder):
        self.folder, self.sections = folder, []
        os.makedirs(folder, exist_ok=True)

    def write(self, machine):
        """papers.html and papers.json; machine: facts by name."""
        flat = [(key, " ".join(value.values()) if isinstance(value, dict) else value)
                for key, value in machine.items()]
        facts = "; ".join(f"{key}: {value}" for key, value in flat)
        contents = "".join(f'<li><a href="#{s.name}">{html.escape(s.title)}</a></li>'
                           for s in self.sections)
        out = ['<!DOCTYPE html><html lang="en"><head><meta charset="utf-8">',
               f"<title>The papers' tables and figures</title><style>{STYLE}</style></head><body>",
               "<h1>The papers' tables and figures, made anew</h1>",
               "<p>The papers' values are quoted, grey and slanted; all others were measured in "
               f"this run. {html.escape(facts)}</p><ol>{contents}</ol>"]
        for section in self.sections:
            out.append(f'<h2 id="{section.name}">{html.escape(section.title)}</h2>')
            out += section.parts
        with open(os.path.join(self.folder, "papers.html"), "w", encoding="utf-8") as file:
            file.write("\n".join(out) + "\n</body></html>\n")
        with open(os.path.join(self.folder, "papers.json"), "w", encoding="utf-8") as file:
            json.dump({"machine": machine, "sections": {
                s.name: {"rows": s.rows, "pictures": s.pictures_seen} for s in self.sections}},
                file, indent=1)
