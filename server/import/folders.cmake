# Apart from CMakeLists.txt, for tests/layering reads the order also where the importer is not built.
ciel_folders(import source parsers parsers/openfoam mesh values readers readers/openfoam .)
