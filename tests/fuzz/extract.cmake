ciel_fuzz(extract LINKS ciel PACKAGES test_support)
