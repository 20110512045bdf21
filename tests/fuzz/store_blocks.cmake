ciel_fuzz(store_blocks LINKS store ciel PACKAGES test_store_box)
