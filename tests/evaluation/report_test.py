#!/usr/bin/python3
"""The quick evaluation shows all that is judged of it, each table is written, and its report is made,
complete, and needs nothing beside itself.

Usage: report_test.py RMAP PAPER_REPORT    exit code 77: matplotlib is not here
"""

import importlib.util
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path


def check_results(folder):
    results = json.loads((folder / "results.json").read_text())
    judged = [check for check in results["checks"] if check["judged"]]
    refuted = [check for check in judged if not check["holds"]]
    assert not refuted, refuted
    assert len({check["experiment"] for check in judged}) >= 3, judged
    tables = {table.name for table in folder.glob("*.csv")}
    wanted = {"sequences", "rtree", "grid", "grid_references", "accuracy", "history", "query_cuboids",
              "clouds", "cuboids", "checks"}
    assert tables == {f"{table}.csv" for table in wanted}, tables


def main(rmap, paper_report):
    with tempfile.TemporaryDirectory() as folder:
        results, report = Path(folder) / "results", Path(folder) / "report"
        subprocess.run([rmap, "evaluate", "--quick", "-o", results], check=True)
        check_results(results)
        if importlib.util.find_spec("matplotlib") is None:
            print("python3-matplotlib is not here: no report was made")
            return 77
        subprocess.run([sys.executable, paper_report, results, "-o", report], check=True)
        page = (report / "report.html").read_text()
        markdown = (report / "report.md").read_text()
        pictures = sorted((report / "pictures").iterdir())
        # R-trees, maps, accuracy, query cuboids, and three clouds.
        assert len(pictures) == 7, pictures
        assert page.count("<svg") == len(pictures)
        assert not re.search(r'(?:src|href)="(?!#|data:)', page.replace("xlink:href", "href")), \
            "the page refers to something outside"
        names = re.findall(r' id="([^"]+)"', page)
        assert len(names) == len(set(names)), "two drawings share a name"
        for words in ("RMAP 3.1", "Fig. 8", "RMAP 3.2", "Fig. 2c", "Table 1", "History",
                      "rmap evaluate", "not available to us"):
            assert words in page and words in markdown, words
        for picture in pictures:
            assert f"pictures/{picture.name}" in markdown
    return 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
