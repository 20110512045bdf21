ciel_fuzz(forwarded_for LINKS gateway)
