# Separate from CMakeLists.txt, because tests/layering reads this order even when the importer is not built.
ciel_folders(import source parsers parsers/openfoam mesh values readers readers/openfoam .)
