ciel_fuzz(step_table LINKS store ciel PACKAGES test_support)
