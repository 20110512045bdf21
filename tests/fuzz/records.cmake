ciel_fuzz(records LINKS ciel PACKAGES test_support)
