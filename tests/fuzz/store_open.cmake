ciel_fuzz(store_open LINKS store ciel PACKAGES test_store_box)
