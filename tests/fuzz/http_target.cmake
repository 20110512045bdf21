ciel_fuzz(http_target LINKS gateway)
