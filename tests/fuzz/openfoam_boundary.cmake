if(TARGET ciel_import_parsers)
  ciel_fuzz(openfoam_boundary LINKS import_parsers ciel)
endif()
