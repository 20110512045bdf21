if(TARGET ciel_import_parsers)
  ciel_fuzz(openfoam_zones LINKS import_parsers ciel)
endif()
