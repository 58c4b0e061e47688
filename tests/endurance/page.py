"""The counts of recorded runs (runs.json) in docs/reliability.md: `page.py` writes them, `page.py --check` compares."""

import json
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
RUNS = HERE / "runs.json"
PAGE = HERE.parents[1] / "docs/reliability.md"
BEGIN, END = "<!-- runs.json begins -->\n", "<!-- runs.json ends -->\n"

ORDER = ("files", "calls", "driven", "drops", "memory", "build")


def number(value):
    """With a space after every three digits."""
    return f"{value:,}".replace(",", " ")


def table(rows):
    """Rows of one run, as Markdown."""
    lines = ["| part | what | count | seconds | findings |", "|---|---|---|---|---|"]
    for row in rows:
        count = f"{number(row['count'])} {row['unit']}"
        lines.append(f"| {row['part']} | {row['what']} | {count} | {number(row['seconds'])} | {len(row['findings'])} |")
    return "\n".join(lines) + "\n"


def totals(runs):
    """Rows of all runs, added up by what was tried."""
    summed = {}
    for row in (row for run in runs for row in run["rows"]):
        total = summed.setdefault((row["part"], row["what"]), row | {"count": 0, "seconds": 0, "findings": []})
        total["count"] += row["count"]
        total["seconds"] += row["seconds"]
        total["findings"] = total["findings"] + row["findings"]
    return sorted(summed.values(), key=lambda row: ORDER.index(row["part"]))


def all_of(rows, unit):
    return sum(row["count"] for row in rows if row["unit"] == unit)


def counts(runs):
    """What the page holds of the runs."""
    rows = totals(runs)
    findings = sum(len(row["findings"]) for row in rows)
    hours = sum(row["seconds"] for row in rows) / 3600
    dropped = [row["of_drops"] for run in runs for row in run["rows"] if "of_drops" in row]
    text = (f"So far: {number(all_of(rows, 'executions'))} executions of fuzzed targets and {number(all_of(rows, 'drops'))} random "
            f"drops in {hours:.1f} hours, findings: {findings}.\n\n{table(rows)}\n")
    if dropped:
        largest = {key: max(one[key] for one in dropped) for key in ("residual", "penetration", "momentum")}
        # Runs before there was an estimate of what layers bear have counted none beyond it.
        solids, coarse, flat = (sum(one.get(key, 0) for one in dropped) for key in ("solids", "too_coarse", "unbearable"))
        text += (f"{number(solids)} of the drops were on solids. Over all of them the largest residual of the energy was {100 * largest['residual']:.2f} % of what was brought "
                 f"in, the largest change of momentum unexplained {largest['momentum']:.1e} of that at the start, the deepest "
                 f"penetration of one layer into another {100 * largest['penetration']:.2f} % of a cell. {number(coarse)} of the drops were "
                 f"more than a coarse mesh could follow, and went through with elements of 3 mm. Refused, because they bring one and a half "
                 f"times the energy that presses their layers flat: {number(flat)}.\n\n")
    text += "| run | of | on | skipped |\n|---|---|---|---|\n"
    for run in runs:
        skipped = ", ".join(name for name, _ in run["skipped"]) or "nothing"
        text += f"| `{run['command']}` | {run['date']}, {run['commit']} | {run['machine']} | {skipped} |\n"
    return text


def written(runs):
    before, rest = PAGE.read_text().split(BEGIN)
    _, after = rest.split(END)
    return before + BEGIN + counts(runs) + END + after


def record(run):
    """Adds a run, and writes the page anew."""
    runs = json.loads(RUNS.read_text()) if RUNS.is_file() else []
    runs.append(run)
    RUNS.write_text(json.dumps(runs, indent=1) + "\n")
    PAGE.write_text(written(runs))


if __name__ == "__main__":
    page = written(json.loads(RUNS.read_text()))
    if sys.argv[1:] == ["--check"]:
        sys.exit(0 if page == PAGE.read_text() else "docs/reliability.md is not of runs.json: run tests/endurance/page.py")
    PAGE.write_text(page)
