ciel_fuzz(extract LINKS geometry ciel PACKAGES test_support)
