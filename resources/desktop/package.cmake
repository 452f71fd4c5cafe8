# `cpack -G DEB` in the build folder: both programs, their modules and what lies beside them, as one package.
set(CPACK_PACKAGE_NAME chiaro)
set(CPACK_PACKAGE_VENDOR "The Chiaro developers")
set(CPACK_PACKAGE_CONTACT "The Chiaro developers <chiaro@example.org>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "shades 3D meshes with an artist's own paint")
set(CPACK_PACKAGE_DESCRIPTION
    "Scan one strip of paint from dark to light; Chiaro separates its colours from its brush texture, makes more of that
texture, and paints your mesh with it, live in a studio or in batches from the command line.")
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/LICENSE)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_GENERATOR DEB)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION graphics)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
# Without these it runs: by the CPU alone, and with English buttons in dialogs.
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "libgl1-mesa-dri, qt6-translations-l10n")
include(CPack)
