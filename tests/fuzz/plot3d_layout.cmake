if(TARGET ciel_import_parsers)
  ciel_fuzz(plot3d_layout LINKS import_parsers ciel)
endif()
