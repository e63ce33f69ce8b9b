let report = {kind: "own", n: 3}
export report to "report.json"
print report.n
