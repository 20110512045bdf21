# Separate from CMakeLists.txt, because tests/layering reads this order and these rooms even when the importer is not built.
set(CIEL_IMPORT_ROOMS importing store limits ciel)
ciel_folders(import source parsers parsers/openfoam mesh values readers readers/openfoam .)
