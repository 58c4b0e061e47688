"""The notebooks run, in reduced size, from their first cell to their last, and draw."""

import os
import re

import jupytext
import nbclient
import pytest

NOTEBOOKS = {"first_drop": 4, "response_surface": 1, "sensitivity": 1, "choose_pad": 3, "calibrate_traces": 1}


@pytest.mark.parametrize("name", NOTEBOOKS)
def test_notebook(root, tmp_path, monkeypatch, name):
    monkeypatch.setenv("SOFTANVIL_QUICK", "1")
    monkeypatch.delenv("MPLBACKEND", raising=False)
    notebook = jupytext.read(root / f"python/examples/{name}.py")
    nbclient.NotebookClient(notebook, timeout=120, kernel_name="python3", resources={"metadata": {"path": str(tmp_path)}}).execute()
    outputs = [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]
    pictures = [output.data["image/png"] for output in outputs if "image/png" in output.get("data", {})]
    assert len(pictures) >= NOTEBOOKS[name]
    assert not [output for output in outputs if output.output_type == "error" or output.get("name") == "stderr"]
    if kept := os.environ.get("SOFTANVIL_PICTURES"):
        import base64
        from pathlib import Path

        for number, picture in enumerate(pictures):
            (Path(kept) / f"{name}-{number}.png").write_bytes(base64.b64decode(picture))


def test_first_drop_of_the_documentation(root, tmp_path, monkeypatch, capsys):
    """The program of docs/first-drop.md prints the peak that the page states, and leaves its files."""
    page = (root / "docs/first-drop.md").read_text()
    (program,) = re.findall(r"## In Python\n.*?```python\n(.*?)```", page, re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(program, {})
    (stated,) = re.findall(r"the drop of 9\.8 J one of `(.*?)`", page)
    assert capsys.readouterr().out == f"{stated}\n"
    assert sorted(path.name for path in tmp_path.iterdir()) == ["force.png", "sweep.csv"]


def test_program_of_the_readme(root, tmp_path, monkeypatch):
    (program,) = re.findall(r"```python\n(.*?)```", (root / "README.md").read_text(), re.DOTALL)
    monkeypatch.chdir(tmp_path)
    exec(program, {})
    assert [path.name for path in tmp_path.iterdir()] == ["force.png"]
