"""One HTML page that needs no other file and no network: pictures are part of it."""
import base64
from html import escape

STYLE = """
:root { color-scheme: light; }
* { box-sizing: border-box; }
body { margin: 0; background: #f6f7f9; color: #1b1f24; font: 16px/1.55 system-ui, "Segoe UI", "DejaVu Sans", sans-serif; }
main, header { max-width: 80rem; margin: 0 auto; padding: 0 1rem; }
header { padding-top: 1.5rem; }
h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .5rem; }
h2 { font-size: 1.15rem; line-height: 1.3; margin: 0 0 .3rem; }
p { margin: .4rem 0; }
nav { display: flex; flex-wrap: wrap; gap: .35rem; margin: .8rem 0 1.2rem; }
nav a { padding: .3rem .6rem; background: #fff; border: 1px solid #d5dae1; border-radius: .4rem; text-decoration: none;
  color: #1f4e79; font-size: .9rem; }
section { background: #fff; border: 1px solid #dfe3e8; border-radius: .6rem; padding: 1rem; margin: 0 0 1rem; }
.source { color: #57606a; font-size: .82rem; overflow-wrap: anywhere; }
.badge { display: inline-block; padding: 0 .5rem; border-radius: .7rem; font-size: .78rem; font-weight: 600;
  white-space: nowrap; }
.measured { background: #dff2e4; color: #14532d; }
.modelled { background: #fdebc8; color: #6b3d00; }
.missing { color: #8a2a1a; font-size: .9rem; }
.scroll { overflow-x: auto; }
table { border-collapse: collapse; font-size: .9rem; margin: .6rem 0; min-width: min(100%, 34rem); }
th, td { text-align: right; padding: .3rem .6rem; border-bottom: 1px solid #e4e8ec; }
th:first-child, td:first-child { text-align: left; }
th, td:not(:first-child) { white-space: nowrap; }
th { color: #57606a; font-weight: 600; }
.beside { display: grid; grid-template-columns: minmax(0, 1fr); column-gap: 1.5rem; }
img { display: block; width: 100%; max-width: 38rem; height: auto; margin: .3rem 0; }
details { margin: .3rem 0 .6rem; font-size: .88rem; }
details .scroll { max-height: 22rem; overflow: auto; }
summary { cursor: pointer; color: #1f4e79; padding: .2rem 0; }
dl { display: grid; grid-template-columns: max-content 1fr; gap: .1rem 1rem; font-size: .9rem; margin: .6rem 0; }
dt { color: #57606a; } dd { margin: 0; overflow-wrap: anywhere; }
@media (min-width: 60rem) {
  .beside { grid-template-columns: minmax(0, 5fr) minmax(0, 6fr); }
  .beside table { min-width: 0; }
  header p, section > p { max-width: 62rem; }
}
@media (max-width: 30rem) {
  section { padding: .8rem; } table { min-width: 100%; } th, td { padding: .3rem .25rem; }
  td .badge { padding: 0 .35rem; font-size: .7rem; }
  dl { grid-template-columns: 1fr; } dd { margin-bottom: .3rem; }
}
"""

INTRODUCTION = """
<p>Chapter 3 of K. Marwah's thesis (University of Illinois, 2014) made the assembly of a spacetime discontinuous Galerkin code faster,
step by step, on a host with twelve cores and on a many-core card. This page repeats its tables and figures, each beside
the numbers that its text gives.</p>
<p><span class="badge measured">measured</span> numbers come from the machine below;
<span class="badge modelled">modelled</span> ones from <code>tentpole model</code>, a simulator of the thesis's machines whose
parameters marked “fitted” were chosen by statements of the thesis, so agreement with those is no prediction. No curve
holds both.</p>
"""


def _table(columns, rows):
    head = "".join(f"<th>{escape(str(column))}</th>" for column in columns)
    body = "".join("<tr>" + "".join(f"<td>{cell}</td>" for cell in row) + "</tr>" for row in rows)
    return f'<div class="scroll"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>'


def _badge(nature):
    return f'<span class="badge {nature}">{nature}</span>'


def _comparison(exhibit):
    rows = [[escape(what).replace(" = ", "&nbsp;=&nbsp;"), escape(thesis), escape(here), _badge(nature)]
            for what, thesis, here, nature in exhibit.comparison]
    return _table(["", "thesis", "here", ""], rows) if rows else ""


def _image(part, folder, alternative):
    path = folder / f"{part.name}.png"
    if not path.exists():
        return ""
    data = base64.b64encode(path.read_bytes()).decode()
    return f'<img alt="{escape(alternative)}" src="data:image/png;base64,{data}">'


def _part(part, exhibit, folder):
    numbers = _table(part.columns, [[escape(str(cell)) for cell in row] for row in part.rows])
    return (f'{_image(part, folder, f"{exhibit.title}, {part.nature}")}'
            f'<p class="source">{_badge(part.nature)} {escape(part.source)}</p>'
            f"<details><summary>All {len(part.rows)} rows of {part.name}.csv</summary>{numbers}</details>")


def _section(exhibit, folder):
    missing = "".join(f'<p class="missing">{escape(reason)}</p>' for reason in exhibit.missing)
    return (f'<section id="{exhibit.name}"><h2>{exhibit.kind} {exhibit.number}. {escape(exhibit.title)}</h2>'
            f"<p>{escape(exhibit.caption)}</p>"
            f'<div class="beside"><div>{_comparison(exhibit)}{missing}</div>'
            f'<div>{"".join(_part(part, exhibit, folder) for part in exhibit.parts)}</div></div></section>')


def write_page(exhibits, machine, folder):
    """Writes FOLDER/index.html from the exhibits and their pictures in the folder."""
    links = "".join(f'<a href="#{e.name}">{e.kind} {e.number}</a>' for e in exhibits)
    facts = "".join(f"<dt>{escape(what)}</dt><dd>{escape(value)}</dd>" for what, value in machine)
    sections = "\n".join(_section(exhibit, folder) for exhibit in exhibits)
    page = (f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8"><meta name="viewport" '
            f'content="width=device-width, initial-scale=1"><title>Thesis figures, repeated with Tentpole</title>'
            f"<style>{STYLE}</style></head><body><header><h1>The thesis's tables and figures, repeated with Tentpole</h1>"
            f"{INTRODUCTION}<dl>{facts}</dl><nav>{links}</nav></header><main>\n{sections}\n</main></body></html>\n")
    (folder / "index.html").write_text(page, encoding="utf-8")
