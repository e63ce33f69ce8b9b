"""Scripts that tests share."""

from __future__ import annotations

from pathlib import Path

import pytest

WING = """
param span = 10m in 1m..30m "Span"
param n = 3
param swept = true
let tip = (span / 2, 0, 0)
let area = span * 1m
let label = "wing {n}"
curve edge = bezier((0, 0), (span / 2, 300mm), (span, 0))
surface skin_of_it = ruled(edge, translate(edge, (0, 0, 200mm)))
mesh faces = tessellate(skin_of_it, tolerance = 5mm)
table offsets = table({t: [0, 1, 2], x: [1mm, 2mm, 3mm], who: ["a", "b", "c"]})
check span < 20m "not too wide"
print area
export edge to "edge.svg"
export offsets to "sub/offsets.csv"
"""


@pytest.fixture
def wing(tmp_path: Path) -> Path:
    script = tmp_path / "wing.geo"
    script.write_text(WING)
    return script
