ciel_fuzz(http_headers LINKS gateway)
