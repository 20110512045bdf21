ciel_fuzz(upload_piece LINKS wire ciel)
