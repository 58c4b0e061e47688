#!/usr/bin/env python3
"""imports.py FOLDER...: shows that no files of a crate or of a Python package import each other in a circle, nor do a crate's
folders.

A crate is a folder with src/lib.rs. A file imports another if it names an item that the other defines: in `use`, or by a path
that begins with crate, super or self. A name that a module passes on (pub use) counts for the file that defines it, and passing
on is no import. Comments and tests do not count.

A Python package is a folder with __init__.py. Every import statement in it counts, within functions and for type checkers too.
"""

import ast
import re
import sys
from pathlib import Path

PATH = re.compile(r"\b(?:crate|super|self)(?:::(?:r#)?\w+)+")
MODULE = re.compile(r"^\s*(?:pub(?:\([^)]*\))?\s+)?mod\s+(\w+)\s*;", re.M)
USE = re.compile(r"^[ \t]*(pub(?:\([^)]*\))?\s+)?use\s+([^;]+);", re.M)


def without_tests(text):
    """The text without comments, strings and items that are compiled for tests alone."""
    text = re.sub(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\])*"', " ", text, flags=re.S)
    while found := re.search(r"#\[cfg\((?:test|all\(test[^\]]*)\)\]", text):
        end, depth = found.end(), 0
        while end < len(text) and not (depth == 0 and text[end] == ";"):
            depth += {"{": 1, "}": -1}.get(text[end], 0)
            end += 1
            if depth == 0 and text[end - 1] == "}":
                break
        text = text[: found.start()] + text[end + 1 :]
    return text


def leaves(tree, before=()):
    """Every (path, name) of the tree of a `use`; the name is that under which its path is known."""
    tree = tree.strip()
    head, brace, rest = tree.partition("{")
    if not brace:
        path, _, name = tree.partition(" as ")
        steps = before + tuple(step.strip() for step in path.split("::"))
        yield steps, name.strip() or steps[-1]
        return
    before += tuple(step.strip() for step in head.split("::") if step.strip())
    depth, start = 0, 0
    inner = rest[: rest.rindex("}")]
    for end, mark in enumerate(inner + ","):
        depth += {"{": 1, "}": -1}.get(mark, 0)
        if mark == "," and depth == 0:
            if inner[start:end].strip():
                yield from leaves(inner[start:end], before)
            start = end + 1


class Crate:
    """The modules of a crate, each with its file, its text, and what it passes on."""

    def __init__(self, folder):
        self.folder = folder / "src"
        self.file, self.text, self.passed_on = {}, {}, {}
        self.add((), self.folder / "lib.rs")
        for module, text in self.text.items():
            self.passed_on[module] = {
                name: self.absolute(module, path)
                for public, tree in USE.findall(text)
                if public
                for path, name in leaves(tree)
            }

    def add(self, module, file):
        self.file[module], self.text[module] = file, without_tests(file.read_text())
        inside = file.parent if file.name in ("lib.rs", "mod.rs") else file.with_suffix("")
        for name in MODULE.findall(self.text[module]):
            at = [path for path in (inside / f"{name}.rs", inside / name / "mod.rs") if path.exists()]
            self.add((*module, name), at[0])

    def absolute(self, module, path):
        """A path from the root of the crate; none for one that leads out of it."""
        first, rest = path[0], path[1:]
        if first == "crate":
            return rest
        if first == "self":
            return module + rest
        if first == "super":
            while rest and rest[0] == "super":
                module, rest = module[:-1], rest[1:]
            return module[:-1] + rest
        return module + path if (*module, first) in self.file else None

    def definition(self, path):
        """The module that defines what `path` names."""
        module = ()
        for i, step in enumerate(path):
            if (*module, step) in self.file:
                module = (*module, step)
                continue
            known = self.passed_on[module].get(step)
            if known and known != (*module, step):
                return self.definition((*known, *path[i + 1 :]))
            break
        return module

    def imports(self, module):
        """The modules whose items `module` names."""
        paths = []
        for public, tree in USE.findall(self.text[module]):
            paths += [path for path, _ in leaves(tree) if not public]
        for found in PATH.findall(USE.sub("", self.text[module])):
            paths.append(tuple(found.split("::")))
        absolute = (self.absolute(module, path) for path in paths)
        return {self.definition(path) for path in absolute if path is not None} - {module}


def imported(package, text):
    """The first names, within a Python package, of what the text of one of its modules imports of it."""
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, ast.Import):
            paths = [alias.name for alias in node.names]
        elif isinstance(node, ast.ImportFrom):
            origin = ".".join(filter(None, [package if node.level else "", node.module]))
            paths = [f"{origin}.{alias.name}" for alias in node.names]
        else:
            continue
        for path in paths:
            first, *rest = path.split(".")
            if first == package:
                yield rest[0] if rest else "__init__"


def modules(folder):
    """The modules of a Python package, each with those that it imports."""
    texts = {path.stem: path.read_text() for path in folder.glob("*.py")}
    # What is no module is compiled, and has a stub, or is an item of the package's own module.
    compiled = {path.stem for path in folder.glob("*.pyi")} - texts.keys()
    return {
        module: {name if name in texts else "__init__" for name in imported(folder.name, text) if name not in compiled} - {module}
        for module, text in texts.items()
    }


def circles(graph):
    """The sets of nodes that reach each other, by Tarjan's algorithm."""
    index, low, stack, found = {}, {}, [], []

    def visit(node):
        index[node] = low[node] = len(index)
        stack.append(node)
        for other in sorted(graph[node]):
            if other not in index:
                visit(other)
                low[node] = min(low[node], low[other])
            elif other in stack:
                low[node] = min(low[node], index[other])
        if low[node] == index[node]:
            circle = stack[stack.index(node) :]
            del stack[stack.index(node) :]
            if len(circle) > 1:
                found.append(sorted(circle))

    for node in sorted(graph):
        if node not in index:
            visit(node)
    return found


def check(folder):
    """The circles of a crate or package, as lines."""
    if (folder / "__init__.py").exists():
        return [f"{folder}: modules import each other: {', '.join(c)}" for c in circles(modules(folder))]
    crate = Crate(folder)
    files = {module: crate.imports(module) for module in crate.file}
    # The root declares and passes on.
    files[()] = set()
    rooms = {}
    for module, others in files.items():
        for other in others:
            if module and other and module[0] != other[0]:
                rooms.setdefault(module[0], set()).add(other[0])
                rooms.setdefault(other[0], set())
    lines = [f"{folder}: files import each other: {', '.join('::'.join(m) for m in c)}" for c in circles(files)]
    return lines + [f"{folder}: folders import each other: {', '.join(c)}" for c in circles(rooms)]


if __name__ == "__main__":
    lines = [line for folder in sys.argv[1:] for line in check(Path(folder))]
    print("\n".join(lines) or "no circle")
    sys.exit(1 if lines else 0)
