"""How a run and a comparison look in a notebook: figure, verdict, table."""

from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING, Iterable

if TYPE_CHECKING:
    from .comparison import Comparison
    from .result import Result

__all__ = ["comparison_html", "result_html"]

# Beyond this a figure would make the notebook slow.
_MOST_BYTES = 8_000_000


def _picture(svg: str) -> str:
    """As an image of its own: the names in one SVG are not those of another."""
    data = base64.b64encode(svg.encode()).decode()
    if len(data) > _MOST_BYTES:
        return "<p>The figure is large: <code>.svg()</code> has it.</p>"
    return f'<img style="max-width:100%;background:white" src="data:image/svg+xml;base64,{data}"/>'


def _list(lines: Iterable[str]) -> str:
    items = "".join(f"<li>{html.escape(line)}</li>" for line in lines)
    return f"<ul>{items}</ul>" if items else ""


def _verdict(result: Result) -> str:
    error = result.relative_error
    said = f"relative error {100 * error:.2g} %" if error == error else "relative error unknown"
    reliable = int(result.reliable.sum())
    ended = "" if result.complete else " <b>Incomplete.</b>"
    return (
        f"<b>{html.escape(result.method)}</b> on <b>{html.escape(result.name)}</b>: {result.samples:,} samples in "
        f"{result.seconds:.3g} s, {said}, {reliable:,} of {result.reliable.size:,} numbers reliable.{ended}"
    )


def result_html(result: Result) -> str:
    """Figure, verdict, warnings and the table of mutations."""
    parts = [_picture(result.svg()), f"<p>{_verdict(result)}</p>", _list(result.warnings)]
    table = result.mutations
    if len(table):
        parts.append(table.to_html(float_format=lambda x: f"{x:.3g}"))
    return "\n".join(parts)


def comparison_html(comparison: Comparison) -> str:
    """Verdict, doubts and the table of errors."""
    parts = [_list(comparison.verdict), comparison.table.to_html(float_format=lambda x: f"{x:.3g}")]
    if comparison.warnings:
        parts.append("<p>To doubt:</p>" + _list(comparison.warnings))
    return "\n".join(parts)
