#!/usr/bin/python3
"""Prints which public names are documented, tested, and used in an example, as a Markdown table.

usage: list_names.py

The names are those that headers outside of internal/ declare in a namespace: types, functions, enumerators; the named
parameters that functions list; and the concepts. A name is documented if a comment of doxygen stands before it or, for an
enumerator, beside it. It is tested if a test names it, comments aside, and a concept if a test says "the concept NAME".

Exit: 0 all names are documented and tested, 1 some are not, 2 wrong usage.
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
PACKAGE = "Volume_mesh_parameterization"

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)
NAMESPACE = re.compile(r"^namespace (\w+) \{|^\} // namespace (\w+)")
# clang-format leaves what is declared in a namespace, and nothing else, without indentation
TYPE = re.compile(r"^(?:class|struct|enum)(?: \[\[\w+\]\])? (\w+)(?! *;)|^using (\w+) =")
FUNCTION = re.compile(r"^(?!return|static_assert)(?:\w[\w:<>,&* ]*[ &*>])?(\w+)\(")
ENUMERATOR = re.compile(r"^  ([A-Z][A-Z_0-9]+)(?: = -?\d+)?,? *(///<)?")
DECLARATION_BEFORE = re.compile(r"^template\b|^    +\S|^\w[\w:<>, ]+[>&]$")


def main(arguments):
    if arguments:
        wants_help = arguments[0] in ("-h", "--help")
        print(__doc__.strip(), file=sys.stdout if wants_help else sys.stderr)
        return 0 if wants_help else 2
    names = public_names()
    tests, examples = text_of("test"), text_of("examples")
    test_words, example_words = words_of_code(tests), words_of_code(examples)
    print("| name | kind | documented | tested | example |\n|---|---|---|---|---|")
    holes = []
    for name, (kind, documented) in sorted(names.items()):
        tested = f"the concept {name}" in tests if kind == "concept" else name in test_words
        if not (documented and tested):
            holes.append(name)
        print(f"| {name} | {kind} | {mark(documented)} | {mark(tested)} | {mark(name in example_words)} |")
    if holes:
        print("list_names.py: not documented or not tested: " + ", ".join(holes), file=sys.stderr)
    return 1 if holes else 0


def mark(holds):
    return "yes" if holds else "-"


def text_of(folder):
    return "\n".join(f.read_text() for f in sorted((ROOT / folder / PACKAGE).glob("*.*")) if f.suffix in (".cpp", ".h"))


def words_of_code(text):
    return set(re.findall(r"\w+", COMMENT.sub("", text)))


def public_names():
    """maps each name to its kind and whether it is documented everywhere where it is declared"""
    headers = ROOT / "include" / "CGAL" / PACKAGE
    texts = [f.read_text() for f in [*headers.glob("*.h"), *headers.glob("IO/*.h")]]
    names = {}
    for text in texts:
        for name, kind, documented in names_of(text.splitlines()):
            names[name] = (kind, documented and names.get(name, (kind, True))[1])
    for name in re.findall(r"\\cgalParamNBegin\{(\w+)\}", "".join(texts)):
        names[name] = ("named parameter", True)
    for file in (ROOT / "doc" / PACKAGE / "Concepts").glob("*.h"):
        names[file.stem] = ("concept", True)
    return names


def names_of(lines):
    namespaces, is_enum = [], False
    for i, line in enumerate(lines):
        if match := NAMESPACE.match(line):
            namespaces.append(match[1]) if match[1] else namespaces.pop()
        elif "internal" in namespaces or "internal_np" in namespaces:
            continue
        elif is_enum and (match := ENUMERATOR.match(line)):
            yield match[1], "enumerator", bool(match[2]) or is_documented(lines, i)
        elif match := TYPE.match(line):
            is_enum = line.startswith("enum")
            yield match[1] or match[2], "type", is_documented(lines, i)
        elif match := FUNCTION.match(line):
            yield match[1], "function", is_documented(lines, i)


def is_documented(lines, i):
    """whether a comment of doxygen ends right before the declaration of which line i is the one with the name"""
    while DECLARATION_BEFORE.match(lines[i - 1]):
        i -= 1
    return lines[i - 1].lstrip().startswith("///") or lines[i - 1] == "*/"


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
