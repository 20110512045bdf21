if(TARGET ciel_import_parsers)
  ciel_fuzz(legacy_vtk_numbers LINKS import_parsers ciel)
endif()
