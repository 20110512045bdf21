"""Options that have another name since, until the version that removes the old name."""

from box_dataset import write_box
from program import ciel


def test_the_old_name_of_an_option_gives_way_to_the_new_one(tmp_path, monkeypatch):
    box = write_box(tmp_path / "box.ciel", 24)

    def surface(name, *options):
        result = ciel("extract", box, "--iso", "r=0.75", "-o", tmp_path / name, *options)
        assert result.returncode == 0, result.stderr
        return (tmp_path / name).read_bytes()

    signatures, propagation = (surface(name, "--algorithm", name.removesuffix(".vtp"))
                               for name in ("signatures.vtp", "propagation.vtp"))
    assert signatures != propagation, "the polygons have another order"
    assert surface("old.vtp", "--engine", "propagation") == propagation
    monkeypatch.setenv("CIEL_ENGINE", "propagation")
    assert surface("environment.vtp") == propagation
    assert surface("both.vtp", "--algorithm", "signatures") == signatures
