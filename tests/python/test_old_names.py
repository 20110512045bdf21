"""Options that have another name since, until the version that removes the old name."""

import pytest
from box_dataset import write_box
from serve_process import Server


@pytest.mark.parametrize(("options", "environment", "algorithm"), [
    ([], {}, "signatures"),
    (["--engine", "propagation"], {}, "propagation"),
    ([], {"CIEL_ENGINE": "propagation"}, "propagation"),
    (["--algorithm", "signatures"], {"CIEL_ENGINE": "propagation"}, "signatures"),
    ([], {"CIEL_ALGORITHM": "signatures", "CIEL_ENGINE": "propagation"}, "signatures"),
])
def test_the_old_name_of_an_option_gives_way_to_the_new_one(tmp_path, options, environment, algorithm):
    with Server(write_box(tmp_path / "box.ciel", n=3), *options, environment=environment) as running:
        assert running.call("server.info")["algorithm"] == algorithm
