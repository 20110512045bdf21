if(TARGET ciel_import_parsers)
  ciel_fuzz(openfoam_field LINKS import_parsers ciel)
endif()
