if(TARGET ciel_import_parsers)
  ciel_fuzz(netcdf_extent LINKS import_parsers ciel)
endif()
