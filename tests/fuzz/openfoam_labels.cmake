if(TARGET ciel_import_parsers)
  ciel_fuzz(openfoam_labels LINKS import_parsers ciel)
endif()
