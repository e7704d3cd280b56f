"""A document as a list of blocks, printed as Markdown and as HTML."""

import html
from dataclasses import dataclass


@dataclass
class Heading:
    text: str
    level: int = 2

    def markdown(self):
        return f"{'#' * self.level} {self.text}"

    def html(self):
        return f"<h{self.level}>{html.escape(self.text)}</h{self.level}>"


@dataclass
class Paragraph:
    text: str

    def markdown(self):
        return self.text

    def html(self):
        return f"<p>{html.escape(self.text)}</p>"


@dataclass
class Code:
    text: str

    def markdown(self):
        fence = "```"
        while fence in self.text:
            fence += "`"
        return f"{fence}text\n{self.text.rstrip()}\n{fence}"

    def html(self):
        return f"<pre>{html.escape(self.text.rstrip())}</pre>"


@dataclass
class Table:
    """Columns of figures are set to the right."""

    head: list
    rows: list

    def _is_figures(self, column):
        return all(str(row[column])[:1].isdigit() for row in self.rows)

    def markdown(self):
        rule = ["---:" if self._is_figures(column) else "---" for column in range(len(self.head))]
        return "\n".join("| " + " | ".join(str(cell).replace("|", "\\|") for cell in row) + " |"
                         for row in [self.head, rule, *self.rows])

    def html(self):
        def line(cells, tag):
            return "<tr>" + "".join(
                f"<{tag}{' class=n' if self._is_figures(column) else ''}>{html.escape(str(cell))}"
                f"</{tag}>" for column, cell in enumerate(cells)) + "</tr>"
        return "\n".join(["<table>", line(self.head, "th"),
                          *(line(row, "td") for row in self.rows), "</table>"])


_STYLE = ("body{font-family:sans-serif;max-width:70em;margin:2em auto}"
          "table{border-collapse:collapse}td,th{border:1px solid #999;padding:.2em .6em}"
          ".n{text-align:right}pre{background:#eee;padding:.6em;overflow:auto}")


def to_markdown(blocks):
    return "\n\n".join(block.markdown() for block in blocks) + "\n"


def to_html(title, blocks):
    body = "\n".join(block.html() for block in blocks)
    return (f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
            f"<title>{html.escape(title)}</title><style>{_STYLE}</style></head>\n"
            f"<body>\n{body}\n</body></html>\n")
