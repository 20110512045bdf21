if(TARGET ciel_import_parsers)
  ciel_fuzz(import_index LINKS import_parsers ciel)
endif()
