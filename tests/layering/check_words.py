"""Fails on retired words and on long lines of Markdown. Each thing has one name (server/README.md, "Words")."""

import pathlib
import re
import subprocess
import sys

# Pattern of the retired word, its replacement, and the files that may contain it.
RETIRED = [
    (r"[Cc]olour", "color", {"CHANGELOG.md"}),
    (r"\bEngine::(signatures|propagation|naive)\b", "Algorithm", set()),
    (r"CIEL_ENGINE|--engine\b", "--algorithm", {"server/app/scene_options.cpp", "tests/python/test_old_names.py", "CHANGELOG.md"}),
    (r"\bGeometryMesh\b", "wire::Primitives", set()),
    (r"\brender::Mesh\b", "render::Primitives", set()),
    (r"\bPrimitives[&>*]* mesh(es)?\b|\b(interface|Sent|decode|isSame)[ ]?Mesh\b", "primitives; in the page BatchShape", set()),
    (r"\brender::Page\b|\bannotations::Page\b", "annotations::Layout", set()),
    (r"\bimporter::(Block|DataSet|DataSets)\b|\bdata_sets\.[ch]pp", "importer::InputGrid, InputGrids", set()),
    (r"\b[Dd]ata sets?\b", "dataset, or input grid", {"CHANGELOG.md"}),
    (r"\bField::Blocks\b", "Field::Data", set()),
    (r"\bPartIds\b|\bHeldParts\b", "ArrayIds, HeldArrays", set()),
    (r"\bMissingPart\b|\bKeptParts\b|\bGeometryParts\b", "MissingArrays, KeptArrays, UploadedBatches", set()),
    (r"\bIndexPart\b", "BoxedRange", set()),
    (r"\bPart(Matcher|Point)\b|\bPartsByPoint\b", "PieceMatcher, PiecePoint, PiecesByPoint", set()),
    (r"\bFoamPart\b", "FoamRoot", set()),
    (r"\bArrayIds parts\b|\bfind_cut_between_parts\b", "ids, find_cut_between_pieces", set()),
    (r"\bPage(States|Checks)\b|\bPaged(File|Values)\b", "CheckedStretches, StretchChecks, CheckedFile, ValuesToLoad", set()),
    (r"\bpaged_(array|file|values)|\bpage_(checks|checksums)\b", "stored_array, checked_file, values_to_load; stretch", set()),
    (r"\bBlockJoiner\b", "MemberJoiner", set()),
    (r"\bJoinedMesh::Surface\b", "JoinedMesh::FlatCells", set()),
    (r"\bdrop_unknown_members\.[ch]pp", "scene/unknown_members.hpp", set()),
    (r"\bgateway::Context\b|gateway/context\.hpp", "gateway::GatewayState", set()),
    (r"\bframes::Readiness\b", "frames::TestPictureResult", set()),
    (r"\bsessions::Steps\b", "sessions::UndoRedoSteps", set()),
    (r"\bstore::Place\b|store/place\.hpp", "store::NewDatasetDirectory", set()),
    (r"\bannotations::(Place|Camera)\b", "annotations::PicturePoint or ViewCamera", set()),
    (r"\bgeometry::Patch\b", "geometry::MeasuredPatch", set()),
    (r"\buseApp\b|\bAppState\b", "useModel and useCommands, PageState", set()),
    (r"[Cc]entre|CENTRE", "center", {"CHANGELOG.md"}),
    (r"\bSlabMesh\b|slab_mesh\.hpp", "color::SlabTriangles", set()),
    (r"\bFullCamera\b", "ViewCamera", set()),
    (r"\bkernel_unit\b", "tests/unit/ciel", set()),
]
TEXTS = {".cpp", ".hpp", ".ts", ".tsx", ".py", ".md", ".json", ".txt", ".cmake", ".css", ".html", ".glsl", ""}
LEFT_OUT = ("tests/layering/check_words.py", "webclient/package-lock.json", "protocol/colormaps.json")
OLD_RESULTS = "tests/bench/results/"  # they keep the words of their time
MOST_COLUMNS = 130  # of a line of Markdown: a longer row of a table cannot be read as text


def main(root: pathlib.Path) -> int:
    names = subprocess.run(["git", "-C", root, "ls-files"], capture_output=True, text=True, check=True).stdout.split("\n")
    problems = []
    for name in names:
        path = root / name
        if path.suffix not in TEXTS or name.startswith(LEFT_OUT) or not path.is_file():
            continue
        try:
            lines = path.read_text(encoding="utf-8").splitlines()
        except UnicodeDecodeError:
            continue
        if path.suffix == ".md":
            problems += [
                f"{name}:{number}: the line has {len(line)} columns; wrap it, or turn the table into a list ({MOST_COLUMNS} at most)"
                for number, line in enumerate(lines, 1)
                if len(line) > MOST_COLUMNS
            ]
        for pattern, now, allowed in RETIRED:
            if name in allowed or name.startswith(OLD_RESULTS):
                continue
            problems += [
                f"{name}:{number}: {match.group(0)} is called {now} now"
                for number, line in enumerate(lines, 1)
                if (match := re.search(pattern, line))
            ]
    print("\n".join(problems) or f"no retired word and no long line of Markdown in {len(names)} files")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
