ciel_fuzz(socket_rows LINKS gateway)
