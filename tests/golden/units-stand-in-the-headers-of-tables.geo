// Lengths are in the document's unit, angles in radians, as they are kept.
unit cm
table parts = table([
    for i in 1..2: {n: i, wide: i * 25mm, turn: i * 30deg, face: i * 1cm * 1cm, share: i / 2}
])
export parts to "parts.csv"
export parts to "parts.json"
