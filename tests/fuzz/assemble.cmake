ciel_fuzz(assemble LINKS ciel PACKAGES oracle_twin test_support)
