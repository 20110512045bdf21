ciel_fuzz(frame_header LINKS wire ciel)
