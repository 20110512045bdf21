ciel_fuzz(store_metadata LINKS store ciel)
