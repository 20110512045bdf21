if(TARGET ciel_import_parsers)
  ciel_fuzz(openfoam_faces LINKS import_parsers ciel)
endif()
