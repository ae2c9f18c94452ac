# SPDX-License-Identifier: LGPL-2.1-or-later
"""Checks rules of the source tree that no compiler knows: layering, licence lines, function sizes, paths."""

import re
from pathlib import Path
from typing import List

import source_tree

# The stages of the pipeline: a folder includes only itself and what stands before it.
LAYERS = "base spline input analysis nearest surface extension trimming projection topology stack report".split()
CORE = source_tree.ROOT / "src" / "core"

LINE_LIMIT = 80
PERCENTILE_LIMIT = 35

SPDX_SUFFIXES = {".h", ".cpp", ".py", ".pyi", ".cmake", ".sh", ".FCMacro", ".toml", ".yaml"}
SPDX_FOLDERS = {"scripts", ".ci"}
SPDX_NAMES = {"CMakeLists.txt", ".clang-format", ".clang-tidy", ".editorconfig"}

# Written so that the pattern does not match itself.
UNFINISHED = re.compile("TO" "DO|FIX" "ME")
MACHINE_PATH = re.compile(r"(?<![\w.$}~])/(?:[w]ork|[h]ome|[r]oot|[t]mp|[U]sers)/\w|[A-Z]:\\[U]sers")

SAMPLE = """
namespace a
{
struct Point
{
    double x{0.0}, y = f({1, 2});
    double sum() const { return x + y; }
};
const std::vector<int> table = {1, 2, 3};
Thing::Thing(int n)
    : m_n{n}, m_text("}")
{
    // a } in a comment
    auto twice = [](int k) {
        return 2 * k;
    };
}
template <typename T>
T largest(T one, T two)
{
    if (one < two)
    {
        return two;
    }
    return one;
}
} // namespace a
"""


def text_files() -> List[Path]:
    """Returns the project's files that are text."""
    return [path for path in source_tree.source_files() if b"\0" not in path.read_bytes()]


def relative(path: Path) -> str:
    """Returns a path as it is written in messages."""
    return str(path.relative_to(source_tree.ROOT))


def test_the_function_counter_counts() -> None:
    counted = [(f.head.split("(")[0].split()[-1], f.lines) for f in source_tree.cpp_functions(SAMPLE, "sample")]
    assert counted == [("sum", 1), ("Thing::Thing", 8), ("largest", 9)]


def test_core_stages_include_only_earlier_ones() -> None:
    checked = 0
    for path in sorted(CORE.rglob("*.[hc]*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        folder = path.relative_to(CORE).parts[0]
        for include in re.findall(r'^\s*#\s*include\s+"([^"]+)"', path.read_text(encoding="utf-8"), re.MULTILINE):
            target = (path.parent / include).resolve()
            assert target.is_file(), f"{relative(path)} includes {include}, which is not relative to it"
            layer = target.relative_to(CORE).parts[0]
            if path.parent == CORE:
                assert layer in LAYERS or target.parent == CORE, f"{relative(path)} includes {include}: unknown stage"
            else:
                assert folder in LAYERS, f"{relative(path)}: {folder} is not a stage; add it to LAYERS"
                assert layer in LAYERS[: LAYERS.index(folder) + 1], f"{relative(path)} includes the later {include}"
            checked += 1
    assert checked > 10


def test_core_includes_itself_relatively() -> None:
    for path in list(CORE.rglob("*.h")) + list(CORE.rglob("*.cpp")):
        assert "#include <laminate_offset/" not in path.read_text(encoding="utf-8"), relative(path)


def test_sources_begin_with_their_licence() -> None:
    def wants_licence(path: Path) -> bool:
        in_folder = path.relative_to(source_tree.ROOT).parts[0] in SPDX_FOLDERS
        return path.suffix in SPDX_SUFFIXES or path.name in SPDX_NAMES or in_folder

    checked = [path for path in source_tree.source_files() if wants_licence(path)]
    assert len(checked) > 20
    missing = [
        relative(path)
        for path in checked
        if "SPDX-License-Identifier: LGPL-2.1-or-later"
        not in "\n".join(path.read_text(encoding="utf-8").splitlines()[:3])
    ]
    assert not missing


def test_nothing_is_left_unfinished() -> None:
    marked = [relative(path) for path in text_files() if UNFINISHED.search(path.read_text(encoding="utf-8"))]
    assert not marked


def test_no_path_of_one_machine() -> None:
    found = []
    for path in text_files():
        for number, line in enumerate(path.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            if MACHINE_PATH.search(line):
                found.append(f"{relative(path)}:{number}: {line.strip()[:100]}")
    assert not found


def test_functions_are_short() -> None:
    functions = source_tree.functions()
    assert len(functions) > 50
    too_long = [f for f in functions if f.lines > LINE_LIMIT]
    assert not too_long, "\n".join(f"{f.place}: {f.lines} lines" for f in too_long)


def test_most_functions_of_the_core_are_very_short() -> None:
    lengths = sorted(f.lines for f in source_tree.functions() if f.place.startswith("src/core/"))
    assert len(lengths) > 20
    assert lengths[int(0.9 * len(lengths))] <= PERCENTILE_LIMIT


def test_the_version_is_the_same_everywhere() -> None:
    patterns = {
        "CMakeLists.txt": r"^\s*VERSION (\S+)$",
        "Mod/LaminateOffset/package.xml": r"<version>([^<]+)</version>",
    }
    found = {}
    for name, pattern in patterns.items():
        match = re.search(pattern, (source_tree.ROOT / name).read_text(encoding="utf-8"), re.MULTILINE)
        assert match, f"{name} states no version"
        found[name] = match.group(1)
    assert len(set(found.values())) == 1, found
