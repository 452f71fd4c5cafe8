#!/usr/bin/env bash
# check_install.sh BUILD_FOLDER: installs into a folder of its own and runs the programs from there, with modules, demo and
# help that were installed, not the source tree's.
set -euo pipefail
build=$1
prefix=$(mktemp -d)
trap 'rm -rf "$prefix"' EXIT
cmake --install "$build" --prefix "$prefix" > /dev/null
for file in bin/chiaro lib/chiaro/chiaro_codec.so lib/chiaro/chiaro_video.so share/chiaro/demo/demo.chiaro share/doc/chiaro/copyright; do
    [ -e "$prefix/$file" ] || { echo "$file is not installed"; exit 1; }
done
unset CHIARO_RESOURCES
LD_DEBUG=files LD_DEBUG_OUTPUT=$prefix/loaded "$prefix/bin/chiaro" sample info "$prefix/share/chiaro/demo/samples/oil.png"
grep -hq "file=$prefix/lib/chiaro/chiaro_codec.so" "$prefix"/loaded.* || { echo "the module is not the installed one"; exit 1; }
[ -e "$prefix/bin/chiaro-studio" ] || exit 0
for file in share/applications/io.github.chiaro.studio.desktop share/metainfo/io.github.chiaro.studio.metainfo.xml \
    share/mime/packages/io.github.chiaro.studio.xml share/icons/hicolor/scalable/apps/io.github.chiaro.studio.svg \
    share/icons/hicolor/48x48/apps/io.github.chiaro.studio.png share/chiaro/help/en/start.md; do
    [ -e "$prefix/$file" ] || { echo "$file is not installed"; exit 1; }
done
"$prefix/bin/chiaro-studio" --version
