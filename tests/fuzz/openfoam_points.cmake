if(TARGET ciel_import_parsers)
  ciel_fuzz(openfoam_points LINKS import_parsers ciel)
endif()
